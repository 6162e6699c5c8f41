#include "burmester/geometry/quadric_intersection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "burmester/geometry/conic_count.hpp"
#include "exact_roots.hpp"
#include "moved_forms.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

template <class T>
using Point = Point3<T>;

template <class T>
Point<T> unit(int i) {
  Point<T> out;
  for (int k = 0; k < 4; ++k) out[k] = T(k == i ? 1 : 0);
  return out;
}
template <class T>
PlanePencil<T> standard_pencil() {
  return planes_through<T>(unit<T>(2), unit<T>(3));
}
/// Whole numbers up to 9, so that doubles do not round them.
template <class T>
Quadric<T> random_quadric(Random& random) {
  Quadric<T> out;
  for (T& q : out.q) q = T(random.below(19) - 9);
  return out;
}
/// A pair with the line of the standard pencil for a chord: B is a multiple of A there.
std::pair<Quadric<double>, Quadric<double>> random_chord_pair(Random& random) {
  Quadric<double> a = random_quadric<double>(random), b = random_quadric<double>(random);
  const int factor = random.below(5) - 2;
  for (const std::size_t k : {2u, 3u, 9u}) b.q[k] = factor * a.q[k];
  return {a, b};
}
QuadricSections<Rational> exact_sections(const Quadric<double>& a, const Quadric<double>& b) {
  return {in_rationals(a), in_rationals(b), standard_pencil<Rational>()};
}
/// Planes (1 : t) between, before and behind the real zeros of a form.
std::vector<double> planes_between_zeros(const BinaryForm<Rational>& form) {
  const std::vector<Rational> roots = exact::real_roots(exact::polynomial(form.coefficients()), 60);
  if (roots.empty()) return {0};
  std::vector<double> out{static_cast<double>(roots.front()) - 1};
  for (std::size_t k = 1; k < roots.size(); ++k)
    out.push_back(static_cast<double>(Rational(roots[k - 1] + roots[k]) / 2));
  out.push_back(static_cast<double>(roots.back()) + 1);
  return out;
}
bool square_free(const BinaryForm<Rational>& form) {
  return form.c[0] != 0 && exact::sturm_chain(exact::polynomial(form.coefficients())).back().size() == 1;
}

TEST(BinaryForm, IsARing) {
  Random random("BinaryForm.IsARing");
  for (int i = 0; i < 100; ++i) {
    const auto form = [&random](std::size_t n) {
      std::vector<Rational> c(n + 1);
      for (Rational& x : c) x = random_rational(random);
      return BinaryForm<Rational>(c);
    };
    const auto f = form(3), g = form(3), h = form(2);
    const Rational s = random_rational(random), t = random_rational(random);
    EXPECT_EQ(((f - 2 * g) * h)(s, t), (f(s, t) - 2 * g(s, t)) * h(s, t));
    EXPECT_EQ((f + g)(s, t), f(s, t) + g(s, t));
    EXPECT_EQ((f * h).degree, 5u);
    EXPECT_EQ(f(Rational(0), Rational(1)), f.c[3]);
  }
}

TEST(PlanePencil, SpansTheSpace) {
  Random random("PlanePencil.SpansTheSpace");
  const PlanePencil<double> planar = standard_pencil<double>();
  EXPECT_EQ(planar.W[0], unit<double>(0));
  EXPECT_EQ(planar.W[1], unit<double>(1));
  for (int i = 0; i < 100; ++i) {
    const Point<Rational> u = random_rationals<4>(random), v = random_rationals<4>(random);
    const auto pencil = planes_through<Rational>(u, v);
    const auto forms =
        Matrix<Rational, 4, 4>((Matrix<Rational, 4, 4>() << u, v, pencil.W[0], pencil.W[1]).finished());
    const Matrix<Rational, 4, 4> gram = forms.transpose() * forms;
    EXPECT_EQ(inertia(gram)->rank, 4) << i;
  }
}

