#include "burmester/spherical/five_pose_solver.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "burmester/spherical/five_pose_roots.hpp"
#include "burmester/spherical/tasks.hpp"
#include "five_orientations.hpp"

namespace burmester::spherical {
namespace {

using support::distance;
using support::nearest;

TEST(FivePoses, CountsAreEvenAndAtMostSixAndResidualsAreRounding) {
  for (const TaskClass& c : random_task_classes()) {
    Random random(std::string("FivePoses.Counts.") + std::string(c.name));
    for (int i = 0; i < 100; ++i) {
      const SphericalReport report = FivePoseSolver().solve(c.make(random));
      const std::size_t real = report.dyads.size();
      EXPECT_TRUE(real <= 6 && real % 2 == 0) << c.name << ", task " << i << ": " << real;
      EXPECT_EQ(report.counts.complex, 6);
      EXPECT_EQ(report.counts.real, static_cast<int>(real));
      EXPECT_EQ(report.status, real > 0 ? Status::exact : Status::none);
      for (const auto& found : report.dyads)
        EXPECT_LT(found.residual, c.name == "planted_slider" ? 2e-9 : 1e-13) << c.name << ", task " << i;
    }
  }
}

TEST(FivePoses, APlantedFourBarIsFound) {
  Random random("FivePoses.APlantedFourBarIsFound");
  for (int i = 0; i < 300; ++i) {
    const PlantedFourBar planted = planted_four_bar(random);
    const SphericalReport report = FivePoseSolver().solve(planted.task);
    for (const RR::Design& dyad : planted.dyads) {
      const auto found = nearest(dyad, report);
      if (found.dyad->condition.value_or(0) > 1e6) continue;
      EXPECT_LT(found.distance, 1e-14 * (1 + found.dyad->condition.value_or(0))) << "task " << i;
    }
  }
}

TEST(FivePoses, APlantedSliderIsASlider) {
  Random random("FivePoses.APlantedSliderIsASlider");
  for (int i = 0; i < 300; ++i) {
    const PlantedSlider planted = planted_slider(random);
    const SphericalReport report = FivePoseSolver().solve(planted.task);
    const auto found = nearest({planted.slider.fixed, planted.slider.moving, std::numbers::pi / 2}, report);
    if (found.dyad->condition.value_or(0) > 1e6) continue;
    EXPECT_TRUE(std::holds_alternative<PR::Design>(found.dyad->design)) << "task " << i;
    EXPECT_LE(found.dyad->departure.value_or(1), 1e-9) << "task " << i;
    EXPECT_LT(found.distance, 1e-14 * (1 + found.dyad->condition.value_or(0))) << "task " << i;
  }
}

TEST(FivePoses, ADyadNearASliderSaysSo) {
  Random random("FivePoses.ADyadNearASliderSaysSo");
  for (int i = 0; i < 100; ++i) {
    PlantedSlider planted = planted_slider(random);
    for (Pose& pose : planted.task) pose = Space::nudged(pose, 3e-6 * Space::random_feature(random));
    const SphericalReport report = FivePoseSolver().solve(planted.task);
    for (const auto& found : report.dyads) {
      const auto* rr = std::get_if<RR::Design>(&found.design);
      const double departure = rr ? std::abs(rr->arc - std::numbers::pi / 2) : 0;
      EXPECT_EQ(found.slider.has_value(), departure > 1e-9 && departure <= 1e-3) << "task " << i;
      if (found.slider) {
        EXPECT_EQ(found.slider->type, "PR");
        EXPECT_NEAR(found.slider->departure, departure, 1e-15);
      }
    }
  }
}

TEST(FivePoses, BothPathsGiveTheSame) {
  for (const char* name : {"generic", "planted_four_bar", "near_half_turns", "four_half_turns", "close_pair"}) {
    Random random(std::string("FivePoses.BothPathsGiveTheSame.") + name);
    for (int i = 0; i < 200; ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      const FivePoseRoots a = five_pose_roots(task, FivePosePath::sextic),
                          b = five_pose_roots(task, FivePosePath::action);
      ASSERT_EQ(a.count, b.count) << name << ", task " << i;
      for (const RR::Design& x : support::dyads_of(a, task)) {
        double least = 4;
        for (const RR::Design& y : support::dyads_of(b, task)) least = std::min(least, distance(x, y));
        EXPECT_LT(least, 1e-7) << name << ", task " << i;
      }
    }
  }
}

// Equations of rank three leave no fourth pivot: nothing is listed, whatever was solved before.
TEST(FivePoses, TheSexticPathListsNothingWithoutPivots) {
  Random random("FivePoses.TheSexticPathListsNothingWithoutPivots");
  const FivePoseTask four_half_turns{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0}, {0, 1, -1, 0}}},
      four_about_one_axis{{{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 3}, {1, 0, 0, -1}, {1, 2, 3, 4}}};
  for (const FivePoseTask& task : {four_half_turns, four_about_one_axis})
    for (int i = 0; i < 20; ++i) {
      five_pose_roots(find_task_class("generic")->make(random), FivePosePath::sextic);
      const FivePoseRoots roots = five_pose_roots(task, FivePosePath::sextic);
      EXPECT_EQ(roots.pivot, 0);
      EXPECT_EQ(roots.count, 0);
    }
}

