// How far five orientations are from those with infinitely many dyads.
#include "burmester/spherical/degeneracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
