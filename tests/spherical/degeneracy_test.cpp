// How far five orientations are from those with infinitely many dyads.
#include "burmester/spherical/degeneracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "burmester/spherical/tasks.hpp"

namespace burmester::spherical {
namespace {

struct Named {
  const char* name;
  Degeneracy kind;
};
constexpr Named classes[] = {{"common_axis", Degeneracy::rank_deficient},
                             {"four_coaxial", Degeneracy::rank_deficient},
                             {"axis_in_two_places", Degeneracy::moving_on_circle}};

FivePoseTask inverted(FivePoseTask task) {
  for (Pose& p : task) p = {p.w, -p.x, -p.y, -p.z};
  return task;
}

TEST(SphericalDegeneracy, SurvivesTheRoundingOfItsDoubles) {
  for (const auto& [name, kind] : classes) {
    const std::string stream = std::string("SphericalDegeneracy.SurvivesTheRoundingOfItsDoubles.") + name;
    Random random(stream);
    for (int i = 0; i < 300; ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      EXPECT_EQ(axis_in_two_places(task).kind, kind) << stream << ' ' << i;
      EXPECT_EQ(axis_in_two_places(inverted(task)).kind,
                kind == Degeneracy::moving_on_circle ? Degeneracy::fixed_on_circle : kind)
          << stream << ' ' << i;
    }
  }
  const FivePoseTask turned_over{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {0, 1, 0, 0}, {0, 2, 1, 0}};
  EXPECT_EQ(axis_in_two_places(turned_over).kind, Degeneracy::both_on_circles);
}

/// A change of the unit quaternions is never shorter than the least one, and in a random direction not much longer: of
/// 15 directions at least four leave the kind.
TEST(SphericalDegeneracy, DistanceIsThatOfASmallChange) {
  for (const auto& [name, kind] : classes) {
    const std::string stream = std::string("SphericalDegeneracy.DistanceIsThatOfASmallChange.") + name;
    Random random(stream);
    for (const double size : {1e-3, 1e-6, 1e-9, 1e-12})
      for (int i = 0; i < 20; ++i) {
        FivePoseTask task = find_task_class(name)->make(random);
        double change = 0;
        for (Pose& p : task) {
          const Vector<double, 3> turn{size * random.normal(), size * random.normal(), size * random.normal()};
          p = Space::nudged(p, turn);
          change = std::hypot(change, turn.norm() / 2);
        }
        const double distance = axis_in_two_places(task).distance;
        EXPECT_LE(distance, change * (1 + 10 * change) + same_tolerance) << stream << ' ' << size << ' ' << i;
        EXPECT_GE(distance, change / 100) << stream << ' ' << size << ' ' << i;
      }
  }
}

/// The same of rotations about one axis: never more than the change, and and not much less where one
/// orientation is turned out of the axis.
TEST(SphericalDegeneracy, DistanceFromOneAxisIsThatOfASmallChange) {
  Random random("SphericalDegeneracy.DistanceFromOneAxisIsThatOfASmallChange");
  for (const std::size_t n : {3u, 4u, 5u})
    for (const double size : {0.0, 1e-3, 1e-6, 1e-9, 1e-12})
      for (int i = 0; i < 40; ++i) {
        const Axis axis = Space::random_feature(random), across = axis.unitOrthogonal();
        std::vector<Pose> poses;
        for (std::size_t j = 0; j < n; ++j)
          poses.push_back(pose_from_axis_degrees({axis[0], axis[1], axis[2]}, random.uniform(-170, 170)));
        EXPECT_LE(distance_from_one_axis(poses), same_tolerance) << n << ' ' << i;
        const double angle = size * random.normal(), change = std::abs(angle) / 2;
        poses[1] = Space::nudged(poses[1], angle * across);
        const double distance = distance_from_one_axis(poses);
        EXPECT_LE(distance, change * (1 + 10 * change) + same_tolerance) << n << ' ' << size << ' ' << i;
        EXPECT_GE(distance, change / 1000 - same_tolerance) << n << ' ' << size << ' ' << i;
        EXPECT_EQ(degeneracy_of(std::span(poses).first(2)), "") << n << ' ' << i;
        EXPECT_EQ(degeneracy_of(poses).empty(), distance > same_tolerance) << n << ' ' << size << ' ' << i;
      }
}

TEST(SphericalDegeneracy, RandomOrientationsAreFar) {
  Random random("SphericalDegeneracy.RandomOrientationsAreFar");
  for (int i = 0; i < 300; ++i) {
    const NearDegeneracy found = axis_in_two_places(find_task_class("generic")->make(random));
    EXPECT_EQ(found.kind, Degeneracy::none) << i;
    EXPECT_GT(found.distance, 1e-4) << i;
  }
}

}  // namespace
}  // namespace burmester::spherical
