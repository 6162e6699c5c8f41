#include "burmester/geometry/quadric_curve.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Point = Point3<double>;

const Point X0(1, 0, 0, 0), X1(0, 1, 0, 0), X2(0, 0, 1, 0), X3(0, 0, 0, 1);

Point random_point(Random& r) {
  Point x;
  for (int i = 0; i < 4; ++i) x[i] = r.normal();
  return x.normalized();
}
/// A random quadric through x.
Quadric<double> random_quadric(Random& r, const Point& x) {
  Quadric<double> s;
  for (double& q : s.q) q = r.normal();
  s.add_product(x, x, -s(x));
  return s;
}
/// x1^2 + x2^2 + x3^2 = x0^2
Quadric<double> sphere() { return {{-1, 1, 1, 1}}; }
Quadric<double> planes(const Point& l, const Point& m) {
  Quadric<double> s;
  s.add_product(l, m, 1);
  return s;
}

TEST(QuadricCurve, WalksCloseAndStayOnTheCurve) {
  Random random("QuadricCurve.WalksCloseAndStayOnTheCurve");
  for (int i = 0; i < 200; ++i) {
    const Point start = random_point(random);
    const Quadric<double> a = random_quadric(random, start), b = random_quadric(random, start);
    const Walk w = walk(QuadricCurve(a, b), start);
    ASSERT_TRUE(w.closed) << "case " << i << ", " << w.points.size() << " points";
    EXPECT_EQ(w.start, 0u);
    for (std::size_t k = 0; k < w.points.size(); ++k) {
      const Point& x = w.points[k];
      const Point next = k + 1 < w.points.size() ? w.points[k + 1] : aligned(w.points[0], x);
      EXPECT_LT(std::abs(a(x)) + std::abs(b(x)), 1e-12) << "case " << i;
      EXPECT_LT((next - x).norm(), 0.04) << "case " << i << " gap at " << k << " of " << w.points.size();
    }
  }
}

TEST(QuadricCurve, AWalkFromAnyOfItsPointsIsTheSameWalk) {
  Random random("QuadricCurve.AWalkFromAnyOfItsPointsIsTheSameWalk");
  for (int i = 0; i < 20; ++i) {
    const Point start = random_point(random);
    const QuadricCurve curve(random_quadric(random, start), random_quadric(random, start));
    const Walk w = walk(curve, start);
    const Walk other = walk(curve, w.points[w.points.size() / 3]);
    ASSERT_TRUE(other.closed);
    for (const Walk* one : {&w, &other})
      for (const Point& x : one->points) {
        const Walk& two = one == &w ? other : w;
        const Point& y = two.points[nearest_point(two, x)];
        EXPECT_LT((aligned(y, x) - x).norm(), 0.021) << "case " << i;
      }
  }
}

TEST(QuadricCurve, StartsNearTheCurve) {
  Random random("QuadricCurve.StartsNearTheCurve");
  const Point start = random_point(random);
  const QuadricCurve curve(random_quadric(random, start), random_quadric(random, start));
  const Walk w = walk(curve, -3 * start + 1e-4 * random_point(random));
  ASSERT_TRUE(w.closed);
  EXPECT_LT(curve.distance(w.points[0]), 1e-14);
  EXPECT_LT((aligned(w.points[0], start) - start).norm(), 1e-3);
}

TEST(QuadricCurve, WalksStraightOverACrossing) {
  const Walk w = walk(QuadricCurve(sphere(), planes(X1, X2)), X0 + 0.6 * X1 + 0.8 * X3);
  ASSERT_TRUE(w.closed);
  for (const Point& x : w.points) EXPECT_LT(std::abs(x[2]), 1e-12);
  EXPECT_NEAR(static_cast<double>(w.points.size()) * 0.02, std::sqrt(2.0) * 3.2, 1.5);
}

TEST(QuadricCurve, DoesNotJumpANarrowGap) {
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    Quadric<double> b = planes(X1, X2);
    b.add_product(X0, X0, -gap);  // x1 x2 = gap: one component with x1 > 0, one with x1 < 0
    const Walk w = walk(QuadricCurve(sphere(), b), X0 + 0.6 * X1 + 0.8 * X3 + gap / 0.6 * X2);
    ASSERT_TRUE(w.closed) << gap;
    for (const Point& x : w.points) EXPECT_GT(x[1] * x[0], 0) << gap;
  }
}

