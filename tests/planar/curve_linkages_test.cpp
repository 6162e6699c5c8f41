// Ranked four-bars from pairs of points of the curves: they keep what was asked for, and are as good as they are said
// to be.
#include "burmester/planar/curve_linkages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

#include "burmester/planar/linkage.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

double ratio_of(const CurveLinkage& l) {
  const double ground = (l.first.fixed - l.second.fixed).norm(), coupler = (l.first.moving - l.second.moving).norm();
  const auto [shortest, longest] = std::minmax({ground, l.first.length, coupler, l.second.length});
  return longest / shortest;
}

std::string class_of(const CurveLinkage& l) {
  return four_bar_class((l.first.fixed - l.second.fixed).norm(), l.first.length,
                        (l.first.moving - l.second.moving).norm(), l.second.length, 1e-12);
}

/// By trying: whether the driver's angles in the poses lie on one arc of angles at which the linkage closes, and the
/// other two links meet on one side. Angles are tried at 4000 places, limits hit more finely are not seen.
bool passes(const FourPoseTask& task, const RR::Design& driver, const RR::Design& driven) {
  const double coupler = (driver.moving - driven.moving).norm();
  const auto closes = [&](double angle) {
    const Vector2 a = driver.fixed + driver.length * Vector2(std::cos(angle), std::sin(angle));
    const double diagonal = (driven.fixed - a).norm();
    return diagonal < coupler + driven.length && diagonal > std::abs(coupler - driven.length);
  };
  std::array<double, 4> angles;
  int left = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const Vector2 a = to_fixed(task[j], driver.moving), b = to_fixed(task[j], driven.moving);
    angles[j] = std::atan2(a[1] - driver.fixed[1], a[0] - driver.fixed[0]);
    const Vector2 along = b - a, back = b - driven.fixed;
    left += along[0] * back[1] - along[1] * back[0] > 0;
  }
  if (left != 0 && left != 4) return false;
  std::ranges::sort(angles);
  int open = 0;  // gaps between neighbouring angles that the driver cannot cross
  for (std::size_t j = 0; j < 4; ++j) {
    const double to = j == 3 ? angles[0] + 2 * std::numbers::pi : angles[j + 1];
    bool crosses = true;
    for (int k = 1; k < 1000; ++k) crosses = crosses && closes(angles[j] + (to - angles[j]) * k / 1000);
    open += !crosses;
  }
  return open <= 1;
}

TEST(CurveLinkages, AreRankedAndMeetThePoses) {
  Random random("CurveLinkages.AreRankedAndMeetThePoses");
  int linkages = 0, good = 0, bad = 0;
  for (int i = 0; i < 100; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const auto found = linkages_from_curves(task, four_pose_curves(task).pieces);
    EXPECT_LE(found.size(), CurveLinkageOptions().wanted) << i;
    for (std::size_t k = 0; k < found.size(); ++k, ++linkages) {
      const CurveLinkage& l = found[k];
      EXPECT_NEAR(l.link_ratio, ratio_of(l), 1e-12 * l.link_ratio) << i;
      EXPECT_LE(l.link_ratio, CurveLinkageOptions().largest_ratio) << i;
      EXPECT_EQ(l.motion_class, class_of(l)) << i;
      for (const RR::Design* d : {&l.first, &l.second}) {
        EXPECT_LT(concyclicity(task, d->moving, d->fixed), 1e-12) << i;
        EXPECT_LT(largest_residual<RR>(*d, task), 1e-12 * (task_size(task) + d->length)) << i;
      }
      if (k > 0) {
        EXPECT_GE(found[k - 1].one_branch, l.one_branch) << i;
        EXPECT_TRUE(found[k - 1].one_branch > l.one_branch || found[k - 1].link_ratio <= l.link_ratio) << i;
      }
      EXPECT_EQ(passes(task, l.first, l.second) || (!l.one_branch && passes(task, l.second, l.first)), l.one_branch)
          << i;
      (l.one_branch ? good : bad) += 1;
    }
  }
  EXPECT_GT(good, 300);
  EXPECT_GT(bad, 30);
  EXPECT_GT(linkages, 500);
}

