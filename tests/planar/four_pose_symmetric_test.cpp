// Four symmetric poses: their curves split into a line and a circle, or would but for rounding, and are whole all the
// same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/planar/four_pose_curves.hpp"
#include "four_poses.hpp"
#include "repetitions.hpp"

namespace burmester::planar {
namespace {

/// How far a pair is out, in units of the window: both pivots from pose 1's origin, along x and y.
double reach(const FourPoseTask& task, const CurveRecord& piece, std::size_t k) {
  const Vector2 p = rotated({0, 0, task[0].X3, task[0].X4}, {piece.moving[k][0], piece.moving[k][1]}),
                c(piece.fixed[k][0] - task[0].x, piece.fixed[k][1] - task[0].y);
  const double window = CurveOptions().window * power_of_two_below(curve_scale(task));
  return std::max(p.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()) / window;
}

/// Complete, in few points that meet the poses, and no end but at the border of the window.
void expect_whole(const FourPoseTask& task, const std::string& name) {
  const FourPoseCurves curves = four_pose_curves(task);
  EXPECT_TRUE(curves.complete) << name;
  std::size_t points = 0;
  for (const CurveRecord& piece : curves.pieces) {
    points += piece.moving.size();
    EXPECT_LE(piece.max_error, 1e-4 * power_of_two_below(curve_scale(task)) * (1 + 1e-9)) << name;
    for (std::size_t k = 0; k < piece.moving.size(); ++k)
      EXPECT_LT(concyclicity(task, {piece.moving[k][0], piece.moving[k][1]}, {piece.fixed[k][0], piece.fixed[k][1]}),
                1e-9)  // where turns are 1e-5 the pivots are 1e5 lengths away
          << name;
    if (piece.closed) continue;
    EXPECT_GT(reach(task, piece, 0), 1 - 1e-9) << name;
    EXPECT_GT(reach(task, piece, piece.moving.size() - 1), 1 - 1e-9) << name;
  }
  EXPECT_GT(points, 20u) << name;
  EXPECT_LT(points, 3000u) << name;
}

TEST(SymmetricPoses, InEqualStepsByName) {
  const struct {
    const char* name;
    std::array<std::array<double, 3>, 4> poses;
  } cases[] = {{"equal steps along a line", {{{0, 0, 0}, {1, 0, 10}, {2, 0, 20}, {3, 0, 30}}}},
               {"equal steps upwards", {{{0, 0, 0}, {2, 1, 15}, {4, 2, 30}, {6, 3, 45}}}},
               {"equal translations", {{{0, 0, 0}, {1, 0, 0}, {2, 1, 30}, {3, 1, 30}}}},
               {"mirror images, turning one way", {{{-3, 1, -30}, {-1, 0, -10}, {1, 0, 10}, {3, 1, 30}}}},
               {"mirror images, turning back", {{{-3, 0, 45}, {-1, 1, 15}, {1, 1, -15}, {3, 0, -45}}}}};
  for (const auto& c : cases) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      std::array<std::array<double, 3>, 4> poses;
      for (std::size_t j = 0; j < 4; ++j) poses[j] = c.poses[order[j]];
      expect_whole(four_poses(poses), c.name);
    } while (std::ranges::next_permutation(order).found);
  }
}

/// Mirror images in the line x = 0, turned by an angle that rounds: the curves split to within rounding.
FourPoseTask mirrored(Random& random) {
  const double turn = random.uniform(-180, 180), radians = turn * std::numbers::pi / 180, c = std::cos(radians),
               s = std::sin(radians);
  std::array<std::array<double, 3>, 4> poses;
  for (std::size_t j = 0; j < 4; j += 2) {
    const double x = random.uniform(0.2, 1), y = random.uniform(-1, 1), angle = random.uniform(-90, 90);
    poses[j] = {c * x - s * y, s * x + c * y, turn + angle};
    poses[j + 1] = {-c * x - s * y, -s * x + c * y, turn - angle};
  }
  return four_poses(poses);
}

TEST(SymmetricPoses, AtRandom) {
  Random random("SymmetricPoses.AtRandom");
  for (int i = 0; i < repetitions(150); ++i) expect_whole(mirrored(random), "set " + std::to_string(i));
}

/// Beside the node of a curve that nearly splits, a partner may run along a line while its point stands still.
TEST(SymmetricPoses, NearlySo) {
  Random random("SymmetricPoses.NearlySo");
  for (int i = 0; i < 120; ++i) {
    FourPoseTask task = mirrored(random);
    const double off = std::ldexp(1.0, -15 - i % 30);
    for (Pose& pose : task) pose.x += off * random.uniform(-1, 1), pose.y += off * random.uniform(-1, 1);
    expect_whole(task, "set " + std::to_string(i));
  }
}

/// Equal steps of a small turn: along a line, or with the other coordinate free; exact but for rounding, and perturbed
/// by 2^-15 to 2^-44. The poles are far away and close together.
TEST(SmallEqualSteps, AreWholeInEveryOrderFrameAndUnit) {
  Random random("SmallEqualSteps.AreWholeInEveryOrderFrameAndUnit");
  for (const double turn : {1e-2, 1e-3, 1e-4, 1e-5})
    for (int i = 0; i < 40; ++i) {
      const double x = random.normal(), y = random.normal(),
                   unit = std::ldexp(1.0, static_cast<int>(random.uniform(-9, 9))),
                   off = i % 4 == 0 ? 0 : std::ldexp(1.0, -15 - i % 30),
                   turned = i % 3 == 0 ? random.uniform(-3, 3) : 0;
      const auto nudge = [&] { return off * random.uniform(-1, 1); };
      FourPoseTask task;
      for (int j = 0; j < 4; ++j) {
        const double along = j * x + nudge(), across = i % 2 == 0 ? j * y + nudge() : random.uniform(-1, 1);
        const Vector2 at = unit * rotated(pose_from_radians(0, 0, turned), {along, across});
        task[static_cast<std::size_t>(j)] = pose_from_radians(at[0], at[1], turned + turn * (j + nudge()));
      }
      std::rotate(task.begin(), task.begin() + i % 4, task.end());
      expect_whole(task, fmt::format("turn {}, set {}", turn, i));
    }
}

}  // namespace
}  // namespace burmester::planar
