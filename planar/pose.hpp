// A planar pose: the moving frame E placed in the fixed frame S, P_S = R(angle) p_E + (x, y).
#pragma once

namespace burmester::planar {

/// The exact data of a pose: four doubles. X3 : X4 = sin(angle/2) : cos(angle/2); the norm need not be 1, and
/// solvers, certificates and oracles all read these doubles as exact numbers.
struct Pose {
  double x = 0, y = 0;    ///< origin of E in S, length units
  double X3 = 0, X4 = 1;  ///< half angle; not both zero
};

/// Pose from an angle in radians; X3 and X4 are each rounded once.
Pose pose_from_radians(double x, double y, double angle);
/// Pose from an angle in degrees, reduced exactly first: 180 deg gives X4 = 0, not 6e-17.
Pose pose_from_degrees(double x, double y, double angle);
/// The pose of an arrow drawn on the body, from the origin of E along its x axis, by tail and tip in S: the angle in
/// all four quadrants, without a trigonometric function. Precondition: they differ.
Pose pose_from_arrow(double tail_x, double tail_y, double tip_x, double tip_y);
/// Angle in radians, in (-pi, pi].
double angle_of(const Pose& pose);

}  // namespace burmester::planar
