#include "burmester/spherical/pose.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "burmester/spherical/space.hpp"

namespace burmester::spherical {
namespace {

using Place = Vector<double, 3>;
constexpr double pi = std::numbers::pi;
const Place x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

Place placed(const Pose& pose, const Place& a) {
  const auto p = Space::point<double>(pose);
  return Space::act<double>(p, a) / Space::norm<double>(p);
}
std::array<std::array<double, 3>, 3> matrix_of(const Pose& pose) {
  std::array<std::array<double, 3>, 3> rows;
  for (std::size_t j = 0; j < 3; ++j) {
    const Place column = placed(pose, Place::Unit(static_cast<int>(j)));
    for (std::size_t i = 0; i < 3; ++i) rows[i][j] = column[static_cast<int>(i)];
  }
  return rows;
}
testing::AssertionResult same(const Pose& a, const Pose& b, double tolerance = 4e-16) {
  const double gap = Space::gap(Space::point<double>(a), Space::point<double>(b));
  if (gap <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "gap " << gap << ": (" << a.w << ", " << a.x << ", " << a.y << ", "
                                     << a.z << ") and (" << b.w << ", " << b.x << ", " << b.y << ", " << b.z
                                     << ")";
}

// Goldens: conventions.
TEST(SphericalPose, AQuarterTurnAboutZTakesXToY) {
  EXPECT_LT((placed(pose_from_axis_degrees({0, 0, 1}, 90), x) - y).norm(), 4e-16);
}

TEST(SphericalPose, LongitudeLatitudeAndRollPlaceTheMovingXAxisOnTheGlobe) {
  EXPECT_LT((placed(pose_from_globe_degrees(90, 0, 0), x) - y).norm(), 4e-16);
  EXPECT_LT((placed(pose_from_globe_degrees(0, 90, 0), x) - z).norm(), 4e-16);  // the north pole
  EXPECT_LT((placed(pose_from_globe_degrees(0, 0, 90), y) - z).norm(), 4e-16);
  const double l = 0.3, b = -0.7;
  const Place expected{std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)};
  EXPECT_LT((placed(pose_from_globe_radians(l, b, 1.1), x) - expected).norm(), 4e-16);
}

TEST(SphericalPose, GlobeIsRzRyRx) {
  const auto product = [](const Pose& a, const Pose& b) {
    return Space::pose(Space::product<double>(Space::point<double>(a), Space::point<double>(b)));
  };
  const Pose expected =
      product(product(pose_from_axis_degrees({0, 0, 1}, 10), pose_from_axis_degrees({0, 1, 0}, -20)),
              pose_from_axis_degrees({1, 0, 0}, 30));
  EXPECT_TRUE(same(pose_from_globe_degrees(10, 20, 30), expected));
}

TEST(SphericalPose, DegreesAreReducedExactly) {
  const Pose half = pose_from_axis_degrees({0, 0, 1}, 180);
  EXPECT_EQ(half.w, 0);
  EXPECT_EQ(half.z, 1);
  for (const double angle : {-720.0, 0.0, 720.0, 7200.0}) {
    const Pose p = pose_from_axis_degrees({1, 2, 3}, angle);
    EXPECT_EQ(p.w, 1) << angle;
    EXPECT_EQ(p.x, 0) << angle;
  }
  for (const double angle : {30.0, 90.0, -45.0, 120.0, 200.0, -300.0, 359.0})
    EXPECT_TRUE(
        same(pose_from_axis_degrees({1, 2, 3}, angle), pose_from_axis_radians({1, 2, 3}, angle / 180 * pi)))
        << angle;
}

TEST(SphericalPose, AxisLengthDoesNotMatter) {
  const Pose expected = pose_from_axis_degrees({1, 2, 2}, 50);
  for (const double scale : {1e-310, 1e-200, 0.5, 1e200, 8e307})
    EXPECT_TRUE(same(pose_from_axis_degrees({scale, 2 * scale, 2 * scale}, 50), expected,
                     scale < 1e-300 ? 1e-13 : 4e-16))
        << scale;
}

TEST(SphericalPose, MatrixGivesThePoseBackInEveryRegion) {
  std::vector<Pose> poses{{},           {0, 1, 0, 0},    {0, 0, 1, 0},
                          {0, 0, 0, 1}, {1e-9, 1, 0, 0}, {1, 0, 1e-9, 0},
                          {0, 1, 1, 1}, {1, 1, 1, 1},    {1, -1, 1, -1}};
  Random random("SphericalPose.MatrixGivesThePoseBackInEveryRegion");
  for (int i = 0; i < 200; ++i) poses.push_back(Space::random_pose(random));
  for (const Pose& p : poses) EXPECT_TRUE(same(pose_from_matrix(matrix_of(p)), p, 2e-15));
}

TEST(SphericalPose, AxisAndAngleComeBack) {
  const auto [axis, angle] = axis_angle_of(pose_from_axis_degrees({2, 0, 0}, 270));  // -90 about x
  EXPECT_THAT(axis, testing::ElementsAre(-1, 0, 0));
  EXPECT_NEAR(angle, pi / 2, 4e-16);
  EXPECT_EQ(axis_angle_of({}).angle, 0);
  EXPECT_NEAR(axis_angle_of(pose_from_axis_radians({0, 1, 0}, 1e-12)).angle, 1e-12, 1e-26);
}

TEST(SphericalSpace, DistanceIsAccurateAtBothEnds) {
  for (const double t : {0.0, 1e-15, 1e-8, 1.0}) {
    const Place near{std::cos(t), std::sin(t), 0};
    EXPECT_NEAR(Space::distance(x, near), t, 1e-15 * t);
    EXPECT_NEAR(Space::distance(x, -near), pi - t, 4e-16);
  }
  EXPECT_EQ(Space::distance(x, z), pi / 2);
}

TEST(SphericalSpace, RandomPosesAreUniform) {
  Random random("SphericalSpace.RandomPosesAreUniform");
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Space::Point<double> p = Space::point<double>(Space::random_pose(random)).normalized();
    moments += p * p.transpose() / n;
  }
  EXPECT_LT((moments - Eigen::Matrix4d::Identity() / 4).cwiseAbs().maxCoeff(), 0.01);
}

}  // namespace
}  // namespace burmester::spherical
