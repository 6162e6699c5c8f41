#include "burmester/geometry/conic_class.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "moved_forms.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using C = Conic<double>;
using Vector2 = Vector<double, 2>;

std::string name(const C& c) { return std::string(name_of(classify(c))); }
Point2<double> at(const Vector2& p) { return {p[0], p[1], 1}; }

struct Normal {
  C conic;
  ConicType type;
};
/// Every class, in coordinates (x, y, z).
std::vector<Normal> normal_forms() {
  using enum ConicType;
  return {{C({1, 2, -3, 0, 0, 0}), ellipse},         {C({1, 2, 3, 0, 0, 0}), imaginary_ellipse},
          {C({1, -2, -3, 0, 0, 0}), hyperbola},      {C({1, 0, 0, -2, 0, 0}), parabola},
          {C({1, -1, 0, 0, 0, 0}), crossing_lines},  {C({1, 2, 0, 0, 0, 0}), point},
          {C({1, 0, -4, 0, 0, 0}), parallel_lines},  {C({1, 0, 4, 0, 0, 0}), complex_parallel_lines},
          {C({1, 0, 0, 0, 0, 0}), coincident_lines}, {C({0, 0, 0, 0, 1, 0}), line_and_infinity},
          {C({0, 0, 1, 0, 0, 0}), infinity_twice},   {C(), everything}};
}

/// a x^2 + 2 b x y + c y^2 + 2 d x + 2 e y + f, as the lecture notes write it (M. J. D. Hayes, course notes
/// on quadratic forms; the printed inequalities of a c - b^2 stand the wrong way round).
C published(double a, double b, double c, double d, double e, double f) {
  return C({a, c, f, 2 * e, 2 * d, 2 * b});
}

TEST(ConicClass, PublishedCases) {
  EXPECT_EQ(name(published(1, 0, 1, 0, 0, -1)), "circle");
  EXPECT_EQ(name(published(1, 0, 4, 0, 0, -4)), "ellipse");
  EXPECT_EQ(name(published(1, 0, -1, 0, 0, -1)), "rectangular hyperbola");
  EXPECT_EQ(name(published(0, 1, 0, 0, 0, -1)), "rectangular hyperbola");
  EXPECT_EQ(name(published(0, 0, 1, -1, 0, 0)), "parabola");
  EXPECT_EQ(name(published(1, 0, -1, 0, 0, 0)), "perpendicular lines");
  EXPECT_EQ(name(published(1, 0, 0, 0, 0, -1)), "parallel lines");
  EXPECT_EQ(name(published(1, 0, 0, 0, 0, 0)), "coincident lines");
  EXPECT_EQ(name(published(1, 0, 1, 0, 0, 0)), "point");
  EXPECT_EQ(name(published(1, 0, 1, 0, 0, 1)), "imaginary circle");
  EXPECT_EQ(name(published(1, 0, 1, -1, -1, 1)), "circle");  // through (2,1), (1,2), (0,1)
}

TEST(ConicClass, IsInvariantUnderAffineMapsScalingAndSign) {
  Random random("ConicClass.IsInvariantUnderAffineMapsScalingAndSign");
  for (const Normal& normal : normal_forms())
    for (int i = 0; i < 100; ++i) {
      const C moved = substituted(normal.conic, random_unimodular<3>(random, true));
      for (const double factor : {1.0, -1.0, -3.0, 0x1p-700, -0x1p300}) {
        const ConicClass found = classify(scaled(moved, factor));
        ASSERT_EQ(found.type, normal.type) << name_of(found) << ", case " << i << ", factor " << factor;
        EXPECT_NE(found.rung, Rung::none);
      }
      const ConicClass exactly = classify(in_rationals(moved));
      EXPECT_EQ(exactly.type, normal.type);
      EXPECT_EQ(exactly.rung, Rung::exact);
    }
}

TEST(ConicClass, CirclesAndRightAnglesAreInvariantUnderSimilarities) {
  Random random("ConicClass.CirclesAndRightAnglesAreInvariantUnderSimilarities");
  for (int i = 0; i < 100; ++i) {
    const double a = random.below(100) + 1, b = random.below(100) - 50, x = random.below(100),
                 y = random.below(100);
    Matrix<double, 3, 3> H;
    H << a, -b, x, b, a, y, 0, 0, 1;
    EXPECT_EQ(name(substituted(C({1, 1, -2, 0, 0, 0}), H)), "circle");
    EXPECT_EQ(name(substituted(C({1, 1, 2, 0, 0, 0}), H)), "imaginary circle");
    EXPECT_EQ(name(substituted(C({1, -1, 2, 0, 0, 0}), H)), "rectangular hyperbola");
    EXPECT_EQ(name(substituted(C({0, 0, 0, 0, 0, 1}), H)), "perpendicular lines");
    C almost = substituted(C({1, 1, -2, 0, 0, 0}), H);
    almost.q[0] = std::nextafter(almost.q[0], 0);
    EXPECT_EQ(name(almost), "ellipse");
  }
}

