// The planar dyad types. To add one: write its header in planar/dyads/, include it here, name it in the list
// (docs/add_a_dyad.md).
#pragma once

#include "burmester/modules/framework/dyad_type.hpp"
#include "burmester/planar/dyads/PP.hpp"
#include "burmester/planar/dyads/RR.hpp"
#include "burmester/planar/dyads/sliders.hpp"

namespace burmester::planar {

using Dyads = DyadList<RR, PR, RP, PP>;

}  // namespace burmester::planar

// A dyad type with a lifted form is one whose family is complete: nobody may see the list without it.
#include "burmester/planar/family.hpp"
