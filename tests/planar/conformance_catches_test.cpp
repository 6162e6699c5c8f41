#include <gtest/gtest.h>

#include "burmester/planar/family.hpp"
#include "caught.hpp"

namespace burmester::planar {

TEST(PlanarConformance, CatchesEveryWrongRowAndFormEntry) { expect_flips_caught<RR>(); }

}  // namespace burmester::planar
