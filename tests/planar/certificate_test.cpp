// The certificate against rational arithmetic and quad precision: the proved number is the exact one, the proved radius
// holds, and nothing is claimed where nothing can be proved.
#include <gtest/gtest.h>

#include "burmester/planar/five_pose_certificate.hpp"
#include "burmester/planar/five_pose_oracle.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "exact_five_pose.hpp"
#include "five_pose_accuracy.hpp"

namespace burmester::planar {
namespace {

TEST(Certificate, EachRungCountsAsSturmDoes) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "Certificate.EachRungCountsAsSturmDoes." + std::string(c.name);
    Random random(stream), coordinates(stream + ".coordinates");
    int decided = 0;
    for (int i = 0; i < 20; ++i) {
      const FivePoseTask task = c.make(random);
      const int truth = static_cast<int>(exact::count_solutions(task, coordinates).real.distinct);
      EXPECT_EQ(count_exactly(task), truth) << stream << ", task " << i;
      const int by_intervals = count_by_intervals(task);
      decided += by_intervals >= 0;
      EXPECT_TRUE(by_intervals == truth || by_intervals == -1) << stream << ", task " << i << ": " << by_intervals;
    }
    EXPECT_GE(decided, 15) << stream << ": intervals should decide nearly all";
  }
}

TEST(Certificate, IsCompleteOnRandomTasks) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "Certificate.IsCompleteOnRandomTasks." + std::string(c.name);
    Random random(stream);
    const bool slider = c.name.starts_with("planted_P") || c.name.starts_with("planted_R");
    for (int i = 0; i < 200; ++i) {
      const CertifiedRoots proved = certified_five_pose_roots(c.make(random));
      EXPECT_TRUE(proved.complete || slider) << stream << ", task " << i;
      EXPECT_TRUE(!proved.complete || proved.count == proved.roots.count) << stream << ", task " << i;
    }
  }
}

/// The oracle's dyad nearest to the one shown is within the radius: every coordinate and length of an RR.
void expect_within_radius(const FivePoseTask& task, const std::string& where) {
  const PlanarReport report = FivePoseSolver().solve(task);
  const FivePoseRoots<Quad> oracle = five_pose_roots_quad(task);
  const Pose& reference = task[static_cast<std::size_t>(oracle.anchor.reference)];
  for (const auto& found : report.dyads) {
    const auto* rr = std::get_if<RR::Design>(&found.design);
    if (!rr || !found.certificate.certified) continue;
    Quad least = 1e300;
    for (int k = 0; k < oracle.count; ++k) {
      const Vector<Quad, 4> y =
          accuracy::detail::pivots<Quad>(oracle.w[static_cast<std::size_t>(k)], oracle.anchor, reference);
      const Vector<Quad, 4> x{rr->moving[0], rr->moving[1], rr->fixed[0], rr->fixed[1]};
      Quad most = 0;
      for (int i = 0; i < 4; ++i) most = std::max(most, Quad(abs(Quad(x[i] - y[i]))));
      least = std::min(least, most);
    }
    EXPECT_LE(static_cast<double>(least), found.certificate.radius) << where;
    EXPECT_GT(found.certificate.radius, 0) << where;
  }
}

TEST(Certificate, RadiusHoldsAgainstQuadPrecision) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "Certificate.RadiusHoldsAgainstQuadPrecision." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 200; ++i) expect_within_radius(c.make(random), stream + ", task " + std::to_string(i));
  }
}

