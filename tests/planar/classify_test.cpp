#include "burmester/planar/classify.hpp"

#include <gtest/gtest.h>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {
namespace {

/// Five poses whose moving pivot lies on an arc of length 2 of a circle of radius R, at places that leave
/// their best line by 1 / (4 R): heights t^2 / (2 R) at t = -1, -1/2, 0, 1/2, 1.
FivePoseTask arc_task(Random& random, double R) {
  const Vector2 moving = Space::random_feature(random);
  FivePoseTask task;
  for (int j = 0; j < 5; ++j) {
    const double t = (j - 2) / 2.0, s = std::sin(t / (2 * R));
    const Vector2 place(R * std::sin(t / R), 2 * R * s * s);  // R (1 - cos), without cancellation
    Pose p = pose_from_radians(0, 0, random.uniform(-3, 3));
    const Vector2 origin = place - rotated(p, moving);
    p.x = origin[0], p.y = origin[1];
    task[j] = p;
  }
  return task;
}

FivePoseTask inverted(FivePoseTask task) {
  for (Pose& p : task) p = Space::pose(Space::conjugate<double>(Space::point<double>(p)));
  return task;
}

double departure_of_radius(double R) { return 1 / (4 * R); }

template <class Slider>
int count_sliders(const PlanarReport& report) {
  int n = 0;
  for (const auto& found : report.dyads) n += std::holds_alternative<typename Slider::Design>(found.design);
  return n;
}
int count_near_sliders(const PlanarReport& report, const std::string& type) {
  int n = 0;
  for (const auto& found : report.dyads) n += found.slider && found.slider->type == type;
  return n;
}

template <class Slider>
void expect_thresholds(const std::string& stream, FivePoseTask (*turned)(FivePoseTask)) {
  Random random(stream);
  for (int i = 0; i < 100; ++i) {
    for (const double departure : {1e-11, 1e-8, 1e-6, 1e-5, 1e-1}) {
      const double R = 1 / (4 * departure);
      const FivePoseTask task = turned(arc_task(random, R));
      const double relative = departure_of_radius(R) / task_size(task);
      const PlanarReport report = FivePoseSolver().solve(task);
      const std::string label =
          stream + ", case " + std::to_string(i) + ", departure " + std::to_string(relative * 1e12) + "e-12";
      EXPECT_EQ(count_sliders<Slider>(report), relative < slider_departure) << label;
      if (relative > slider_departure && relative < near_slider_departure) {
        EXPECT_GE(count_near_sliders(report, Slider::name), 1) << label;
      }
      for (const auto& found : report.dyads) {
        EXPECT_LE(found.departure.value_or(0), slider_departure * task_size(task)) << label;
        if (found.slider) {
          EXPECT_GT(found.slider->departure, slider_departure * task_size(task)) << label;
          EXPECT_LE(found.slider->departure, near_slider_departure * task_size(task)) << label;
        }
      }
    }
  }
}

TEST(Classify, PRThresholds) {
  expect_thresholds<PR>("Classify.PRThresholds", [](FivePoseTask task) { return task; });
}
TEST(Classify, RPThresholds) { expect_thresholds<RP>("Classify.RPThresholds", inverted); }

TEST(Classify, SliderRecordIsTheLineOfTheArc) {
  Random random("Classify.SliderRecordIsTheLineOfTheArc");
  for (int i = 0; i < 100; ++i) {
    const double R = 1e4;
    const FivePoseTask task = arc_task(random, R);
    int seen = 0;
    for (const auto& found : FivePoseSolver().solve(task).dyads) {
      const auto* rr = std::get_if<RR::Design>(&found.design);
      if (!rr || !found.slider || std::abs(rr->length / R - 1) > 1e-3) continue;
      ++seen;
      EXPECT_NEAR(found.slider->departure, departure_of_radius(R), 1e-3 * departure_of_radius(R))
          << "case " << i;
      EXPECT_LT(std::abs(std::sin(found.slider->line->angle)), 1e-6) << "case " << i;  // the arc runs along x
    }
    EXPECT_EQ(seen, 1) << "case " << i;
  }
}

TEST(Classify, PlantedSlidersAreFound) {
  for (const char* name : {"planted_PR", "planted_RP"}) {
    Random random(std::string("Classify.PlantedSlidersAreFound.") + name);
    for (int i = 0; i < 500; ++i) {
      const PlanarReport report = FivePoseSolver().solve(find_task_class(name)->make(random));
      const int sliders = name[8] == 'P' ? count_sliders<PR>(report) : count_sliders<RP>(report);
      EXPECT_EQ(sliders, 1) << name << ", case " << i;
    }
  }
}

// The moving pivot stands still to some 1e-3 of the task: its places fit a line well, but it is a crank.
// Points near it move as little, so other short cranks may come with it.
TEST(Classify, ShortCranksStayRR) {
  Random random("Classify.ShortCranksStayRR");
  for (int i = 0; i < 100; ++i) {
    const double length = 1e-2;
    const Vector2 moving = 3 * Space::random_feature(random);
    FivePoseTask task;
    for (Pose& p : task) {
      p = pose_from_radians(0, 0, random.uniform(-3, 3));
      const double crank = random.uniform(-3, 3);
      const Vector2 origin = length * Vector2(std::cos(crank), std::sin(crank)) - rotated(p, moving);
      p.x = origin[0], p.y = origin[1];
    }
    double least_error = 1;
    for (const auto& found : FivePoseSolver().solve(task).dyads) {
      const auto* rr = std::get_if<RR::Design>(&found.design);
      if (!rr || rr->length > 0.1 * task_size(task)) continue;
      least_error = std::min(least_error, std::abs(rr->length - length));
      EXPECT_FALSE(found.slider) << "case " << i;
    }
    EXPECT_LT(least_error, 1e-2 * length) << "case " << i;
  }
}

// A slider whose finite pivot is the reference pose's origin: K0 and u are rounding errors there, and so is
// v.
TEST(Classify, SlidersThroughTheOrigin) {
  const FivePoseTask on_diagonal{Pose{1, 1, 0, 1}, Pose{1, 1, 1, 0}, Pose{-1, -1, 1, 0}, Pose{-1, -1, -1, 1},
                                 Pose{0, 0, -1, 1}};
  const PlanarReport direct = FivePoseSolver().solve(on_diagonal);
  const PlanarReport inverse = FivePoseSolver().solve(inverted(on_diagonal));
  EXPECT_EQ(count_sliders<PR>(direct), 1);
  EXPECT_EQ(count_sliders<RP>(inverse), 1);
  for (const auto& found : direct.dyads) EXPECT_LT(found.residual, 1e-14);
  for (const auto& found : inverse.dyads) EXPECT_LT(found.residual, 1e-14);
}

}  // namespace
}  // namespace burmester::planar
