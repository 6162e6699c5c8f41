// Polylines on the unit sphere. All points given are unit vectors; so are those that come out.
#pragma once

#include <array>
#include <vector>

#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

using SpherePoints = std::vector<std::array<double, 3>>;

/// Neighbours are at most this far apart (radians).
inline constexpr double arc_step = 0.05;
/// Arms of an attitude (radians).
inline constexpr double attitude_arm = 0.17;

/// The point at an angle from p towards q along their great circle; any great circle if they are equal or opposite.
Axis towards(const Axis& p, const Axis& q, double angle);
/// The shorter arc of the great circle from p to q, both ends included.
SpherePoints great_arc(const Axis& p, const Axis& q);
/// The circle of all points at the angle `arc` from the pole; closed, the first point is not repeated.
SpherePoints circle_about(const Axis& pole, double arc);
/// A closed rectangle about p, its longer sides along the circle about the pole.
SpherePoints block_at(const Axis& p, const Axis& pole);
/// y tip, x axis, z tip of the moving frame: the arms point from the x axis towards the other two.
SpherePoints attitude(const Pose& pose);

/// p as the fixed frame sees it.
Axis carried(const Pose& pose, const Axis& p);
std::array<double, 3> coordinates(const Axis& p);

}  // namespace burmester::spherical