TEST(Certificate, RadiusOfAPlantedSliderCoversIt) {
  const std::string stream = "Certificate.RadiusOfAPlantedSliderCoversIt";
  Random random(stream);
  int certified = 0;
  for (int i = 0; i < 200; ++i) {
    // poses that bring the point (m) of E exactly onto the X axis:
    // the true dyad is PR with angle 0 up to their rounding
    const Vector2 m{random.normal(), random.normal()};
    FivePoseTask task;
    for (Pose& p : task) {
      p = pose_from_radians(0, 0, random.uniform(-3, 3));
      const Vector2 at = to_fixed(p, m);
      p.x = random.normal() - at[0], p.y = -at[1];
    }
    for (const auto& found : FivePoseSolver().solve(task).dyads) {
      const auto* pr = std::get_if<PR::Design>(&found.design);
      if (!pr || !found.certificate.certified) continue;
      ++certified;
      const double rounding = 1e-13 * (1 + *found.condition);  // the planted poses are rounded to 1e-16 of their size
      EXPECT_LE((pr->moving - m).norm(), 2 * found.certificate.radius + rounding) << stream << ", task " << i;
      EXPECT_LE(std::abs(std::remainder(pr->line.record().angle, 3.14159265358979)),
                2 * found.certificate.radius + rounding)
          << stream << ", task " << i;
    }
  }
  EXPECT_GE(certified, 150) << stream;
}

/// Of the random degenerate tasks these are degenerate exactly, the others within rounding.
TEST(Certificate, OfDegeneratePosesIsClaimedWhereTheDoublesAreDegenerate) {
  for (const TaskClass& c : degenerate_task_classes()) {
    const std::string stream =
        "Certificate.OfDegeneratePosesIsClaimedWhereTheDoublesAreDegenerate." + std::string(c.name);
    Random random(stream);
    const bool exactly = c.name == "equal_poses" || c.name == "all_parallel" || c.name == "four_parallel" ||
                         c.name == "two_orientations";
    for (int i = 0; i < 20; ++i) {
      const PlanarReport report = FivePoseSolver().solve(c.make(random));
      EXPECT_EQ(report.counts.certified, exactly) << stream << ", task " << i << ": " << report.message;
      EXPECT_EQ(report.message.find(", proved") != std::string::npos, exactly) << stream << ", task " << i;
      EXPECT_EQ(report.message.find("within rounding") != std::string::npos, !exactly) << stream << ", task " << i;
    }
  }
}

TEST(Certificate, SharpBoxesLieInTheOthers) {
  const std::string stream = "Certificate.SharpBoxesLieInTheOthers";
  Random random(stream);
  for (int i = 0; i < 100; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    const CertifiedRoots wide = certified_five_pose_roots(task);
    CertifiedRoots sharp = wide;
    ASSERT_TRUE(sharpen(task, sharp)) << stream << ", task " << i;
    EXPECT_TRUE(sharp.sharp && sharp.complete && sharp.count == wide.count) << stream << ", task " << i;
    for (int k = 0; k < sharp.count; ++k) {
      const auto inside = [&](const DyadBox& box) {  // the roots may come in another order
        const auto meets = [](const Range& a, const Range& b) { return a.low <= b.high && b.low <= a.high; };
        const DyadBox& small = sharp.boxes[static_cast<std::size_t>(k)];
        return meets(small.moving[0], box.moving[0]) && meets(small.moving[1], box.moving[1]) &&
               meets(small.fixed[0], box.fixed[0]) && meets(small.fixed[1], box.fixed[1]) &&
               small.length.high - small.length.low <= box.length.high - box.length.low;
      };
      EXPECT_TRUE(std::any_of(wide.boxes.begin(), wide.boxes.begin() + wide.count, inside)) << stream << ", task " << i;
    }
  }
}

TEST(Certificate, RadiusIsSmallBesideTheTask) {
  const std::string stream = "Certificate.RadiusIsSmallBesideTheTask";
  Random random(stream);
  int wide = 0;
  for (int i = 0; i < 3000; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    const PlanarReport report = FivePoseSolver().solve(task);
    EXPECT_TRUE(report.counts.certified) << stream << ", task " << i;
    for (const auto& found : report.dyads) wide += found.certificate.radius > 1e-9 * task_size(task);
  }
  EXPECT_LE(wide, 3) << stream;
}

