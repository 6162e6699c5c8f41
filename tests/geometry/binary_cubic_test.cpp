#include "burmester/geometry/binary_cubic.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/random.hpp"
#include "exact_roots.hpp"

namespace burmester {
namespace {

using Form = std::array<double, 4>;
using Pair = std::array<double, 2>;

std::string text(const Form& c) {
  std::ostringstream out;
  out.precision(17);
  out << "form " << c[0] << ' ' << c[1] << ' ' << c[2] << ' ' << c[3];
  return out.str();
}

/// (a s + b t)(c s + d t)(e s + f t)
Form product(const Pair& p, const Pair& q, const Pair& r) {
  const auto [a, b] = p;
  const auto [c, d] = q;
  const auto [e, f] = r;
  return {a * c * e, a * c * f + a * d * e + b * c * e, a * d * f + b * c * f + b * d * e, b * d * f};
}

exact::RootCount exact_count(const Form& c) {
  return exact::count_real_roots_of_form({Rational(c[0]), Rational(c[1]), Rational(c[2]), Rational(c[3])});
}

/// |form(s, t)| relative to the largest coefficient and the third power of the larger of |s|, |t|, in unit
/// roundoffs.
double backward_error(const Form& c, const Pair& root) {
  const Rational s(root[0]), t(root[1]), larger = std::max(Rational(abs(s)), Rational(abs(t)));
  const Rational a(c[0]), b(c[1]), e(c[2]), d(c[3]),
      value = ((a * s + b * t) * s + e * t * t) * s + d * t * t * t;
  const Rational largest(std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])}));
  return approximate(Rational(abs(value) / (largest * larger * larger * larger))) / unit_roundoff;
}

// Horner's rule for a cubic: 6 roundings, each at most a unit roundoff of the sum of the 4 terms, in the
// residual that Newton's method brings to rounding; as much again in the deflated quadratic and its square
// root; twice that where they add up in a multiple root.
constexpr double backward_limit = 64;

void expect_stable(const Form& c, const std::string& label) {
  const auto roots = binary_cubic_roots(c);
  for (int i = 0; i < roots.count; ++i) {
    const double larger = std::max(std::abs(roots.at[i][0]), std::abs(roots.at[i][1]));
    EXPECT_TRUE(1 <= larger && larger < 2) << label << ": " << text(c);
    EXPECT_LE(backward_error(c, roots.at[i]), backward_limit) << label << ": " << text(c);
  }
}

/// Counts agree where the discriminant, relative to the fourth power of the largest coefficient, exceeds
/// `certain`.
void expect_exact_counts(const std::string& stream, int tasks, const std::function<Form(Random&)>& make,
                         double certain = 0) {
  Random random(stream);
  for (int i = 0; i < tasks; ++i) {
    const Form c = make(random);
    const std::string label = stream + ", case " + std::to_string(i);
    expect_stable(c, label);
    const exact::RootCount truth = exact_count(c);
    if (truth.distinct != truth.counted) continue;
    const int count = binary_cubic_roots(c).count;
    const std::array<Rational, 4> exactly{Rational(c[0]), Rational(c[1]), Rational(c[2]), Rational(c[3])};
    const bool sure = std::abs(approximate(relative_discriminant(exactly))) >= certain;
    EXPECT_TRUE(count == truth.distinct || !sure)
        << label << ": " << count << " for " << truth.distinct << ", " << text(c);
  }
}

double small_integer(Random& random) { return random.below(41) - 20; }
Pair integer_root(Random& random) {
  const double s = small_integer(random), t = small_integer(random);
  return s == 0 && t == 0 ? Pair{1, 0} : Pair{s, t};
}

TEST(BinaryCubic, CountsAreExactForRandomForms) {
  expect_exact_counts("BinaryCubic.CountsAreExactForRandomForms", 5000, [](Random& r) {
    return Form{r.normal(), r.normal(), r.normal(), r.normal()};
  });
}

TEST(BinaryCubic, CountsAreExactForIntegerRoots) {  // infinite ones among them
  expect_exact_counts("BinaryCubic.CountsAreExactForIntegerRoots", 5000,
                      [](Random& r) { return product(integer_root(r), integer_root(r), integer_root(r)); });
}

TEST(BinaryCubic, CountsAreExactForCoefficientsOfAllSizes) {
  for (const double decades : {10, 20, 30, 40})
    expect_exact_counts("BinaryCubic.CountsAreExactForCoefficientsOfAllSizes." + std::to_string(decades),
                        3000, [decades](Random& r) {
                          Form c;
                          for (double& x : c) x = r.normal() * std::pow(10, r.uniform(-decades, decades));
                          return c;
                        });
}

