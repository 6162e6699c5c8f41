// How many independent conditions poses put on the lifted form k of a dyad: the rank of their m x 8 matrix of rows
// (family.hpp). 8 - rank is the number of independent surfaces through all of them, so that for poses of a motion
//   8  none: no dyad carries it
//   7  one: a dyad's, or no dyad's
//   6  the pencil of two dyads: RRRR, RRRP, PRRR, ..
//   5  PRRP, RPPR: two sliders of one kind; the third is the RR of the ellipse motion's circle
// (M. J. D. Hayes, T. Luu, X.-W. Chang, ARK 2004.) Fewer poses than that have at most their number.
#pragma once

#include <span>

#include "burmester/geometry/vector.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

struct MotionRank {
  int rank = 0;
  Vector<double, 8> singular_values;  ///< descending, of the rows of poses seen from their centroid in task sizes
};

/// Rank after changes of the poses by `errors` at most, in task sizes and radians: singular values below what rounding
/// and such errors can do to the matrix count as zero.
MotionRank motion_rank(std::span<const Pose> poses, double errors = 0);

}  // namespace burmester::planar
