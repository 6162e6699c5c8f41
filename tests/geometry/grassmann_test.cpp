#include "burmester/geometry/grassmann.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "moved_forms.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

template <int n, std::size_t count>
std::array<Vector<double, n>, count> rounded(const std::array<Vector<Rational, n>, count>& points) {
  std::array<Vector<double, n>, count> out;
  for (std::size_t i = 0; i < count; ++i) out[i] = points[i].template cast<double>();
  return out;
}
template <int n, std::size_t count>
std::array<Vector<Rational, n>, count> random_points(Random& random) {
  std::array<Vector<Rational, n>, count> out;
  for (auto& p : out) p = random_rationals<n>(random);
  return out;
}

/// M. J. D. Hayes, course notes on Grassmannians: x^2 + y^2 - 2 x z - 2 y z + z^2 = 0, centre (1, 1), radius 1.
TEST(CircleThrough, ReproducesThePublishedCircle) {
  const std::array<Point2<double>, 3> points{Point2<double>(2, 1, 1), {1, 2, 1}, {0, 1, 1}};
  const auto K = circle_through(points);
  ASSERT_TRUE(K);
  EXPECT_LT((*K / (*K)[0] - Vector<double, 4>(1, -1, -1, 1)).norm(), 1e-15);
}

/// Two of the published feature-extraction points are enough for the line: x - y = 1 through (2, 1) and (3, 2).
TEST(LineThrough, IsTheJoin) {
  const auto line = line_through<double>({Point2<double>(2, 1, 1), {3, 2, 1}});
  ASSERT_TRUE(line);
  EXPECT_LT((*line / (*line)[0] - LinearForm<double>(1, -1, -1)).norm(), 1e-15);
  Random random("LineThrough.IsTheJoin");
  for (int i = 0; i < 100; ++i) {
    const auto p = random_points<3, 2>(random);
    const Point2<Rational> join = p[0].cross(p[1]);
    const auto exactly = line_through(p);
    ASSERT_EQ(exactly.has_value(), !join.isZero(0)) << i;
    if (exactly) {
      EXPECT_TRUE(exactly->cross(join).isZero(0)) << i;
    }
  }
}

TEST(PlaneThrough, HoldsItsPoints) {
  Random random("PlaneThrough.HoldsItsPoints");
  for (int i = 0; i < 100; ++i) {
    auto p = random_points<4, 3>(random);
    const auto plane = plane_through(p);
    ASSERT_TRUE(plane) << i;
    EXPECT_FALSE(plane->isZero(0));
    for (const auto& x : p) EXPECT_EQ(Rational(plane->dot(x)), 0) << i;
    p[2] = 3 * p[0] - p[1] / 2;
    EXPECT_FALSE(plane_through(p)) << i;
    for (auto& x : p) x *= 1260;  // whole numbers: denominators are up to 9, and 2
    EXPECT_FALSE(plane_through(rounded(p))) << i;
  }
}

TEST(CircleThrough, HoldsItsPoints) {
  Random random("CircleThrough.HoldsItsPoints");
  for (int i = 0; i < 200; ++i) {
    const auto p = random_points<3, 3>(random);
    const auto K = circle_through(p);
    ASSERT_TRUE(K) << i;
    for (const auto& x : p)
      EXPECT_EQ((*K)[0] * (x[0] * x[0] + x[1] * x[1]) + 2 * ((*K)[1] * x[0] + (*K)[2] * x[1]) * x[2] +
                    (*K)[3] * x[2] * x[2],
                0)
          << i;
  }
}

TEST(CircleThrough, OfCollinearPointsIsTheirLine) {
  const auto K = circle_through<double>({Point2<double>(0, 1, 1), {1, 2, 1}, {5, 6, 1}});  // y = x + 1
  ASSERT_TRUE(K);
  EXPECT_NEAR((*K)[0], 0, 1e-15);
  EXPECT_NEAR((*K)[1], -(*K)[2], 1e-15);
  EXPECT_NEAR((*K)[3], 2 * (*K)[1], 1e-15);
}

TEST(CircleThrough, IsEmptyForRepeatedPoints) {
  const Point2<double> a(1, 2, 1), b(3, -1, 1);
  EXPECT_FALSE(circle_through<double>({a, b, Point2<double>(-2 * a)}));
  EXPECT_FALSE(circle_through<double>({a, b, Point2<double>::Zero()}));
  Point2<double> near = a;
  near[0] = std::nextafter(near[0], 2);
  const auto K = circle_through<double>({a, b, near});  // tangent to y = 2 there
  ASSERT_TRUE(K);
  EXPECT_TRUE(K->allFinite());
  const Vector<double, 2> centre(-(*K)[1] / (*K)[0], -(*K)[2] / (*K)[0]);
  EXPECT_NEAR(centre[0], 1, 1e-15);
  EXPECT_NEAR((centre - Vector<double, 2>(1, 2)).norm(), (centre - Vector<double, 2>(3, -1)).norm(), 1e-15);
}

