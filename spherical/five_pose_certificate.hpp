// The five-orientation answer proved: every dyad in its box, and no others (docs/certificates.md has the proof).
//
// Intervals first: the sextic of five_pose_sextic.hpp encloses that of the exact data, its real roots are as many as
// the real dyads where all are proved simple, and Krawczyk's test gives a box around each dyad found. Where intervals
// cannot decide, where they are too wide, or where the dyads found are not as many as are proved to exist, all is done
// over rationals (exact_axes.hpp), which needs nothing of what was found. Where that ends in infinitely many dyads,
// their kind is proved (exact_degeneracy.hpp).
#pragma once

#include <array>
#include <span>

#include "burmester/geometry/range.hpp"
#include "burmester/modules/framework/certificate.hpp"
#include "burmester/spherical/dyads.hpp"
#include "burmester/spherical/exact_axes.hpp"
#include "burmester/spherical/exact_degeneracy.hpp"

namespace burmester::spherical {

/// A dyad without its arc: directions of any length but zero.
struct AxisPair {
  Axis moving, fixed;  ///< in E, in S
};

/// Where a dyad provably is: homogeneous coordinates of its axes.
struct AxesBox {
  std::array<Range, 3> moving, fixed;  ///< in E, and in S seen from the reference pose
  int multiplicity = 1;                ///< so many dyads over the complex numbers coincide here
  Rung rung = Rung::none;              ///< none: no box could be proved
};

struct CertifiedAxes {
  int reference = 0;             ///< the pose that boxes are seen from
  std::array<AxisPair, 6> axes;  ///< the dyads to be listed: those found, or all that elimination gives; unit vectors
  std::array<AxesBox, 6> boxes;  ///< box of dyad i
  int count = -1;                ///< the proved number of different real dyads; -1: not proved, or infinite
  Rung count_rung = Rung::none;  ///< what proved it
  bool complete = false;         ///< count is proved, and so many disjoint boxes are
  Degeneracy degeneracy = Degeneracy::none;  ///< proved: infinitely many dyads, why
  int isolated = 0;                          ///< beside these so many, the first of `axes`; all there are, proved
};

/// For any five orientations. `found`: approximations of the real dyads, of any origin, in any order; they save time,
/// but the answer does not depend on them.
CertifiedAxes certified_axes(FivePoses poses, std::span<const AxisPair> found);

/// The same of all that elimination gave (exact_axes.hpp), seen from the reference pose with that number.
CertifiedAxes certified_axes(std::span<const EnclosedAxes> all, const Pose& reference, int number);

/// How far what `shown` states can be from the truth, given that the dyad is in the box: the angles between the axes
/// shown and the true ones and the error of the arc, radians, all together as one Euclidean distance (coordinates are
/// then off by no more). Infinite where the box does not say.
double error_bound(const Dyads::Design& shown, const AxesBox& box, const Pose& reference);

/// The interval rung alone: the number of real dyads, -1 where intervals cannot tell. For tests and benchmarks.
int count_by_intervals(FivePoses poses);
/// The exact rung alone, -1 where it does not decide (exact_axes.hpp).
int count_exactly(FivePoses poses);

}  // namespace burmester::spherical
