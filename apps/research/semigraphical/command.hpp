// burmester-semigraphical: five orientations by contour plots, side by side with the algebraic answer.
#pragma once

#include <string>
#include <vector>

#include "burmester/modules/framework/registry.hpp"
#include "program/console.hpp"

namespace burmester {

/// The whole program on the given arguments (without its own name). The registry has a spherical module.
int run_semigraphical(const std::vector<std::string>& arguments, const Registry& registry, Console& console);

}  // namespace burmester
