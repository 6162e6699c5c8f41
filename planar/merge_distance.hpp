// How far five poses are from poses where two of their dyads coincide: as one number, relative to the data.
//
// Two dyads coincide where a discriminant D of the data is zero. With data x_i and their scales s_i (the largest
// absolute coordinate for x and y, the norm of its image point for X3 and X4),
//     d = |D| / sum_i |dD/dx_i| s_i
// is to first order the least d such that some change of every x_i by at most d s_i makes two dyads coincide (Hoelder's
// inequality: the sum is the dual of the maximum norm); as d is at most 1e-13 where it is stated, first order is
// enough. D cancels there and the derivatives must not: quad precision, forward differentiation (geometry/jet.hpp).
//
// D is the discriminant of det(s A + t B), A and B the conics of the five-pose equations. Five poses with two
// orientations (3 + 2) have two dyads only while they keep them: the moving pivot's circle has the circumradius R of
// the three parallel origins, the other two are seen to be on it from two places where they are less than 2 R apart.
// There D = |a|^2 |b|^2 |a - b|^2 - |t|^2 (a x b)^2, a and b the sides of the triple from one origin,
// t the step of the pair.
#pragma once

#include <optional>

#include "burmester/planar/five_pose_roots.hpp"

namespace burmester::planar {

struct MergeDistance {
  double distance = 0;
  bool appear = false;  ///< the two dyads that coincide there are complex now: two more would appear
};

/// Precondition: `what` is regular or two_orientations, with `count` real dyads. Nothing where D is stationary.
std::optional<MergeDistance> merge_distance(FivePoseCase what, FivePoses poses, const Anchor& anchor, int count);

/// Around poses with infinitely many dyads, or none at all, D changes by its own size over the distance from them, so
/// that d is a fraction of it. Poses of the degenerate task classes, rounded once, have d <= 0.16 units of 2^-53.
inline constexpr double largest_degenerate = unit_roundoff / 4;

/// Whether poses that five_pose_roots() names degenerate are within rounding of such: sizes alone call clusters of
/// close poses (3 + 2, 2 + 2 + 1, ..) degenerate that are far from it. True of those told by equal orientations.
bool degenerate_within_rounding(FivePoseCase what, FivePoses poses, const Anchor& anchor);

/// Of the data: below this distance two dyads nearly merge, and the report warns.
inline constexpr double near_merging = 100 * unit_roundoff;

}  // namespace burmester::planar
