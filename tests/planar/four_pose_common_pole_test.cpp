// Three of four poses about one point O, exactly or nearly. The dyads are known by construction: the fixed pivot O with
// the moving pivots on the perpendicular bisector of O and its place in the body in pose 4, and the moving pivot O with
// the fixed pivots on the bisector of O and its place in pose 4 (docs/curves.md).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "burmester/planar/near_curve.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

using testing::HasSubstr;

struct Pair {
  Vector2 moving, fixed;
};

/// Three rotations about the origins of both frames and a fourth pose, in random order; points of both lines.
struct AboutOrigin {
  FourPoseTask task;
  std::vector<Pair> dyads;

  explicit AboutOrigin(Random& random) {
    for (std::size_t j = 0; j < 3; ++j)
      task[j] = pose_from_radians(0, 0, 2 * static_cast<double>(j) + random.uniform(-0.7, 0.7));
    task[3] = Space::random_pose(random);
    const Vector2 ahead(task[3].x, task[3].y), back = to_moving(task[3], {0, 0});
    const auto on_bisector = [](const Vector2& of, double t) { return Vector2(of / 2 + t * Vector2(-of[1], of[0])); };
    for (const double t : {-1.7, -0.6, 0.01, 0.4, 1.3})
      dyads.push_back({on_bisector(back, t), {0, 0}}), dyads.push_back({{0, 0}, on_bisector(ahead, t)});
    for (std::size_t j = 4; j > 1; --j) {
      const auto k = static_cast<std::size_t>(random.uniform(0, static_cast<double>(j)));
      std::swap(task[j - 1], task[k]);
    }
  }
};

/// Distance of a dyad from the pairs listed, in both planes at once.
double distance_from(const Pair& dyad, const std::vector<CurveRecord>& curves) {
  double best = std::numeric_limits<double>::infinity();
  for (const CurveRecord& piece : curves)
    for (std::size_t k = 1; k < piece.moving.size(); ++k) {
      Vector<double, 4> a, b, p;
      a << piece.moving[k - 1][0], piece.moving[k - 1][1], piece.fixed[k - 1][0], piece.fixed[k - 1][1];
      b << piece.moving[k][0], piece.moving[k][1], piece.fixed[k][0], piece.fixed[k][1];
      p << dyad.moving, dyad.fixed;
      const Vector<double, 4> d = b - a;
      const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0;
      best = std::min(best, (p - a - t * d).norm());
    }
  return best;
}

/// Whole, in few points, each of which meets the poses.
FourPoseCurves whole_curves(const FourPoseTask& task, const std::string& name) {
  FourPoseCurves curves = four_pose_curves(task);
  EXPECT_TRUE(curves.complete) << name;
  EXPECT_EQ(curves.topology.components, 2) << name;
  std::size_t points = 0;
  for (const CurveRecord& piece : curves.pieces) {
    points += piece.moving.size();
    for (std::size_t k = 0; k < piece.moving.size(); ++k)
      EXPECT_LT(concyclicity(task, {piece.moving[k][0], piece.moving[k][1]}, {piece.fixed[k][0], piece.fixed[k][1]}),
                1e-12)
          << name;
  }
  EXPECT_LT(points, 3000u) << name;
  return curves;
}

TEST(CommonPole, ExactlyBothLinesAreListed) {
  Random random("CommonPole.ExactlyBothLinesAreListed");
  for (int i = 0; i < 200; ++i) {
    const AboutOrigin set(random);
    const FourPoseCurves curves = whole_curves(set.task, fmt::format("set {}", i));
    EXPECT_EQ(curves.topology.isolated, 1) << i;
    EXPECT_EQ(curves.lines_of_partners, 1) << i;
    for (const Pair& dyad : set.dyads) EXPECT_LT(distance_from(dyad, curves.pieces), 1e-14) << i;
  }
}

