// How near two dyads are to merging, against a discriminant in 50 digits; and what reports say about it.
#include "burmester/planar/merge_distance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "double_roots.hpp"

namespace burmester::planar {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(MergeDistance, IsRightBesideDoubleRoots) {
  const std::string stream = "MergeDistance.IsRightBesideDoubleRoots";
  Random random(stream), coordinates(stream + ".coordinates");
  double_roots::Outcome out;
  for (int i = 0; i < 40; ++i) double_roots::walk(random, coordinates, out);
  EXPECT_EQ(out.uncertified, 0) << stream;
  EXPECT_EQ(out.wrong_count, 0) << stream;
  EXPECT_EQ(out.missing, 0) << stream << ": warnings below 10 units in the last place";
  EXPECT_EQ(out.needless, 0) << stream << ": warnings above 1000 units in the last place";
  EXPECT_EQ(out.wrong_kind, 0) << stream;
  EXPECT_EQ(out.not_bracketed, 0) << stream;
  EXPECT_LT(out.largest_error, 0.01) << stream;
}

/// No task may be farther than the filter looks: |discriminant| over rounding against the distance, in units in the
/// last place. The solver looks up to 2^16 times the rounding, so 100 units are seen while the quotient is below 655.
TEST(MergeDistance, IsSeenByTheRoundingEstimate) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "MergeDistance.IsSeenByTheRoundingEstimate." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 100; ++i) {
      const FivePoseTask task = c.make(random);
      const FivePoseRoots<double> roots = five_pose_roots(task);
      const auto merging = merge_distance(roots.what, task, roots.anchor, roots.count);
      ASSERT_TRUE(merging) << stream << ", task " << i;
      EXPECT_LT(std::abs(roots.discriminant) / roots.rounding, 655 * merging->distance / unit_roundoff)
          << stream << ", task " << i;
    }
  }
}

/// Three parallel origins with circumradius 1 and two others, turned by 90 degrees, 2 + gap apart.
FivePoseTask two_orientations(double gap) {
  return {Pose{1, 0, 0, 1}, {0, 1, 0, 1}, {-1, 0, 0, 1}, {5, 1, 1, 1}, {7 + gap, 1, 1, 1}};
}

TEST(MergeDistance, OfTwoOrientations) {
  constexpr double step = 0x1p-50;  // of 7, the largest coordinate: 2^-50 is a unit in the last place of 7
  for (const int n : {-64, -4, 4, 64}) {
    const PlanarReport report = FivePoseSolver().solve(two_orientations(n * step));
    ASSERT_TRUE(report.counts.certified) << report.message;
    EXPECT_EQ(report.counts.real, n < 0 ? 2 : 0) << n;
    ASSERT_TRUE(report.counts.merge_distance) << n;
    // The gap closes by 2 d at the pair and by 2 dR of the triple, whose radius grows at most by sqrt 2 .. 2 per d.
    const double d = *report.counts.merge_distance * 7 / (std::abs(n) * step);
    EXPECT_TRUE(0.1 < d && d < 0.5) << n << ": " << d;
    EXPECT_EQ(report.warnings.size(), *report.counts.merge_distance < near_merging ? 1u : 0u) << n;
    EXPECT_THAT(report.message, HasSubstr(n < 0 ? "two of them would merge" : "two more would appear")) << n;
  }
}

TEST(MergeDistance, IsZeroWhereTwoDyadsCoincide) {
  const PlanarReport report = FivePoseSolver().solve(two_orientations(0));
  EXPECT_FALSE(report.counts.certified);
  ASSERT_TRUE(report.counts.merge_distance);
  EXPECT_EQ(*report.counts.merge_distance, 0);
  EXPECT_EQ(report.warnings.size(), 1u);
}

TEST(MergeDistance, IsNotStatedFarAway) {
  Random random("MergeDistance.IsNotStatedFarAway");
  const PlanarReport report = FivePoseSolver().solve(find_task_class("generic")->make(random));
  EXPECT_FALSE(report.counts.merge_distance);
  EXPECT_THAT(report.warnings, IsEmpty());
}

}  // namespace
}  // namespace burmester::planar
