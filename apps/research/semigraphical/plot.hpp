// The contour plots of the semigraphical method, SVG: longitude to the right, latitude up, degrees.
#pragma once

#include <string>
#include <vector>

#include "burmester/modules/framework/record.hpp"
#include "burmester/spherical/semigraphical.hpp"

namespace burmester {

/// The zero curves of the four minors, every crossing of two of them, those rejected crossed out, and the axes of the
/// algebraic answer as numbered rings. `moving`: the plot of the moving axes, otherwise that of the fixed ones.
/// `task`: the problem's name, may be empty.
std::string semigraphical_plot(const spherical::AxisPlot& plot, bool moving, const std::vector<DyadRecord>& algebraic,
                               const std::string& task);

}  // namespace burmester
