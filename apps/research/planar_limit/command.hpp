// burmester-planar-limit: five planar poses as the limit of spherical ones.
#pragma once

#include <string>
#include <vector>

#include "burmester/modules/framework/registry.hpp"
#include "program/console.hpp"

namespace burmester {

/// The whole program on the given arguments (without its own name). The registry has a planar module.
int run_planar_limit(const std::vector<std::string>& arguments, const Registry& registry, Console& console);

}  // namespace burmester