/// One unit in the last place of z^2 opens a degenerate conic. det changes by delta times the minor of q0, q1.
TEST(ConicClass, IsDecidedByTheLastBit) {
  Random random("ConicClass.IsDecidedByTheLastBit");
  for (int i = 0; i < 100; ++i) {
    const Matrix<double, 3, 3> H = random_unimodular<3>(random, true);
    const auto type = [&H](const C& form, double toward) {
      C c = substituted(form, H);
      c.q[2] = std::nextafter(c.q[2], toward);
      return classify(c);
    };
    const double up = std::numeric_limits<double>::infinity();
    const C point({1, 2, 0, 0, 0, 0}), twice({1, 0, 0, 0, 0, 0}), crossing({1, -1, 0, 0, 0, 0});
    EXPECT_EQ(type(point, up).type, ConicType::imaginary_ellipse);
    EXPECT_EQ(type(crossing, up).type, ConicType::hyperbola);
    EXPECT_EQ(type(crossing, -up).type, ConicType::hyperbola);
    EXPECT_EQ(type(twice, up).type, ConicType::complex_parallel_lines);
    EXPECT_EQ(type(point, -up).type, ConicType::ellipse);
    EXPECT_EQ(type(twice, -up).type, ConicType::parallel_lines);
  }
  for (const double one : {std::nextafter(1.0, 2.0), 1.0, std::nextafter(1.0, 0.0)}) {
    const ConicType type = classify(C({1, one, -1, 0, 0, 2})).type;  // x^2 + 2 x y + one y^2 = 1
    EXPECT_EQ(type, one > 1   ? ConicType::ellipse
                    : one < 1 ? ConicType::hyperbola
                              : ConicType::parallel_lines);
  }
}

/// Products of two lines with 26 random bits each are exact, and no double arithmetic can tell.
TEST(ConicClass, RecognisesProductsOfLines) {
  Random random("ConicClass.RecognisesProductsOfLines");
  for (int i = 0; i < 200; ++i) {
    LinearForm<double> l, m;
    for (int k = 0; k < 3; ++k) l[k] = random.below(1 << 25) + 1, m[k] = random.below(1 << 25) + 1;
    C c;
    c.add_product(l, m, 1);
    const ConicClass found = classify(c);
    EXPECT_EQ(found.type, ConicType::crossing_lines);
    EXPECT_EQ(found.rung, Rung::exact);
    c.q[i % 6] = std::nextafter(c.q[i % 6], 0);
    EXPECT_EQ(classify(c).type, ConicType::hyperbola);
  }
}

TEST(ConicClass, GenericConicsNeedNoExactArithmetic) {
  Random random("ConicClass.GenericConicsNeedNoExactArithmetic");
  for (int i = 0; i < 1000; ++i) {
    C c;
    for (double& q : c.q) q = random.normal();
    const ConicClass found = classify(c), exactly = classify(in_rationals(c));
    EXPECT_EQ(found.rung, Rung::intervals) << i;
    EXPECT_EQ(found.type, exactly.type) << i;
  }
}

/// u^2 / square[0] + v^2 / square[1] - 1 in the frame turned by an angle and shifted to the centre.
C central_conic(const Vector2& centre, double angle, double square0, double square1) {
  Matrix<double, 3, 3> H;
  const double c = std::cos(angle), s = std::sin(angle);
  H << c, s, -c * centre[0] - s * centre[1], -s, c, s * centre[0] - c * centre[1], 0, 0, 1;
  return substituted(C({1 / square0, 1 / square1, -1, 0, 0, 0}), H);
}

