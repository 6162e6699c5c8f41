#include "burmester/planar/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester::planar {
namespace {

const Quad quad_pi = boost::multiprecision::acos(Quad(-1));

/// |x - truth| in units of the last place of x.
double in_ulps(double x, const Quad& truth) {
  const double ulp = std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
  return static_cast<double>(abs(Quad(x) - truth)) / ulp;
}

// Sine and cosine in long double, 11 bits more, then rounded: half a unit, and 2^-10 of one.
constexpr double rounded_once = 0.5 + 0x1p-9;

TEST(PoseFromRadians, RoundsOnce) {
  Random random("PoseFromRadians.RoundsOnce");
  for (int i = 0; i < 10000; ++i) {
    const double angle = i % 2 ? random.uniform(-7, 7) : std::pow(10, random.uniform(-12, 3));
    const Pose pose = pose_from_radians(1, 2, angle);
    const Quad half = Quad(angle) / 2;
    EXPECT_LE(in_ulps(pose.X3, sin(half)), rounded_once) << angle;
    EXPECT_LE(in_ulps(pose.X4, cos(half)), rounded_once) << angle;
  }
}

TEST(PoseFromDegrees, RoundsOnce) {
  Random random("PoseFromDegrees.RoundsOnce");
  for (int i = 0; i < 10000; ++i) {
    const double angle = i % 2 ? random.uniform(-400, 400) : 180 + 180 * std::pow(10, random.uniform(-12, 0));
    const Pose pose = pose_from_degrees(1, 2, angle);
    const Quad half = Quad(angle) * quad_pi / 360;
    EXPECT_LE(in_ulps(pose.X3, sin(half)), rounded_once) << angle;
    EXPECT_LE(in_ulps(pose.X4, cos(half)), rounded_once) << angle;
  }
}

void expect_half_angle(double degrees, double X3, double X4) {
  const Pose pose = pose_from_degrees(0, 0, degrees);
  EXPECT_EQ(pose.X3, X3) << degrees;
  EXPECT_EQ(pose.X4, X4) << degrees;
}

TEST(PoseFromDegrees, HalfAndWholeTurnsAreExact) {
  expect_half_angle(0, 0, 1);
  expect_half_angle(180, 1, 0);
  expect_half_angle(-180, -1, 0);
  expect_half_angle(360, 0, -1);
  expect_half_angle(540, -1, 0);
  expect_half_angle(720, 0, 1);
  const Pose quarter = pose_from_degrees(0, 0, 90);
  EXPECT_EQ(quarter.X3, quarter.X4);
  for (const double angle : {0.0, 180.0, -180.0, 360.0, 540.0, 720.0}) {
    const Pose pose = pose_from_degrees(0, 0, angle);
    EXPECT_FALSE(std::signbit(pose.X3) && pose.X3 == 0) << angle;
    EXPECT_FALSE(std::signbit(pose.X4) && pose.X4 == 0) << angle;
  }
}

TEST(PoseFromDegrees, WholeTurnsChangeTheSignAtMost) {
  Random random("PoseFromDegrees.WholeTurnsChangeTheSignAtMost");
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.below(360 * 64) / 64.0;  // exact sums
    for (const double turns : {1.0, -1.0, 1e6, -1e6, 1e6 + 1}) {
      const Pose a = pose_from_degrees(0, 0, angle), b = pose_from_degrees(0, 0, angle + 360 * turns);
      const double sign = std::fmod(turns, 2) == 0 ? 1 : -1;
      EXPECT_EQ(b.X3, sign * a.X3) << angle << ' ' << turns;
      EXPECT_EQ(b.X4, sign * a.X4) << angle << ' ' << turns;
    }
  }
}

/// MECH 576, "Kinematic Mapping and the Burmester Problem", Eq. 1, which gives the cosine alone and so leaves the sign
/// of the angle open: here it is that of the arrow.
TEST(PoseFromArrow, HasTheArrowsAngleInAllQuadrants) {
  for (int degrees = -179; degrees <= 180; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Pose pose = pose_from_arrow(3, -2, 3 + 5 * std::cos(angle), -2 + 5 * std::sin(angle));
    EXPECT_EQ(pose.x, 3);
    EXPECT_EQ(pose.y, -2);
    EXPECT_NEAR(std::remainder(angle_of(pose) - angle, 2 * std::numbers::pi), 0, 1e-15) << degrees;
    EXPECT_NEAR(std::hypot(pose.X3, pose.X4), 1, 1e-15);
  }
  EXPECT_EQ(pose_from_arrow(1, 1, -4, 1).X4, 0);  // a half turn, exactly
  EXPECT_EQ(pose_from_arrow(1, 1, 7, 1).X3, 0);
}

TEST(AngleOf, IsTheAngleInTheHalfOpenInterval) {
  constexpr double pi = std::numbers::pi;
  for (int degrees = -719; degrees <= 719; ++degrees) {
    const double angle = angle_of(pose_from_degrees(0, 0, degrees));
    EXPECT_TRUE(-pi < angle && angle <= pi) << degrees;
    EXPECT_NEAR(std::remainder(angle - degrees * pi / 180, 2 * pi), 0, 4e-15) << degrees;
  }
  EXPECT_EQ(angle_of({0, 0, 1, 0}), pi);
  EXPECT_EQ(angle_of({0, 0, 0, -2}), 0);
  EXPECT_EQ(angle_of({0, 0, 3, 3}), angle_of({0, 0, -1, -1}));
}

TEST(AngleOf, HalfTurnOfAnySign) {
  constexpr double pi = std::numbers::pi;
  for (const double X3 : {1.0, -1.0})
    for (const double X4 : {0.0, -0.0}) EXPECT_EQ(angle_of({0, 0, X3, X4}), pi) << X3 << ' ' << X4;
  EXPECT_EQ(angle_of({0, 0, -1, 1e-20}), pi);  // rounds to -pi
}

}  // namespace
}  // namespace burmester::planar
