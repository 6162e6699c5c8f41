// Plates as static figures, SVG.
#pragma once

#include <string>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// `task`: the problem's name, may be empty; `unit`: of lengths, for the scale bar.
std::string plate_figure(const Plate& plate, const std::string& task, const std::string& unit);

}  // namespace burmester
