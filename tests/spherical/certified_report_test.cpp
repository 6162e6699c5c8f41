// What people read of a proof: messages, certificates and verdicts in the reports of FivePoseSolver.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "burmester/spherical/degeneracy.hpp"
#include "burmester/spherical/five_pose_oracle.hpp"
#include "burmester/spherical/five_pose_solver.hpp"
#include "burmester/spherical/tasks.hpp"
#include "clusters.hpp"

namespace burmester::spherical {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

SphericalReport solved(const FivePoseTask& task) { return FivePoseSolver().solve(task); }

TEST(SphericalReports, EveryRandomTaskIsProvedComplete) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "SphericalReports.EveryRandomTaskIsProvedComplete." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 40; ++i) {
      const SphericalReport report = solved(c.make(random));
      ASSERT_TRUE(report.counts.certified) << stream << ' ' << i << ": " << report.message;
      EXPECT_EQ(report.counts.real, static_cast<int>(report.dyads.size()));
      EXPECT_THAT(report.message, HasSubstr(report.dyads.empty() ? ", proved" : ", proved complete, true to "));
      for (const auto& found : report.dyads) {
        EXPECT_TRUE(found.certificate.certified);
        EXPECT_NE(found.certificate.rung, Rung::none);
        EXPECT_GT(found.certificate.radius, 0);
        EXPECT_LE(found.certificate.radius, 1e-9 + found.departure.value_or(0)) << stream << ' ' << i;
      }
    }
  }
}

TEST(SphericalReports, TheRadiusOfASliderHoldsItsDeparture) {
  const std::string stream = "SphericalReports.TheRadiusOfASliderHoldsItsDeparture";
  SCOPED_TRACE(stream);
  Random random(stream);
  int sliders = 0;
  for (int i = 0; i < 20; ++i) {
    PlantedSlider planted = planted_slider(random);
    for (Pose& p : planted.task) p = Space::nudged(p, 1e-11 * Space::random_feature(random));
    for (const auto& found : solved(planted.task).dyads)
      if (std::holds_alternative<PR::Design>(found.design)) {
        ++sliders;
        EXPECT_GE(found.certificate.radius, 0.99 * found.departure.value());
      }
  }
  EXPECT_GT(sliders, 10);
}

TEST(SphericalReports, WithoutProofNothingIsClaimed) {
  Random random("SphericalReports.WithoutProofNothingIsClaimed");
  const SphericalReport report = FivePoseSolver{.certify = false}.solve(planted_four_bar(random).task);
  EXPECT_FALSE(report.counts.certified);
  EXPECT_THAT(report.message, Not(HasSubstr("proved")));
  ASSERT_FALSE(report.dyads.empty());
  EXPECT_FALSE(report.dyads[0].certificate.certified);
}

TEST(SphericalReports, ExactDegeneraciesAreProved) {
  const FivePoseTask equal{Pose{1, 2, 3, 4}, {1, 0, 0, 1}, {2, 1, 0, 0}, {-3, -6, -9, -12}, {0, 1, 1, 0}};
  const FivePoseTask one_axis{Pose{1, 0, 0, 0}, {1, 1, 2, -1}, {2, 3, 6, -3}, {0, 1, 2, -1}, {5, 1, 2, -1}};
  const FivePoseTask four_about_one{Pose{1, 0, 0, 0}, {1, 1, 2, -1}, {2, 3, 6, -3}, {0, 1, 2, -1}, {5, 1, 0, -1}};
  const FivePoseTask turned_over{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {0, 1, 0, 0}, {0, 2, 1, 0}};
  const std::pair<FivePoseTask, const char*> named[] = {{equal, "poses 1 and 4 are equal"},
                                                        {one_axis, "have one axis"},
                                                        {four_about_one, "fewer than four independent conditions"},
                                                        {turned_over, "two places, opposite to each other"}};
  for (const auto& [task, words] : named) {
    const SphericalReport report = solved(task);
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_TRUE(report.counts.certified) << report.message;
    EXPECT_THAT(report.message, AllOf(HasSubstr(words), EndsWith(", proved")));
    EXPECT_THAT(report.dyads, IsEmpty());
  }
}

