// Dyads near given points: on the curve, and no point of the traced curve is nearer.
#include "burmester/planar/near_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burmester::planar {
namespace {

using FourPoseTask = std::array<Pose, 4>;

FourPoseTask random_task(Random& random) {
  FourPoseTask task;
  for (Pose& p : task) p = Space::random_pose(random);
  return task;
}

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
    const FourPoseTask task = random_task(random);
    const FourPoseCurves curves = four_pose_curves(task);
    const Vector2 q = Space::random_feature(random);
    for (const auto& found : dyads_near(task, curves.pieces, {{q[0], q[1]}}, true)) {
      const auto& d = std::get<RR::Design>(found.design);
      ++all, certified += found.certificate.certified;
      EXPECT_LT(found.residual, 1e-11 * (1 + d.length)) << i;
      EXPECT_LE((d.fixed - q).norm(), nearest_vertex(q, curves.pieces) + 1e-12) << i;
      EXPECT_LT(found.certificate.radius, 1e-6 * (1 + d.length)) << i;
    }
  }
  EXPECT_GE(all, 58);
  EXPECT_GE(certified, all - 2);
}

TEST(NearCurve, ACentrePointIsNearestToItself) {
  Random random("NearCurve.ACentrePointIsNearestToItself");
  for (int i = 0; i < 40; ++i) {
    const FourPoseTask task = random_task(random);
    const FourPoseCurves curves = four_pose_curves(task);
    const Vector2 q = Space::random_feature(random);
    const auto first = dyads_near(task, curves.pieces, {{q[0], q[1]}}, false);
    if (first.empty()) continue;
    const auto& d = std::get<RR::Design>(first[0].design);
    const auto again = dyads_near(task, curves.pieces, {{d.fixed[0], d.fixed[1]}}, false);
    ASSERT_EQ(again.size(), 1u) << i;
    EXPECT_LT((std::get<RR::Design>(again[0].design).fixed - d.fixed).norm(), 1e-11 * (1 + d.fixed.norm())) << i;
  }
}

TEST(NearCurve, ScaleAndOriginDoNotMatter) {
  Random random("NearCurve.ScaleAndOriginDoNotMatter");
  for (int i = 0; i < 20; ++i) {
    const FourPoseTask task = random_task(random);
    FourPoseTask large = task;
    for (Pose& p : large) p.x = 1024 * p.x, p.y = 1024 * p.y;
    const Vector2 q = Space::random_feature(random);
    const auto a = dyads_near(task, four_pose_curves(task).pieces, {{q[0], q[1]}}, true);
    const auto b = dyads_near(large, four_pose_curves(large).pieces, {{1024 * q[0], 1024 * q[1]}}, true);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_LT((1024 * std::get<RR::Design>(a[k].design).fixed - std::get<RR::Design>(b[k].design).fixed).norm(), 1e-9)
          << i;
  }
}

}  // namespace
}  // namespace burmester::planar
