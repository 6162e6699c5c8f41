// Five poses: all dyads of all types in one solve, as points of the null space of the anchored equations.
//
// Steps: anchor in the closest pair; 4 x 7 rows; null space (complete pivoting); the two relations as conics in
// the P^2 of the null space; their common points by a degenerate member of the pencil; one Newton step on the
// relations. No allocation. The rows, the elimination and the conics are rational in the exact data of the poses
// and are templates on the number type; the rest needs square and cube roots (double, Quad).
#pragma once

#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/planar/anchored_basis.hpp"

namespace burmester::planar {

/// What the five poses turned out to be. Everything but `regular` and `two_orientations` is a degeneracy that a
/// caller must name; the roots listed with it are the isolated dyads.
enum class FivePoseCase {
  regular,            ///< four dyads over the complex numbers
  equal_poses,        ///< two poses coincide: in effect four poses, a curve of dyads
  all_parallel,       ///< one orientation: no finite dyad but the double slider PP
  translation,        ///< one orientation, and the origins lie on a circle or line: every point is a moving pivot
  four_parallel,      ///< four orientations equal, one not: no finite dyad
  two_orientations,   ///< orientations 3 + 2: two of the four roots are the pair of orientations, two are dyads
  rotation,           ///< rank below four otherwise: rotations about one point, a surface of dyads
  common_line,        ///< a one-parameter family of dyads (Cardan motion: PR dyads) and at most one other
  whole_conic,        ///< a one-parameter family of dyads
  common_vertex       ///< one dyad of multiplicity four
};

template <class T>
struct FivePoseRoots {
  FivePoseCase what = FivePoseCase::regular;
  Anchor anchor;
  int count = 0;                        ///< real roots listed
  std::array<Anchored<T>, 4> w;         ///< the roots
  std::array<T, 4> separation;          ///< relative squared distance to merging with another root; 0: double root
  Anchored<T> family;                   ///< common_line: a member of the family
  double smallest_pivot = 0;            ///< of the elimination; below rank_tolerance the rank counts as deficient
  double pencil_size = 0;               ///< largest coefficient of the pencil's cubic; below pencil_tolerance: degenerate
};

/// The entries of the rows carry relative errors of a few unit roundoffs (the data are doubles), complete pivoting
/// on 4 x 7 entries of order 1 lets them grow by less than 2^5 in practice; 2^9 roundoffs leave a margin of 4.
/// Checked against the distribution over random tasks (docs/robustness.md).
inline constexpr double rank_tolerance = 0x1p-44;
/// The cubic of the pencil has degree 3 in conics of size 1 whose coefficients carry the errors above.
inline constexpr double pencil_tolerance = 0x1p-42;
/// Two equal angles, sine and cosine each rounded once, may differ by this much in X3 X4' - X4 X3'.
inline constexpr double same_orientation_tolerance = 0x1p-52;

FivePoseRoots<double> five_pose_roots(FivePoses poses);

}  // namespace burmester::planar