// Where all four rotations from the first orientation are half turns, the conditions are symmetric in a and b.
TEST(FivePoses, HalfTurnsGiveDyadsInExchangedPairs) {
  Random random("FivePoses.HalfTurnsGiveDyadsInExchangedPairs");
  for (int i = 0; i < 100; ++i) {
    FivePoseTask task = find_task_class("four_half_turns")->make(random);
    const SphericalReport report =
        FivePoseSolver().solve(task);  // the first orientation is the identity: a is in S too
    for (const auto& found : report.dyads) {
      const RR::Design dyad = support::as_RR(found.design);
      EXPECT_LT(nearest({dyad.moving, dyad.fixed, dyad.arc}, report).distance,
                1e-14 * (1 + found.condition.value_or(0)))
          << "task " << i;
    }
  }
}

TEST(FivePoses, DegenerateOnesAreNamed) {
  for (const TaskClass& c : degenerate_task_classes()) {
    Random random(std::string("FivePoses.DegenerateOnesAreNamed.") + std::string(c.name));
    const char* words = c.name == "equal_poses"    ? "poses 2 and 4 are equal"
                        : c.name == "common_axis"  ? "have one axis"
                        : c.name == "four_coaxial" ? "fewer than four independent conditions"
                                                   : "takes only two places";
    for (int i = 0; i < 200; ++i) {
      const SphericalReport report = FivePoseSolver{.certify = false}.solve(c.make(random));
      EXPECT_EQ(report.status, Status::degenerate) << c.name << ", task " << i;
      EXPECT_NE(report.message.find(words), std::string::npos) << c.name << ", task " << i << ": " << report.message;
      EXPECT_TRUE(report.dyads.empty() && !report.counts.real && !report.counts.complex);
    }
  }
}

TEST(FivePoses, AllEqualIsNamed) {
  const FivePoseTask task{};
  EXPECT_NE(FivePoseSolver().solve(task).message.find("poses 1 and 2 and 3 and 4 and 5 are equal"), std::string::npos);
}

// Between two tasks with different numbers of dyads two of them coincide somewhere; there the report says so.
TEST(FivePoses, CoincidingDyadsAreNamed) {
  Random random("FivePoses.CoincidingDyadsAreNamed");
  int named = 0, ways = 0;
  while (ways < 20) {
    const FivePoseTask from = find_task_class("generic")->make(random), to = find_task_class("generic")->make(random);
    const auto between = [&](double t) {
      FivePoseTask task;
      for (std::size_t j = 0; j < 5; ++j)
        task[j] = {(1 - t) * from[j].w + t * to[j].w, (1 - t) * from[j].x + t * to[j].x,
                   (1 - t) * from[j].y + t * to[j].y, (1 - t) * from[j].z + t * to[j].z};
      return task;
    };
    const auto count = [&](double t) { return FivePoseSolver{.certify = false}.solve(between(t)).dyads.size(); };
    double low = 0, high = 1;
    const std::size_t at_low = count(low);
    if (at_low == count(high)) continue;
    ++ways;
    while (high - low > 0x1p-52) {
      const double middle = (low + high) / 2;
      (count(middle) == at_low ? low : high) = middle;
    }
    const SphericalReport a = FivePoseSolver{.certify = false}.solve(between(low)),
                          b = FivePoseSolver{.certify = false}.solve(between(high));
    named += !(a.dyads.size() > b.dyads.size() ? a : b).warnings.empty();
  }
  EXPECT_EQ(named, ways);
}

}  // namespace
}  // namespace burmester::spherical
