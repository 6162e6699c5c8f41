// The direct solver against exact elimination, class by class, and the two oracles against each other: the seeded,
// small version of the study (bench/studies/spherical_five_pose.cpp).
#include "burmester/spherical/five_pose_oracle.hpp"

#include <gtest/gtest.h>

#include "burmester/spherical/tasks.hpp"
#include "five_orientations.hpp"
#include "spherical_accuracy.hpp"

namespace burmester::spherical {
namespace {

class SphericalAccuracy : public ::testing::TestWithParam<TaskClass> {};

TEST_P(SphericalAccuracy, IsWithinTheLimitsOfItsClass) {
  const TaskClass& c = GetParam();
  const std::string stream = "SphericalAccuracy." + std::string(c.name);
  Random random(stream);
  accuracy::Outcome outcome;
  for (int i = 0; i < 300; ++i) accuracy::add_task(c.make(random), outcome);
  const accuracy::Limits limits = accuracy::limits_of(c.name);
  EXPECT_LE(outcome.wrong_count, limits.wrong_share * 300) << stream;
  EXPECT_LE(outcome.quantile(0.5), limits.median) << stream;
  EXPECT_LE(outcome.quantile(0.999), limits.tail) << stream;
}

INSTANTIATE_TEST_SUITE_P(Classes, SphericalAccuracy, ::testing::ValuesIn(random_task_classes()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SphericalOracles, BothFindTheSamePolynomialAndTheSameDyads) {
  for (const TaskClass& c : random_task_classes()) {
    Random random("SphericalOracles." + std::string(c.name));
    for (int i = 0; i < 10; ++i) {
      const FivePoseTask task = c.make(random);
      const ExactFivePoses a = exact_by_elimination(task), b = exact_by_cones(task);
      EXPECT_TRUE(a.eliminant == b.eliminant || a.eliminant == -b.eliminant) << c.name << ", task " << i;
      EXPECT_EQ(a.eliminant.degree(), 6);
      ASSERT_EQ(a.real.size(), b.real.size());
      EXPECT_EQ(exact_count(task), static_cast<int>(a.real.size()));
      for (const ExactDyad& x : a.real) {
        double least = 4;
        for (const ExactDyad& y : b.real) least = std::min(least, support::distance(x.rounded(), y.rounded()));
        EXPECT_LT(least, 1e-15) << c.name << ", task " << i;
      }
    }
  }
}

TEST(SphericalOracles, TheirDyadsMeetTheExactPoses) {
  Random random("SphericalOracles.TheirDyadsMeetTheExactPoses");
  for (int i = 0; i < 20; ++i) {
    const FivePoseTask task = find_task_class("nearly_coaxial")->make(random);
    for (const ExactDyad& dyad : exact_by_elimination(task).real)
      for (const Pose& pose : task) {
        const Space::Point<Quad> x = Space::point<Quad>(pose);
        const Vector<Quad, 3> a = Space::act<Quad>(x, dyad.moving) / Space::norm<Quad>(x);
        EXPECT_LT(abs(a.dot(dyad.fixed) - cos(dyad.arc)), Quad(1e-30)) << "task " << i;
      }
  }
}

/// Small integers, found by search: six dyads of which two coincide; in the first frame two others lie behind each
/// other.
TEST(SphericalOracles, DyadsBehindTheLineOfProjectionAreSeenFromAnother) {
  const FivePoseTask double_dyad{Pose{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 1, 5, 1}, {1, -1, -3, 1}, {1, -1, 0, -2}};
  const auto by_elimination = exact_by_elimination(double_dyad), by_cones = exact_by_cones(double_dyad);
  for (const ExactFivePoses& found : {by_elimination, by_cones}) {
    EXPECT_EQ(found.real.size(), 5u);
    int counted = 0;
    for (const ExactDyad& dyad : found.real) counted += dyad.multiplicity;
    EXPECT_EQ(counted, 6);
  }
  EXPECT_EQ(exact_count(double_dyad), 5);
}

TEST(SphericalOracles, AnAxisInTheLineOfProjectionIsFound) {
  const std::string stream = "SphericalOracles.AnAxisInTheLineOfProjectionIsFound";
  SCOPED_TRACE(stream);
  Random random(stream);
  const Vector<double, 3> a(3, 1, -1), b(1, 2, -2);  // a in the first pose, integers
  for (int i = 0; i < 5; ++i) {
    FivePoseTask task{Pose{}};
    for (std::size_t j = 1; j < 5; ++j) {  // about b, and about a before that: exactly, the norm is free
      const auto part = [&](const Vector<double, 3>& v) {
        const double s = 1.0 + random.below(20);
        return Vector<double, 4>(random.below(41) - 20.0, s * v[0], s * v[1], s * v[2]);
      };
      task[j] = Space::pose(quaternion_product<double>(part(b), part(a)));
    }
    const auto by_elimination = exact_by_elimination(task), by_cones = exact_by_cones(task);
    for (const ExactFivePoses& found : {by_elimination, by_cones}) {
      EXPECT_EQ(std::count_if(found.real.begin(), found.real.end(),
                              [&](const ExactDyad& dyad) {
                                return dyad.rounded().moving.cross(a.normalized()).norm() < 1e-14 &&
                                       dyad.rounded().fixed.cross(b.normalized()).norm() < 1e-14;
                              }),
                1)
          << i;
      EXPECT_EQ(exact_count(task), static_cast<int>(found.real.size())) << i;
    }
    EXPECT_EQ(EliminationOracle().solve(task).status, Status::exact) << i;
  }
}

TEST(SphericalOracles, AnAxisInTwoPlacesHasInfinitelyManyPartners) {
  const FivePoseTask task{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {1, 2, 3, 4}, {-3, 5, 1, 5}};
  EXPECT_FALSE(exact_count(task));
  EXPECT_EQ(EliminationOracle().solve(task).status, Status::degenerate);
  EXPECT_EQ(ConesOracle().solve(task).status, Status::degenerate);
}

TEST(SphericalOracles, InfinitelyManyDyadsAreNotCounted) {
  for (const char* name : {"equal_poses"}) {  // of the others rounding makes ordinary poses
    Random random(std::string("SphericalOracles.InfinitelyMany.") + name);
    const FivePoseTask task = find_task_class(name)->make(random);
    EXPECT_FALSE(exact_count(task));
    EXPECT_EQ(EliminationOracle().solve(task).status, Status::degenerate);
    EXPECT_EQ(ConesOracle().solve(task).status, Status::degenerate);
  }
}

TEST(SphericalOracles, ReportsAgreeWithTheDirectSolver) {
  Random random("SphericalOracles.ReportsAgreeWithTheDirectSolver");
  for (int i = 0; i < 20; ++i) {
    const FivePoseTask task = find_task_class("planted_slider")->make(random);
    const SphericalReport direct = FivePoseSolver().solve(task);
    for (const SphericalReport& slow : {EliminationOracle().solve(task), ConesOracle().solve(task)}) {
      ASSERT_EQ(slow.dyads.size(), direct.dyads.size()) << "task " << i;
      for (std::size_t k = 0; k < slow.dyads.size(); ++k) {
        EXPECT_EQ(slow.dyads[k].design.index(), direct.dyads[k].design.index()) << "task " << i;
        const double condition = slow.dyads[k].condition.value_or(0);
        EXPECT_LT(support::nearest(support::as_RR(slow.dyads[k].design), direct).distance, 1e-14 * (1 + condition));
      }
    }
  }
}

}  // namespace
}  // namespace burmester::spherical
