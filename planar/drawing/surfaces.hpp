// What the constraint surfaces of a linkage look like: wireframes in the chart X4 = 1 of the image space, at a slant.
//
// E is turned so that the middle orientation of the task is X3 = 0 (drawing/chart.hpp). The level lines of a surface
// are the poses of one orientation, its straight lines those of one place of a joint: generators
// (constraint_manifold.hpp). Poses turned by more than 150 degrees from the middle are out of the picture.
#pragma once

#include <array>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/planar/drawing/motion.hpp"
#include "burmester/planar/drawing/sketch.hpp"

namespace burmester::planar {

/// Poses and designs on the stage. Empty lines where no pose is in the picture.
SurfaceDrawing draw_surfaces(int linkage, const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& poses,
                             const std::vector<Stretch>& motion);

}  // namespace burmester::planar
