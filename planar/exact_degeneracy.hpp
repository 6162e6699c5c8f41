// Degenerate poses proved: whether the doubles, read as exact numbers, are degenerate in the way that the fast solver
// found by tolerance. Everything over rationals; the reasons for each case are in docs/certificates.md.
#pragma once

#include <optional>
#include <vector>

#include "burmester/geometry/rational.hpp"
#include "burmester/planar/five_pose_roots.hpp"

namespace burmester::planar {

struct ExactDegeneracy {
  std::vector<Anchored<Rational>> isolated;  ///< the dyads to be listed, exactly
  Anchored<Rational> family;                 ///< common_line: a member
};

/// Nothing where the exact data are not degenerate as `what` says, or that could not be shown. Precondition: `what` is
/// neither regular nor two_orientations.
std::optional<ExactDegeneracy> exact_degeneracy(FivePoseCase what, FivePoses poses, const Anchor& anchor);

/// Poses with exactly two orientations, 3 + 2, whose three parallel origins are not in line: 0 or 2, the number of real
/// dyads; -1 where the two coincide or the poses are others.
int count_of_two_orientations(FivePoses poses);

}  // namespace burmester::planar
