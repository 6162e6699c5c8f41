// Five-orientation tasks by name: random ones, ones with planted dyads, and degenerate ones. Tests, benchmarks and
// studies draw from here.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/task_class.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

using FivePoseTask = std::array<Pose, 5>;

using TaskClass = TaskClassOf<FivePoseTask>;

/// Tasks with finitely many dyads.
const std::vector<TaskClass>& random_task_classes();
/// Tasks that must be named degenerate.
const std::vector<TaskClass>& degenerate_task_classes();
/// A class of either list by name; nullptr if there is none.
const TaskClass* find_task_class(std::string_view name);

/// Coupler orientations of a four-bar, with its two dyads.
struct PlantedFourBar {
  FivePoseTask task;
  std::array<RR::Design, 2> dyads;
};
PlantedFourBar planted_four_bar(Random& random);

/// Orientations in which a moving axis stays in a plane, with that slider.
struct PlantedSlider {
  FivePoseTask task;
  PR::Design slider;
};
PlantedSlider planted_slider(Random& random);

}  // namespace burmester::spherical
