// Infinitely many pairs of axes that meet four bilinear equations: proved over rationals, and those in no family.
//
// a^T N_j b' = 0, j = 1 .. 4, as in five_pose_sextic.hpp: the moving axes are the common points of the four cubics, the
// minors of M(a) with the rows a^T N_j. There is a curve of solutions exactly where the cubics have a common factor G,
// seen from one body or from the other; they are G times forms h_j, which have finitely many common points. A solution
// in no family has a moving axis with h_j(a) = 0, G(a) not 0, and one partner. docs/certificates.md has the proofs.
#pragma once

#include <optional>
#include <vector>

#include "burmester/spherical/exact_axes.hpp"

namespace burmester::spherical {

struct AxesFamily {
  /// Degrees of the cones that the axes of the families fill: 0 single axes, 1 a plane, 2, 3, 4 every axis.
  int moving = 0, fixed = 0;
  /// All different real solutions in no family, seen from the reference pose; multiplicities are not told. Nothing: not
  /// decided.
  std::optional<std::vector<EnclosedAxes>> isolated;
};

/// Nothing where there are finitely many, or no real curve is proved.
std::optional<AxesFamily> axes_family(const Bilinear<Rational>& equations);

}  // namespace burmester::spherical
