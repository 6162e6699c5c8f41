// Static figures of the sphere, SVG: the views of one drawing on one sheet, with a legend.
//
// The hidden half is dashed and faint. Task attitudes are amber, the coupler and its attitudes red, the links in the
// colours of their dyads; the linkage in pose 1 is strong, in the other poses thin. An attitude is a dot where the
// moving x axis pierces the sphere, a full arrowhead towards the y axis, an open one towards the z axis.
#pragma once

#include <string>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// `task`: the problem's name, may be empty.
std::string sphere_figure(const SphereDrawing& drawing, const std::string& task);

}  // namespace burmester
