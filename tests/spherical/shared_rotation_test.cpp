// Two pairs with one rotation: whether that is exact is told over rationals, not by what doubles make of it.
#include "burmester/spherical/shared_rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "burmester/spherical/four_pose_curves.hpp"

namespace burmester::spherical {
namespace {

using FourPoseTask = std::array<Pose, 4>;

Pose product(const Pose& a, const Pose& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// Products of these are exact.
Pose small_integers(Random& random) {
  const auto some = [&] { return std::floor(random.uniform(-9, 10)); };
  return {1 + std::abs(some()), some(), some(), some()};
}

/// T p and p, T q and q in any order.
FourPoseTask with_shared(const Pose& turn, const Pose& p, const Pose& q, Random& random) {
  FourPoseTask task{p, product(turn, p), q, product(turn, q)};
  for (int k = 3; k > 0; --k)
    std::swap(task[static_cast<std::size_t>(k)], task[static_cast<std::size_t>(random.below(k + 1))]);
  return task;
}

bool said(const FourPoseTask& task) {
  return FourPoseSolver().solve(task).message.find("one to within rounding") != std::string::npos;
}

TEST(SharedRotation, OfIntegerQuaternionsIsExactAndNothingIsSaid) {
  const std::string seed = "SharedRotation.OfIntegerQuaternionsIsExactAndNothingIsSaid";
  Random random(seed);
  int exact = 0;
  for (int i = 0; i < 200; ++i) {
    FourPoseTask task = with_shared(small_integers(random), small_integers(random), small_integers(random), random);
    const auto shared = shared_rotation(task);
    if (!shared) continue;  // two of them are equal
    ++exact;
    EXPECT_TRUE(shared->exact) << seed << " " << i;
    EXPECT_EQ(shared->off, 0) << seed << " " << i;
    if (i % 10 == 0) {
      EXPECT_FALSE(said(task)) << seed << " " << i;
    }
    // a turn of up to 2^-50 rad
    Pose& p = task[static_cast<std::size_t>(random.below(4))];
    p.x += 0x1p-51 * std::hypot(std::hypot(p.w, p.x), std::hypot(p.y, p.z));
    const auto rounded = shared_rotation(task);
    ASSERT_TRUE(rounded) << seed << " " << i;
    EXPECT_FALSE(rounded->exact) << seed << " " << i;
    if (i % 10 == 0) {
      EXPECT_TRUE(said(task)) << seed << " " << i;
    }
  }
  EXPECT_GT(exact, 190);
}

TEST(SharedRotation, OfRoundedQuaternionsIsNotExactAndIsSaid) {
  const std::string seed = "SharedRotation.OfRoundedQuaternionsIsNotExactAndIsSaid";
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const FourPoseTask task =
        with_shared(Space::random_pose(random), Space::random_pose(random), Space::random_pose(random), random);
    const auto shared = shared_rotation(task);
    ASSERT_TRUE(shared) << seed << " " << i;
    EXPECT_FALSE(shared->exact) << seed << " " << i;
    EXPECT_LT(shared->off, 0x1p-48) << seed << " " << i;
    if (i % 10 == 0) {
      EXPECT_TRUE(said(task)) << seed << " " << i;
    }
  }
}

}  // namespace
}  // namespace burmester::spherical
