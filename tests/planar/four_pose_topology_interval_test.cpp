// The topology of the curves of four poses, as it is found first (intervals, from a pole), against rational numbers.
#include <gtest/gtest.h>

#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

TEST(FourPoseTopology, IsTheExactOneOfBothCurves) {
  Random random("FourPoseTopology.IsTheExactOneOfBothCurves");
  int intervals = 0, ovals = 0;
  for (int i = 0; i < 1000; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const CurveTopology found = four_pose_curves(task, {1, 1, 0.01}).topology;
    intervals += found.rung == Rung::intervals;
    ovals += found.ovals;
    const ExactCubics cubics(task);
    const Correlation<Rational> n = equidistance<Rational>(task[0], task[2], 1 / power_of_two_below(task_size(task)));
    const CurveTopology moving = branches_by_rationals(cubics.moving(), vertex(n)).topology,
                        fixed = branches_by_rationals(cubics.fixed(), vertex<Rational>(n.transpose())).topology;
    for (const CurveTopology& exact :
         {moving, fixed}) {  // the partner map is one to one: both curves have one topology
      ASSERT_EQ(exact.rung, Rung::exact) << i;
      EXPECT_EQ(found.components, exact.components) << i;
      EXPECT_EQ(found.ovals, exact.ovals) << i;
      EXPECT_EQ(found.singular.size(), exact.singular.size()) << i;
    }
  }
  EXPECT_GT(intervals, 990);
  EXPECT_GT(ovals, 100);
}

}  // namespace
}  // namespace burmester::planar
