// The curves of four poses: every pair of points meets the poses, nothing is missed, and what other solvers find lies on
// them.
#include "burmester/planar/four_pose_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "burmester/planar/five_pose_solver.hpp"

namespace burmester::planar {
namespace {

using FourPoseTask = std::array<Pose, 4>;

FourPoseTask random_task(Random& random) {
  FourPoseTask task;
  for (Pose& p : task) p = Space::random_pose(random);
  return task;
}

double distance_to_chord(const Vector2& p, const std::vector<double>& from, const std::vector<double>& to) {
  const Vector2 a(from[0], from[1]), d = Vector2(to[0], to[1]) - a;
  const double t = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - t * d).norm();
}

/// Distance of a point from the polylines, moving or fixed, less their errors.
double distance(const Vector2& p, const std::vector<CurveRecord>& curves, bool moving) {
  double best = 1e300;
  for (const CurveRecord& curve : curves) {
    const auto& points = moving ? curve.moving : curve.fixed;
    for (std::size_t k = curve.closed ? 0 : 1; k < points.size(); ++k)
      best = std::min(best, distance_to_chord(p, points[k == 0 ? points.size() - 1 : k - 1], points[k]) - curve.max_error);
  }
  return best;
}

bool within(const Vector2& moving, const Vector2& fixed, const FourPoseTask& task) {
  const double window = 8 * power_of_two_below(task_size(task)) * 0.99;
  const Vector2 m = rotated({0, 0, task[0].X3, task[0].X4}, moving), c = fixed - Vector2(task[0].x, task[0].y);
  return m.cwiseAbs().maxCoeff() < window && c.cwiseAbs().maxCoeff() < window;
}

TEST(FourPoseCurves, PairedPointsMeetThePoses) {
  Random random("FourPoseCurves.PairedPointsMeetThePoses");
  int pairs = 0;
  for (int i = 0; i < 1000; ++i) {
    const FourPoseTask task = random_task(random);
    const FourPoseCurves curves = four_pose_curves(task, {1e-3, 1, 8});
    ASSERT_NE(curves.topology.rung, Rung::none) << i;
    ASSERT_FALSE(curves.pieces.empty()) << i;
    EXPECT_TRUE(curves.complete) << i;
    for (const CurveRecord& piece : curves.pieces) {
      ASSERT_EQ(piece.moving.size(), piece.fixed.size());
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++pairs) {
        const Vector2 m(piece.moving[k][0], piece.moving[k][1]), c(piece.fixed[k][0], piece.fixed[k][1]);
        double least = 1e300, largest = 0;
        for (const Pose& pose : task) {
          const double r = (to_fixed(pose, m) - c).norm();
          least = std::min(least, r), largest = std::max(largest, r);
        }
        // The pair is on the cubics to rounding; distances may differ by that over the angle at which the bisectors meet.
        EXPECT_LT(largest - least, 1e-9 * (task_size(task) + largest)) << i;
      }
    }
  }
  EXPECT_GT(pairs, 50000);
}

TEST(FourPoseCurves, FivePoseDyadsLieOnAllFiveCurves) {
  Random random("FourPoseCurves.FivePoseDyadsLieOnAllFiveCurves");
  int dyads = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<Pose, 5> five;
    for (Pose& p : five) p = Space::random_pose(random);
    const PlanarReport report = FivePoseSolver{.certify = false}.solve(five);
    for (std::size_t left_out = 0; left_out < 5; ++left_out) {
      FourPoseTask four;
      for (std::size_t j = 0, k = 0; j < 5; ++j)
        if (j != left_out) four[k++] = five[j];
      const FourPoseCurves curves = four_pose_curves(four);
      for (const auto& found : report.dyads) {
        const auto* rr = std::get_if<RR::Design>(&found.design);
        if (!rr || !within(rr->moving, rr->fixed, four)) continue;
        ++dyads;
        EXPECT_LT(distance(rr->moving, curves.pieces, true), 1e-9) << i;
        EXPECT_LT(distance(rr->fixed, curves.pieces, false), 1e-9) << i;
      }
    }
  }
  EXPECT_GT(dyads, 500);
}

