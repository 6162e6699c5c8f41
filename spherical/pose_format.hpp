// Spherical poses in files, mixed as one likes:
// {"axis": [x, y, z], "angle"}, {"quaternion_wxyz": [w, x, y, z]},
// {"matrix": [[..], [..], [..]]} by rows, {"longitude", "latitude", "roll"}; CSV columns qw, qx, qy, qz.
#pragma once

#include <vector>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/spherical/pose.hpp"

namespace burmester::spherical {

/// A matrix may leave orthogonality and determinant +1 by this much, entry by entry.
inline constexpr double matrix_tolerance = 1e-6;

/// (w, x, y, z): a given quaternion unchanged, but for a power of two where squares would under- or overflow.
/// Throws InputError with the place.
PoseData read_pose(const InputNode& node, const Units& units);
/// Throws InputError without the place.
PoseData read_csv_pose(const std::vector<double>& row);

Pose pose_of(const PoseData& data);
std::vector<Pose> poses_of(const Problem& problem);

}  // namespace burmester::spherical
