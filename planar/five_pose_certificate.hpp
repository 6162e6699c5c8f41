// The five-pose answer proved: every dyad in its box, and no others (docs/certificates.md has the proof).
//
// Intervals first: the rows, the null space and the two conics of the anchored equations enclose those of the exact
// data; Krawczyk's test gives a box for each root, and the number of real common points of the conics follows from the
// inertia of one 3 x 3 matrix (geometry/conic_count.hpp). Where intervals cannot decide, the same formulas run over
// rationals; the number of real dyads is then exact whatever the fast solver found. Where that was wrong, or its roots
// cannot be enclosed, the roots of quad precision are taken, enclosed with rational intervals if need be.
#pragma once

#include <array>

#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/modules/framework/certificate.hpp"
#include "burmester/planar/dyads.hpp"
#include "burmester/planar/five_pose_roots.hpp"

namespace burmester::planar {

/// Where a dyad provably is, as an RR: pivots seen from the reference pose's origin (moving: directions of E, fixed:
/// directions of S) and the distance between them, length units of the poses. Ends may be infinite: a pivot that may
/// be at infinity.
struct DyadBox {
  std::array<Range, 2> moving, fixed;
  Range length;
  Rung rung = Rung::none;  ///< none: no box could be proved
};

struct CertifiedRoots {
  FivePoseRoots<double> roots;   ///< the roots to be listed: corrected where the fast solver's count was wrong
  std::array<DyadBox, 4> boxes;  ///< box of root i
  std::array<Anchored<Quad>, 4> quad;  ///< sharp: root i in quad precision
  int count = -1;                ///< the proved number of real dyads; -1: not proved
  Rung count_rung = Rung::none;  ///< what proved it
  bool complete = false;         ///< count is proved, and so many disjoint boxes are
  bool sharp = false;            ///< the boxes are smaller than the rounding of the numbers shown
  bool degenerate = false;       ///< proved: the doubles are degenerate as roots.what says; boxes of all that is listed
};

/// For any five poses. Of degenerate ones the kind is proved, or else the number of real dyads of the doubles, if that
/// is finite; two_orientations are proved like regular poses.
CertifiedRoots certified_five_pose_roots(FivePoses poses);

/// The same dyads from roots of quad precision and exact values of the equations: the boxes are then smaller than the
/// rounding of what is shown. False, and nothing changed, where there is no complete answer to start from.
bool sharpen(FivePoses poses, CertifiedRoots& certified);

/// How far what `shown` states (pivots, length, line as in results; length units and radians, all together as one
/// Euclidean distance) can be from the truth, given that the dyad is in the box. The line of a slider stands for the
/// true places of its pivot: its angle is off by at most what their distances from the line allow over their spread.
/// Infinite where the box does not say. For any number of poses.
double error_bound(const Dyads::Design& shown, const DyadBox& box, std::span<const Pose> poses, const Pose& reference);

/// The interval rung alone: 0, 2 or 4 real dyads, -1 where intervals cannot tell. For tests and benchmarks.
int count_by_intervals(FivePoses poses);
/// The exact rung alone, -1 where two dyads coincide exactly or the poses are degenerate.
int count_exactly(FivePoses poses);

}  // namespace burmester::planar
