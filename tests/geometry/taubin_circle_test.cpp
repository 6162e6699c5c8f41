// The algebraic circle fit: exact on circles, blind to frames, and silent on lines.
#include "burmester/geometry/taubin_circle.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Point = Vector<double, 2>;

std::vector<Point> on_circle(Random& random, const Point& centre, double radius, int count) {
  std::vector<Point> out;
  for (int i = 0; i < count; ++i) {
    const double t = random.uniform(-3, 3);
    out.push_back(centre + radius * Point(std::cos(t), std::sin(t)));
  }
  return out;
}

TEST(TaubinCircle, FindsTheCircleOfItsPoints) {
  Random random("CircleFit.FindsTheCircleOfItsPoints");
  for (int i = 0; i < 200; ++i) {
    const Point centre(random.normal(), random.normal());
    const double radius = 0.1 + std::abs(random.normal());
    const auto fit = taubin_circle(on_circle(random, centre, radius, 5 + i % 5));
    ASSERT_TRUE(fit) << i;
    EXPECT_LT((fit->centre - centre).norm(), 1e-9) << i;
    EXPECT_NEAR(fit->radius, radius, 1e-9) << i;
  }
}

TEST(TaubinCircle, TurnsShiftsAndScalesWithThePoints) {
  Random random("CircleFit.TurnsShiftsAndScalesWithThePoints");
  for (int i = 0; i < 100; ++i) {
    std::vector<Point> points, moved;
    for (int k = 0; k < 7; ++k) points.push_back({random.normal(), random.normal()});
    const double angle = random.uniform(-3, 3), scale = std::exp(random.normal());
    const Point shift(random.normal(), random.normal());
    const auto move = [&](const Point& p) {
      return Point(scale * Point(std::cos(angle) * p[0] - std::sin(angle) * p[1],
                                 std::sin(angle) * p[0] + std::cos(angle) * p[1]) +
                   shift);
    };
    for (const Point& p : points) moved.push_back(move(p));
    const auto a = taubin_circle(points), b = taubin_circle(moved);
    ASSERT_TRUE(a && b);
    EXPECT_LT((move(a->centre) - b->centre).norm(), 1e-8 * (1 + b->radius)) << i;
    EXPECT_NEAR(scale * a->radius, b->radius, 1e-8 * (1 + b->radius)) << i;
  }
}

TEST(TaubinCircle, LinesAndSinglePointsHaveNone) {
  EXPECT_FALSE(taubin_circle(std::vector<Point>{{2, 3}, {2, 3}, {2, 3}}));
  const auto line = taubin_circle(std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {5, 0}});
  EXPECT_GT(line ? line->radius : 1e300, 1e12);  // rounding may bend it
}

}  // namespace
}  // namespace burmester
