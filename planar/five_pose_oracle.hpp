// The slow oracle of the five-pose solver: the same exact data, the same steps, 113 bits and three Newton steps.
#pragma once

#include "burmester/geometry/quad.hpp"
#include "burmester/planar/five_pose_roots.hpp"

namespace burmester::planar {

/// Precondition as for five_pose_roots; about sixty times as slow. Errors are below 1e-24 where double gives 1e-6.
FivePoseRoots<Quad> five_pose_roots_quad(FivePoses poses);
/// Of poses that are known not to be degenerate: the doubles read as exact, no size counts as zero.
FivePoseRoots<Quad> five_pose_roots_as_given(FivePoses poses);

}  // namespace burmester::planar
