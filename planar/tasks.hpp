// Five-pose tasks by name: random ones, ones with a planted dyad, and degenerate ones.
//
// The random classes cover what designers produce daily (millimetres with an offset origin, small turns, nearly
// parallel poses); the degenerate ones have a known verdict. Tests, benchmarks and studies draw from here.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/task_class.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

using FivePoseTask = std::array<Pose, 5>;

using TaskClass = TaskClassOf<FivePoseTask>;

/// Tasks with finitely many dyads.
const std::vector<TaskClass>& random_task_classes();
/// Tasks that must be named degenerate, or lose dyads to infinity.
const std::vector<TaskClass>& degenerate_task_classes();
/// A class of either list by name; nullptr if there is none.
const TaskClass* find_task_class(std::string_view name);

}  // namespace burmester::planar
