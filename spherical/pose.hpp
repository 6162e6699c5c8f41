// A spherical pose: the moving frame E turned against the fixed frame S about their common origin.
// p_S = Q p_E.
#pragma once

#include <array>
#include <span>

namespace burmester::spherical {

/// The exact data of a pose: the four doubles of a quaternion. Its norm may be any; solvers, certificates and
/// oracles all read these doubles as exact numbers, up to a factor (Space::point, spherical/space.hpp).
/// (w, x, y, z) and (-w, -x, -y, -z) are the same pose.
struct Pose {
  double w = 1, x = 0, y = 0, z = 0;  ///< not all zero
};

using FourPoses = std::span<const Pose, 4>;
using FivePoses = std::span<const Pose, 5>;

/// Rotation about `axis` (any length but zero) by an angle in radians.
Pose pose_from_axis_radians(const std::array<double, 3>& axis, double angle);
/// The same in degrees, reduced exactly first: 180 deg gives w = 0, not 6e-17.
Pose pose_from_axis_degrees(const std::array<double, 3>& axis, double angle);

/// Q = Rz(longitude) Ry(-latitude) Rx(roll): the moving x-axis points to that place on the globe.
Pose pose_from_globe_radians(double longitude, double latitude, double roll);
Pose pose_from_globe_degrees(double longitude, double latitude, double roll);

/// Q given by rows; a rotation near it if it is orthogonal but for rounding.
/// Precondition: the determinant is positive.
Pose pose_from_matrix(const std::array<std::array<double, 3>, 3>& rows);

/// Unit axis and angle in [0, pi] radians. The axis of the identity is (0, 0, 1).
struct AxisAngle {
  std::array<double, 3> axis;
  double angle;
};
AxisAngle axis_angle_of(const Pose& pose);

}  // namespace burmester::spherical
