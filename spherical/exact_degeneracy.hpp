// Five orientations with infinitely many dyads: why, proved over rationals of the doubles as they are, and the dyad
// that is in none of the families.
#pragma once

#include <optional>

#include "burmester/spherical/degeneracy.hpp"
#include "burmester/spherical/exact_axes.hpp"

namespace burmester::spherical {

struct ExactDegeneracy {
  Degeneracy kind = Degeneracy::none;    ///< the first in the order above that is proved
  std::optional<EnclosedAxes> isolated;  ///< the only real dyad that is in no family, seen from the first pose
};

/// Of five orientations.
ExactDegeneracy exact_degeneracy(FivePoses poses);

}  // namespace burmester::spherical