// Coefficients below 2: the discriminant has derivatives up to 4 * 8 + 54 * 8 + 18 * 8 = 608.
TEST(BinaryCubic, CountsAreExactNearDoubleRoots) {
  const auto make = [](Random& r) {
    const Pair twice{r.normal(), r.normal()};
    Form c = product(twice, twice, {r.normal(), r.normal()});
    const double apart = std::pow(10, -r.uniform(1, 16));
    for (double& x : c) x *= 1 + apart * r.normal();
    return c;
  };
  expect_exact_counts("BinaryCubic.CountsAreExactNearDoubleRoots", 5000, make,
                      608 * backward_limit * unit_roundoff);
}

TEST(BinaryCubic, CountsAreExactWithRootsAtInfinityAndZero) {
  const std::string stream = "BinaryCubic.CountsAreExactWithRootsAtInfinityAndZero";
  expect_exact_counts(stream + ".infinity", 1000, [](Random& r) {
    return Form{0, r.normal(), r.normal(), r.normal()};
  });
  expect_exact_counts(stream + ".zero", 1000, [](Random& r) {
    return Form{r.normal(), r.normal(), r.normal(), 0};
  });
  expect_exact_counts(stream + ".both", 1000, [](Random& r) { return Form{0, r.normal(), r.normal(), 0}; });
}

/// Distance of two points of the projective line, 0 to 1.
double apart(const Pair& p, const Pair& q) {
  return std::abs(p[0] * q[1] - p[1] * q[0]) / (std::hypot(p[0], p[1]) * std::hypot(q[0], q[1]));
}
double nearest(const Pair& p, const BinaryCubicRoots<double>& roots) {
  double least = 1;
  for (int i = 0; i < roots.count; ++i) least = std::min(least, apart(p, roots.at[i]));
  return least;
}

// A double root may be seen as none, one or two. The simple root stays, to rounding over its distance.
TEST(BinaryCubic, DoubleRootsLeaveTheSimpleRoot) {
  Random random("BinaryCubic.DoubleRootsLeaveTheSimpleRoot");
  for (int i = 0; i < 3000; ++i) {
    const Pair twice = integer_root(random), once = integer_root(random);
    if (apart(twice, once) == 0) continue;
    const Form c = product(twice, twice, once);
    const auto roots = binary_cubic_roots(c);
    const Pair simple{-once[1], once[0]}, multiple{-twice[1], twice[0]};
    const double gap = apart(simple, multiple);
    expect_stable(c, "case " + std::to_string(i));
    EXPECT_TRUE(1 <= roots.count && roots.count <= 3) << text(c);
    // slope of the normed form at the simple root: gap^2 times at least 1/8 (largest coefficient of the
    // product)
    EXPECT_LT(nearest(simple, roots), 8 * backward_limit * unit_roundoff / (gap * gap)) << text(c);
    for (int k = 0; k < roots.count; ++k) {
      const double away = std::min(apart(simple, roots.at[k]), apart(multiple, roots.at[k]));
      EXPECT_LT(away, std::sqrt(8 * backward_limit * unit_roundoff / gap)) << text(c);
    }
  }
}

TEST(BinaryCubic, TripleRootsAreFoundToTheCubeRootOfRounding) {
  Random random("BinaryCubic.TripleRootsAreFoundToTheCubeRootOfRounding");
  for (int i = 0; i < 1000; ++i) {
    const Pair root = integer_root(random);
    const Form c = product(root, root, root);
    const auto roots = binary_cubic_roots(c);
    ASSERT_GE(roots.count, 1) << text(c);
    for (int k = 0; k < roots.count; ++k)
      EXPECT_LT(apart({-root[1], root[0]}, roots.at[k]), std::cbrt(8 * backward_limit * unit_roundoff))
          << text(c);
  }
}

TEST(BinaryCubic, SatisfiesVieta) {
  Random random("BinaryCubic.SatisfiesVieta");
  int three = 0;
  for (int i = 0; i < 1000; ++i) {
    const Form c{1, random.normal(), random.normal(), random.normal()};
    const auto roots = binary_cubic_roots(c);
    if (roots.count != 3) continue;
    ++three;
    const auto x = [&](int k) { return roots.at[k][0] / roots.at[k][1]; };
    const double size = 1 + std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]), tolerance = 1e-13 * size * size;
    EXPECT_NEAR(x(0) + x(1) + x(2), -c[1], tolerance) << text(c);
    EXPECT_NEAR(x(0) * x(1) + x(1) * x(2) + x(2) * x(0), c[2], tolerance) << text(c);
    EXPECT_NEAR(x(0) * x(1) * x(2), -c[3], tolerance) << text(c);
  }
  EXPECT_GT(three, 100);
}