TEST(QuadricSections, AreTheRestrictions) {
  Random random("QuadricSections.AreTheRestrictions");
  for (int i = 0; i < 50; ++i) {
    const auto a = random_quadric<Rational>(random), b = random_quadric<Rational>(random);
    const Point<Rational> u = random_rationals<4>(random), v = random_rationals<4>(random);
    const QuadricSections<Rational> sections(a, b, planes_through<Rational>(u, v));
    EXPECT_FALSE(sections.axis_is_chord());
    const Rational s = random_rational(random), t = random_rational(random);
    const Point2<Rational> x = random_rationals<3>(random);
    EXPECT_EQ(sections.conic(0, s, t)(x), a(sections.planes().point(x, s, t)));
    EXPECT_EQ(sections.conic(1, s, t)(x), b(sections.planes().point(x, s, t)));
  }
}

/// b A - a B = gamma l, and D is the discriminant of the conic on l: with u, v on l, u x v = k l,
/// polar(u, v)^2 - 4 Q(u) Q(v) = k^2 D.
TEST(QuadricSections, DiscriminantOfAChordIsThatOfTheRadicalLine) {
  Random random("QuadricSections.DiscriminantOfAChordIsThatOfTheRadicalLine");
  for (int i = 0; i < 100; ++i) {
    const auto [a, b] = random_chord_pair(random);
    const auto sections = exact_sections(a, b);
    ASSERT_TRUE(sections.axis_is_chord());
    const auto D = sections.discriminant();
    EXPECT_EQ(D.degree, 4u);
    const Rational s = random_rational(random), t = random_rational(random);
    const LinearForm<Rational> l = sections.radical_line(s, t);
    const Conic<Rational> own = sections.conic(sections.leading(), s, t),
                          other = sections.conic(1 - sections.leading(), s, t);
    const std::size_t on = own.q[0] != 0 ? 0 : own.q[1] != 0 ? 1 : 5;
    const Conic<Rational> mixed = pencil_member(other, own.q[on], own, Rational(-other.q[on]));
    for (const std::size_t k : {0u, 1u, 5u}) EXPECT_EQ(mixed.q[k], 0) << i;
    EXPECT_TRUE(LinearForm<Rational>(mixed.q[4], mixed.q[3], mixed.q[2]).cross(l).isZero(0)) << i;
    if (l.isZero(0)) continue;
    Point2<Rational> u, v;
    detail::span_line<Rational>(l, u, v);
    const Rational length = u.cross(v).dot(l),
                   square = own.polar(u, v) * own.polar(u, v) - 4 * own(u) * own(v);
    EXPECT_EQ(square * Rational(l.dot(l)) * Rational(l.dot(l)), length * length * D(s, t)) << i;
  }
}

TEST(QuadricSections, GeneralDiscriminantIsThatOfThePencilDeterminant) {
  Random random("QuadricSections.GeneralDiscriminantIsThatOfThePencilDeterminant");
  for (int i = 0; i < 50; ++i) {
    const auto sections = exact_sections(random_quadric<double>(random), random_quadric<double>(random));
    const auto D = sections.discriminant();
    ASSERT_EQ(D.degree, sections.axis_is_chord() ? 4u : 8u);
    const Rational s = random_rational(random), t = random_rational(random);
    const auto [a, b, c, d] = pencil_determinant(sections.conic(0, s, t), sections.conic(1, s, t));
    EXPECT_EQ(D(s, t), b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - 27 * a * a * d * d +
                           18 * a * b * c * d);
  }
}

/// The doubles' discriminant has the coefficients of the exact one: whole numbers below 2^53 here.
TEST(QuadricSections, DoublesAreExactOnSmallWholeNumbers) {
  Random random("QuadricSections.DoublesAreExactOnSmallWholeNumbers");
  for (int i = 0; i < 50; ++i) {
    const auto [a, b] = random_chord_pair(random);
    const auto exactly = exact_sections(a, b).discriminant();
    const auto found = QuadricSections<double>(a, b, standard_pencil<double>()).discriminant();
    ASSERT_EQ(found.degree, exactly.degree);
    for (std::size_t k = 0; k <= found.degree; ++k) EXPECT_EQ(Rational(found.c[k]), exactly.c[k]) << i;
  }
}