TEST(ConicThrough, FindsTheConicOfItsPoints) {
  Random random("ConicThrough.FindsTheConicOfItsPoints");
  for (int i = 0; i < 100; ++i) {
    const auto p = random_points<3, 5>(random);
    const auto c = conic_through(p);
    ASSERT_TRUE(c) << i;
    for (const auto& x : p) EXPECT_EQ((*c)(x), 0) << i;
  }
}

TEST(ConicThrough, IsEmptyWhereManyConicsPass) {
  Random random("ConicThrough.IsEmptyWhereManyConicsPass");
  for (int i = 0; i < 100; ++i) {
    auto p = random_points<3, 5>(random);
    p[2] = p[0] - 2 * p[1], p[3] = p[0] + 3 * p[1];
    EXPECT_FALSE(conic_through(p)) << i;
    for (auto& x : p) x *= 2520;
    EXPECT_FALSE(conic_through(rounded(p))) << i;
    p[3] = random_rationals<3>(random);  // three on a line: a pair of lines
    const auto c = conic_through(p);
    ASSERT_TRUE(c) << i;
    EXPECT_EQ(Adjugate<Rational>(*c).determinant(*c), 0) << i;
  }
}

TEST(QuadricThrough, FindsTheQuadricOfItsPoints) {
  Random random("QuadricThrough.FindsTheQuadricOfItsPoints");
  for (int i = 0; i < 20; ++i) {
    const auto p = random_points<4, 9>(random);
    const auto s = quadric_through(p);
    ASSERT_TRUE(s) << i;
    for (const auto& x : p) EXPECT_EQ((*s)(x), 0) << i;
  }
}

std::array<Point3<double>, 9> curve(auto&& point) {
  std::array<Point3<double>, 9> p;
  for (int k = 0; k < 9; ++k) p[static_cast<std::size_t>(k)] = point(k - 4.0);
  return p;
}

TEST(QuadricThrough, IsEmptyOnATwistedCubic) {  // three independent quadrics hold it
  EXPECT_FALSE(quadric_through(curve([](double t) { return Point3<double>(1, t, t * t, t * t * t); })));
}

TEST(QuadricThrough,
     IsEmptyOnACommonCurveOfTwo) {  // x^2 + y^2 = z^2, z w = 0: points of a circle and of a line pair
  EXPECT_FALSE(
      quadric_through(curve([](double t) { return Point3<double>(1 - t * t, 2 * t, 1 + t * t, 0); })));
}

/// x0 x3 = x1 x2 is the only quadric through the quartic.
TEST(QuadricThrough, IsTheOnlyOneOnARationalQuartic) {
  const auto s =
      quadric_through(curve([](double t) { return Point3<double>(1, t, t * t * t, t * t * t * t); }));
  ASSERT_TRUE(s);
  for (std::size_t k = 0; k < 10; ++k)
    EXPECT_NEAR(s->q[k] / s->q[6], k == 6 ? 1 : k == 7 ? -1 : 0, 1e-9) << k;
}

/// Rounding the points moves the form by the roundoff over the last pivot at most; normal data keeps nine digits.
TEST(Through, DoublesAgreeWithExactArithmetic) {
  Random random("Through.DoublesAgreeWithExactArithmetic");
  for (int i = 0; i < 50; ++i) {
    std::array<Point3<double>, 9> p;
    std::array<Point3<Rational>, 9> q;
    for (std::size_t k = 0; k < 9; ++k)
      for (int j = 0; j < 4; ++j) p[k][j] = random.normal(), q[k][j] = Rational(p[k][j]);
    const auto s = quadric_through(p);
    const auto exactly = quadric_through(q);
    ASSERT_TRUE(s && exactly);
    EXPECT_EQ(size_of(*s), 1);
    int largest = 0;
    for (int k = 0; k < 10; ++k)
      if (std::abs(s->q[static_cast<std::size_t>(k)]) == 1) largest = k;
    for (std::size_t k = 0; k < 10; ++k) {
      const double expected =
          static_cast<double>(Rational(exactly->q[k] / exactly->q[static_cast<std::size_t>(largest)])) *
          s->q[static_cast<std::size_t>(largest)];
      EXPECT_NEAR(s->q[k], expected, 1e-9) << i;
    }
  }
}

/// Any finite numbers: an answer of finite numbers or none.
TEST(Through, NeverIsNotANumber) {
  Random random("Through.NeverIsNotANumber");
  for (int i = 0; i < 300; ++i) {
    std::array<Point2<double>, 5> p;
    for (auto& x : p)
      for (int j = 0; j < 3; ++j)
        x[j] = random.below(3) ? std::ldexp(random.normal(), random.below(2000) - 1000) : 0;
    if (i % 3 == 0) p[4] = p[1];
    if (const auto c = conic_through(p)) {
      EXPECT_NE(i % 3, 0);
      EXPECT_EQ(size_of(*c), 1) << i;
      for (const double q : c->q) EXPECT_TRUE(std::isfinite(q)) << i;
    }
  }
}

}  // namespace
}  // namespace burmester
