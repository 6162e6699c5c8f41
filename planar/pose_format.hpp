// Planar poses in files: {"x", "y", "angle"}, [x, y, angle], and CSV columns x, y, angle_deg or angle_rad.
#pragma once

#include <vector>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

/// (x, y, X3, X4). Throws InputError with the place.
PoseData read_pose(const InputNode& node, const Units& units);
PoseData read_csv_pose(bool degrees, const std::vector<double>& row);

Pose pose_of(const PoseData& data);
std::vector<Pose> poses_of(const Problem& problem);

}  // namespace burmester::planar
