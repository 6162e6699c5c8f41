// The stage: the frame and the unit in which a linkage is drawn. Its origin is the centroid of the pose origins, its
// unit the radius of the view: of the circle about the centroid that holds the pose origins and the pivots in all
// task poses, pivots left out that lie absurdly far away (those of dyads that are almost sliders).
#pragma once

#include <vector>

#include "burmester/planar/family.hpp"

namespace burmester::planar {

struct Stage {
  Vector2 centre{0, 0};  ///< in S
  double unit = 1;       ///< length units

  Pose pose(const Pose& p) const { return {(p.x - centre[0]) / unit, (p.y - centre[1]) / unit, p.X3, p.X4}; }
  Family::Design design(const Family::Design& d) const;
  Vector2 in_problem(const Vector2& p) const { return centre + unit * p; }
};

/// A pivot is too far where it is this many times farther than the size of the task and than the linkage's own size:
/// the longest link, or the distance of the nearer dyad's farther pivot if that is less.
inline constexpr double too_far = 20;

/// Precondition: at least one pose.
Stage stage_of(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b);

/// Pivots of a design in the plane that carries them; empty where there is none.
const Vector2* fixed_pivot(const Family::Design& design);
const Vector2* moving_pivot(const Family::Design& design);

}  // namespace burmester::planar
