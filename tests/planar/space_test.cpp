// Conventions of the planar pose space: what no law can see.
#include "burmester/planar/space.hpp"

#include <gtest/gtest.h>

#include "rational.hpp"

namespace burmester::planar {
namespace {

Vector2 placed(const Pose& pose, const Vector2& a) {
  const auto p = Space::point<double>(pose);
  return Space::act<double>(p, a) / Space::norm<double>(p);
}

TEST(PlanarSpace, AQuarterTurnAboutOneTwoTakesThreeTwoToOneFour) {
  // P = c + R (p - c), so the origin of E is at c - R c = (1, 2) - (-2, 1).
  const Pose turn = pose_from_degrees(3, 1, 90);
  EXPECT_LT((placed(turn, {3, 2}) - Vector2(1, 4)).norm(), 1e-15);
  EXPECT_LT((placed(turn, {1, 2}) - Vector2(1, 2)).norm(), 1e-15);
  EXPECT_LT((to_fixed(turn, {3, 2}) - Vector2(1, 4)).norm(), 1e-15);
  EXPECT_LT((to_moving(turn, {1, 4}) - Vector2(3, 2)).norm(), 1e-15);
}

TEST(PlanarSpace, PoseIsTheOriginAndAngleOfE) {
  const Pose pose = pose_from_degrees(5, -7, 30);
  EXPECT_LT((placed(pose, {0, 0}) - Vector2(5, -7)).norm(), 4e-15);
  EXPECT_LT((placed(pose, {1, 0}) - Vector2(5 + std::sqrt(0.75), -6.5)).norm(), 4e-15);
}

TEST(PlanarSpace, ImagePointsAreBlaschkeGruenwald) {
  // Quarter turn about (1, 2): the pole is (X1 : X2 : X3) and X4 / X3 the cotangent of half the angle.
  const auto X = image_point(pose_from_degrees(3, 1, 90));
  EXPECT_NEAR(X[0] / X[2], 1, 1e-15);
  EXPECT_NEAR(X[1] / X[2], 2, 1e-15);
  EXPECT_NEAR(X[3] / X[2], 1, 1e-15);
}

TEST(PlanarSpace, ProductIsTheLaterDisplacementOnTheLeft) {
  const Pose shift = pose_from_degrees(1, 0, 0), turn = pose_from_degrees(0, 0, 90);
  const auto both = Space::product<double>(Space::point<double>(turn), Space::point<double>(shift));
  const Pose expected =
      Space::pose(both);  // first shift, then turn: the origin goes to (1, 0), then to (0, 1)
  EXPECT_LT(std::hypot(expected.x, expected.y - 1), 1e-15);
}

TEST(PlanarSpace, PointsOfPosesComposeExactlyOverTheRationals) {
  Random random("PlanarSpace.PointsOfPosesComposeExactlyOverTheRationals");
  for (int i = 0; i < 50; ++i) {
    const Pose pose{random.normal(), random.normal(), random.normal(), random.normal()};  // any norm
    const Vector<Rational, 4> x = Space::point<Rational>(pose);
    const Vector<Rational, 2> origin = Space::act<Rational>(x, Vector<Rational, 2>(Rational(0), Rational(0)));
    const Rational n = Space::norm<Rational>(x);
    EXPECT_EQ(origin[0], n * Rational(pose.x));
    EXPECT_EQ(origin[1], n * Rational(pose.y));
  }
}

}  // namespace
}  // namespace burmester::planar
