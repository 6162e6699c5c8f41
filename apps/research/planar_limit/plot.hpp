// The picture of a planar limit, SVG: the dyads' paths in the tangent plane, and how fast they arrive.
#pragma once

#include <string>

#include "research/planar_limit/limit.hpp"

namespace burmester {

/// Left: the poses, the planar dyads in pose 1, and the paths of the spherical ones' axes in the tangent plane, in
/// units of L. Right: the distance of each from its planar dyad against e, logarithmic. `task`: the problem's name, may
/// be empty.
std::string planar_limit_plot(const PlanarLimit& limit, std::span<const planar::Pose, 5> poses,
                              const std::string& task);

/// Where the dyads that are on no path are complex, in a few words.
std::string about_others(const PlanarLimit& limit);

}  // namespace burmester