/// On both quadrics to the rounding of the two steps: the radical line, whose errors the leading conic's form
/// on the axis divides, and the quadratic on it.
void expect_on_both(const Quadric<double>& a, const Quadric<double>& b, double s, double t,
                    const SectionPoints& found, double roundings, const std::string& where) {
  const double size = 10 * std::max(size_of(a), size_of(b)), width = (s * s + t * t);
  for (int k = 0; k < found.count; ++k) {
    const Point<double>& x = found.point[static_cast<std::size_t>(k)];
    const double bound = roundings * unit_roundoff * size * size * width * x.squaredNorm();
    EXPECT_LE(std::abs(a(x)), bound) << where;
    EXPECT_LE(std::abs(b(x)), bound) << where;
    EXPECT_LE(std::abs(x[0] * t - x[1] * s), 8 * unit_roundoff * x.norm() * (std::abs(s) + std::abs(t)))
        << where;
  }
}

TEST(PointsInPlane, OfAChordAreTwoWhereTheDiscriminantIsPositive) {
  Random random("PointsInPlane.OfAChordAreTwoWhereTheDiscriminantIsPositive");
  int planes = 0, with_points = 0;
  for (int i = 0; i < 300; ++i) {
    const auto [a, b] = random_chord_pair(random);
    const auto D = exact_sections(a, b).discriminant();
    const QuadricSections<double> sections(a, b, standard_pencil<double>());
    if (sections.axis_is_common() || !square_free(D)) continue;
    for (const double t : planes_between_zeros(D)) {
      const SectionPoints found = points_in_plane(sections, 1, t);
      const Rational sign = D(Rational(1), Rational(t));
      EXPECT_EQ(found.count, sign > 0 ? 2 : 0) << i;
      EXPECT_FALSE(found.holds_curve) << i;
      expect_on_both(a, b, 1, t, found, 64, "case " + std::to_string(i));
      ++planes, with_points += found.count == 2;
    }
  }
  EXPECT_GT(planes, 500);
  EXPECT_GT(with_points, 200);
}

/// Scaling either quadric by a power of two moves no point: nothing is rounded otherwise.
TEST(PointsInPlane, DoNotDependOnTheScaleOfTheForms) {
  Random random("PointsInPlane.DoNotDependOnTheScaleOfTheForms");
  const auto planes = standard_pencil<double>();
  for (int i = 0; i < 200; ++i) {
    const auto [a, b] = random_chord_pair(random);
    const double t = random.normal();
    const SectionPoints found = points_in_plane({a, b, planes}, 1, t);
    for (const double factor : {0x1p-40, 0x1p60}) {
      const SectionPoints other = points_in_plane({a, scaled(b, factor), planes}, 1, t);
      ASSERT_EQ(other.count, found.count) << i;
      for (std::size_t k = 0; k < 2 && static_cast<int>(k) < found.count; ++k) {
        const Point<double> u = found.point[k].normalized(), v = other.point[k].normalized();
        EXPECT_EQ(std::min((u - v).norm(), (u + v).norm()), 0) << i;
      }
    }
  }
}

/// The exact count of the exact section conics, and the sign of the discriminant: positive for 0 or 4, negative for 2.
TEST(PointsInPlane, OfAnyAxisAreAsManyAsTheConicsHave) {
  Random random("PointsInPlane.OfAnyAxisAreAsManyAsTheConicsHave");
  std::array<int, 5> seen{};
  for (int i = 0; i < 60; ++i) {
    const auto a = random_quadric<double>(random), b = random_quadric<double>(random);
    const auto exactly = exact_sections(a, b);
    const auto D = exactly.discriminant();
    if (exactly.axis_is_chord() || !square_free(D)) continue;
    const QuadricSections<double> sections(a, b, standard_pencil<double>());
    int last = -1;
    for (const double t : planes_between_zeros(D)) {
      const SectionPoints found = points_in_plane(sections, 1, t);
      const Rational one(1), u(t);
      const auto count = count_common_points(exactly.conic(0, one, u), exactly.conic(1, one, u));
      ASSERT_TRUE(count) << i;
      EXPECT_EQ(found.count, *count) << i << " t " << t;
      EXPECT_EQ(*count == 2, D(one, u) < 0) << i;
      if (last >= 0) {  // every zero is a turning point
        EXPECT_EQ(std::abs(last - *count), 2) << i;
      }
      last = *count;
      ++seen[static_cast<std::size_t>(*count)];
      expect_on_both(a, b, 1, t, found, 4096, "case " + std::to_string(i));
    }
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[2], 20);
  EXPECT_GT(seen[4], 5);
}