TEST(Certificate, ExactlyDegeneratePosesAreNotCounted) {
  const Pose a{0, 0, 0, 1}, b{1, 2, 0, 1}, c{3, 1, 0, 1}, d{-1, 4, 0, 1}, e{2, -2, 0, 1};
  for (const FivePoseTask& task : {FivePoseTask{a, b, c, d, e}, FivePoseTask{a, a, b, {1, 2, 3, 4}, {2, 2, 1, 5}}}) {
    EXPECT_EQ(count_by_intervals(task), -1);
    EXPECT_EQ(count_exactly(task), -1);
  }
}

TEST(Certificate, NoCertificateUnlessAskedFor) {
  Random random("Certificate.NoCertificateUnlessAskedFor");
  const FivePoseTask task = find_task_class("generic")->make(random);
  EXPECT_TRUE(FivePoseSolver().solve(task).counts.certified);
  const PlanarReport bare = FivePoseSolver{.certify = false}.solve(task);
  EXPECT_FALSE(bare.counts.certified);
  for (const auto& found : bare.dyads) EXPECT_FALSE(found.certificate.certified);
}

FivePoseTask degrees(const std::array<std::array<double, 3>, 5>& rows) {
  FivePoseTask out;
  for (std::size_t j = 0; j < 5; ++j) out[j] = pose_from_degrees(rows[j][0], rows[j][1], rows[j][2]);
  return out;
}

TEST(Certificate, HoldsWhereBothConicsAreSingular) {
  for (const auto& [task, real] :
       {std::pair(degrees({{{0, -2, 180}, {-1, 0, -90}, {-3, -2, 180}, {0, -2, 0}, {-3, -1, 90}}}), 4),
        std::pair(degrees({{{-2, 1, -90}, {-2, 0, 180}, {1, -2, 90}, {-3, 0, -90}, {2, -1, 90}}}), 4),
        std::pair(degrees({{{0, 2, 90}, {2, 2, 180}, {2, -3, -90}, {2, 2, 90}, {2, 3, -90}}}), -1)}) {
    Random coordinates("Certificate.HoldsWhereBothConicsAreSingular");
    const int truth = static_cast<int>(exact::count_solutions(task, coordinates).real.distinct);
    const PlanarReport report = FivePoseSolver().solve(task);
    EXPECT_TRUE(report.counts.certified) << report.message;
    EXPECT_EQ(static_cast<int>(report.dyads.size()), truth) << report.message;
    EXPECT_TRUE(real < 0 || truth == real);
  }
}

TEST(Certificate, ATinyDifferenceIsNoDegeneracy) {
  for (const double angle : {100.0, 30.0, 10.0, 77.0}) {
    const FivePoseTask task =
        degrees({{{0, .8, angle}, {-.8, .25, 0}, {-.9, -.9, 0}, {0, 1, -60}, {5e-324, .8, angle}}});
    const PlanarReport report = FivePoseSolver().solve(task);  // the doubles have finitely many dyads
    EXPECT_FALSE(report.status == Status::degenerate && report.counts.certified) << report.message;
  }
}

TEST(Certificate, CoincidingDyadsAreNamedInTheMessage) {
  // 3 + 2 orientations with |t| = 2 R; a double dyad of regular poses
  for (const FivePoseTask& task : {degrees({{{5, 0, 0}, {-5, 0, 0}, {3, 4, 0}, {1, 1, 90}, {7, 9, 90}}}),
                                   degrees({{{-3, -1, -90}, {2, -2, 90}, {-2, 0, 180}, {-3, -3, 90}, {3, 1, 180}}})}) {
    const PlanarReport report = FivePoseSolver().solve(task);
    EXPECT_FALSE(report.counts.certified);
    EXPECT_NE(report.message.find("not proved, because two dyads coincide"), std::string::npos) << report.message;
  }
}

}  // namespace
}  // namespace burmester::planar
