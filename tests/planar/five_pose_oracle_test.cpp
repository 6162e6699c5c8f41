// The direct solver against quad precision, class by class: the seeded, small version of the accuracy study.
#include "burmester/planar/five_pose_oracle.hpp"

#include <gtest/gtest.h>

#include "five_pose_accuracy.hpp"

namespace burmester::planar {
namespace {

// With 500 tasks a class the 99.9 % quantile is nearly the largest error, and medians scatter by a few per
// cent.
constexpr double small_sample = 1.5;

class FivePoseAccuracy : public ::testing::TestWithParam<TaskClass> {};

TEST_P(FivePoseAccuracy, IsWithinTheLimitsOfItsClass) {
  const TaskClass& c = GetParam();
  const std::string stream = "FivePoseAccuracy.IsWithinTheLimitsOfItsClass." + std::string(c.name);
  Random random(stream);
  accuracy::Outcome outcome;
  for (int i = c.name == "generic" ? 3000 : 500; i-- > 0;) accuracy::add_task(c.make(random), outcome);
  EXPECT_EQ(outcome.wrong_count, 0) << stream;
  EXPECT_EQ(outcome.wrong_type, 0) << stream;
  EXPECT_EQ(outcome.with_real[1] + outcome.with_real[3], 0) << stream << ": complex dyads come in pairs";
  EXPECT_GT(outcome.with_real[2] + outcome.with_real[4], 0) << stream;
  const accuracy::Limits limits = accuracy::limits_of(c.name);
  EXPECT_LE(outcome.quantile(0.5), small_sample * limits.median) << stream;
  EXPECT_LE(outcome.quantile(0.999), small_sample * limits.tail) << stream;
  RecordProperty("median", std::to_string(outcome.quantile(0.5) * 1e16) + "e-16");
  RecordProperty("tail", std::to_string(outcome.quantile(0.999) * 1e12) + "e-12");
}

INSTANTIATE_TEST_SUITE_P(Classes, FivePoseAccuracy, ::testing::ValuesIn(random_task_classes()),
                         [](const auto& test) { return std::string(test.param.name); });

// What the oracle finds are dyads: the residuals of its roots vanish to quad precision.
TEST(FivePoseOracle, RootsSatisfyTheEquations) {
  Random random("FivePoseOracle.RootsSatisfyTheEquations");
  for (const TaskClass& c : random_task_classes())
    for (int i = 0; i < 100; ++i) {
      const FivePoseTask task = c.make(random);
      const FivePoseRoots<Quad> roots = five_pose_roots_quad(task);
      const Matrix<Quad, 4, 7> rows = anchored_rows<Quad>(task, roots.anchor);
      for (int k = 0; k < roots.count; ++k) {
        const Anchored<Quad> w = roots.w[k].normalized();
        // 1e-16 of slack for the elimination of ill-conditioned tasks
        EXPECT_LT(approximate(Quad((rows * w).norm())), 0x1p-113 * 1e4) << c.name << ", task " << i;
        for (const Quad& f : anchored_relations<Quad>(w, Quad(roots.anchor.turn)))
          EXPECT_LT(std::abs(approximate(f)), 0x1p-113 * 1e4) << c.name << ", task " << i;
      }
    }
}

TEST(FivePoseOracle, ReportsAgreeWithTheDirectSolver) {
  Random random("FivePoseOracle.ReportsAgreeWithTheDirectSolver");
  for (const auto* classes : {&random_task_classes(), &degenerate_task_classes()})
    for (const TaskClass& c : *classes)
      for (int i = 0; i < 50; ++i) {
        const FivePoseTask task = c.make(random);
        const PlanarReport fast = FivePoseSolver().solve(task), slow = FivePoseOracle().solve(task);
        EXPECT_EQ(fast.status, slow.status) << c.name << ", task " << i;
        EXPECT_TRUE(fast.message.starts_with(slow.message))
            << c.name << ", task " << i << ": " << fast.message;
        EXPECT_EQ(fast.counts.real, slow.counts.real) << c.name << ", task " << i;
        ASSERT_EQ(fast.dyads.size(), slow.dyads.size()) << c.name << ", task " << i;
        for (std::size_t k = 0; k < fast.dyads.size(); ++k)
          EXPECT_EQ(fast.dyads[k].design.index(), slow.dyads[k].design.index()) << c.name << ", task " << i;
      }
}

TEST(FivePoseReport, ResidualsAreRoundingErrors) {
  Random random("FivePoseReport.ResidualsAreRoundingErrors");
  for (int i = 0; i < 500; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    const PlanarReport report = FivePoseSolver().solve(task);
    for (const auto& found : report.dyads) {
      const double length = Dyads::visit(
          found.design, []<class D>(const typename D::Design& d) { return D::record(d).length.value_or(0); });
      EXPECT_LT(found.residual, 1e-12 * std::max(length, task_size(task))) << "task " << i;
    }
  }
}

}  // namespace
}  // namespace burmester::planar