/// A point of both quadrics is found in its plane, whatever the axis.
TEST(PointsInPlane, FindAGivenPoint) {
  Random random("PointsInPlane.FindAGivenPoint");
  for (int i = 0; i < 300; ++i) {
    Point<double> x, u, v;
    for (int k = 0; k < 4; ++k) x[k] = random.normal(), u[k] = random.normal(), v[k] = random.normal();
    std::array<Quadric<double>, 2> pair;
    for (auto& s : pair) {
      for (double& q : s.q) q = random.normal();
      s.add_product(x, x, -s(x) / (x.squaredNorm() * x.squaredNorm()));
    }
    const QuadricSections<double> sections(pair[0], pair[1], planes_through<double>(u, v));
    Matrix<double, 4, 4> frame;
    frame << u, v, sections.planes().W[0], sections.planes().W[1];
    const Point<double> y = Eigen::Matrix4d(frame).inverse() * x;
    const SectionPoints found = points_in_plane(sections, y[2], y[3]);
    double nearest = 1;
    for (int k = 0; k < found.count; ++k) {
      const Point<double> z = found.point[static_cast<std::size_t>(k)].normalized(), w = x.normalized();
      nearest = std::min({nearest, (z - w).norm(), (z + w).norm()});
    }
    EXPECT_LT(nearest, 1e-6) << i;
  }
}

/// Two quadrics through the axis: a twisted cubic beside it, one point in each plane. x1 x2 = x0 x3 and x0 x2
/// = x1^2.. in coordinates (1, t, t^2, t^3): the plane (1 : t) through x0 = x1 = 0 holds (1, t, t^2, t^3).
TEST(PointsInPlane, OfACommonAxisIsOneOfATwistedCubic) {
  const Quadric<double> a{{0, 0, 0, 0, 0, 0, -1, 1, 0, 0}}, b{{0, -1, 0, 0, 0, 1, 0, 0, 0, 0}};
  const QuadricSections<double> sections(a, b, standard_pencil<double>());
  EXPECT_TRUE(sections.axis_is_chord());
  EXPECT_TRUE(sections.axis_is_common());
  for (int k = -5; k <= 5; ++k) {
    const double t = k / 4.0;
    const SectionPoints found = points_in_plane(sections, 1, t);
    ASSERT_EQ(found.count, 1);
    const Point<double> x = found.point[0] / found.point[0][0];
    EXPECT_EQ(x, Point<double>(1, t, t * t, t * t * t));
  }
}

/// Equal surfaces, and a plane that holds a conic of the curve.
TEST(PointsInPlane, SayWhereThePlaneHoldsACurve) {
  const Quadric<double> sphere{{-1, 1, 1, 1}};
  EXPECT_TRUE(points_in_plane({sphere, sphere, standard_pencil<double>()}, 1, 0.5).holds_curve);
  Quadric<double> other = sphere;
  other.add_product(Point<double>(1, -2, 0, 0), Point<double>(1, 0, 3, 0), 1);  // meet in x1 = x0 / 2 too
  const QuadricSections<double> sections(sphere, other, standard_pencil<double>());
  EXPECT_TRUE(points_in_plane(sections, 1, 0.5).holds_curve);
  EXPECT_FALSE(points_in_plane(sections, 1, 0.25).holds_curve);
}

}  // namespace
}  // namespace burmester