/// In frames of its own, and off by `by`.
struct Moved {
  FourPoseTask task;
  Pose fixed_frame, moving_frame;  ///< S' in S and E' in E
  Moved(const AboutOrigin& set, double by, Random& random)
      : fixed_frame(Space::random_pose(random)), moving_frame(Space::random_pose(random)) {
    for (std::size_t j = 0; j < 4; ++j) {
      task[j] = Space::pose(
          Space::product<double>(Space::product<double>(Space::conjugate<double>(Space::point<double>(fixed_frame)),
                                                        Space::point<double>(set.task[j])),
                                 Space::point<double>(moving_frame)));
      task[j].x += by * random.uniform(-1, 1), task[j].y += by * random.uniform(-1, 1);
    }
  }
  Pair seen(const Pair& dyad) const {
    return {to_moving(moving_frame, dyad.moving), to_moving(fixed_frame, dyad.fixed)};
  }
};

TEST(CommonPole, NearlyTheSameDyadsAreListed) {
  Random random("CommonPole.NearlyTheSameDyadsAreListed");
  for (const double by : {0.0, 0x1p-52, 1e-15, 1e-12, 1e-9, 1e-6})
    for (int i = 0; i < 40; ++i) {
      const AboutOrigin set(random);
      const Moved moved(set, by, random);
      const FourPoseCurves curves = whole_curves(moved.task, fmt::format("{} {}", by, i));
      for (const Pair& dyad : set.dyads)
        EXPECT_LT(distance_from(moved.seen(dyad), curves.pieces), 1e-4 * task_size(moved.task) + 1e3 * by)
            << by << " " << i;
    }
}

