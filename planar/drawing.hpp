// Drawings of planar linkages: parts, snapshots at the task poses, sampled motions through them. Where to look:
//   drawing/stage.hpp    the frame and the unit that a linkage is drawn in, so that far origins draw well
//   drawing/chart.hpp    the image space as motions are walked in it, so that small turns draw well
//   drawing/motion.hpp   walks through the task poses, resampled into frames
//   drawing/sketch.hpp   what the parts of each dyad type look like
//   drawing/surfaces.hpp the constraint surfaces of a linkage in the image space
//   drawing/construction.hpp   three poses and given fixed pivots: the constructions by inversion and by poles
// Everything here is for the eye: a motion is a sample of a curve, and no verdict follows from it.
#pragma once

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/record.hpp"

namespace burmester::planar {

/// The poses, and every linkage of the answer whose two dyads are listed in it. Labels: A0, A of a linkage's first
/// dyad, B0, B of its second. A pose that a linkage meets only nearly (best fits) is drawn where the linkage comes
/// nearest. Poses as PoseData: x, y, X3, X4.
Drawing draw_synthesis(const Problem& problem, const Synthesis& answer);

}  // namespace burmester::planar
