// Planar poses wrapped onto a sphere that touches the plane at the z axis: as the sphere grows, the planar problem.
// Turning the plane by half a turn about that point is the same as changing the sign of the curvature, so whatever
// has a limit differs from it by a power series in the square of the curvature.
#pragma once

#include <cmath>

#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// The pose with origin (x, y) and this angle (radians): turned about z, then shifted along the great circle in the
/// direction of (x, y) by as much as it is away. Curvature: 1 / radius, of the unit that x and y have; not zero.
inline Pose wrapped_pose(double x, double y, double angle, double curvature) {
  const double away = std::hypot(x, y), half = curvature * away / 2, s = away > 0 ? std::sin(half) / away : 0;
  return Space::pose(
      Space::product<double>({std::cos(half), -y * s, x * s, 0}, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}));
}

/// Where the axis meets the tangent plane (gnomonic projection); infinite for axes parallel to it.
inline Vector<double, 2> in_tangent_plane(const Axis& axis, double curvature) {
  return axis.head<2>() / (axis[2] * curvature);
}
/// The axis through that point.
inline Axis axis_through(const Vector<double, 2>& p, double curvature) {
  return Axis(curvature * p[0], curvature * p[1], 1).normalized();
}

}  // namespace burmester::spherical
