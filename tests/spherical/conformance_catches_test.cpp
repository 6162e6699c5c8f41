#include <gtest/gtest.h>

#include "burmester/spherical/family.hpp"
#include "caught.hpp"

namespace burmester::spherical {

TEST(SphericalConformance, CatchesEveryWrongRowAndFormEntry) { expect_flips_caught<RR>(); }

}  // namespace burmester::spherical