TEST(BinaryCubic, SpecialForms) {
  EXPECT_EQ(binary_cubic_roots(Form{0, 0, 0, 0}).count, 0);
  const auto at_infinity = binary_cubic_roots(Form{0, 0, 0, 5});
  ASSERT_GE(at_infinity.count, 1);
  for (int i = 0; i < at_infinity.count; ++i) EXPECT_EQ(at_infinity.at[i][1], 0);
  const auto at_zero = binary_cubic_roots(Form{-3, 0, 0, 0});
  ASSERT_GE(at_zero.count, 1);
  for (int i = 0; i < at_zero.count; ++i) EXPECT_EQ(at_zero.at[i][0], 0);
  const auto cube = binary_cubic_roots(Form{1, 0, 0, -8});
  ASSERT_EQ(cube.count, 1);
  EXPECT_DOUBLE_EQ(cube.at[0][0], 2 * cube.at[0][1]);
}

TEST(BinaryCubic, QuadRootsAreRootsToQuadPrecision) {
  Random random("BinaryCubic.QuadRootsAreRootsToQuadPrecision");
  for (int i = 0; i < 1000; ++i) {
    const Form c{random.normal(), random.normal(), random.normal(), random.normal()};
    const auto roots = binary_cubic_roots(std::array<Quad, 4>{c[0], c[1], c[2], c[3]});
    EXPECT_EQ(roots.count, exact_count(c).distinct) << text(c);
    for (int k = 0; k < roots.count; ++k) {
      const Quad s = roots.at[k][0], t = roots.at[k][1];
      const Quad value = ((c[0] * s + c[1] * t) * s + c[2] * t * t) * s + c[3] * t * t * t;
      const double largest = std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])});
      EXPECT_LT(std::abs(approximate(value)), 8 * largest * backward_limit * 0x1p-113) << text(c);
    }
  }
}

TEST(BinaryQuadratic, RootsAndDiscriminant) {
  std::array<Pair, 2> root;
  double discriminant;
  EXPECT_EQ(binary_quadratic_roots(1.0, -3.0, 2.0, root, discriminant), 2);
  EXPECT_EQ(discriminant, 1);
  EXPECT_EQ(apart(root[0], {2, 1}) + apart(root[1], {1, 1}), 0);
  EXPECT_EQ(binary_quadratic_roots(1.0, 0.0, 1.0, root, discriminant), 0);
  EXPECT_EQ(binary_quadratic_roots(4.0, 4.0, 1.0, root, discriminant), 1);
  EXPECT_EQ(apart(root[0], {-1, 2}), 0);
  EXPECT_EQ(binary_quadratic_roots(0.0, 2.0, 6.0, root, discriminant), 2);
  EXPECT_EQ(std::min(apart(root[0], {1, 0}), apart(root[1], {1, 0})), 0);
  EXPECT_EQ(binary_quadratic_roots(0.0, 0.0, 6.0, root, discriminant), 1);
  EXPECT_EQ(apart(root[0], {1, 0}), 0);
  EXPECT_EQ(binary_quadratic_roots(6.0, 0.0, 0.0, root, discriminant), 1);
  EXPECT_EQ(apart(root[0], {0, 1}), 0);
  EXPECT_EQ(binary_quadratic_roots(0.0, 0.0, 0.0, root, discriminant), 0);
}

TEST(RelativeDiscriminant, HasTheSignOfTheCount) {
  Random random("RelativeDiscriminant.HasTheSignOfTheCount");
  for (int i = 0; i < 1000; ++i) {
    const Form c{random.normal(), random.normal(), random.normal(), random.normal()};
    EXPECT_EQ(relative_discriminant(c) > 0, exact_count(c).distinct == 3) << text(c);
    const Form scaled{8 * c[0], 8 * c[1], 8 * c[2], 8 * c[3]};
    EXPECT_EQ(relative_discriminant(scaled), relative_discriminant(c));
    const Pair twice{small_integer(random), 1};
    EXPECT_EQ(relative_discriminant(product(twice, twice, {small_integer(random), 1})), 0);
  }
  EXPECT_EQ(relative_discriminant(Form{}), 0);
}

TEST(CubeRootAbove, IsAboveByAtMostFourPerMille) {
  Random random("CubeRootAbove.IsAboveByAtMostFourPerMille");
  for (int i = 0; i < 100000; ++i) {
    const double x = std::ldexp(1 + random.uniform(), random.below(2000) - 999);
    const double bound = detail::cube_root_above(x), root = std::cbrt(x);
    ASSERT_TRUE(root <= bound && bound <= 1.004 * root) << x;
  }
  EXPECT_EQ(detail::cube_root_above(0), 0);
  EXPECT_GE(detail::cube_root_above(std::numeric_limits<double>::denorm_min()), 0x1p-358);
}

}  // namespace
}  // namespace burmester
