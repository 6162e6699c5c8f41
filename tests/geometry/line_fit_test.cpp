#include "burmester/geometry/line_fit.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Points = std::vector<Vector<double, 2>>;

Points random_points(Random& random, int n) {
  Points out;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    out.emplace_back(x, random.normal());
  }
  return out;
}

double squared_distances(const Points& points, const Vector<double, 2>& centre, double angle) {
  double sum = 0;
  for (const auto& p : points) {
    const Vector<double, 2> d = p - centre;
    sum += std::pow(d[0] * std::sin(angle) - d[1] * std::cos(angle), 2);
  }
  return sum;
}

TEST(FitLine, IsTheBestOfAllLines) {
  Random random("FitLine.IsTheBestOfAllLines");
  for (int i = 0; i < 50; ++i) {
    const Points points = random_points(random, 5);
    const FittedLine line = fit_line(points);
    const double angle = std::atan2(line.direction[1], line.direction[0]);
    const double best = squared_distances(points, line.centre, angle);
    for (int k = 1; k < 60; ++k)
      EXPECT_LE(best,
                squared_distances(points, line.centre, angle + k * std::numbers::pi / 60) * (1 + 1e-13));
    const Vector<double, 2> aside =
        line.centre + Vector<double, 2>(-line.direction[1], line.direction[0]) * 1e-3;
    EXPECT_LT(best, squared_distances(points, aside, angle));
  }
}

TEST(FitLine, FindsPointsOnALine) {
  Random random("FitLine.FindsPointsOnALine");
  for (int i = 0; i < 100; ++i) {
    const double angle = random.uniform(0, std::numbers::pi), offset = random.normal();
    const Vector<double, 2> along(std::cos(angle), std::sin(angle)), normal(-along[1], along[0]);
    Points points;
    for (int k = 0; k < 5; ++k) points.emplace_back(offset * normal + random.normal() * along);
    const FittedLine line = fit_line(points);
    EXPECT_NEAR(std::abs(line.direction.dot(normal)), 0, 1e-14);
    EXPECT_NEAR(line.centre.dot(normal), offset, 1e-15 * 8);
    EXPECT_LT(line.departure, 1e-14);
  }
}

TEST(FitLine, DepartureIsTheLargestDistance) {
  const Points points{{-1, 0}, {1, 0}, {-2, 0.25}, {2, -0.25}, {0, 0}};
  const FittedLine line = fit_line(points);
  double largest = 0;
  for (const auto& p : points)
    largest = std::max(
        largest, std::abs((p - line.centre).dot(Vector<double, 2>(-line.direction[1], line.direction[0]))));
  EXPECT_DOUBLE_EQ(line.departure, largest);
  EXPECT_GT(line.departure, 0.05);
}

TEST(FitLine, VerticalAndHorizontal) {
  const Points up{{3, -1}, {3, 5}}, across{{-2, 7}, {4, 7}};
  EXPECT_NEAR(fit_line(up).direction[0], 0, 1e-16);
  EXPECT_EQ(fit_line(across).direction[1], 0);
  EXPECT_LT(fit_line(up).departure, 1e-15);
}

TEST(FitLine, CoincidingPointsDepartFromNothing) {
  const Points same(4, {1.5, -2});
  const FittedLine line = fit_line(same);
  EXPECT_EQ(line.departure, 0);
  EXPECT_NEAR(line.direction.norm(), 1, 1e-15);
}

}  // namespace
}  // namespace burmester
