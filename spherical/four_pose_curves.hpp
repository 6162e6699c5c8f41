// Four orientations: every dyad that meets them, one for each axis of the circle-point cone.
//
// An axis a of the body whose four places lie on a circular cone is a circle axis, the cone's axis b a centre axis.
// Each rotation from one pose gives one bilinear equation (equal_angles.hpp); three of them leave a cubic cone for a in
// E and one for b in S, paired axis by axis (B. Roth, "On the screw axes and other special lines associated with
// spatial displacements of a rigid body", 1967; D. A. Ruth, J. M. McCarthy, "The design of spherical 4R linkages for
// four specified orientations", 1999; equations 9 and 10 of J. Angeles, S. Bai, "A robust solution of the spherical
// Burmester problem"). The axes of the six relative rotations lie on them, and the sliders (sliders.hpp). Topology and
// errors are proved for the doubles given, a rotation that two pairs share within rounding made one (docs/curves.md).
#pragma once

#include <span>

#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/spherical/five_pose_solver.hpp"
#include "burmester/spherical/sliders.hpp"

namespace burmester::spherical {

using burmester::FourPoseCurves;

/// Radians on the unit sphere.
struct CurveOptions {
  double tolerance = 1e-4;  ///< largest error of a piece
  double longest = 0.1;     ///< longest chord
};

/// Unit vectors. Each branch is one closed piece where all of it is proved; one that runs through opposite directions
/// shows both. Precondition: finite numbers, no quaternion zero.
FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options = {});

struct FourPoseSolver {
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* name = "four orientations, cones";
  static constexpr const char* answers =
      "circle-point and centre-point cones with proved topology and error; the up to six sliders on them, proved "
      "complete";
  SphericalReport solve(std::span<const Pose> poses) const;
};

}  // namespace burmester::spherical
