#include "burmester/modules/framework/condition.hpp"

#include <gtest/gtest.h>

#include "burmester/modules/framework/search.hpp"
#include "toy_geometry.hpp"

namespace burmester {
namespace {

using toy::Circle;
using Poses = std::vector<toy::Plane::Pose>;

Vector<double, 5> coordinates(const Circle::Design& d) {
  return {d.fixed[0], d.fixed[1], d.moving[0], d.moving[1], d.length};
}

TEST(Condition, OfAMeanIsOneOverTheRoot) {  // r_j = x_j - angle: J^+ = -(1, 1, 1, 1) / 4, c = 1
  const std::vector<toy::Turns::Pose> poses{{0.1}, {0.2}, {0.3}, {0.4}};
  EXPECT_NEAR((condition<toy::Stop>({0.25}, poses)), 0.5, 1e-8);
}

/// Solves again with poses changed by `size` in all, many times: the largest change of the design, per size.
double worst_of_many(const Circle::Design& d, const Poses& poses, Random& random, double size) {
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    Vector<double, 15> v;
    for (int j = 0; j < 15; ++j) v[j] = random.normal();
    v *= size / v.norm();
    Poses changed;
    for (int j = 0; j < 5; ++j)
      changed.push_back(toy::Plane::nudged(poses[static_cast<std::size_t>(j)], v.segment<3>(3 * j)));
    const auto again = refine<Circle>(d, changed);
    worst = std::max(worst, (coordinates(again.design) - coordinates(d)).norm() / size);
  }
  return worst;
}

TEST(Condition, BoundsAndPredictsTheEffectOfPoseErrors) {
  Random random("Condition.BoundsAndPredictsTheEffectOfPoseErrors");
  for (int i = 0; i < 5; ++i) {
    const Circle::Design d = Circle::random_design(random);
    Poses poses;
    while (poses.size() < 5)
      if (const auto pose = pose_with_residual<Circle>(d, toy::Plane::random_pose(random)))
        poses.push_back(*pose);
    const double predicted = condition<Circle>(d, poses);
    const double worst = worst_of_many(d, poses, random, 1e-5 / predicted);
    EXPECT_LE(worst, 1.01 * predicted) << "task " << i;  // a bound
    EXPECT_GE(worst, 0.25 * predicted)
        << "task " << i;  // and not a loose one: 2000 directions in 15 dimensions
  }
}

TEST(Condition, IsAttainedInTheWorstDirection) {
  Random random("Condition.IsAttainedInTheWorstDirection");
  const Circle::Design d = Circle::random_design(random);
  Poses poses;
  while (poses.size() < 5)
    if (const auto pose = pose_with_residual<Circle>(d, toy::Plane::random_pose(random)))
      poses.push_back(*pose);
  const double predicted = condition<Circle>(d, poses), size = 1e-5 / predicted;
  // Each pose moves along its own gradient; by how much is the top right singular vector of J^-1 diag(c).
  const Eigen::MatrixXd J = design_jacobian<Circle>(d, poses);
  Eigen::MatrixXd map = J.inverse();
  for (int j = 0; j < 5; ++j)
    map.col(j) *= pose_gradient<Circle>(d, poses[static_cast<std::size_t>(j)]).norm();
  const Eigen::VectorXd along = Eigen::JacobiSVD<Eigen::MatrixXd>(map, Eigen::ComputeThinV).matrixV().col(0);
  for (int j = 0; j < 5; ++j) {
    auto& pose = poses[static_cast<std::size_t>(j)];
    const Vector<double, 3> gradient = pose_gradient<Circle>(d, pose);
    pose = toy::Plane::nudged(pose, size * along[j] * gradient.normalized());
  }
  const auto again = refine<Circle>(d, poses);
  EXPECT_NEAR((coordinates(again.design) - coordinates(d)).norm() / size, predicted, 1e-2 * predicted);
}

TEST(Condition, IsInfiniteWhereThePosesDoNotDetermineTheDesign) {
  const Circle::Design d{{0, 0}, {1, 0}, 1};
  const Poses turns{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, -1}};  // every point runs on a circle
  EXPECT_EQ((condition<Circle>(d, turns)), std::numeric_limits<double>::infinity());
}

TEST(Condition, OfATinyTaskIsThatOfTheUnitTaskWithTurnsMadeCheap) {
  // Lengths times s: the same J, and the part of c_j that comes from turns times s. So c_j shrinks, to the
  // part from shifts alone, which is 1 for a point on a circle.
  Random random("Condition.OfATinyTask");
  const Circle::Design d = Circle::random_design(random);
  Poses poses;
  while (poses.size() < 5)
    if (const auto pose = pose_with_residual<Circle>(d, toy::Plane::random_pose(random)))
      poses.push_back(*pose);
  const Eigen::MatrixXd J = design_jacobian<Circle>(d, poses);
  const double shifts_only = 1 / Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues()[4];

  constexpr double s = 1e-6;
  for (auto& pose : poses) pose.x *= s, pose.y *= s;
  const Circle::Design tiny{s * d.fixed, s * d.moving, s * d.length};
  EXPECT_NEAR(condition<Circle>(tiny, poses) / shifts_only, 1, 1e-3);
}

}  // namespace
}  // namespace burmester