/// Entries of size 1 with a few roundings each; division by the discriminant and by square roots of size 1/20.
TEST(ConicAxes, AreThoseOfTheConstruction) {
  Random random("ConicAxes.AreThoseOfTheConstruction");
  for (int i = 0; i < 300; ++i) {
    const Vector2 centre(random.uniform(-2, 2), random.uniform(-2, 2));
    const double angle = random.uniform(-3, 3), first = random.uniform(1, 4), factor = i % 2 ? -3.5 : 0.25;
    const double sign = i % 3 == 0 ? -1 : 1, second = sign * random.uniform(0.3, 0.9);
    const C c = scaled(central_conic(centre, angle, first, second), factor);
    ASSERT_EQ(classify(c).type, second > 0 ? ConicType::ellipse : ConicType::hyperbola);
    const ConicAxes axes = axes_of(c);
    EXPECT_LT((axes.centre - centre).norm(), 1e-13) << i;
    EXPECT_NEAR(axes.square[0], first, 1e-12) << i;
    EXPECT_NEAR(axes.square[1], second, 1e-12) << i;
    EXPECT_NEAR(std::abs(axes.axis[0].dot(Vector2(std::cos(angle), std::sin(angle)))), 1, 1e-13) << i;
    EXPECT_NEAR(axes.axis[0][0] * axes.axis[1][1] - axes.axis[0][1] * axes.axis[1][0], 1, 1e-15) << i;
    if (second > 0) continue;
    for (const Vector2& d : asymptote_directions(c)) {
      const Vector2 turned(d.dot(axes.axis[0]), d.dot(axes.axis[1]));
      EXPECT_NEAR(turned[0] * turned[0] / first + turned[1] * turned[1] / second, 0, 1e-12) << i;
    }
  }
}

TEST(ConicAxes, OfImaginaryEllipsesAreNegativeSquares) {
  const ConicAxes axes = axes_of(C({1, 4, 4, 0, 0, 0}));
  EXPECT_EQ(axes.square[0], -1);
  EXPECT_EQ(axes.square[1], -4);
}

TEST(ParabolaFrame, IsThatOfTheConstruction) {
  Random random("ParabolaFrame.IsThatOfTheConstruction");
  for (int i = 0; i < 300; ++i) {
    const double a = random.below(20) - 10, b = random.below(20) + 1;  // axis along (a, b)
    const double x = random.below(20) - 10, y = random.below(20) - 10, p = random.below(9) + 1,
                 n = a * a + b * b;
    Matrix<double, 3, 3> H;  // u = a x' + b y', v = a y' - b x', n times the coordinates' lengths
    H << a, b, -a * x - b * y, -b, a, b * x - a * y, 0, 0, 1;
    C c = substituted(C({0, 1, 0, 0, -2 * p, 0}), H);  // v^2 = 2 p u
    ASSERT_EQ(classify(c).type, ConicType::parabola);
    if (i % 2) c = scaled(c, -2);
    const ParabolaFrame frame = parabola_frame(c);
    EXPECT_LT((frame.vertex - Vector2(x, y)).norm(), 1e-12) << i;
    EXPECT_LT((frame.axis - Vector2(a, b) / std::sqrt(n)).norm(), 1e-14) << i;
    EXPECT_NEAR(frame.parameter, p / std::sqrt(n), 1e-13) << i;
  }
}

/// Q is proportional to the product of its lines, to the rounding of the lines.
TEST(LinesOf, MultiplyToTheConic) {
  Random random("LinesOf.MultiplyToTheConic");
  for (const Normal& normal : normal_forms())
    for (int i = 0; i < 50; ++i) {
      const C c = substituted(normal.conic, random_unimodular<3>(random, true));
      const auto lines = lines_of(c, classify(c).type);
      using enum ConicType;
      const bool two =
          normal.type == crossing_lines || normal.type == parallel_lines || normal.type == line_and_infinity;
      const bool one = normal.type == coincident_lines || normal.type == infinity_twice;
      ASSERT_EQ(lines.size(), two ? 2u : one ? 1u : 0u) << name_of(classify(c));
      if (lines.empty()) continue;
      C product;
      product.add_product(lines.front(), lines.back(), 1);
      EXPECT_TRUE(proportional(scaled(product, 1 / size_of(product)), scaled(c, 1 / size_of(c)), 1e-14));
    }
}

/// Two lines that differ in the last of 26 bits.
TEST(LinesOf, SeparatesLinesThatNearlyCoincide) {
  const LinearForm<double> l(0x1.fffffep24, 12345677, 54321), m(0x1.fffffep24, 12345676, 54321);
  C c;
  c.add_product(l, m, 1);
  const auto lines = lines_of(c, classify(c).type);
  ASSERT_EQ(lines.size(), 2u);
  const auto same = [](const LinearForm<double>& u, const LinearForm<double>& v) {
    return u.normalized().cross(v.normalized()).norm() < 1e-15;
  };
  EXPECT_TRUE((same(lines[0], l) && same(lines[1], m)) || (same(lines[0], m) && same(lines[1], l)));
}

