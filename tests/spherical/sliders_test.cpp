// The sliders of four orientations: all of them, proved, and on both cones.
#include "burmester/spherical/sliders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/four_pose_curves.hpp"
#include "spherical_examples.hpp"

namespace burmester::spherical {
namespace {

using FourPoseTask = std::array<Pose, 4>;

FourPoseTask random_task(Random& random) {
  FourPoseTask task;
  for (Pose& p : task) p = Space::random_pose(random);
  return task;
}
const PR::Design& design_of(const FoundSlider& found) { return std::get<PR::Design>(found.slider.design); }
/// Of two axes, which have no direction.
double angle(const Axis& a, const Axis& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }
double difference(const PR::Design& a, const PR::Design& b) {
  return std::max(angle(a.fixed, b.fixed), angle(a.moving, b.moving));
}

TEST(SphericalSliders, AreCertifiedAtRightAnglesAndEvenInNumber) {
  Random random("SphericalSliders.AreCertifiedAtRightAnglesAndEvenInNumber");
  std::array<int, 7> tasks{};
  for (int i = 0; i < 200; ++i) {
    const FourPoseTask task = random_task(random);
    const auto found = sliders(task);
    ASSERT_TRUE(found) << i;
    ASSERT_LE(found->size(), 6u) << i;
    EXPECT_EQ(found->size() % 2, 0u) << i;
    ++tasks[found->size()];
    for (const FoundSlider& f : *found) {
      EXPECT_LT(f.slider.residual, 1e-15) << i;
      EXPECT_TRUE(f.slider.certificate.certified) << i;
      EXPECT_LT(f.slider.certificate.radius, 1e-14) << i;
      EXPECT_EQ(f.multiplicity, 1) << i;
    }
  }
  EXPECT_GT(tasks[2], 0);
  EXPECT_GT(tasks[4], 0);
  EXPECT_EQ(tasks[1] + tasks[3] + tasks[5], 0);
}

TEST(SphericalSliders, HoldWhatASearchFinds) {
  Random random("SphericalSliders.HoldWhatASearchFinds");
  int seen = 0;
  for (int i = 0; i < 10; ++i) {
    const FourPoseTask task = random_task(random);
    const auto proved = sliders(task);
    ASSERT_TRUE(proved) << i;
    for (const auto& found : search<PR>(task, {.starts = 40})) {
      ++seen;
      EXPECT_TRUE(std::any_of(proved->begin(), proved->end(), [&](const FoundSlider& f) {
        return difference(design_of(f), found.design) < 1e-6;
      })) << i;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(SphericalSliders, LieOnBothCones) {
  Random random("SphericalSliders.LieOnBothCones");
  int seen = 0;
  for (int i = 0; i < 50; ++i) {
    const FourPoseTask task = random_task(random);
    const SphericalReport report = FourPoseSolver().solve(task);
    ASSERT_EQ(report.status, Status::family);
    for (const auto& found : report.dyads) {
      const auto& slider = std::get<PR::Design>(found.design);
      double nearest = 2;
      for (const CurveRecord& piece : report.curves)
        for (std::size_t k = 0; k < piece.moving.size(); ++k) {
          const Axis a(piece.moving[k][0], piece.moving[k][1], piece.moving[k][2]),
              b(piece.fixed[k][0], piece.fixed[k][1], piece.fixed[k][2]);
          nearest = std::min(nearest, std::max(angle(a, slider.moving), angle(b, slider.fixed)));
        }
      EXPECT_LT(nearest, 0.05) << i;  // half a chord
      ++seen;
    }
  }
  EXPECT_GT(seen, 50);
}

TEST(SphericalSliders, FollowTheFramesAndExchangeTheirAxesUnderInversion) {
  Random random("SphericalSliders.FollowTheFramesAndExchangeTheirAxesUnderInversion");
  const auto point = [](const Pose& p) { return Space::point<double>(p); };
  const auto expect = [](const FourPoseTask& task, const std::vector<FoundSlider>& expected, const auto& moved, int i) {
    const auto found = sliders(task);
    ASSERT_TRUE(found) << i;
    ASSERT_EQ(found->size(), expected.size()) << i;
    for (const FoundSlider& e : expected)
      EXPECT_TRUE(std::any_of(found->begin(), found->end(), [&](const FoundSlider& f) {
        return difference(design_of(f), moved(design_of(e))) < 1e-12 * (1 + *e.slider.condition);
      })) << i;
  };
  for (int i = 0; i < 50; ++i) {
    const FourPoseTask task = random_task(random);
    const auto given = sliders(task);
    ASSERT_TRUE(given) << i;
    const auto g = point(Space::random_pose(random)), h = point(Space::random_pose(random));
    FourPoseTask turned = task, ordered = task, inverted = task;
    for (Pose& p : turned)
      p = Space::pose(Space::product<double>(Space::product<double>(g, point(p)), Space::conjugate<double>(h)));
    std::swap(ordered[0], ordered[3]);
    ordered[1] = {-task[1].w, -task[1].x, -task[1].y, -task[1].z};
    for (Pose& p : inverted) p = Space::pose(Space::conjugate<double>(point(p)));
    expect(
        turned, *given, [&](const PR::Design& d) { return PR::moved(d, g, h); }, i);
    expect(
        ordered, *given, [](const PR::Design& d) { return d; }, i);
    expect(
        inverted, *given, [](const PR::Design& d) { return PR::inverse(d); }, i);
  }
}

TEST(SphericalSliders, OfHalfTurnsAboutThreeAxesAreInfinitelyMany) {
  const FourPoseTask klein{Pose{1, 0, 0, 0}, Pose{0, 1, 0, 0}, Pose{0, 0, 1, 0}, Pose{0, 0, 0, 1}};
  EXPECT_FALSE(sliders(klein));  // a1 b1 = a2 b2 = a3 b3 = 0: an axis of the frame, with any one at right angles to it
}

/// Example 2 of J. Angeles, S. Bai, "A robust solution of the spherical Burmester problem": its five attitudes moved by
/// about 0.01 deg onto a linkage with the slider below. Any four of them have it.
TEST(SphericalSliders, HoldTheOneOfExampleTwo) {
  const std::vector<Pose> poses = testing::angeles_bai_2_exact().poses;
  const PR::Design published{{0.5221393938323564, 0.8442635990986221, -0.12078670723809137},
                             {0.06550500280810398, 0.10150775244309242, 0.9926758135469315}};
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    FourPoseTask task;
    for (std::size_t j = 0, k = 0; j < 5; ++j)
      if (j != left_out) task[k++] = poses[j];
    const auto found = sliders(task);
    ASSERT_TRUE(found);
    EXPECT_TRUE(std::any_of(found->begin(), found->end(), [&](const FoundSlider& f) {
      return difference(design_of(f), published) < 1e-13;
    })) << left_out;
  }
}

}  // namespace
}  // namespace burmester::spherical