/// Nearly the same turns make two of the correlations nearly multiples of each other, in any order of the poses.
TEST(CommonPole, SmallStepsInEveryOrder) {
  constexpr double degree = std::numbers::pi / 180;
  for (const double step : {1.0, 0.5, 0.1}) {
    std::array<Pose, 4> poses;
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = (20 + step * static_cast<double>(k)) * degree;
      poses[k] = pose_from_radians(2 + 1.1 * std::cos(at), 1 + 1.1 * std::sin(at), at);
    }
    poses[3] = pose_from_radians(1.5, 2.5, 75 * degree);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      FourPoseTask task;
      for (std::size_t k = 0; k < 4; ++k) task[k] = poses[order[k]];
      whole_curves(task, fmt::format("steps of {} deg, order {}{}{}{}", step, order[0], order[1], order[2], order[3]));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// The set of the inverse motion has fixed and moving pivots exchanged.
TEST(CommonPole, InversionExchangesThePivots) {
  Random random("CommonPole.InversionExchangesThePivots");
  for (int i = 0; i < 60; ++i) {
    const AboutOrigin set(random);
    const Moved moved(set, i % 2 == 0 ? 1e-15 : 1e-8, random);
    FourPoseTask inverse;
    for (std::size_t j = 0; j < 4; ++j)
      inverse[j] = Space::pose(Space::conjugate<double>(Space::point<double>(moved.task[j])));
    const FourPoseCurves there = whole_curves(moved.task, "there"), back = whole_curves(inverse, "back");
    for (const Pair& dyad : set.dyads) {
      const Pair seen = moved.seen(dyad);
      EXPECT_LT(distance_from({seen.fixed, seen.moving}, back.pieces), 1e-3 * task_size(inverse)) << i;
    }
    EXPECT_EQ(there.pieces.size(), back.pieces.size()) << i;
  }
}

TEST(CommonPole, IsNamedInTheReport) {
  const FourPoseTask exact = four_poses({{{0, 0, 0}, {0, 0, 60}, {1, 0.5, 30}, {0, 0, 120}}});
  EXPECT_THAT(FourPoseSolver().solve(exact).message,
              HasSubstr("poses 1, 2 and 4 turn about one point, (0, 0), to within rounding"));
  EXPECT_TRUE(FourPoseSolver().solve(exact).warnings.empty());
  const FourPoseTask nearly = four_poses({{{1, 0.5, 30}, {0, 0, 0}, {1e-6, 0, 60}, {0, 0, 120}}});
  EXPECT_THAT(FourPoseSolver().solve(nearly).message, HasSubstr("poses 2, 3 and 4 turn about one point, ("));
  EXPECT_THAT(FourPoseSolver().solve(nearly).message, HasSubstr("to within 1.7e-06"));
  const auto about = [](const Vector2& pole, double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    return pose_from_radians(pole[0] - c * pole[0] + s * pole[1], pole[1] - s * pole[0] - c * pole[1], angle);
  };
  const Vector2 on_axis(0.3, 0);  // the pole comes out with a second coordinate of 1e-17
  const FourPoseTask rounded{about(on_axis, 0.2), about(on_axis, 1), about(on_axis, 2), pose_from_radians(1, 0.5, 0.6)};
  EXPECT_THAT(FourPoseSolver().solve(rounded).message, HasSubstr("turn about one point, (0.3, 0), to within rounding"));
  // three small turns about a far point, within a third of the task's size
  FourPoseTask far{about({0, 300}, 0), about({0, 300}, 1e-3), about({0, 300}, 2.2e-3),
                   pose_from_radians(0.3, 1, 1.5e-3)};
  far[2].x += 3e-4;
  EXPECT_THAT(FourPoseSolver().solve(far).message,
              HasSubstr("; the poles of poses 1, 2 and 3 are close together for curves of this extent, within 2.5e-01 "
                        "of (0, 300): one pivot of each dyad is near them"));
  FourPoseTask all;
  for (std::size_t j = 0; j < 4; ++j) {
    const double angle = 0.1 + 0.7 * static_cast<double>(j);
    all[j] = pose_from_radians(2 + std::cos(angle), 1 + std::sin(angle), angle);
  }
  const PlanarReport report = FourPoseSolver().solve(all);
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_THAT(report.message, HasSubstr("to within rounding; all four poses are rotations about one point, (2, 1)"));
}

TEST(CommonPole, NearDoesNotDependOnTheOrder) {
  for (const double off : {0.0, 1e-15, 1e-9}) {
    FourPoseTask task{pose_from_radians(0, 0, 0), pose_from_radians(off, 0, 1), pose_from_radians(0, off / 2, 2),
                      pose_from_radians(1, 0.5, 0.5)};
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      FourPoseTask ordered;
      for (std::size_t j = 0; j < 4; ++j) ordered[j] = task[order[j]];
      const auto curves = four_pose_curves(ordered).pieces;
      const NearDyads on_line = dyads_near(ordered, curves, {{1, 1}}, true);
      ASSERT_EQ(on_line.dyads.size(), 1u) << off;
      const auto& found = on_line.dyads[0];
      const auto& rr = std::get<RR::Design>(found.design);
      EXPECT_LT((rr.fixed - Vector2(0.3, 0.65)).norm(), 1e-15 + 10 * off);  // the foot on x + y / 2 = 5 / 8
      EXPECT_LT(rr.moving.norm(), 1e-15 + 10 * off);
      EXPECT_LT(found.residual, 1e-15);
      EXPECT_TRUE(found.certificate.certified && on_line.warnings.empty());

      const NearDyads at_pole = dyads_near(ordered, curves, {{0.1, 0}}, true);
      if (off < 1e-14) {
        EXPECT_TRUE(at_pole.dyads.empty());
        ASSERT_EQ(at_pole.warnings.size(), 1u);
        EXPECT_THAT(at_pole.warnings[0], HasSubstr("the nearest centre point is a common pole"));
      } else {
        ASSERT_EQ(at_pole.dyads.size(), 1u);
        EXPECT_LT(std::get<RR::Design>(at_pole.dyads[0].design).fixed.norm(), 10 * off);
        EXPECT_LT(at_pole.dyads[0].residual, 1e-14);
      }
    } while (std::ranges::next_permutation(order).found);
  }
}

}  // namespace
}  // namespace burmester::planar
