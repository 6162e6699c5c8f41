// Drawings of spherical answers on the unit sphere. Where to look:
//   drawing/arcs.hpp     great-circle arcs, circles, attitudes and blocks as polylines of the sphere
//   drawing/sketch.hpp   a linkage in one pose, and the paths of its motion
//   drawing/views.hpp    from where a linkage is looked at
// Everything here is for the eye: a path is a sample of a curve, and no verdict follows from it.
#pragma once

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/record.hpp"

namespace burmester::spherical {

/// First the task with the curves of the answer, then every linkage whose two dyads are listed in the answer. Labels:
/// A0, A of a linkage's first dyad, B0, B of its second. Of the two opposite points of each axis the drawing takes
/// those that make the linkage compact. A pose that a linkage meets only nearly (best fits) is drawn where the linkage
/// comes nearest; the task attitude stays where it was asked for. Poses as PoseData: w, x, y, z.
Drawing draw_synthesis(const Problem& problem, const Synthesis& answer);

}  // namespace burmester::spherical
