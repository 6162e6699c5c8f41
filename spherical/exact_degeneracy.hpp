// Five orientations with infinitely many dyads: why, proved over rationals of the doubles as they are, and the dyad
// that is in none of the families.
#pragma once

#include <optional>

#include "burmester/spherical/exact_axes.hpp"

namespace burmester::spherical {

enum class Degeneracy {
  none,                ///< nothing proved
  equal_orientations,  ///< two orientations are equal: in effect four, curves of dyads
  one_axis,            ///< all rotate about one axis: every axis with that one
  rank_deficient,      ///< the four conditions on b (x) a are dependent
  moving_on_circle,    ///< a moving axis takes only two places: the fixed axes with it are a great circle
  fixed_on_circle,     ///< the same seen from the body
  both_on_circles      ///< both: three orientations about one axis, the other two with that axis turned over
};

struct ExactDegeneracy {
  Degeneracy kind = Degeneracy::none;    ///< the first in the order above that is proved
  std::optional<EnclosedAxes> isolated;  ///< the only real dyad that is in no family, seen from the first pose
};

/// Of five orientations.
ExactDegeneracy exact_degeneracy(FivePoses poses);

}  // namespace burmester::spherical
