// Dyads near given points: on the curve, and no point of the traced curve is nearer.
#include "burmester/planar/near_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "four_poses.hpp"

namespace burmester::planar {
namespace {

double nearest_vertex(const Vector2& q, const std::vector<CurveRecord>& curves) {
  double best = 1e300;
  for (const CurveRecord& curve : curves)
    for (const auto& c : curve.fixed) best = std::min(best, (Vector2(c[0], c[1]) - q).norm());
  return best;
}

TEST(NearCurve, NoTracedPointIsNearerAndAllPosesAreMet) {
  Random random("NearCurve.NoTracedPointIsNearerAndAllPosesAreMet");
  int certified = 0, all = 0;
  for (int i = 0; i < 60; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const FourPoseCurves curves = four_pose_curves(task);
    const Vector2 q = Space::random_feature(random);
    for (const auto& found : dyads_near(task, curves.pieces, {{q[0], q[1]}}, true).dyads) {
      const auto& d = std::get<RR::Design>(found.design);
      ++all, certified += found.certificate.certified;
      EXPECT_LT(found.residual, 1e-11 * (1 + d.length)) << i;
      EXPECT_LE((d.fixed - q).norm(), nearest_vertex(q, curves.pieces) + 1e-12) << i;
      if (found.certificate.certified) {
        EXPECT_LT(found.certificate.radius, 1e-6 * (1 + d.length)) << i;
      }
    }
  }
  EXPECT_GE(all, 58);
  EXPECT_GE(certified, all - 2);
}

TEST(NearCurve, ACentrePointIsNearestToItself) {
  Random random("NearCurve.ACentrePointIsNearestToItself");
  for (int i = 0; i < 40; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const FourPoseCurves curves = four_pose_curves(task);
    const Vector2 q = Space::random_feature(random);
    const auto first = dyads_near(task, curves.pieces, {{q[0], q[1]}}, false).dyads;
    if (first.empty()) continue;
    const auto& d = std::get<RR::Design>(first[0].design);
    const auto again = dyads_near(task, curves.pieces, {{d.fixed[0], d.fixed[1]}}, false).dyads;
    ASSERT_EQ(again.size(), 1u) << i;
    EXPECT_LT((std::get<RR::Design>(again[0].design).fixed - d.fixed).norm(), 1e-11 * (1 + d.fixed.norm())) << i;
  }
}

TEST(NearCurve, ScaleAndOriginDoNotMatter) {
  Random random("NearCurve.ScaleAndOriginDoNotMatter");
  int listed = 0;
  for (int i = 0; i < 20; ++i) {
    const FourPoseTask task = random_four_poses(random);
    FourPoseTask moved = task;
    const auto carried = [](double x, double y) { return Vector2(1024 * x + 3000, 1024 * y - 500); };
    for (Pose& p : moved) {
      const Vector2 at = carried(p.x, p.y);
      p.x = at[0], p.y = at[1];
    }
    const Vector2 q = Space::random_feature(random), r = carried(q[0], q[1]);
    const auto a = dyads_near(task, four_pose_curves(task).pieces, {{q[0], q[1]}}, true).dyads;
    const auto b = dyads_near(moved, four_pose_curves(moved).pieces, {{r[0], r[1]}}, true).dyads;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k, ++listed) {
      const Vector2 c = std::get<RR::Design>(a[k].design).fixed;
      EXPECT_LT((carried(c[0], c[1]) - std::get<RR::Design>(b[k].design).fixed).norm(), 1e-8) << i;
    }
  }
  EXPECT_GE(listed, 18);
}

NearDyads nearest_of(const FourPoseTask& task, const std::vector<std::vector<double>>& near, bool certify = true) {
  return dyads_near(task, four_pose_curves(task).pieces, near, certify);
}

bool says(const NearDyads& answer, std::size_t k, const char* words) {
  return k < answer.warnings.size() && answer.warnings[k].find(words) != std::string::npos;
}

/// Every point is answered by a dyad or a warning, also where several poles coincide and the curve has a double point.
TEST(NearCurve, DoublePointsAreAnswered) {
  const FourPoseTask tasks[] = {four_poses({{{0, 0, 0}, {2, 0, 180}, {0, 2, 180}, {2, 2, 0}}}),
                                four_poses({{{0, 0, 0}, {1, 0, 0}, {0, 0, 180}, {1, 0, 180}}}),
                                four_poses({{{0, 0, 0}, {0, 0, 30}, {0, 0, 80}, {3, 1, -50}}})};
  for (const FourPoseTask& task : tasks)
    for (const std::vector<double>& q : std::vector<std::vector<double>>{{1, 1}, {0, 0}, {0.5, 0}, {0.3, 2}})
      for (const bool certify : {false, true}) {
        const NearDyads answer = nearest_of(task, {q}, certify);
        EXPECT_EQ(answer.dyads.size() + answer.warnings.size(), 1u) << q[0] << " " << q[1];
        for (const auto& found : answer.dyads) {
          const auto& d = std::get<RR::Design>(found.design);
          EXPECT_LT(concyclicity(task, d.moving, d.fixed), 1e-9) << q[0] << " " << q[1];
        }
      }
}

TEST(NearCurve, PointsWithoutADyadAndTheEndOfTheTraceAreTold) {
  const FourPoseTask task = four_poses({{{0, 0, 0}, {2, 1, 30}, {3, -1, 75}, {1, 4, -20}}});
  const NearDyads far = nearest_of(task, {{0, 0}, {1000, 1000}});
  EXPECT_EQ(far.dyads.size(), 2u);
  ASSERT_EQ(far.warnings.size(), 1u);
  EXPECT_TRUE(says(far, 0, "near[1]: the curve is traced no farther")) << far.warnings[0];

  const PlanarReport report = FourPoseSolver().solve(task);
  const auto slider = std::ranges::find_if(
      report.dyads, [](const auto& found) { return std::holds_alternative<RP::Design>(found.design); });
  ASSERT_NE(slider, report.dyads.end());
  const Vector2 pivot = std::get<RP::Design>(slider->design).fixed;
  std::vector<CurveRecord> through(1);  // the curve near the slider's pivot
  through[0].fixed = {{pivot[0] - 1e-9, pivot[1]}, {pivot[0] + 1e-9, pivot[1]}};
  const NearDyads at_slider = dyads_near(task, through, {{pivot[0], pivot[1]}}, true);
  EXPECT_TRUE(at_slider.dyads.empty());
  EXPECT_TRUE(says(at_slider, 0, "near[0]: the nearest centre point is the pivot of a slider"));

  const NearDyads none = nearest_of(four_poses({{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}}), {{1, 1}, {2, 2}});
  EXPECT_TRUE(none.dyads.empty());
  EXPECT_EQ(none.warnings.size(), 2u);
  EXPECT_TRUE(says(none, 1, "near[1]: no curve is listed"));
}

}  // namespace
}  // namespace burmester::planar
