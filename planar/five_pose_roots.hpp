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
/// caller must name; the roots listed with it are the isolated dyads. Those before `rotation` are told by equal
/// orientations, the others by size (`degenerate_within_rounding` uses the order).
enum class FivePoseCase {
  regular,            ///< four dyads over the complex numbers
  equal_poses,        ///< two poses coincide: in effect four poses, a curve of dyads
  all_parallel,       ///< one orientation: no finite dyad but the double slider PP
  translation,        ///< one orientation, and the origins lie on a circle or line: every point is a moving pivot
  four_parallel,      ///< four orientations equal, one not: no finite dyad
  two_orientations,   ///< orientations 3 + 2: two of the four roots are the pair of orientations, two are dyads
  two_orientations_in_line,  ///< the same, and the three origins lie on a line: no finite dyad
  rotation,           ///< rotations about one point: a surface of dyads
  rank_deficient,     ///< rank below four otherwise
  common_line,        ///< a one-parameter family of dyads (Cardan motion: PR dyads) and at most one other
  whole_conic,        ///< a one-parameter family of dyads: the two conditions coincide
  empty_conic,        ///< the same, but no real point of the conic is a dyad
  common_vertex       ///< four dyads that coincide within rounding
};

template <class T>
struct FivePoseRoots {
  FivePoseCase what = FivePoseCase::regular;
  Anchor anchor;
  bool indistinct = false;              ///< AnchorChoice::indistinct
  int count = 0;                        ///< real roots listed
  std::array<Anchored<T>, 4> w;         ///< the roots
  Anchored<T> family;                   ///< common_line: a member of the family
  double smallest_pivot = 0;            ///< of the elimination, relative to the largest
  double pencil_size = 0;               ///< largest coefficient of the pencil's cubic; 0: a degenerate pencil
  double discriminant = 0;              ///< of that cubic (3 + 2: of the line pair), relative: 0 where two coincide
  double rounding = 0;                  ///< below this |discriminant| the count may be off by two
};

/// A pivot, or the pencil's cubic, counts as zero when it is below what rounding the data once can make of zero:
/// AnchorChoice::noise over the pivot that amplifies it, times this factor for the additions in between. In 100,000
/// tasks of each class the quotient was at most 150 for degenerate and at least 74,000 for the other tasks.
inline constexpr double noise_factor = 2048;

FivePoseRoots<double> five_pose_roots(FivePoses poses);

}  // namespace burmester::planar
