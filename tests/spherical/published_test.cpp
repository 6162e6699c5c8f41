// The two examples of J. Angeles and S. Bai, "A robust solution of the spherical Burmester problem".
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burmester/spherical/five_pose_solver.hpp"
#include "five_orientations.hpp"
#include "spherical_examples.hpp"

namespace burmester::spherical {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A printed row: moving axis a0 in the first pose, fixed axis b.
struct Row {
  Axis moving, fixed;
  RR::Design design(double arc) const { return {fixed.normalized(), moving.normalized(), arc}; }
  /// Angle between them in the first pose, which is the identity.
  RR::Design design() const { return design(std::acos(fixed.normalized().dot(moving.normalized()))); }
};

/// The digits of x as printed: cut off after the fourth, not rounded.
double cut(double x) { return std::trunc(x * 1e4) / 1e4; }

// Example 1 by the angles beta in whole degrees (longitude, latitude and roll of the moving frame); the table of
// solutions is reproduced to all digits. beta2 of the second pose is printed as -6; axis and angle beside it, and the
// solutions, belong to +6.
TEST(Published, AngelesBaiExample1) {
  const std::array<Pose, 5> poses{Pose{}, pose_from_globe_degrees(-10, 6, 0), pose_from_globe_degrees(-51, -52, -12),
                                  pose_from_globe_degrees(15, -56, 47), pose_from_globe_degrees(33, -40, 47)};
  const Row table[] = {{{0.7085, -0.6418, -0.2932}, {0.2640, -0.6636, -0.6998}},
                       {{0.0385, 0.3163, 0.9478}, {0.1143, 0.7263, -0.6777}},
                       {{0.1642, 0.6977, 0.6972}, {0.5218, 0.8413, -0.1403}},
                       {{0.8077, 0.1493, 0.5702}, {0.9524, -0.2535, 0.1686}}};
  const double arcs[] = {35.08752256387994, 114.0956785806511, 54.90881132896959, 34.135322118552374};  // degrees, ours
  const SphericalReport report = FivePoseSolver().solve(poses);
  EXPECT_EQ(report.counts.complex, 6);
  ASSERT_EQ(report.dyads.size(), 4u);
  EXPECT_EQ(report.status, Status::exact);
  for (std::size_t i = 0; i < 4; ++i) {
    RR::Design found = support::as_RR(support::nearest(table[i].design(), report).dyad->design);
    if (found.moving.dot(table[i].moving) < 0) found.moving = -found.moving, found.arc = std::numbers::pi - found.arc;
    if (found.fixed.dot(table[i].fixed) < 0) found.fixed = -found.fixed, found.arc = std::numbers::pi - found.arc;
    for (int k = 0; k < 3; ++k) {
      EXPECT_DOUBLE_EQ(cut(found.moving[k]), table[i].moving[k]) << "solution " << i + 1 << ", coordinate " << k;
      EXPECT_DOUBLE_EQ(cut(found.fixed[k]), table[i].fixed[k]) << "solution " << i + 1 << ", coordinate " << k;
    }
    EXPECT_NEAR(found.arc, arcs[i] * degree, 1e-13) << "solution " << i + 1;
  }
}

TEST(Published, AngelesBaiExample1ByTheMisprintedAngleIsAnotherProblem) {
  const std::array<Pose, 5> poses{Pose{}, pose_from_globe_degrees(-10, -6, 0), pose_from_globe_degrees(-51, -52, -12),
                                  pose_from_globe_degrees(15, -56, 47), pose_from_globe_degrees(33, -40, 47)};
  const Row first{{0.7085, -0.6418, -0.2932}, {0.2640, -0.6636, -0.6998}};
  const SphericalReport report = FivePoseSolver().solve(poses);
  EXPECT_TRUE(report.dyads.empty() || support::nearest(first.design(), report).distance > 1e-2);
}

// Example 2 by the printed axes and angles (four digits). The columns a0 and b of its table are exchanged: what is
// printed as b moves. The slider (fourth row) was found by least squares; five rounded poses only have an RR near it.
TEST(Published, AngelesBaiExample2) {
  const std::array<Pose, 5> poses{Pose{}, pose_from_axis_radians({-0.2280, -0.4553, -0.8606}, 0.2563),
                                  pose_from_axis_radians({-0.0578, 0.2370, -0.9697}, 1.1307),
                                  pose_from_axis_radians({0.5049, 0.8505, -0.1468}, 1.1938),
                                  pose_from_axis_radians({0.7119, 0.6601, 0.2393}, 1.3665)};
  const Row table[] = {{{0.1219, -0.7089, -0.6946}, {0.2845, 0.3863, 0.8773}},
                       {{0.2309, 0.4566, 0.8591}, {0.7226, 0.5295, 0.4442}},
                       {{0.8134, 0.1643, 0.5579}, {0.9573, -0.2433, 0.1555}},
                       {{0.0655, 0.1015, 0.9926}, {0.5221, 0.8442, -0.1208}}};
  const SphericalReport report = FivePoseSolver().solve(poses);
  ASSERT_EQ(report.dyads.size(), 4u);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(support::nearest(table[i].design(), report).distance, 3e-4) << "solution " << i + 1;
  const auto fourth = support::nearest(table[3].design(), report);
  EXPECT_LT(fourth.distance, 3e-3);
  EXPECT_NEAR(support::as_RR(fourth.dyad->design).arc, (180 - 90.11025199884692) * degree, 0.4 * degree);
}

// The same poses moved by about 0.01 deg onto the linkage of the second and the fourth dyad: the slider is one.
TEST(Published, AngelesBaiExample2MadeExact) {
  const std::vector<Pose> poses = testing::angeles_bai_2_exact().poses;
  const SphericalReport report = FivePoseSolver().solve(poses);
  ASSERT_EQ(report.dyads.size(), 4u);
  const auto& slider = report.dyads.back();  // sorted: RR before PR
  ASSERT_TRUE(std::holds_alternative<PR::Design>(slider.design));
  EXPECT_LT(slider.departure.value_or(1), 1e-13);
  const RR::Design planted{{0.5221393938323564, 0.8442635990986221, -0.12078670723809137},
                           {0.06550500280810398, 0.10150775244309242, 0.9926758135469315},
                           std::numbers::pi / 2};
  EXPECT_LT(support::distance(support::as_RR(slider.design), planted), 1e-13);
  const RR::Design second{{0.7226597483646462, 0.5295437818420705, 0.44423672878989184},
                          {0.2309171831869252, 0.45663397939865763, 0.8591639327669442},
                          37.78135573307057 * degree};
  EXPECT_LT(support::nearest(second, report).distance, 1e-13);
}

}  // namespace
}  // namespace burmester::spherical
