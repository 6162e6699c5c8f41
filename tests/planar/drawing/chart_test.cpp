#include "burmester/planar/drawing/chart.hpp"

#include <gtest/gtest.h>

namespace burmester::planar {
namespace {

std::vector<Pose> random_poses(Random& random, double turn) {
  std::vector<Pose> out;
  for (int i = 0; i < 5; ++i)
    out.push_back(pose_from_radians(random.normal(), random.normal(), 2.5 + turn * random.uniform(-1, 1)));
  return out;
}
double apart(const Pose& p, const Pose& q) {
  return std::hypot(p.x - q.x, p.y - q.y) + std::abs(std::remainder(angle_of(p) - angle_of(q), 2 * std::numbers::pi));
}

TEST(Chart, PointAndPoseAreInverse) {
  Random random("Chart.PointAndPoseAreInverse");
  const Chart chart{pose_from_radians(0, 0, 1.2), 50};
  for (int i = 0; i < 50; ++i) {
    const Pose x = Space::random_pose(random);
    EXPECT_LT(apart(chart.pose(chart.point(x)), x), 1e-13);
    EXPECT_NEAR(chart.point(x).norm(), 1, 1e-15);
    EXPECT_EQ(chart.beyond(1.5, chart.point(x)), std::hypot(x.x, x.y) > 1.5);
  }
}

TEST(Chart, QuadricsVanishAtThePosesOfTheDyad) {
  Random random("Chart.QuadricsVanishAtThePosesOfTheDyad");
  for (const double far : {1.0, 1e3, 1e6}) {
    const std::vector<Pose> poses = random_poses(random, 1 / far);
    for (const Pose& x : poses) {
      RR::Design d{{far, 2 * far}, {-far, far}, 0};
      d.length = (to_fixed(x, d.moving) - d.fixed).norm();
      const Chart chart = chart_for(poses, d, d);
      const Quadric<double> s = chart.quadric(d);
      EXPECT_LT(std::abs(s(chart.point(x))), 4e-16 * (10 + far) * size_of(s)) << far;
    }
  }
}

TEST(Chart, TheDoubleSliderHasTangentPlanes) {
  const Chart chart{pose_from_radians(0, 0, 1.2), 1};
  const PP::Design d{0.7};
  const Point3<double> x = chart.point(pose_from_radians(0.3, 0.4, 0.7));
  const Point3<double> other = chart.point(pose_from_radians(0, 0, 1));
  EXPECT_NEAR(chart.quadric(d)(x), 0, 1e-15);
  EXPECT_GT(chart.quadric(d).gradient(x).norm(), 0.1);
  EXPECT_GT(std::abs(chart.quadric(d)(other)), 0.1);
}

TEST(ChartFor, WeighsTurnsAboutFarPivotsOnly) {
  Random random("ChartFor.WeighsTurnsAboutFarPivotsOnly");
  const RR::Design near{{0.5, 0}, {0, 0.5}, 1}, far{{1e4, 0}, {-1e4, 0}, 1};
  const auto wide = random_poses(random, 1), small = random_poses(random, 1e-4);
  EXPECT_EQ(chart_for(small, near, near).weight, 1);
  EXPECT_LT(chart_for(wide, near, far).weight, 10);
  EXPECT_GT(chart_for(small, near, far).weight, 1e3);
  EXPECT_NEAR(angle_of(chart_for(small, near, far).middle), 2.5, 1e-4);
  const std::vector<Pose> one{{0, 0, 0, 1}};
  EXPECT_EQ(chart_for(one, near, near).weight, 1);
}

}  // namespace
}  // namespace burmester::planar
