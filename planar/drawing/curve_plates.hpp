// Plates for four poses: the two curves with the poles and one linkage,
// the curves of the dyad form mode by mode, and its compatibility linkage.
#pragma once

#include <span>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/modules/framework/record.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

/// The first without a linkage where there is no candidate; the others only where the dyad form has curves.
std::vector<Plate> four_pose_plates(std::span<const Pose, 4> poses, const std::vector<CurveRecord>& curves,
                                    const std::vector<CandidateRecord>& candidates);

}  // namespace burmester::planar
