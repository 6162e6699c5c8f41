// Five orientations with infinitely many dyads: of which kind, proved, and the one dyad beside a family.
#include <gtest/gtest.h>

#include <cmath>

#include "burmester/spherical/five_pose_oracle.hpp"
#include "burmester/spherical/tasks.hpp"
#include "certified_axes.hpp"

namespace burmester::spherical {
namespace {

Pose product(const Pose& a, const Pose& b) {
  return Space::pose(Space::product<double>(Space::point<double>(a), Space::point<double>(b)));
}

Degeneracy degeneracy_of(const FivePoseTask& task) {
  const CertifiedAxes answer = certified_axes(task, {});
  EXPECT_EQ(answer.count, -1);
  EXPECT_FALSE(answer.complete);
  return answer.degeneracy;
}

TEST(SphericalCertificate, InfinitelyManyDyadsAreProvedByKind) {
  const FivePoseTask equal{Pose{1, 2, 3, 4}, {1, 0, 0, 1}, {2, 1, 0, 0}, {-3, -6, -9, -12}, {0, 1, 1, 0}};
  EXPECT_EQ(degeneracy_of(equal), Degeneracy::equal_orientations);

  const Pose from{3, 1, -2, 5};
  const auto about = [](double c, double s) { return Pose{c, s, 2 * s, -s}; };
  FivePoseTask task{product(from, about(1, 0)), product(from, about(1, 1)), product(from, about(2, -3)),
                    product(from, about(0, 1)), product(from, about(5, 1))};
  EXPECT_EQ(degeneracy_of(task), Degeneracy::one_axis);
  task[4] = {7, 1, 1, 0};
  EXPECT_EQ(degeneracy_of(task), Degeneracy::rank_deficient);
  task[3] = product(task[4], about(3, 2));  // (1, 2, -1) takes two places
  EXPECT_EQ(degeneracy_of(task), Degeneracy::moving_on_circle);
  for (Pose& p : task) p = {p.w, -p.x, -p.y, -p.z};
  EXPECT_EQ(degeneracy_of(task), Degeneracy::fixed_on_circle);
  const FivePoseTask turned_over{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {0, 1, 0, 0}, {0, 2, 1, 0}};
  EXPECT_EQ(degeneracy_of(turned_over), Degeneracy::both_on_circles);
}

/// Small integers: three orientations about one axis, the other two with it in one place; in any order and frames.
FivePoseTask three_and_two(Random& random) {
  const auto integer = [&] { return static_cast<double>(random.below(9)) - 4; };
  const auto turn = [&] { return Pose{5, integer(), integer(), integer()}; };
  const Vector<double, 3> v(integer(), integer(), 5);
  const auto about = [&](double c, double s) { return Pose{c, s * v[0], s * v[1], s * v[2]}; };
  const Pose from = turn(), other = turn();
  FivePoseTask task{product(from, about(1, 0)), product(from, about(2, 1)), product(from, about(3, -1)), other,
                    product(other, about(1, 2))};
  for (std::size_t i = 4; i > 0; --i) std::swap(task[i], task[static_cast<std::size_t>(random.below(5)) % (i + 1)]);
  return task;
}

TEST(SphericalCertificate, OneDyadIsBesideTheFamilyOfAnAxisInTwoPlaces) {
  const std::string stream = "SphericalCertificate.OneDyadIsBesideTheFamilyOfAnAxisInTwoPlaces";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 20; ++i) {
    const FivePoseTask task = three_and_two(random);
    FivePoseTask inverse = task;
    for (Pose& p : inverse) p = {p.w, -p.x, -p.y, -p.z};
    const CertifiedAxes here = certified_axes(task, {}), there = certified_axes(inverse, {});
    ASSERT_EQ(here.degeneracy, Degeneracy::moving_on_circle) << i;
    ASSERT_EQ(there.degeneracy, Degeneracy::fixed_on_circle) << i;
    ASSERT_EQ(here.isolated, 1) << i;
    ASSERT_EQ(there.isolated, 1) << i;
    EXPECT_TRUE(same_axes(here.axes[0], {there.axes[0].fixed, there.axes[0].moving})) << i;
    const RR::Design dyad = shown(here.axes[0], task[0]);
    EXPECT_LT(error_bound(dyad, here.boxes[0], task[0]), 1e-14) << i;
    EXPECT_LT(largest_residual<RR>(dyad, task), 1e-14) << i;
    // all dyads close to the poses that are not in the family are close to it
    FivePoseTask near = task;
    for (Pose& p : near) p = Space::nudged(p, 1e-6 * Space::random_feature(random));
    const std::vector<AxisPair> all = found_in(near);
    EXPECT_EQ(std::count_if(all.begin(), all.end(),
                            [&](const AxisPair& a) {
                              return a.moving.cross(here.axes[0].moving).norm() < 1e-3 &&
                                     a.fixed.cross(here.axes[0].fixed).norm() < 1e-3;
                            }),
              1)
        << i;
  }
}

TEST(SphericalCertificate, DoublesThatAreOnlyNearlyDegenerateHaveFinitelyManyDyads) {
  FivePoseTask task{Pose{1, 2, 3, 4}, {1, 0, 0, 1}, {2, 1, 0, 0}, {-1, -2, -3, -4}, {0, 1, 1, 0}};
  EXPECT_EQ(degeneracy_of(task), Degeneracy::equal_orientations);
  task[3].y = std::nextafter(task[3].y, 0);
  const CertifiedAxes proved = certified_axes(task, {});
  EXPECT_TRUE(proved.complete);
  EXPECT_EQ(proved.count, exact_count(task));
}

}  // namespace
}  // namespace burmester::spherical