/// Narrower still: the walk may take either way, but it comes to an end and stays on the curve.
TEST(QuadricCurve, EndsAtAnyGap) {
  Random random("QuadricCurve.EndsAtAnyGap");
  for (int i = 0; i < 300; ++i) {
    const double gap = std::pow(10.0, random.uniform(-17, -8)) * (random.below(2) ? 1 : -1);
    const Point l = random_point(random), m = random_point(random);
    Quadric<double> a = sphere(), b = planes(l, m);
    b.add_product(X0, X0, -gap);
    const std::optional<Point> start = QuadricCurve(a, b).corrected(random_point(random));
    if (!start) continue;
    const Walk w = walk(QuadricCurve(a, b), *start);
    EXPECT_TRUE(w.closed) << "case " << i << " gap " << gap << " points " << w.points.size();
    for (const Point& x : w.points) EXPECT_LT(std::abs(a(x)) + std::abs(b(x)), 1e-10);
  }
}

/// A loop 1e-3 wide and 1 long: sharp turns are walked round, not taken for crossings.
TEST(QuadricCurve, WalksRoundHairpins) {
  for (const double width : {1e-1, 1e-2, 1e-3}) {
    const Quadric<double> loop{{-0.25, 1, 1 / (width * width), 0}};  // x1^2 + (x2 / width)^2 = 1/4
    const QuadricCurve curve(sphere(), loop);
    const Walk w = walk(curve, X0 + std::sqrt(0.75) * X3 + 0.5 * width * X2);
    ASSERT_TRUE(w.closed) << width;
    double left = 0, right = 0;
    for (const Point& x : w.points) left = std::min(left, x[1] / x[0]), right = std::max(right, x[1] / x[0]);
    EXPECT_NEAR(left, -0.5, 1e-3) << width;
    EXPECT_NEAR(right, 0.5, 1e-3) << width;
    for (const Point& x : w.points) EXPECT_GT(x[0] * x[3], 0) << width;
  }
}

TEST(QuadricCurve, StopsAndTurnsBack) {
  WalkOptions options;
  options.stop = [](const Point& x) { return x[3] < 0; };
  const Walk w = walk(QuadricCurve(sphere(), planes(X2, X0)), X0 + 0.6 * X1 + 0.8 * X3, options);
  EXPECT_FALSE(w.closed);
  EXPECT_EQ(w.ends[0], WalkEnd::stopped);
  EXPECT_EQ(w.ends[1], WalkEnd::stopped);
  ASSERT_GT(w.start, 10u);
  EXPECT_LT((w.points[w.start] - (X0 + 0.6 * X1 + 0.8 * X3).normalized()).norm(), 1e-12);
  for (std::size_t k = 0; k < w.points.size(); ++k) {
    EXPECT_GE(w.points[k][3], 0);
    EXPECT_LT((w.points[k] - w.points[k ? k - 1 : 0]).norm(), 0.03);
  }
  EXPECT_LT(w.points.front()[1] * w.points.back()[1], 0);
  EXPECT_EQ(nearest_point(w, -w.points[w.start]), w.start);
}

TEST(QuadricCurve, ReportsStartsThatShowNoDirection) {
  const Walk crossing = walk(QuadricCurve(sphere(), planes(X1, X2)), X0 + X3);
  EXPECT_EQ(crossing.ends[0], WalkEnd::singular);
  EXPECT_LE(crossing.points.size(), 1u);
  const Walk vertex = walk(QuadricCurve({{0, 1, 1, -1}}, planes(X1, X2)), X0);
  EXPECT_EQ(vertex.ends[0], WalkEnd::singular);
  const Walk twice = walk(QuadricCurve(planes(X1, X1), sphere()), X0 + X3);
  EXPECT_EQ(twice.ends[0], WalkEnd::singular);
}

TEST(QuadricCurve, NoCurveNoWalk) {
  Quadric<double> far = planes(X1, X1);
  far.add_product(X0, X0, -4);  // x1 = +-2 misses the sphere
  const Walk w = walk(QuadricCurve(sphere(), far), X0 + X1);
  EXPECT_TRUE(w.points.empty());
  EXPECT_FALSE(w.closed);
}

TEST(QuadricCurve, IsCappedAtTheMostPoints) {
  WalkOptions options;
  options.most_points = 10;
  const Walk w = walk(QuadricCurve(sphere(), planes(X2, X0)), X0 + X3, options);
  EXPECT_EQ(w.ends[0], WalkEnd::too_long);
  EXPECT_EQ(w.points.size(), 19u);
}

}  // namespace
}  // namespace burmester
