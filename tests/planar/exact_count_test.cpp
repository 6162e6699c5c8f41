// The direct solver and its quad oracle against rational arithmetic.
#include <gtest/gtest.h>

#include "burmester/planar/five_pose_oracle.hpp"
#include "exact_five_pose.hpp"

namespace burmester::planar {
namespace {

TEST(ExactCount, AgreesOnEveryClass) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "ExactCount.AgreesOnEveryClass." + std::string(c.name);
    Random random(stream), coordinates(stream + ".coordinates");
    for (int i = 0; i < 200; ++i) {
      const FivePoseTask task = c.make(random);
      const exact::Solutions truth = exact::count_solutions(task, coordinates);
      ASSERT_EQ(truth.dimension, 3u) << stream << ", task " << i;
      ASSERT_TRUE(truth.finite) << stream << ", task " << i;
      EXPECT_EQ(truth.real.distinct, truth.real.counted) << stream << ", task " << i << ": a double root";
      EXPECT_EQ(five_pose_roots(task).count, truth.real.distinct) << stream << ", task " << i;
      EXPECT_EQ(five_pose_roots_quad(task).count, truth.real.distinct) << stream << ", task " << i << " (quad)";
    }
  }
}

/// (moving, fixed) of an RR from its lifted form.
Vector<Rational, 4> pivots(const exact::Lifted& k) {
  const Rational K0 = k[0];
  return {Rational(k[3] / K0), Rational(k[4] / K0), Rational(-k[1] / K0), Rational(-k[2] / K0)};
}

}  // namespace
}  // namespace burmester::planar
