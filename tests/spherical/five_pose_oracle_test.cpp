// The direct solver against exact elimination, class by class, and the two oracles against each other: the seeded, small
// version of the study (bench/studies/spherical_five_pose.cpp).
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