TEST(CurveLinkages, KeepTheLimitsAskedFor) {
  Random random("CurveLinkages.KeepTheLimitsAskedFor");
  int listed = 0, crank_rockers = 0;
  for (int i = 0; i < 60; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const FourPoseCurves curves = four_pose_curves(task);
    CurveLinkageOptions options;
    options.fixed = {{-2, -1.5}, {1, 3}};
    options.moving = {{-3, -2}, {1.5, 2}};
    options.largest_ratio = 5;
    options.wanted = 3;
    const auto found = linkages_from_curves(task, curves.pieces, options);
    EXPECT_LE(found.size(), 3u) << i;
    for (const CurveLinkage& l : found) {
      ++listed;
      EXPECT_LE(l.link_ratio, 5) << i;
      for (const RR::Design* d : {&l.first, &l.second}) {
        EXPECT_TRUE((d->fixed.array() >= options.fixed->low.array()).all()) << i;
        EXPECT_TRUE((d->fixed.array() <= options.fixed->high.array()).all()) << i;
        EXPECT_TRUE((d->moving.array() >= options.moving->low.array()).all()) << i;
        EXPECT_TRUE((d->moving.array() <= options.moving->high.array()).all()) << i;
      }
    }
    for (const CurveLinkage& l : linkages_from_curves(task, curves.pieces, {.classes = {"crank-rocker"}})) {
      EXPECT_EQ(l.motion_class, "crank-rocker") << i;
      ++crank_rockers;
    }
  }
  EXPECT_GT(listed, 50);
  EXPECT_GT(crank_rockers, 50);
}

/// A rocker-crank is a crank-rocker driven at its other dyad. The rank counts the driver, so whole lists are compared.
TEST(CurveLinkages, RockerCranksAreCrankRockersDrivenAtTheOtherDyad) {
  Random random("CurveLinkages.RockerCranksAreCrankRockersDrivenAtTheOtherDyad");
  int pairs = 0;
  for (int i = 0; i < 10; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const FourPoseCurves curves = four_pose_curves(task);
    const auto listed = [&](const char* motion_class) {
      return linkages_from_curves(task, curves.pieces, {.classes = {motion_class}, .wanted = 100000, .apart = 0});
    };
    const auto cranks = listed("crank-rocker"), rockers = listed("rocker-crank");
    ASSERT_EQ(cranks.size(), rockers.size()) << i;
    const auto key = [](const RR::Design& a, const RR::Design& b) {
      return std::array{a.fixed[0], a.fixed[1], a.moving[0], a.moving[1],
                        b.fixed[0], b.fixed[1], b.moving[0], b.moving[1]};
    };
    std::set<std::array<double, 8>> forth, back;
    for (const CurveLinkage& l : cranks) forth.insert(key(l.first, l.second));
    for (const CurveLinkage& l : rockers) {
      EXPECT_EQ(l.motion_class, "rocker-crank") << i;
      back.insert(key(l.second, l.first));
    }
    EXPECT_EQ(forth, back) << i;
    pairs += static_cast<int>(forth.size());
  }
  EXPECT_GT(pairs, 100);
}

TEST(CurveLinkages, FollowTheUnitAndTheFrame) {
  const FourPoseTask task = four_poses({{{0, 0, 0}, {1.5, 0.8, 20}, {3.2, 0.9, 50}, {4, -0.6, 85}}});
  const auto carried = [](const Vector2& p) { return Vector2(16 * p + Vector2(48, -80)); };
  FourPoseTask moved = task;
  for (Pose& p : moved) {
    const Vector2 at = carried({p.x, p.y});
    p.x = at[0], p.y = at[1];
  }
  const auto found = linkages_from_curves(task, four_pose_curves(task).pieces),
             other = linkages_from_curves(moved, four_pose_curves(moved).pieces);
  ASSERT_EQ(found.size(), other.size());
  ASSERT_FALSE(found.empty());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].link_ratio, other[k].link_ratio, 1e-9) << k;
    EXPECT_EQ(found[k].motion_class, other[k].motion_class) << k;
    EXPECT_LT((carried(found[k].first.fixed) - other[k].first.fixed).norm(), 1e-9) << k;
    EXPECT_LT((16 * found[k].second.moving - other[k].second.moving).norm(), 1e-9) << k;
  }
}

TEST(CurveLinkages, NoneWhereThereIsNoCurve) {
  const FourPoseTask task = four_poses({{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}});
  EXPECT_TRUE(linkages_from_curves(task, four_pose_curves(task).pieces).empty());
}

}  // namespace
}  // namespace burmester::planar
