// The direct solver of five poses against the intersection of two circle-point curves, in exact arithmetic.
#include "burmester/planar/four_pose_intersection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {
namespace {

TEST(FourPoseIntersection, FindsWhatTheDirectSolverFinds) {
  int dyads = 0;
  std::array<int, 5> count{};
  for (const std::string_view name :
       {"generic", "offset_origin", "small_rotations", "planted_four_bar", "exact_half_turn"}) {
    const std::string seed = "FourPoseIntersection.FindsWhatTheDirectSolverFinds." + std::string(name);
    Random random(seed);
    for (int i = 0; i < (name == "generic" ? 120 : 20); ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      const CommonDyads common = intersected_four_pose_curves(task);
      ASSERT_EQ(common.reason, "") << seed << " " << i;
      const PlanarReport report = FivePoseSolver().solve(task);
      ASSERT_TRUE(report.counts.certified) << seed << " " << i;
      ASSERT_EQ(common.dyads.size(), report.dyads.size()) << seed << " " << i;
      ++count[common.dyads.size()];
      for (const auto& found : report.dyads) {
        const auto& rr = std::get<RR::Design>(found.design);
        // The exact dyad is within the proved radius of the one shown; shown here it is rounded once more.
        const double coordinates = std::abs(task[0].x) + std::abs(task[0].y) + rr.fixed.norm() + rr.moving.norm();
        const double radius = found.certificate.radius + 8 * unit_roundoff * coordinates;
        int matches = 0;
        for (const CommonDyad& c : common.dyads)
          matches += (c.moving - rr.moving).norm() <= radius && (c.fixed - rr.fixed).norm() <= radius;
        EXPECT_EQ(matches, 1) << seed << " " << i;
        ++dyads;
      }
      for (const CommonDyad& c : common.dyads) EXPECT_LT(c.centre_gap, 1e-20) << seed << " " << i;
    }
  }
  EXPECT_GT(dyads, 300);
  EXPECT_GT(std::min({count[0], count[2], count[4]}), 5);
  EXPECT_EQ(count[1] + count[3], 0);
}

TEST(FourPoseIntersection, SaysWhereTheCurvesHaveAPartInCommon) {
  Random random("FourPoseIntersection.SaysWhereTheCurvesHaveAPartInCommon");
  FivePoseTask equal = find_task_class("generic")->make(random), rotations = equal;
  equal[4] = equal[1];
  for (Pose& pose : rotations) pose.x = pose.y = 0;
  for (const FivePoseTask& task : {equal, find_task_class("all_parallel")->make(random), rotations})
    EXPECT_EQ(intersected_four_pose_curves(task).reason, "the two circle-point curves have a part in common");
}

}  // namespace
}  // namespace burmester::planar
