#include "burmester/planar/poles.hpp"

#include <gtest/gtest.h>

#include "rational.hpp"

namespace burmester::planar {
namespace {

Vector2 finite(const Point2<double>& P) { return P.head<2>() / P[2]; }

TEST(Pole, StandsStill) {
  Random random("Pole.StandsStill");
  for (int i = 0; i < 100; ++i) {
    const Pose x = Space::random_pose(random), y = Space::random_pose(random), home = Space::random_pose(random);
    const Vector2 own = finite(pole(x)), P = finite(relative_pole(x, y)), Q = finite(moving_pole(x, y));
    const double size = 1e-13 * (1 + P.norm() + Q.norm() + own.norm()) * (1 + P.norm());
    EXPECT_LT((to_fixed(x, own) - own).norm(), size) << i;
    EXPECT_LT((to_fixed(x, Q) - P).norm(), size) << i;
    EXPECT_LT((to_fixed(y, Q) - P).norm(), size) << i;
    // The image pole: where the pole is when the body is at home, the pole of the poses seen from there.
    const Vector2 image = to_fixed(home, Q), other = to_fixed(home, to_moving(y, P));
    EXPECT_LT((image - other).norm(), 10 * size) << i;
  }
}

/// The pole as seen from pose i is that from pose j, up to sign; exact, of any scale.
TEST(Pole, IsSymmetricExactly) {
  Random random("Pole.IsSymmetricExactly");
  for (int i = 0; i < 50; ++i) {
    const Pose x{random.normal(), random.normal(), random.normal(), random.normal()},
        y{random.normal(), random.normal(), random.normal(), random.normal()};
    EXPECT_TRUE((relative_pole<Rational>(x, y) + relative_pole<Rational>(y, x)).isZero(0)) << i;
    EXPECT_TRUE((moving_pole<Rational>(x, y) + moving_pole<Rational>(y, x)).isZero(0)) << i;
    EXPECT_TRUE(relative_pole<Rational>(x, x).isZero(0)) << i;
    const Pose home{0, 0, 0, 1};
    EXPECT_TRUE(relative_pole<Rational>(home, x).cross(pole<Rational>(x)).isZero(0)) << i;
    EXPECT_TRUE(moving_pole<Rational>(home, x).cross(pole<Rational>(x)).isZero(0)) << i;
  }
}

TEST(Pole, OfATranslationIsAtInfinityAcrossIt) {
  Random random("Pole.OfATranslationIsAtInfinityAcrossIt");
  for (int i = 0; i < 50; ++i) {
    const Pose x = Space::random_pose(random);
    Pose y = x;
    y.x += random.normal(), y.y += random.normal();
    const Point2<Rational> P = relative_pole<Rational>(x, y);
    EXPECT_EQ(P[2], 0) << i;
    EXPECT_EQ(P[0] * (Rational(y.x) - Rational(x.x)) + P[1] * (Rational(y.y) - Rational(x.y)), 0) << i;
    EXPECT_FALSE(P.isZero(0)) << i;
  }
}

TEST(Pole, OfAHalfTurnIsTheMidpoint) {
  const Point2<double> P = pole(pose_from_degrees(6, -4, 180));  // X4 = 0
  EXPECT_EQ(P[0] / P[2], 3);
  EXPECT_EQ(P[1] / P[2], -2);
}

/// L. Burmester, 1888: the angles of the pole triangle are half the turns about its corners.
TEST(Pole, TriangleHasHalfTheTurns) {
  Random random("Pole.TriangleHasHalfTheTurns");
  for (int i = 0; i < 100; ++i) {
    const Pose a = Space::random_pose(random), b = Space::random_pose(random), c = Space::random_pose(random);
    const Vector2 ab = finite(relative_pole(a, b)), bc = finite(relative_pole(b, c)), ca = finite(relative_pole(c, a));
    const auto direction = [](const Vector2& v) { return std::atan2(v[1], v[0]); };
    const double turn = angle_of(b) - angle_of(a), at_ab = 2 * (direction(ca - ab) - direction(bc - ab));
    const double size = (1 + ab.norm()) / std::min((ca - ab).norm(), (bc - ab).norm());
    EXPECT_NEAR(std::remainder(turn + at_ab, 2 * std::numbers::pi), 0, 1e-12 * size * (1 + ca.norm() + bc.norm())) << i;
  }
}

}  // namespace
}  // namespace burmester::planar
