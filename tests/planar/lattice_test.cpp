// Tasks with small integer data, where degeneracies of all kinds are frequent and exact, against rational arithmetic.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "burmester/planar/five_pose_roots.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "exact_five_pose.hpp"
#include "repetitions.hpp"

namespace burmester::planar {
namespace {

/// X3 and X4 up to `turns`, coordinates up to `places`.
FivePoseTask lattice_task(Random& random, int turns, int places) {
  FivePoseTask task;
  for (Pose& p : task) {
    do {
      p.X3 = random.below(2 * turns + 1) - turns, p.X4 = random.below(turns + 1);
    } while (p.X3 == 0 && p.X4 == 0);
    p.x = random.below(2 * places + 1) - places, p.y = random.below(2 * places + 1) - places;
  }
  return task;
}

std::string text(const FivePoseTask& task) {
  std::ostringstream out;
  for (const Pose& p : task) out << " (" << p.x << ", " << p.y << "; " << p.X3 << " : " << p.X4 << ')';
  return out.str();
}

/// Whether every listed dyad meets the poses: to rounding, or nearly so where the report warns of a multiple dyad.
bool all_meet(const PlanarReport& report, const FivePoseTask& task) {
  const double allowed = report.warnings.empty() ? 1e-9 : 1e-4;
  for (const auto& found : report.dyads) {
    const double length = Dyads::visit(
        found.design, []<class D>(const typename D::Design& d) { return D::record(d).length.value_or(0); });
    if (!(found.residual <= allowed * std::max(length, task_size(task)))) return false;
  }
  return true;
}

/// Number of real dyads among the exact solutions, where it is beyond doubt: all simple. Of a 3 + 2 task two
/// solutions are the pair of orientations.
std::optional<int> expected_count(const exact::Solutions& truth, FivePoseCase what) {
  const bool pair = what == FivePoseCase::two_orientations;
  if (!truth.finite || truth.real.distinct != truth.real.counted - (pair ? 1 : 0)) return std::nullopt;
  return truth.real.counted - (pair ? 2 : 0);
}

void expect_agreement(const std::string& stream, int tasks, int turns, int places) {
  Random random(stream), coordinates(stream + ".coordinates");
  for (int i = 0; i < repetitions(tasks); ++i) {
    const FivePoseTask task = lattice_task(random, turns, places);
    const std::string label = stream + ", task " + std::to_string(i) + ':' + text(task);
    const exact::Solutions truth = exact::count_solutions(task, coordinates);
    const FivePoseRoots<double> roots = five_pose_roots(task);
    const PlanarReport report = FivePoseSolver().solve(task);
    const bool regular =
        roots.what == FivePoseCase::regular || roots.what == FivePoseCase::two_orientations ||
        roots.what == FivePoseCase::two_orientations_in_line || roots.what == FivePoseCase::common_vertex;
    EXPECT_EQ(regular, truth.finite) << label << "\n" << report.message;
    EXPECT_TRUE(all_meet(report, task)) << label << "\n" << report.message;
    const bool counted = roots.what == FivePoseCase::regular || roots.what == FivePoseCase::two_orientations;
    if (const auto expected = expected_count(truth, roots.what); expected && counted) {
      EXPECT_EQ(static_cast<int>(report.dyads.size()), *expected) << label << "\n" << report.message;
    }
    const bool pair = roots.what == FivePoseCase::two_orientations;
    if (report.counts.certified && counted) {
      EXPECT_EQ(*report.counts.real, truth.real.distinct - (pair ? 1 : 0)) << label;
    }
    if (!counted) {
      EXPECT_TRUE(report.counts.certified) << label << "\n" << report.message;  // exactly degenerate, or not at all
    }
  }
}

TEST(LatticeTasks, QuarterTurns) { expect_agreement("LatticeTasks.QuarterTurns", 5000, 1, 1); }
TEST(LatticeTasks, SmallIntegers) { expect_agreement("LatticeTasks.SmallIntegers", 5000, 2, 2); }
TEST(LatticeTasks, LargerIntegers) { expect_agreement("LatticeTasks.LargerIntegers", 3000, 3, 4); }

}  // namespace
}  // namespace burmester::planar
