// Four poses with small turns: far curves, and what is said about the four-bars listed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "burmester/modules/framework/problem.hpp"
#include "burmester/planar/planar.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

FourPoseTask small_turns(Random& random, double turn) {
  FourPoseTask task;
  for (Pose& p : task) {
    const double x = random.normal(), y = random.normal();
    p = pose_from_radians(x, y, turn * random.normal());
  }
  return task;
}

Problem problem_of(const FourPoseTask& task) {
  Problem problem;
  for (const Pose& p : task) problem.poses.push_back({p.x, p.y, p.X3, p.X4});
  return problem;
}

bool says(const Synthesis& answer, const std::string& words) {
  return std::ranges::any_of(answer.warnings,
                             [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

TEST(SmallTurns, FourBarsAreListedOrSaidToBeMissing) {
  Random random("SmallTurns.FourBarsAreListedOrSaidToBeMissing");
  const auto module = make_module();
  int shorter = 0;
  for (const double turn : {1e-1, 1e-2, 1e-3}) {
    int listed = 0, widened = 0;
    for (int i = 0; i < 20; ++i) {
      const FourPoseTask task = small_turns(random, turn);
      const Synthesis answer = module->synthesize(problem_of(task));
      const bool far = says(answer, "the four-bars listed have pivots up to");
      ASSERT_TRUE(answer.candidates);
      EXPECT_EQ(answer.candidates->empty(), says(answer, "make a four-bar")) << turn << " " << i;
      const bool few = !answer.candidates->empty() && answer.candidates->size() < 6;
      EXPECT_EQ(few, says(answer, fmt::format("linkages: only {} of 6 found", answer.candidates->size())));
      shorter += few;
      Vector2 centroid(0, 0);
      for (const Pose& p : task) centroid += Vector2(p.x, p.y) / 4;
      double reach = 0;
      for (const CandidateRecord& candidate : *answer.candidates)
        for (const DyadRecord& dyad : candidate.dyads) {
          const Vector2 fixed(dyad.fixed[0], dyad.fixed[1]), moving(dyad.moving[0], dyad.moving[1]);
          EXPECT_LT(concyclicity(task, moving, fixed), 1e-12 * (1 + moving.norm() / task_size(task)))
              << turn << " " << i;
          for (const Vector2& p : {fixed, to_fixed(task[0], moving)})
            reach = std::max(reach, (p - centroid).cwiseAbs().maxCoeff() / task_size(task));
        }
      EXPECT_TRUE(reach <= 2 || far) << turn << " " << i;
      listed += !answer.candidates->empty(), widened += far;
    }
    EXPECT_GE(listed, turn < 2e-3 ? 12 : 18) << turn;  // of 20; the smaller the turns, the longer ground and coupler
    EXPECT_GE(widened, 3) << turn;
  }
  EXPECT_GE(shorter, 1);
}

TEST(SmallTurns, RequestsAreAnsweredWhereThereIsNoCurve) {
  Problem parallel = problem_of(four_poses({{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}}));
  parallel.linkages.emplace().most = 3;
  const Synthesis answer = make_module()->synthesize(parallel);
  EXPECT_TRUE(says(answer, "linkages: no two dyads of the curves"));
  EXPECT_TRUE(answer.candidates && answer.candidates->empty());
}

/// Far or not is no matter of the unit of length or of the frame.
TEST(SmallTurns, UnitAndFrameChangeNoWords) {
  Random random("SmallTurns.UnitAndFrameChangeNoWords");
  int far = 0, near = 0;
  for (int i = 0; i < 60; ++i) {
    const FourPoseTask task = small_turns(random, 0.15);
    FourPoseTask other = task;
    const Pose frame = pose_from_radians(0, 0, 0.7);
    for (Pose& p : other) {
      const Vector2 at = 1.3 * to_fixed(frame, Vector2(p.x, p.y));
      p = pose_from_radians(at[0], at[1], angle_of(p) + 0.7);
    }
    ASSERT_EQ(curves_are_far(task), curves_are_far(other)) << i;
    const auto told = [](const FourPoseTask& poses) {
      return FourPoseSolver().solve(poses).message.find("the poles are far") != std::string::npos;
    };
    EXPECT_EQ(told(task), curves_are_far(task)) << i;
    EXPECT_EQ(told(other), curves_are_far(task)) << i;
    (curves_are_far(task) ? far : near) += 1;
  }
  EXPECT_GT(far, 10);
  EXPECT_GT(near, 10);
}

}  // namespace
}  // namespace burmester::planar
