#include "burmester/spherical/semigraphical.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "spherical_examples.hpp"

namespace burmester::spherical {
namespace {

double axis_distance(const Axis& a, const Axis& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

double apart(const RR::Design& d, const RR::Design& e) {
  return std::max(axis_distance(d.fixed, e.fixed), axis_distance(d.moving, e.moving));
}

int near(const std::vector<RR::Design>& dyads, const RR::Design& d, double tolerance) {
  return static_cast<int>(
      std::count_if(dyads.begin(), dyads.end(), [&](const auto& e) { return apart(d, e) < tolerance; }));
}

std::vector<double> residuals(const RR::Design& d, const std::vector<Pose>& poses) {
  std::vector<double> out;
  for (const Pose& p : poses) out.push_back(std::abs(RR::residual(d, p)));
  return out;
}

/// Angeles and Bai: four real dyads in both examples, read off four contour plots.
TEST(Semigraphical, FindsTheDyadsOfTheDocumentInBothPlots) {
  for (const testing::SphericalExample& example : {testing::angeles_bai_1(), testing::angeles_bai_2_exact()}) {
    const SemigraphicalAnswer answer = semigraphical(example.poses);
    EXPECT_FALSE(answer.degenerate);
    for (const auto& dyads : {answer.dyads, answer.from_fixed}) {
      EXPECT_EQ(dyads.size(), 4u);
      for (const RR::Design& d : example.dyads) EXPECT_EQ(near(dyads, d, 1e-11), 1) << d.moving.transpose();
    }
  }
}

TEST(Semigraphical, RejectsTheCrossingsOfTwoCurvesOnly) {
  const testing::SphericalExample example = testing::angeles_bai_1();
  const SemigraphicalAnswer answer = semigraphical(example.poses);
  for (const AxisPlot* plot : {&answer.moving, &answer.fixed}) {
    int spurious = 0;
    for (const Crossing& c : plot->crossings) {
      const bool all_four = std::any_of(example.dyads.begin(), example.dyads.end(), [&](const RR::Design& d) {
        return axis_distance(c.axis, plot == &answer.moving ? d.moving : d.fixed) < 1e-9;
      });
      EXPECT_EQ(c.accepted(), all_four) << c.rank_ratio;
      EXPECT_TRUE(all_four || c.rank_ratio > 1e-4) << c.rank_ratio;
      spurious += !all_four;
    }
    EXPECT_GT(spurious, 0);
    for (int i = 1; i <= 4; ++i)
      for (int j = i + 1; j <= 4; ++j)  // nine common axes of two cubic cones, six of them on all four
        EXPECT_LE(std::count_if(plot->crossings.begin(), plot->crossings.end(),
                                [&](const Crossing& c) {
                                  return c.curves == std::array{i, j} && !c.accepted();
                                }),
                  3);
  }
}

TEST(Semigraphical, EveryDyadFoundIsOne) {
  Random random("Semigraphical.EveryDyadFoundIsOne");
  for (int i = 0; i < 40; ++i) {
    std::vector<Pose> poses;
    for (int j = 0; j < 5; ++j) poses.push_back(Space::random_pose(random));
    const SemigraphicalAnswer answer = semigraphical(poses, 90);
    EXPECT_LE(answer.dyads.size(), 6u);
    for (const auto& dyads : {answer.dyads, answer.from_fixed})
      for (const RR::Design& d : dyads)
        for (const double r : residuals(d, poses)) EXPECT_LT(r, 1e-9) << "Semigraphical.EveryDyadFoundIsOne " << i;
  }
}

TEST(Semigraphical, FindsAPlantedDyad) {
  Random random("Semigraphical.FindsAPlantedDyad");
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    const RR::Design d = RR::random_design(random);
    std::vector<Pose> poses;
    for (int j = 0; j < 5; ++j) {  // turn E until its axis a is at the arc from b
      const Pose p = Space::random_pose(random);
      const Axis a = Space::act<double>(Space::point<double>(p), d.moving).normalized();
      const Axis about = d.fixed.cross(a).normalized();
      const double angle = d.arc - Space::distance(d.fixed, a);
      const Pose turn = pose_from_axis_radians({about[0], about[1], about[2]}, angle);
      poses.push_back(Space::pose(Space::product<double>(Space::point<double>(turn), Space::point<double>(p))));
    }
    for (const double r : residuals(d, poses)) ASSERT_LT(r, 1e-12);
    found += near(semigraphical(poses).dyads, d, 1e-8);
  }
  EXPECT_GE(found, 19);  // a picture may hide one
}

TEST(Semigraphical, NamesDegenerateOrientations) {
  std::vector<Pose> poses;
  for (const double angle : {0., 10., 30., 50., 90.}) poses.push_back(pose_from_axis_degrees({1, 2, 2}, angle));
  EXPECT_TRUE(semigraphical(poses, 30).degenerate);
  testing::SphericalExample example = testing::angeles_bai_1();
  example.poses[3] = example.poses[1];
  EXPECT_TRUE(semigraphical(example.poses, 30).degenerate);
}

TEST(LongitudeLatitude, IsTheInverseOnTheHalfSphere) {
  for (const double longitude : {-1.5, -0.3, 0.0, 1.2})
    for (const double latitude : {-1.5, -0.2, 0.7}) {
      for (const double sign : {-1.0, 1.0}) {
        const auto at = longitude_latitude(sign * axis_at(longitude, latitude));
        EXPECT_NEAR(at[0], longitude, 1e-14);
        EXPECT_NEAR(at[1], latitude, 1e-14);
      }
    }
  EXPECT_NEAR(longitude_latitude(Axis(0, 0, 1))[1], std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace burmester::spherical
