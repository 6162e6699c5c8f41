// Derivatives by jets against the rules of calculus over rationals.
#include "burmester/geometry/jet.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Jet2 = Jet<double, 2>;

TEST(Jet, FollowsTheRulesOfCalculus) {
  const Jet2 x = Jet2::variable(3, 0, 1), y = Jet2::variable(-2, 1, 1);
  const Jet2 f = (x * x * y - 4 * x) / (y + Jet2(7.0)) + (-y);  // value (-18 - 12) / 5 + 2
  EXPECT_DOUBLE_EQ(f.value, -4);
  EXPECT_DOUBLE_EQ(f.slope[0], (2.0 * 3 * -2 - 4) / 5);
  EXPECT_DOUBLE_EQ(f.slope[1], 9.0 / 5 + 30.0 / 25 - 1);
}

TEST(Jet, VariablesHaveTheirOwnUnit) {
  const Jet2 x = Jet2::variable(3, 0, 10), square = x * x;
  EXPECT_DOUBLE_EQ(square.slope[0], 60);
  EXPECT_DOUBLE_EQ(square.slope[1], 0);
}

TEST(Jet, AProductMayBeItsOwnFactor) {
  Jet2 x = Jet2::variable(3, 0, 1);
  x *= x;
  EXPECT_DOUBLE_EQ(x.value, 9);
  EXPECT_DOUBLE_EQ(x.slope[0], 6);
  x /= x;
  EXPECT_DOUBLE_EQ(x.value, 1);
  EXPECT_DOUBLE_EQ(x.slope[0], 0);
}

/// The null space of a matrix whose entry (0, 0) varies, against the difference of two eliminations.
TEST(Jet, GoesThroughAnElimination) {
  const std::string stream = "Jet.GoesThroughAnElimination";
  Random random(stream);
  for (int n = 0; n < 50; ++n) {
    Matrix<double, 2, 4> m;
    for (int i = 0; i < 8; ++i) m(i) = random.normal();
    Matrix<Jet<double, 1>, 2, 4> j = m.cast<Jet<double, 1>>();
    j(0, 0) = Jet<double, 1>::variable(m(0, 0), 0, 1);
    constexpr double h = 1e-6;
    Matrix<double, 2, 4> up = m, down = m;
    up(0, 0) += h, down(0, 0) -= h;
    const auto basis = null_space(j).basis;
    const Matrix<double, 4, 2> slope = (null_space(up).basis - null_space(down).basis) / (2 * h);
    for (int i = 0; i < 8; ++i)
      EXPECT_NEAR(basis(i).slope[0], slope(i), 1e-6 * (1 + slope.cwiseAbs().maxCoeff())) << stream << ", matrix " << n;
  }
}

}  // namespace
}  // namespace burmester
