#include "burmester/modules/framework/conformance.hpp"

#include "burmester/spherical/family.hpp"

BURMESTER_SPACE_CONFORMANCE(burmester::spherical::Space);
BURMESTER_DYAD_CONFORMANCE(burmester::spherical::Dyads);
