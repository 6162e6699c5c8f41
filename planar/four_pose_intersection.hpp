// Five poses as two times four: the dyads of poses 1, 2, 3, 4 and of 1, 2, 3, 5 are two circle-point curves, and what
// they have in common are the dyads of all five (L. Burmester, 1888). An oracle: exact, slow, and by another way than
// the direct solver.
//
// Two cubics F and G meet in nine points. Both pass through the circular points at infinity and through the places in
// pose 1 of the poles P12, P13 and P23, where poses 1, 2 and 3 alone leave no single centre; four points remain.
// Eliminating y,
//     R(x) = det B(x),   B the Bezout matrix of F and G as polynomials in y,
// of degree seven as the circular points lie at infinity; R over the three linear factors of the poles is the quartic
// of Burmester's four points, and (1, y, y^2) spans the kernel of B at a root. All in rational numbers, the doubles
// of the poses as they stand; only the roots are rounded, to 160 bits.
#pragma once

#include <string>
#include <vector>

#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/space.hpp"

namespace burmester::planar {

struct CommonDyad {
  Vector2 moving, fixed;  ///< in E, in S; rounded once from 160 bits and more
  /// Distance of the centres that the two curves give it, in task sizes: 0 but for the 160 bits.
  double centre_gap = 0;
};

struct CommonDyads {
  std::string reason;  ///< why there is no answer: the curves have a part in common, or touch; empty otherwise
  std::vector<CommonDyad> dyads;
};

/// All RR dyads of five poses, in the order of their x in pose 1. Preconditions as for FivePoseSolver, and no slider
/// among the dyads: a PR dyad would show as a centre some 1e40 away.
CommonDyads intersected_four_pose_curves(FivePoses poses);

}  // namespace burmester::planar
