// The diameter against all pairs of points.
#include "burmester/geometry/diameter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Points = std::vector<Vector<double, 2>>;

double of_all_pairs(const Points& points) {
  double out = 0;
  for (const auto& a : points)
    for (const auto& b : points) out = std::max(out, std::hypot(b[0] - a[0], b[1] - a[1]));
  return out;
}

TEST(Diameter, OfRandomPointsOfEverySizeAndScale) {
  Random random("Diameter.OfRandomPointsOfEverySizeAndScale");
  for (int i = 0; i < 3000; ++i) {
    const double unit = std::ldexp(1, random.below(2000) - 1000);
    Points points(static_cast<std::size_t>(1 + random.below(12)));
    for (auto& p : points) p = {unit * random.normal(), unit * random.normal()};
    EXPECT_EQ(diameter(points), of_all_pairs(points)) << i;
  }
}

/// Equal points, points in one line, parallel edges.
TEST(Diameter, OfPointsOfAGrid) {
  Random random("Diameter.OfPointsOfAGrid");
  for (int i = 0; i < 5000; ++i) {
    const int width = 1 + random.below(5), height = 1 + random.below(3);
    Points points(static_cast<std::size_t>(1 + random.below(14)));
    for (auto& p : points) p = {double(random.below(width)), double(random.below(height))};
    EXPECT_EQ(diameter(points), of_all_pairs(points)) << i;
  }
}

TEST(Diameter, OfPointsInALineButForRounding) {
  Random random("Diameter.OfPointsInALineButForRounding");
  for (int i = 0; i < 2000; ++i) {
    const Vector<double, 2> base(random.normal(), random.normal()), along(random.normal(), random.normal());
    Points points(20);
    for (auto& p : points) p = base + random.normal() * along;
    EXPECT_NEAR(diameter(points), of_all_pairs(points), 1e-15 * of_all_pairs(points)) << i;
  }
}

/// All are vertices of the hull, and each is as far from the one opposite to it as any other, but for rounding.
TEST(Diameter, OfPointsOfACircle) {
  Points points(1500);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points.size());
    points[k] = {3 + std::cos(angle), std::sin(angle) - 2};
  }
  EXPECT_NEAR(diameter(points), of_all_pairs(points), 4e-16);
  points.resize(700);  // less than a half circle
  EXPECT_NEAR(diameter(points), of_all_pairs(points), 4e-16);
}

TEST(Diameter, OfNoPointsIsZero) {
  EXPECT_EQ(diameter({}), 0);
  EXPECT_EQ(diameter({{1, 2}}), 0);
  EXPECT_EQ(diameter({{1, 2}, {1, 2}}), 0);
}

}  // namespace
}  // namespace burmester
