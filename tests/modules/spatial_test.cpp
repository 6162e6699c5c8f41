// The framework does not know how many dimensions a geometry has: SE(3) and its SS dyad keep the same laws.
#include "spatial.hpp"

#include "burmester/modules/framework/conformance.hpp"

BURMESTER_SPACE_CONFORMANCE(burmester::toy::Spatial);
BURMESTER_DYAD_CONFORMANCE(burmester::DyadList<burmester::toy::SS>);