/// Three orientations about z, the other two with z in one place: z goes with a plane of axes, and with b = z one
/// moving axis does, here in five digits from the two conditions of the other two.
TEST(SphericalReports, TheDyadBesideAFamilyIsListedAndProved) {
  const FivePoseTask task{Pose{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {1, 2, 3, 4}, {-3, 5, 1, 5}};
  FivePoseTask inverse = task;
  for (Pose& p : inverse) p = {p.w, -p.x, -p.y, -p.z};
  const Axis z(0, 0, 1), partner(0.70274, 0.33288, 0.62877);
  for (const bool seen_from_body : {false, true}) {
    const SphericalReport report = solved(seen_from_body ? inverse : task);
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_TRUE(report.counts.certified);
    EXPECT_THAT(report.message, AllOf(HasSubstr("takes only two places"), EndsWith("; one dyad beside them, proved")));
    ASSERT_EQ(report.dyads.size(), 1u);
    const auto& found = report.dyads[0];
    const auto& dyad = std::get<RR::Design>(found.design);
    EXPECT_LT((seen_from_body ? dyad.moving : dyad.fixed).cross(z).norm(), 1e-15);
    EXPECT_LT((seen_from_body ? dyad.fixed : dyad.moving).cross(partner).norm(), 1e-5);
    EXPECT_NEAR(std::sin(dyad.arc), std::sin(51.04073 * std::numbers::pi / 180), 1e-7);
    EXPECT_LT(found.residual, 1e-14);
    EXPECT_TRUE(found.certificate.certified);
    EXPECT_LT(found.certificate.radius, 1e-14);
  }
  EXPECT_THAT(FivePoseSolver{.certify = false}.solve(task).message, EndsWith("(any others are not listed)"));
}

/// Poses 1 and 4 are equal; 2 and 3 differ, by less than the rounding of unit quaternions.
TEST(SphericalReports, OnlyEqualOrientationsAreProvedEqual) {
  const FivePoseTask task{Pose{1, 2, 3, 4}, {1, 0, 0, 1}, {1, 0, 0x1p-52, 1}, {-3, -6, -9, -12}, {0, 1, 1, 0}};
  EXPECT_EQ(solved(task).message,
            "poses 1 and 4 are equal: in effect 4 poses, in general met by a curve of dyads (circle points and centre "
            "points), proved");
}

TEST(SphericalReports, RoundedDegeneraciesSayWhatHoldsOfTheDoubles) {
  const std::string stream = "SphericalReports.RoundedDegeneraciesSayWhatHoldsOfTheDoubles";
  SCOPED_TRACE(stream);
  Random random(stream);
  const SphericalReport report = solved(find_task_class("common_axis")->make(random));
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_FALSE(report.counts.certified);
  EXPECT_THAT(report.message,
              AllOf(HasSubstr("have one axis"), HasSubstr("true within rounding, the doubles given have ")));
}

/// Two orientations that differ by 1e-11: too near for the data of a measurement, but a task like any other.
TEST(SphericalReports, IndistinctOrientationsAreAnsweredForTheDoubles) {
  const std::string stream = "SphericalReports.IndistinctOrientationsAreAnsweredForTheDoubles";
  SCOPED_TRACE(stream);
  Random random(stream);
  FivePoseTask task = find_task_class("generic")->make(random);
  task[3] = Space::nudged(task[0], 1e-11 * Space::random_feature(random));
  EXPECT_THAT(FivePoseSolver{.certify = false}.solve(task).message, HasSubstr("not decided"));
  const SphericalReport report = solved(task);
  EXPECT_TRUE(report.counts.certified);
  EXPECT_THAT(report.warnings, ::testing::Contains(HasSubstr("the answer holds for the doubles given")));
}

/// Orientations in clusters, 1e-8 to 2e-14 rad wide and of different widths: not coaxial, so only their doubles count.
TEST(SphericalReports, ClustersAreRegular) {
  const std::string stream = "SphericalReports.ClustersAreRegular";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 80; ++i) {
    const FivePoseTask task = support::in_clusters(find_task_class("generic")->make(random), i, [&](const Pose& p) {
      return Space::nudged(p, std::pow(10, random.uniform(-13.7, -8)) * Space::random_feature(random));
    });
    if (axis_in_two_places(task).distance < 0x1p-48) continue;  // two of the directions drawn nearly agree
    const SphericalReport report = solved(task);
    EXPECT_NE(report.status, Status::degenerate) << i << ": " << report.message;
    EXPECT_TRUE(report.counts.certified) << i << ": " << report.message;
    EXPECT_EQ(report.counts.real, exact_count(task)) << i;
    EXPECT_THAT(FivePoseSolver{.certify = false}.solve(task).message, Not(HasSubstr("infinitely many"))) << i;
  }
}

