#include "burmester/modules/dyads/dyad_name.hpp"

#include <gtest/gtest.h>

#include <set>

namespace burmester {

TEST(DyadName, RanksFollowTheOrderOfResults) {
  EXPECT_EQ(type_rank("RR"), 0);
  EXPECT_EQ(type_rank("PR"), 1);
  EXPECT_EQ(type_rank("RP"), 2);
  EXPECT_EQ(type_rank("PP"), 3);
  EXPECT_EQ(type_rank("SS"), 4);
  EXPECT_EQ(type_rank(""), 4);
}

TEST(DyadName, ReadsFromTheFixedToTheMovingBody) {
  EXPECT_EQ(fixed_joint("PR"), Joint::prismatic);
  EXPECT_EQ(moving_joint("PR"), Joint::revolute);
  EXPECT_EQ(fixed_joint("RP"), Joint::revolute);
  EXPECT_EQ(moving_joint("RP"), Joint::prismatic);
}

TEST(DyadName, InverseReadsBackwards) {
  EXPECT_EQ(inverse_type("RR"), "RR");
  EXPECT_EQ(inverse_type("PR"), "RP");
  EXPECT_EQ(inverse_type("RP"), "PR");
  EXPECT_EQ(inverse_type("PP"), "PP");
  for (const auto type : dyad_names) EXPECT_EQ(fixed_joint(type), moving_joint(inverse_type(type)));
}

struct Pairing {
  const char *first, *second, *linkage;
};
constexpr Pairing pairings[] = {{"RR", "RR", "RRRR"}, {"RR", "PR", "RRRP"}, {"RR", "RP", "RRPR"},
                                {"RR", "PP", "RRPP"}, {"PR", "PR", "PRRP"}, {"PR", "RP", "PRPR"},
                                {"PR", "PP", "PRPP"}, {"RP", "RP", "RPPR"}, {"RP", "PP", "RPPP"}};

TEST(DyadName, NineLinkageTypesInEitherOrder) {
  std::set<std::string> seen;
  for (const auto& [first, second, linkage] : pairings) {
    EXPECT_TRUE(pairs(first, second) && pairs(second, first)) << linkage;
    EXPECT_EQ(linkage_type(first, second), linkage);
    EXPECT_EQ(linkage_type(second, first), linkage);
    seen.insert(linkage);
  }
  EXPECT_EQ(seen.size(), 9u);
}

TEST(DyadName, TwoTranslatorsMakeNoLinkage) {
  EXPECT_FALSE(pairs("PP", "PP"));
  EXPECT_FALSE(pairs("RR", "SS"));
  EXPECT_FALSE(pairs("", "RR"));
}

}  // namespace burmester