TEST(FourPoseCurves, SlidersMeetThePosesAndSwapUnderInversion) {
  Random random("FourPoseCurves.SlidersMeetThePosesAndSwapUnderInversion");
  for (int i = 0; i < 200; ++i) {
    const FourPoseTask task = random_task(random);
    FourPoseTask inverse;
    for (std::size_t j = 0; j < 4; ++j) inverse[j] = Space::pose(Space::conjugate<double>(Space::point<double>(task[j])));
    const PlanarReport report = FourPoseSolver().solve(task), turned = FourPoseSolver().solve(inverse);
    ASSERT_EQ(report.dyads.size(), 2u) << i;
    ASSERT_EQ(turned.dyads.size(), 2u) << i;
    const auto& pr = std::get<PR::Design>(report.dyads[0].design);
    const auto& rp = std::get<RP::Design>(report.dyads[1].design);
    for (const auto& found : report.dyads) EXPECT_LT(found.residual, 1e-9 * (1 + pr.moving.norm() + rp.fixed.norm())) << i;
    const auto& turned_rp = std::get<RP::Design>(turned.dyads[1].design);
    EXPECT_LT((turned_rp.fixed - pr.moving).norm(), 1e-7 * (1 + pr.moving.norm())) << i;
  }
}

TEST(FourPoseCurves, TheOrderOfThePosesDoesNotMatter) {
  Random random("FourPoseCurves.TheOrderOfThePosesDoesNotMatter");
  for (int i = 0; i < 100; ++i) {
    FourPoseTask task = random_task(random);
    const FourPoseCurves before = four_pose_curves(task);
    std::reverse(task.begin() + 1, task.end());
    const FourPoseCurves after = four_pose_curves(task);
    EXPECT_EQ(before.topology.components, after.topology.components) << i;
    EXPECT_EQ(before.topology.ovals, after.topology.ovals) << i;
    for (const CurveRecord& piece : after.pieces)
      for (std::size_t k = 0; k < piece.moving.size(); k += 7) {
        const Vector2 m(piece.moving[k][0], piece.moving[k][1]), c(piece.fixed[k][0], piece.fixed[k][1]);
        if (!within(m, c, task)) continue;
        EXPECT_LT(distance(m, before.pieces, true), 1e-9) << i;
      }
  }
}

/// Two sets of four positions, computed by the dyad form (compatibility linkage, position analysis) in 15 digits: pairs of
/// circle and centre point, the six poles, the sliders. Where the compatibility linkage turns fully its two modes are the
/// two components of the curve.
struct Published {
  std::array<std::array<double, 3>, 4> poses;
  int components;
  std::vector<std::array<double, 4>> pairs;
  std::vector<std::array<double, 2>> poles;
  std::array<double, 3> PR, RP;  ///< pivot and direction of the line in degrees
};

