// Static figures, SVG: the task poses, and a linkage in all of them.
#pragma once

#include <string>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// `task`: the problem's name, may be empty; `unit`: of lengths, for the scale bar.
std::string poses_figure(const Drawing& drawing, const std::string& task, const std::string& unit);
std::string linkage_figure(const LinkageDrawing& linkage, const Drawing& drawing, const std::string& task,
                           const std::string& unit);
std::string construction_figure(const Plate& construction, const std::string& task,
                                const std::string& unit);

}  // namespace burmester
