// A static figure, SVG: the constraint surfaces of a linkage in the image space.
#pragma once

#include <string>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// `task`: the problem's name, may be empty.
std::string surfaces_figure(const SurfaceDrawing& surfaces, const std::string& task);

}  // namespace burmester
