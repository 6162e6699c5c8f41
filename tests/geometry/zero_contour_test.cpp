#include "burmester/geometry/zero_contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace burmester {
namespace {

TEST(ZeroContour, CircleIsClosedAndWithinTheSquareOfTheCell) {
  const SampledSquare f = sampled(1, 40, [](double u, double v) { return u * u + v * v - 0.47; });
  const auto segments = zero_contour(f);
  ASSERT_GT(segments.size(), 50u);
  std::map<std::pair<long, long>, int> ends;
  double length = 0;
  for (const ContourSegment& s : segments) {
    length += std::hypot(s.to[0] - s.from[0], s.to[1] - s.from[1]);
    for (const auto& p : {s.from, s.to}) {
      EXPECT_NEAR(std::hypot(p[0], p[1]), std::sqrt(0.47), 0.05 * 0.05);
      ++ends[{std::lround(p[0] * 1e9), std::lround(p[1] * 1e9)}];
    }
  }
  for (const auto& [point, count] : ends) EXPECT_EQ(count, 2);  // every end is joined to one other
  EXPECT_NEAR(length, 2 * std::numbers::pi * std::sqrt(0.47), 0.01);
}

TEST(ZeroContour, SegmentsJoinToWholeCurves) {
  const auto circle = joined(zero_contour(sampled(1, 40, [](double u, double v) { return u * u + v * v - 0.47; })));
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(circle[0].front(), circle[0].back());
  const auto hyperbola = joined(zero_contour(sampled(1, 40, [](double u, double v) { return u * v - 0.11; })));
  ASSERT_EQ(hyperbola.size(), 2u);
  for (const auto& branch : hyperbola)  // each from one side of the square to another
    for (const auto& end : {branch.front(), branch.back()})
      EXPECT_EQ(std::max(std::abs(end[0]), std::abs(end[1])), 1);
}

TEST(ZeroContour, SaddlesAreJoinedTheWayTheMiddleSays) {
  for (const double level : {-0.1, 0.1}) {
    const SampledSquare f = sampled(1, 1, [&](double u, double v) { return u * v + level; });
    const auto segments = zero_contour(f);
    ASSERT_EQ(segments.size(), 2u);
    for (const ContourSegment& s : segments) {  // a branch of the hyperbola stays in one quadrant
      const double side = s.from[0] * s.from[1];
      EXPECT_LT(side * level, 0);
      EXPECT_GT(side * (s.to[0] * s.to[1]), 0);
    }
  }
}

TEST(ZeroContour, NothingWhereTheSignIsConstant) {
  EXPECT_TRUE(zero_contour(sampled(1, 10, [](double, double) { return 1.0; })).empty());
  EXPECT_TRUE(zero_contour(sampled(1, 10, [](double, double) { return 0.0; })).empty());
}

TEST(ZeroContour, CrossingsOfALineAndACircle) {
  const auto circle = zero_contour(sampled(1, 100, [](double u, double v) { return u * u + v * v - 0.5; }));
  const auto line = zero_contour(sampled(1, 100, [](double u, double v) { return v - 0.3 * u - 0.1; }));
  auto points = crossings(circle, line);
  ASSERT_EQ(points.size(), 2u);
  std::sort(points.begin(), points.end());
  // 1.09 u^2 + 0.06 u - 0.49 = 0
  for (const int k : {0, 1}) {
    const double u = (-0.06 + (k == 0 ? -1 : 1) * std::sqrt(0.06 * 0.06 + 4 * 1.09 * 0.49)) / (2 * 1.09);
    EXPECT_NEAR(points[static_cast<std::size_t>(k)][0], u, 1e-3);
    EXPECT_NEAR(points[static_cast<std::size_t>(k)][1], 0.3 * u + 0.1, 1e-3);
  }
}

}  // namespace
}  // namespace burmester
