// The sliders of four orientations: all of them, proved, and on both cones.
#include "burmester/spherical/sliders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/four_pose_curves.hpp"
#include "cgal_leaks.hpp"
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

struct Degrees {
  int moving, fixed, isolated;
  bool operator==(const Degrees&) const = default;
};

/// Of the families; zeros where none is proved.
Degrees degrees_of(const FourPoseTask& task) {
  if (sliders(task)) return {};
  const auto family = slider_family(task);
  if (!family) return {};
  return {family->moving, family->fixed, family->isolated ? static_cast<int>(family->isolated->size()) : -1};
}

struct NamedTask {
  FourPoseTask task;
  Degrees degrees;
};

/// a1 b1 = a2 b2 = a3 b3 = 0: an axis of the frame, with any one at right angles to it.
constexpr FourPoseTask half_turns_about_three_axes{Pose{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
/// z in one place in three orientations, opposite in the fourth: it goes with all axes at right angles, and as fixed
/// axis too.
constexpr FourPoseTask one_axis_turned_over{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {0, 1, 2, 0}};

const std::array<NamedTask, 5> infinite{{
    {half_turns_about_three_axes, {3, 3, 0}},
    {one_axis_turned_over, {1, 1, 0}},
    {{Pose{0, -1, 0, -1}, {1, -1, -1, -1}, {1, 0, -1, 0}, {0, 1, 0, -1}}, {1, 1, 0}},
    {{Pose{1, -1, -1, 0}, {1, 0, 1, -1}, {1, 0, 0, -1}, {0, -1, -1, 0}}, {1, 2, 1}},
    {{Pose{-1, 0, -1, 0}, {-1, 0, 1, 0}, {1, -1, -1, -1}, {1, -1, 1, 1}}, {2, 2, 0}},
}};

/// A half turn but for far less than doubles see beside 1: solutions whose coordinates differ by hundreds of digits.
TEST(SphericalSliders, NearlyHalfTurnsOfAnySizeAreMet) {
  for (const double e : {1e-20, 1e-90, 1e-100, 1e-300}) {
    const FourPoseTask task{Pose{1, 0, 0, 0}, {0.9 * e, 1, -0.2 * e, 0.3 * e}, {0.9, 0.3, 0.2, 0.3}, {1, 0, 0, 1}};
    const auto found = sliders(task);
    ASSERT_TRUE(found) << e;
    EXPECT_EQ(found->size() % 2, 0u) << e;
    EXPECT_FALSE(found->empty()) << e;
    for (const FoundSlider& f : *found) {
      EXPECT_NEAR(design_of(f).fixed.norm(), 1, 1e-15) << e;
      EXPECT_NEAR(design_of(f).moving.norm(), 1, 1e-15) << e;
      EXPECT_LT(f.slider.residual, 1e-15) << e;
      EXPECT_TRUE(f.slider.certificate.certified) << e;
    }
  }
}

TEST(SphericalSliders, InfinitelyManyAreProvedAndNamed) {
  for (const NamedTask& named : infinite) EXPECT_EQ(degrees_of(named.task), named.degrees);
  EXPECT_NE(FourPoseSolver()
                .solve(infinite[3].task)
                .message.find("infinitely many sliders, proved: their moving axes "
                              "fill a plane, their fixed axes a cone of degree 2; 1 "
                              "slider beside them"),
            std::string::npos);
}

/// Where the conditions of one slider leave all directions to first order, four of the six coincide.
TEST(SphericalSliders, FourThatCoincideAreDecided) {
  const FourPoseTask tasks[] = {{Pose{1, 1, 0, 0}, {0, -1, -1, 0}, {0, 1, -1, 0}, {-1, 1, 0, 0}},
                                {Pose{0, -1, -1, 0}, {0, 0, -1, -1}, {-1, 0, 0, -1}, {-1, -1, 0, 0}},
                                {Pose{1, -1, 1, 0}, {0, 1, -1, -1}, {-1, -1, -1, 0}, {0, -1, -1, -1}},
                                {Pose{1, 0, -1, 1}, {-1, 0, 1, 1}, {1, -1, 0, -1}, {1, -1, 0, 1}}};
  for (const FourPoseTask& task : tasks) {
    const auto found = sliders(task);
    ASSERT_TRUE(found);
    int counted = 0, largest = 0;
    for (const FoundSlider& f : *found) {
      counted += f.multiplicity, largest = std::max(largest, f.multiplicity);
      EXPECT_LT(f.slider.residual, 1e-15);
      EXPECT_TRUE(f.slider.certificate.certified);
    }
    EXPECT_EQ(largest, 4);
    EXPECT_EQ(counted % 2, 0);
    EXPECT_LE(counted, 6);
  }
  // by hand: the four minors are x^2 z, y z^2, x^2 y and x z^2 in a suitable order, and vanish on the axes of the frame
  EXPECT_EQ(sliders(tasks[0])->size(), 3u);
}

/// Four orientations about z: a z = 0 with b = z, and the reverse. The cubic in common, z (x^2 + y^2), is no more than
/// that plane.
TEST(SphericalSliders, ADefiniteConicIsNoPartOfTheCone) {
  const FourPoseTask coaxial{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {1, 0, 0, -3}};
  EXPECT_EQ(degrees_of(coaxial), (Degrees{1, 1, 0}));
}

/// Those with a regular Jacobian are in no family.
TEST(SphericalSliders, BesideAFamilyAreThoseThatASearchFinds) {
  for (const NamedTask& named : infinite) {
    int isolated = 0;
    for (const auto& found : search<PR>(named.task, {.starts = 60}))
      isolated += std::isfinite(condition<PR>(found.design, named.task));
    EXPECT_EQ(isolated, named.degrees.isolated);
  }
  const auto family = slider_family(infinite[3].task);
  ASSERT_TRUE(family && family->isolated && family->isolated->size() == 1);
  const Found<Dyads::Design>& slider = family->isolated->front().slider;
  EXPECT_LT(slider.residual, 1e-15);
  EXPECT_TRUE(slider.certificate.certified);
}

TEST(SphericalSliders, FamiliesFollowTheFramesAndExchangeTheirAxesUnderInversion) {
  Random random("SphericalSliders.FamiliesFollowTheFramesAndExchangeTheirAxesUnderInversion");
  const auto integers = [&](int size) {
    Pose p{0, 0, 0, 0};
    const auto any = [&] { return static_cast<double>(random.below(2 * size + 1) - size); };
    while (Space::norm<double>(Space::point<double>(p)) == 0) p = {any(), any(), any(), any()};
    return p;
  };
  int families = 0;
  for (int i = 0; i < 80; ++i) {
    FourPoseTask task, turned, inverted;
    for (Pose& p : task) p = integers(1);
    const auto g = Space::point<double>(integers(5)), h = Space::point<double>(integers(5));
    for (std::size_t j = 0; j < 4; ++j) {  // products of small integers: exact
      const auto x = Space::point<double>(task[j]);
      turned[j] = Space::pose(quaternion_product<double>(quaternion_product<double>(g, x), h));
      inverted[j] = Space::pose(Space::conjugate<double>(x));
    }
    const Degrees degrees = degrees_of(task), inverse = degrees_of(inverted);
    families += degrees.moving > 0;
    EXPECT_EQ(degrees_of(turned), degrees) << i;
    EXPECT_EQ(inverse, (Degrees{degrees.fixed, degrees.moving, degrees.isolated})) << i;
  }
  EXPECT_GT(families, 8);
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
