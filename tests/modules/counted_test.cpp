#include "burmester/modules/framework/counted.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace burmester {
namespace {

TEST(Counted, OneIsSingularAllOthersArePlural) {
  EXPECT_EQ(counted(0, "real dyad"), "0 real dyads");
  EXPECT_EQ(counted(1, "real dyad"), "1 real dyad");
  EXPECT_EQ(counted(std::size_t{2}, "slider"), "2 sliders");
}

}  // namespace
}  // namespace burmester
