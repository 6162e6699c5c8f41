// Transformed orientations give the transformed dyads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "burmester/geometry/rational.hpp"
#include "burmester/modules/framework/result_io.hpp"
#include "burmester/spherical/equal_angles.hpp"
#include "burmester/spherical/spherical.hpp"
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

/// The program's answer to these orientations, without the numbers in which they were given.
nlohmann::ordered_json answer(Problem problem, const std::vector<Pose>& poses) {
  problem.poses.clear();
  for (const Pose& p : poses) problem.poses.push_back({p.w, p.x, p.y, p.z});
  static const auto module = make_module();
  nlohmann::ordered_json out = result_document(*module, problem, module->synthesize(problem));
  out.erase("poses");
  return out;
}

/// Each quaternion times a power of two of its own, up to 2^+-900.
std::vector<Pose> scaled_by_powers(const std::vector<Pose>& poses, Random& random) {
  std::vector<Pose> out;
  for (const Pose& p : poses) {
    const double factor = std::ldexp(1, random.below(1801) - 900);
    out.push_back({factor * p.w, factor * p.x, factor * p.y, factor * p.z});
  }
  return out;
}

TEST(Invariance, ToTheLastBitUnderPowersOfTwo) {
  Random random("Invariance.ToTheLastBitUnderPowersOfTwo");
  const auto expect_same = [&](const Problem& problem, const std::vector<Pose>& poses, const std::string& label) {
    EXPECT_EQ(answer(problem, scaled_by_powers(poses, random)), answer(problem, poses)) << label;
  };
  Problem free, given, near;
  given.fixed = {{1, 2, 3}}, given.moving = {{-1, 0.5, 0}, {0, 0, 1}};
  near.near = {{1, 1, 0}};
  for (const int count : {2, 3, 4, 7})
    for (int i = 0; i < (count < 4 ? 20 : 3); ++i) {
      std::vector<Pose> poses;
      for (int j = 0; j < count; ++j) poses.push_back(Space::random_pose(random));
      const std::string label = fmt::format("{} orientations, task {}", count, i);
      expect_same(free, poses, label);
      expect_same(given, poses, label + ", given axes");
      if (count == 4) expect_same(near, poses, label + ", near an axis");
    }
  for (const auto* classes : {&random_task_classes(), &degenerate_task_classes()})
    for (const auto& task_class : *classes)
      for (int i = 0; i < 10; ++i) {
        const FivePoseTask task = task_class.make(random);
        expect_same(free, {task.begin(), task.end()}, fmt::format("{}, task {}", task_class.name, i));
      }
  // equal ones; half turns about three axes at right angles, with infinitely many sliders
  expect_same(free, {{1, 2, 3, 4}, {4, 3, 2, 1}, {1, 2, 3, 4}, {0, 1, 2, 0}, {1, 1, 0, 1}}, "equal orientations");
  expect_same(free, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, "half turns");
}

/// As close as doubles allow, on both sides of a power of two, where the scales of the two differ.
TEST(Invariance, ClosePosesAroundAPowerOfTwoKeepTheirDifference) {
  Random random("Invariance.ClosePosesAroundAPowerOfTwoKeepTheirDifference");
  for (int i = 0; i < 100; ++i) {
    const Vector<double, 3> v = Space::random_feature(random);
    const double e = std::pow(10, random.uniform(-15, -3));
    const Pose a{1, 0.3, 0.2, -0.4}, b{1 - 0x1p-53, 0.3 + e * v[0], 0.2 + e * v[1], -0.4 + e * v[2]};
    const Quaternion<Rational> exact = relative_rotation<Rational>(a, b);
    const Quaternion<double> rounded = relative_rotation<double>(a, b);
    const Vector<double, 3> inverse = half_angle_sine({a.w, -a.x, -a.y, -a.z}, {b.w, -b.x, -b.y, -b.z});
    const double size = std::sqrt(approximate(Rational(exact.squaredNorm())));
    for (int k = 0; k < 3; ++k) {
      const double expected = approximate(exact[k + 1]) / size, tolerance = 4e-15 * inverse.norm();
      EXPECT_NEAR(rounded[k + 1] / size, expected, tolerance) << i;
      EXPECT_NEAR(-inverse[k], expected, tolerance) << i;
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