TEST(CentreOf, IsTheCommonPointOfLines) {
  Random random("CentreOf.IsTheCommonPointOfLines");
  for (int i = 0; i < 100; ++i) {
    const Matrix<double, 3, 3> H = random_unimodular<3>(random, true);
    for (const C& form : {C({1, -1, 0, 0, 0, 0}), C({1, 2, 0, 0, 0, 0})}) {
      const Vector2 centre = centre_of(substituted(form, H));
      const Point2<double> there = H * at(centre);
      EXPECT_LT(std::abs(there[0]) + std::abs(there[1]), 1e-12 * (1 + centre.norm())) << i;
    }
  }
}

TEST(Parametrisation, IsExact) {
  Random random("ConicParametrisation.IsExact");
  for (int i = 0; i < 200; ++i) {
    Conic<Rational> c;
    for (Rational& q : c.q) q = random_rational(random);
    Point2<Rational> p = random_rationals<3>(random), u, v;
    if (p.isZero(0)) continue;
    detail::span_line<Rational>(p, u, v);
    const auto X = parametrisation(c, p);
    const Rational s = random_rational(random), t = random_rational(random);
    const Point2<Rational> d = s * u + t * v;
    EXPECT_EQ(c(X(s, t)), Rational(c(d) * c(d) * c(p))) << i;
    EXPECT_EQ(Rational(X(s, t).dot(d.cross(p))), 0) << i;
  }
}

/// Every point of the conic is reached: by the direction in which P sees it.
TEST(Parametrisation, ReachesEveryPoint) {
  Random random("ConicParametrisation.ReachesEveryPoint");
  for (int i = 0; i < 100; ++i) {
    const Matrix<double, 3, 3> H = random_unimodular<3>(random, false);
    const Conic<Rational> c = in_rationals(substituted(C({0, 1, 0, 0, -1, 0}), H));  // y^2 = x z
    const auto point = [&H](int s, int t) -> Point2<Rational> {
      const Matrix<Rational, 3, 3> G = H.template cast<Rational>();
      const Matrix<Rational, 3, 3> adj = (Matrix<Rational, 3, 3>() << G.row(1).cross(G.row(2)),
                                          G.row(2).cross(G.row(0)), G.row(0).cross(G.row(1)))
                                             .finished()
                                             .transpose();
      return adj * Point2<Rational>(s * s, s * t, t * t);
    };
    const Point2<Rational> p = point(random.below(9) - 4, 1), x = point(random.below(9) + 5, 1);
    ASSERT_EQ(c(p), 0);
    ASSERT_EQ(c(x), 0);
    Point2<Rational> u, v;
    detail::span_line<Rational>(p, u, v);
    // d = s u + t v on the line p x: s (u, p, x) + t (v, p, x) = 0
    const Rational su = v.dot(p.cross(x)), tv = -u.dot(p.cross(x));
    const Point2<Rational> found = parametrisation(c, p)(su, tv);
    EXPECT_FALSE(found.isZero(0)) << i;
    EXPECT_TRUE(found.cross(x).isZero(0)) << i;
  }
}

/// real_point: an eigenvalue decomposition, backward stable. Then |Q(X)| = Q(D)^2 |Q(P)| and the roundings of X.
TEST(Parametrisation, ThroughARealPointLiesOnTheConic) {
  Random random("ConicParametrisation.ThroughARealPointLiesOnTheConic");
  int conics = 0;
  for (int i = 0; i < 1000; ++i) {
    C c;
    for (double& q : c.q) q = random.normal();
    if (classify(c).type == ConicType::imaginary_ellipse) continue;
    ++conics;
    const Point2<double> p = real_point(c);
    const double size = 6 * size_of(c);  // |Q(x)| <= size |x|^2
    EXPECT_LE(std::abs(c(p)), 64 * unit_roundoff * size) << i;
    const auto X = parametrisation(c, p);
    for (int k = 0; k < 20; ++k) {
      const Point2<double> x = X(std::cos(k), std::sin(k));
      EXPECT_LE(std::abs(c(x)), 256 * unit_roundoff * size * size * size) << i;
    }
  }
  EXPECT_GT(conics, 500);
}

TEST(ConicClass, TheUnitOfTheCoefficientsDoesNotMatter) {
  for (const double s : {1e300, 1.0, 1e-300}) {
    const ConicAxes circle = axes_of(Conic<double>({s, s, -s, 0, 2 * s, 0}));  // (x + 1)^2 + y^2 = 2
    EXPECT_NEAR(circle.centre[0], -1, 1e-15);
    EXPECT_NEAR(circle.square[0], 2, 1e-14);
    EXPECT_NEAR(parabola_frame(Conic<double>({s, 0, 0, -2 * s, 0, 0})).parameter, 1, 1e-15);  // x^2 = 2 y
  }
}

}  // namespace
}  // namespace burmester
