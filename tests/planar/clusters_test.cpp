// Five poses in clusters of close ones: their doubles are proved, and not called degenerate.
#include <gmock/gmock.h>

#include <cmath>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"
#include "clusters.hpp"
#include "exact_five_pose.hpp"

namespace burmester::planar {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Pose beside(const Pose& p, double size, Random& random) {
  return {p.x + size * random.normal(), p.y + size * random.normal(), p.X3 + size * random.normal(),
          p.X4 + size * random.normal()};
}

/// Each pose 1e-8 to 1e-12 from the first of its cluster.
TEST(PoseClusters, AreProvedAsTheDoublesSay) {
  const std::string stream = "PoseClusters.AreProvedAsTheDoublesSay";
  SCOPED_TRACE(stream);
  Random random(stream), coordinates(stream + ".coordinates");
  for (int i = 0; i < 60; ++i) {
    const FivePoseTask task = support::in_clusters(find_task_class("generic")->make(random), i, [&](const Pose& p) {
      return beside(p, std::pow(10, random.uniform(-12, -8)), random);
    });
    const PlanarReport report = FivePoseSolver().solve(task);
    EXPECT_NE(report.status, Status::degenerate) << i << ": " << report.message;
    EXPECT_TRUE(report.counts.certified) << i << ": " << report.message;
    EXPECT_EQ(report.counts.real, exact::count_solutions(task, coordinates).real.distinct) << i;
    const std::string unproved = FivePoseSolver{.certify = false}.solve(task).message;
    EXPECT_THAT(unproved, Not(HasSubstr("family"))) << i;
    EXPECT_THAT(unproved, Not(HasSubstr("infinitely many"))) << i;
  }
}

/// Poses that are degenerate but for the rounding of their doubles keep the name.
TEST(PoseClusters, RoundedDegeneraciesKeepTheirName) {
  for (const char* name : {"rotation_about_point", "cardan_motion", "oldham_motion"}) {
    const std::string stream = std::string("PoseClusters.RoundedDegeneraciesKeepTheirName.") + name;
    Random random(stream);
    for (int i = 0; i < 40; ++i) {
      const PlanarReport report = FivePoseSolver().solve(find_task_class(name)->make(random));
      EXPECT_EQ(report.status, Status::degenerate) << stream << ' ' << i;
      EXPECT_TRUE(report.counts.certified || report.message.find("within rounding") != std::string::npos)
          << stream << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace burmester::planar
