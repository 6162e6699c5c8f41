// Five orientations over rationals: every real dyad, found and enclosed by elimination alone (five_pose_sextic.hpp).
//
// Needs no approximate solution, so nothing can be missed: the real roots of the sextic are isolated exactly, and each
// is narrowed until both axes are known far beyond doubles. About a millisecond.
#pragma once

#include <optional>
#include <vector>

#include "burmester/geometry/rational_interval.hpp"
#include "burmester/spherical/five_pose_sextic.hpp"

namespace burmester::spherical {

/// A real dyad: directions of its axes, of any length, each coordinate within 2^-60 of the largest.
struct EnclosedAxes {
  Vector<RationalInterval, 3> moving, fixed;  ///< in E, and in S seen from the reference pose
  int multiplicity = 1;                       ///< of the solution of the equations
};

/// All different real solutions of the equations; nothing where there are infinitely many (a chart that hides two
/// solutions behind each other is replaced by another).
std::optional<std::vector<EnclosedAxes>> exact_axes(const Bilinear<Rational>& equations);

}  // namespace burmester::spherical
