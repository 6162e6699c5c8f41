// The direct solver and its quad oracle against rational arithmetic.
#include <gtest/gtest.h>

#include <limits>

#include "burmester/planar/five_pose_oracle.hpp"
#include "exact_five_pose.hpp"
#include "repetitions.hpp"

namespace burmester::planar {
namespace {

TEST(ExactCount, AgreesOnEveryClass) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "ExactCount.AgreesOnEveryClass." + std::string(c.name);
    Random random(stream), coordinates(stream + ".coordinates");
    for (int i = 0; i < repetitions(200); ++i) {
      const FivePoseTask task = c.make(random);
      const exact::Solutions truth = exact::count_solutions(task, coordinates);
      ASSERT_EQ(truth.dimension, 3u) << stream << ", task " << i;
      ASSERT_TRUE(truth.finite) << stream << ", task " << i;
      EXPECT_EQ(truth.real.distinct, truth.real.counted) << stream << ", task " << i << ": a double root";
      EXPECT_EQ(five_pose_roots(task).count, truth.real.distinct) << stream << ", task " << i;
      EXPECT_EQ(five_pose_roots_quad(task).count, truth.real.distinct)
          << stream << ", task " << i << " (quad)";
    }
  }
}

Vector<double, 4> pivots(const exact::Lifted& k) {
  const auto ratio = [&](int i) { return static_cast<double>(Rational(k[i] / k[0])); };
  return {ratio(3), ratio(4), -ratio(1), -ratio(2)};  // moving pivot in E, fixed pivot in S
}

Vector<double, 4> pivots(const Anchored<double>& w, const Anchor& anchor, const Pose& reference) {
  const AnchoredPivots<double> p = decode_pivots(w, anchor);
  const Vector2 moving = to_moving({0, 0, reference.X3, reference.X4}, p.moving * anchor.length);
  return {moving[0], moving[1], p.fixed[0] * anchor.length + reference.x,
          p.fixed[1] * anchor.length + reference.y};
}

double distance_to_nearest(const Vector<double, 4>& x, const std::vector<exact::Lifted>& solutions) {
  double least = std::numeric_limits<double>::infinity();
  for (const exact::Lifted& k : solutions) {
    const Vector<double, 4> y = pivots(k);
    least = std::min(least, (x - y).norm() / std::max(1.0, y.norm()));
  }
  return least;
}

TEST(ExactCount, PivotsAreThoseOfTheExactSolutions) {
  const std::string stream = "ExactCount.PivotsAreThoseOfTheExactSolutions";
  Random random(stream), coordinates(stream + ".coordinates");
  double worst = 0;
  for (int i = 0; i < repetitions(100); ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    const std::vector<exact::Lifted> solutions = exact::real_solutions(task, coordinates, 60);
    const FivePoseRoots<double> roots = five_pose_roots(task);
    ASSERT_EQ(roots.count, static_cast<int>(solutions.size())) << stream << ", task " << i;
    for (int r = 0; r < roots.count; ++r) {
      const Vector<double, 4> x = pivots(roots.w[r], roots.anchor, task[roots.anchor.reference]);
      const double error = distance_to_nearest(x, solutions);
      EXPECT_LT(error, 1e-9) << stream << ", task " << i << ", root " << r << ": " << x.transpose();
      worst = std::max(worst, error);
    }
  }
  RecordProperty("largest_relative_error", std::to_string(worst * 1e15) + "e-15");
}

// The oracle itself: E's origin on the circle of radius 5 about the origin, by construction.
TEST(ExactFivePoses, FindAPlantedDyadExactly) {
  Random random("ExactFivePoses.FindAPlantedDyadExactly");
  for (int i = 0; i < 20; ++i) {
    FivePoseTask task;
    for (Pose& p : task) {
      const double signs[] = {-1.0, 1.0};
      const double x = 3 * signs[random.below(2)], y = 4 * signs[random.below(2)];
      p = {x, y, random.below(19) - 9.0, random.below(9) + 1.0};
      if (random.below(2)) std::swap(p.x, p.y);
    }
    const exact::Lifted planted{{1, 0, 0, 0, 0, -25, 0, 0}};
    EXPECT_EQ(Family::relations<Rational>(planted), (Vector<Rational, 2>::Zero()));
    for (const Pose& p : task) EXPECT_EQ(Rational(Family::row<Rational>(p).dot(planted)), 0);
    const auto basis = exact::null_basis(task);
    for (const exact::Lifted& k : basis)
      for (const Pose& p : task) EXPECT_EQ(Rational(Family::row<Rational>(p).dot(k)), 0);
  }
}

}  // namespace
}  // namespace burmester::planar
