#include "burmester/geometry/number.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

double random_size(Random& random) { return std::ldexp(1 + random.uniform(), random.below(2040) - 1020); }

bool is_power_of_two(double x) {
  int exponent;
  return std::frexp(x, &exponent) == 0.5;
}

TEST(PowerOfTwoBelow, IsTheLargestNotAboveX) {
  Random random("PowerOfTwoBelow.IsTheLargestNotAboveX");
  for (int i = 0; i < 10000; ++i) {
    const double x = random_size(random), p = power_of_two_below(x);
    EXPECT_TRUE(is_power_of_two(p) && p <= x && x / 2 < p) << x;
  }
  for (int e = -1022; e <= 1023; ++e) EXPECT_EQ(power_of_two_below(std::ldexp(1.0, e)), std::ldexp(1.0, e));
}

TEST(UnitScale, IsItsInverse) {
  Random random("UnitScale.IsItsInverse");
  for (int i = 0; i < 10000; ++i) {
    const double x = random_size(random);
    EXPECT_EQ(unit_scale(x) * power_of_two_below(x), 1) << x;
    EXPECT_TRUE(1 <= x * unit_scale(x) && x * unit_scale(x) < 2) << x;
  }
  EXPECT_EQ(unit_scale(1), 1);
  EXPECT_EQ(unit_scale(std::numeric_limits<double>::min()), 0x1p1022);
}

TEST(Approximate, IsTheNearestDouble) {
  EXPECT_EQ(approximate(0.1), 0.1);
  EXPECT_EQ(approximate(Quad(1) / 3), 1.0 / 3);
}

TEST(UnitRoundoff, IsHalfTheGapAboveOne) {
  EXPECT_EQ(1 + unit_roundoff, 1);
  EXPECT_GT(1 + 1.5 * unit_roundoff, 1);
}

}  // namespace
}  // namespace burmester
