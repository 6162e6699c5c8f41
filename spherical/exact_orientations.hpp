// Equal orientations, and rotations about one axis, told over rationals of the doubles as they are.
#pragma once

#include <span>

#include "burmester/geometry/rational.hpp"
#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {

using ExactAxis = Vector<Rational, 3>;

/// Axis in E of the rotation from one pose to the other, of any length; zero where they are equal.
inline ExactAxis turn_axis(const Pose& from, const Pose& to) { return relative_rotation<Rational>(from, to).tail<3>(); }

inline bool equal_exactly(const Pose& a, const Pose& b) { return turn_axis(a, b).isZero(0); }

inline bool parallel(const ExactAxis& a, const ExactAxis& b) { return a.cross(b).isZero(0); }

/// Whether all rotations from one pose to another have one axis. Precondition: at least two poses, no two equal.
inline bool one_axis_exactly(std::span<const Pose> poses) {
  const ExactAxis axis = turn_axis(poses[0], poses[1]);
  for (const Pose& pose : poses.subspan(2))
    if (!parallel(axis, turn_axis(poses[0], pose))) return false;
  return true;
}

}  // namespace burmester::spherical