TEST(FourPoseCurves, AgreeWithTheDyadForm) {
  const Published sets[] = {
      {{{{0, 0, 0}, {-2.7, 0.5, -55}, {3.9, -0.9, 75}, {1.3, -2, 50}}},
       2,
       {{-0.4419843584457464, 2.5382204160716286, 0.17853593789558442, 0.7860976992043189},
        {2.5101974924631394, 1.6403843660273563, 9.863848551604063, -8.703725882451646},
        {0.6329112568989839, 2.255364118409023, 0.7716390632322574, 0.9637904477096992}},
       {{-0.8697544682572086, 2.843325871411074},
        {2.5364514177785424, 2.0912894770403514},
        {2.7945069205095585, 0.3939294983312131},
        {0.9264153607084991, 1.3388152719114954},
        {0.25915873497370046, 0.7846539759579206},
        {0.11911032298586857, 4.413921054760674}},
       {2.5556155220862196, 1.353002973339223, 38.986923810045504},
       {-0.4154912580278662, 4.555738417056104, 12.642958581391746}},
      {{{{0, 0, 0}, {1.5, 0.8, 20}, {3.2, 0.9, 50}, {4, -0.6, 85}}},
       1,
       {{2.237594863249881, 2.2224406285983154, -2.8957352921341264, 5.235553666125028},
        {2.821743589528946, 2.7599265009322216, 1.8731285370836521, 3.8347962570515306},
        {1.2069279544638651, 1.8962591170836363, 2.3551981603525847, 1.9074802131823707},
        {3.13627327655793, 2.9438178073211696, 2.135452849607466, 3.9981394914475996}},
       {{-1.5185127278470838, 4.653461364713282},
        {0.6349718857706986, 3.8812110728152938},
        {2.3273925503207815, 1.8826170021385429},
        {2.163397459621556, 4.0222431864335455},
        {3.8487799039822432, 2.062106971396863},
        {5.978696101772409, 1.418637920945285}},
       {-1.4615035892119252, -4.1506159021961295, 10.37100280777032},
       {5.115332877588492, 9.895472558467297, 180 - 61.68449443033245}}};
  for (const Published& set : sets) {
    FourPoseTask task;
    for (std::size_t j = 0; j < 4; ++j) task[j] = pose_from_degrees(set.poses[j][0], set.poses[j][1], set.poses[j][2]);
    const PlanarReport report = FourPoseSolver().solve(task);
    EXPECT_EQ(four_pose_curves(task).topology.components, set.components);
    for (const auto& [mx, my, cx, cy] : set.pairs) {
      EXPECT_LT(distance({mx, my}, report.curves, true), 1e-12);
      EXPECT_LT(distance({cx, cy}, report.curves, false), 1e-12);
    }
    for (const auto& [x, y] : set.poles) EXPECT_LT(distance({x, y}, report.curves, false), 1e-12) << x << " " << y;
    ASSERT_EQ(report.dyads.size(), 2u);
    const auto& pr = std::get<PR::Design>(report.dyads[0].design);
    const auto& rp = std::get<RP::Design>(report.dyads[1].design);
    EXPECT_LT((pr.moving - Vector2(set.PR[0], set.PR[1])).norm(), 1e-12);
    EXPECT_LT((rp.fixed - Vector2(set.RP[0], set.RP[1])).norm(), 1e-12);
    EXPECT_NEAR(pr.line.record().angle * 180 / std::numbers::pi, set.PR[2], 1e-11);
    EXPECT_NEAR(rp.line.record().angle * 180 / std::numbers::pi, set.RP[2], 1e-11);
  }
}

TEST(FourPoseCurves, DegeneratePosesAreNamedAndSymmetricOnesSplit) {
  const Pose a = pose_from_degrees(0, 0, 0), b = pose_from_degrees(2, 1, 40), c = pose_from_degrees(-1, 3, 100);
  for (const FourPoseTask& task :
       {FourPoseTask{a, b, b, c}, FourPoseTask{a, pose_from_degrees(1, 0, 0), pose_from_degrees(0, 2, 0), pose_from_degrees(3, 1, 0)},
        FourPoseTask{a, pose_from_degrees(0, 0, 30), pose_from_degrees(0, 0, 60), pose_from_degrees(0, 0, 90)}}) {
    const PlanarReport report = FourPoseSolver().solve(task);
    EXPECT_EQ(report.status, Status::degenerate) << report.message;
    EXPECT_TRUE(report.curves.empty());
  }
  // Mirror images of each other in pairs, quarter turns, small integers: exact. The cubic splits into a line and a conic.
  const FourPoseTask mirrored{pose_from_degrees(-1, 0, -90), pose_from_degrees(1, 0, 90), pose_from_degrees(-3, 2, 0), pose_from_degrees(3, 2, 0)};
  const PlanarReport report = FourPoseSolver().solve(mirrored);
  EXPECT_EQ(report.status, Status::family) << report.message;
  // One translation among them is an ordinary task.
  EXPECT_EQ(FourPoseSolver().solve(FourPoseTask{a, pose_from_degrees(2, 0, 0), b, c}).status, Status::family);
}

}  // namespace
}  // namespace burmester::planar