/// An axis in two places, but for changes a few times as large as rounding: which dyads there are is a matter of these.
TEST(SphericalReports, NearlyAnAxisInTwoPlacesIsSaid) {
  const std::string stream = "SphericalReports.NearlyAnAxisInTwoPlacesIsSaid";
  SCOPED_TRACE(stream);
  Random random(stream);
  int tried = 0;
  for (int i = 0; i < 20; ++i) {
    FivePoseTask task = find_task_class("axis_in_two_places")->make(random);
    for (Pose& p : task) p = Space::nudged(p, std::pow(10, random.uniform(-13.7, -12)) * Space::random_feature(random));
    if (axis_in_two_places(task).kind != Degeneracy::none) continue;
    ++tried;
    const SphericalReport report = solved(task);
    EXPECT_TRUE(report.counts.certified) << i << ": " << report.message;
    EXPECT_EQ(report.counts.real, exact_count(task)) << i;
    EXPECT_THAT(report.warnings, ::testing::Contains(HasSubstr("the answer holds for the doubles given"))) << i;
    EXPECT_THAT(FivePoseSolver{.certify = false}.solve(task).message, HasSubstr("not decided")) << i;
  }
  EXPECT_GE(tried, 10);
}

/// Two pairs of close orientations and a fifth: the two equations of the second pair nearly agree, but not by rounding.
TEST(SphericalReports, TwoClosePairsAreRegular) {
  const std::string stream = "SphericalReports.TwoClosePairsAreRegular";
  SCOPED_TRACE(stream);
  Random random(stream);
  std::vector<FivePoseTask> tasks{{Pose{1, 2, -1, 3},
                                   {1.00000002, 2.00000001, -1, 2.99999999},
                                   {2, -1, 1, 1},
                                   {2, -0.99999997, 0.99999999, 1.00000001},
                                   {3, 1, 2, 0}}};
  for (int i = 0; i < 60; ++i) {
    FivePoseTask task = find_task_class("generic")->make(random);
    for (const std::size_t j : {0, 2})
      task[j + 1] = Space::nudged(task[j], std::pow(10, random.uniform(-12, -5)) * Space::random_feature(random));
    tasks.push_back(task);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const SphericalReport report = solved(tasks[i]);
    EXPECT_NE(report.status, Status::degenerate) << i << ": " << report.message;
    EXPECT_TRUE(report.counts.certified) << i << ": " << report.message;
    EXPECT_EQ(report.counts.real, exact_count(tasks[i])) << i;
    EXPECT_THAT(FivePoseSolver{.certify = false}.solve(tasks[i]).message, Not(HasSubstr("infinitely many"))) << i;
  }
}

TEST(SphericalReports, CoincidingDyadsAreProvedAndNamed) {
  const FivePoseTask task{Pose{1, 0, 0, 0}, {1, 2, 0, -2}, {3, 1, -5, -1}, {3, 2, 8, -2}, {4, 0, 5, -4}};
  const SphericalReport report = solved(task);
  EXPECT_EQ(report.dyads.size(), 3u);
  EXPECT_TRUE(report.counts.certified);
  EXPECT_THAT(report.warnings, ::testing::Contains(HasSubstr("coincide")));
}

}  // namespace
}  // namespace burmester::spherical
