#include "burmester/modules/framework/conformance.hpp"

#include "burmester/planar/family.hpp"

BURMESTER_SPACE_CONFORMANCE(burmester::planar::Space);
BURMESTER_DYAD_CONFORMANCE(burmester::planar::Dyads);
