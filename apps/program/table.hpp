// Answers for the terminal: aligned tables, 6 significant digits, fewer where 100 columns ask for it.
#pragma once

#include <string>

#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/record.hpp"

namespace burmester {

/// Coordinates below 1e-9 of `task_size` are shown as 0.
std::string answer_text(const Problem& problem, const Synthesis& answer, double task_size);

}  // namespace burmester
