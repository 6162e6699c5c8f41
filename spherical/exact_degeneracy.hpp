// Five orientations with infinitely many dyads: why, proved over rationals of the doubles as they are.
#pragma once

#include "burmester/spherical/five_pose_sextic.hpp"

namespace burmester::spherical {

enum class Degeneracy {
  none,                ///< nothing proved
  equal_orientations,  ///< two orientations are equal: in effect four, curves of dyads
  one_axis,            ///< all rotate about one axis: every axis with that one
  rank_deficient,      ///< the four conditions on b (x) a are dependent
  moving_on_circle,    ///< a moving axis takes only two places: the fixed axes with it are a great circle
  fixed_on_circle      ///< the same seen from the body
};

/// Of five orientations; the first kind in the order above that is proved.
Degeneracy exact_degeneracy(FivePoses poses);

}  // namespace burmester::spherical
