// Transformed orientations give the transformed dyads.
#include <gtest/gtest.h>

#include "burmester/spherical/tasks.hpp"
#include "five_orientations.hpp"

namespace burmester::spherical {
namespace {

using Image = Space::Point<double>;

/// transform: Pose -> Pose; follow: RR design -> RR design.
template <class Transform, class Follow>
void expect_follow(const FivePoseTask& task, Transform transform, Follow follow, const std::string& label) {
  FivePoseTask image;
  for (std::size_t j = 0; j < 5; ++j) image[j] = transform(task[j]);
  const SphericalReport before = FivePoseSolver().solve(task), after = FivePoseSolver().solve(image);
  ASSERT_EQ(before.dyads.size(), after.dyads.size()) << label;
  for (const auto& found : before.dyads) {
    const double condition = found.condition.value_or(0);
    if (condition > 1e7) continue;
    EXPECT_LT(support::nearest(follow(support::as_RR(found.design)), after).distance, 2e-14 * (1 + condition)) << label;
  }
}

template <class Make>
void expect_follow(const std::string& test, Make make) {
  for (const char* name : {"generic", "small_rotations", "near_half_turns", "planted_four_bar", "planted_slider"}) {
    Random random("Invariance." + test + "." + name);
    for (int i = 0; i < 60; ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      const auto [transform, follow] = make(random);
      // the smaller the rotations, the more the rounding of the image changes them
      const std::string label = test + "." + name + ", task " + std::to_string(i);
      expect_follow(task, transform, follow, label);
    }
  }
}

auto reframe(const Image& g, const Image& h) {
  return std::pair([=](const Pose& p) { return Space::pose(reframed<Space>(g, Space::point<double>(p), h)); },
                   [=](const RR::Design& d) { return RR::moved(d, g, h); });
}

TEST(Invariance, UnderRotationOfTheFixedFrame) {
  expect_follow("FixedFrame", [](Random& random) {
    return reframe(Space::point<double>(Space::random_pose(random)), Space::point<double>(Pose{}));
  });
}

TEST(Invariance, UnderRotationOfTheMovingFrame) {
  expect_follow("MovingFrame", [](Random& random) {
    return reframe(Space::point<double>(Pose{}), Space::point<double>(Space::random_pose(random)));
  });
}

TEST(Invariance, UnderInversionWhichExchangesTheAxes) {
  expect_follow("Inversion", [](Random&) {
    return std::pair([](const Pose& p) { return Space::pose(Space::conjugate<double>(Space::point<double>(p))); },
                     [](const RR::Design& d) { return RR::inverse(d); });
  });
}

TEST(Invariance, UnderScaleOfTheQuaternions) {
  for (const double factor : {3.7, -0.013, 1e5})
    expect_follow("Scale", [factor](Random&) {
      return std::pair(
          [=](const Pose& p) {
            return Pose{factor * p.w, factor * p.x, factor * p.y, factor * p.z};
          },
          [](const RR::Design& d) { return d; });
    });
}

TEST(Invariance, UnderDifferentScalesOfTheQuaternions) {
  Random random("Invariance.DifferentScales");
  for (int i = 0; i < 100; ++i) {
    const FivePoseTask task = find_task_class(i % 2 ? "generic" : "close_pair")->make(random);
    const auto scaled = [&](const Pose& p) {
      const double factor = random.normal();
      return Pose{factor * p.w, factor * p.x, factor * p.y, factor * p.z};
    };
    // of close poses rounding of the scaled coordinates is a change of 1e-16 / 1e-6
    expect_follow(
        task, scaled, [](const RR::Design& d) { return d; }, "Invariance.DifferentScales, task " + std::to_string(i));
  }
}

TEST(Invariance, ToTheLastBitUnderSigns) {
  Random random("Invariance.ToTheLastBitUnderSigns");
  for (int i = 0; i < 100; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    FivePoseTask image = task;
    for (std::size_t j = 1; j < 5; ++j)
      if (random.below(2)) image[j] = {-task[j].w, -task[j].x, -task[j].y, -task[j].z};
    const SphericalReport before = FivePoseSolver().solve(task), after = FivePoseSolver().solve(image);
    ASSERT_EQ(before.dyads.size(), after.dyads.size()) << "task " << i;
    for (std::size_t k = 0; k < before.dyads.size(); ++k) {
      const RR::Design a = support::as_RR(before.dyads[k].design), b = support::as_RR(after.dyads[k].design);
      EXPECT_LT(support::distance(a, b), 1e-15 * (1 + before.dyads[k].condition.value_or(0))) << "task " << i;
    }
  }
}

TEST(Invariance, UnderReordering) {
  for (const char* name : {"generic", "close_pair", "nearly_coaxial", "planted_four_bar"}) {
    Random random(std::string("Invariance.UnderReordering.") + name);
    for (int i = 0; i < 60; ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      FivePoseTask shuffled = task;
      for (int k = 4; k > 0; --k)
        std::swap(shuffled[static_cast<std::size_t>(k)], shuffled[static_cast<std::size_t>(random.below(k + 1))]);
      const SphericalReport before = FivePoseSolver().solve(task), after = FivePoseSolver().solve(shuffled);
      ASSERT_EQ(before.dyads.size(), after.dyads.size()) << name << ", task " << i;
      for (const auto& found : before.dyads) {
        const double condition = found.condition.value_or(0);
        if (condition > 1e7) continue;
        EXPECT_LT(support::nearest(support::as_RR(found.design), after).distance, 2e-14 * (1 + condition))
            << name << ", task " << i;
      }
    }
  }
}

}  // namespace
}  // namespace burmester::spherical
