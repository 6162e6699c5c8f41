// Burmester: every linkage that guides a rigid body through given poses.
//
// The front door. A problem goes in, an answer comes out, whatever the geometry:
//   burmester::Registry registry = burmester::built_in_modules();
//   burmester::Synthesis answer = registry.find("planar")->synthesize(problem);
// Those who know their geometry include <burmester/planar/...> or <burmester/spherical/...> instead.
#pragma once

#include "burmester/modules/framework/module.hpp"
#include "burmester/modules/framework/registry.hpp"

namespace burmester {

/// The modules of this package, planar and spherical: the list is built_in_modules.cpp.
Registry built_in_modules();

}  // namespace burmester
