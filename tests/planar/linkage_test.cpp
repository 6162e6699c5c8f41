#include "burmester/planar/linkage.hpp"

#include <gtest/gtest.h>

namespace burmester::planar {
namespace {

using AnyDyad = Found<Dyads::Design>;

AnyDyad rr(Vector2 fixed, Vector2 moving, double length) {
  AnyDyad out;
  out.design = RR::Design{fixed, moving, length};
  return out;
}
/// Fixed line normal . P = offset.
AnyDyad pr(Vector2 moving, Vector2 normal, double offset) {
  AnyDyad out;
  out.design = PR::Design{moving, {normal, offset}};
  return out;
}
AnyDyad rp(Vector2 fixed, Vector2 normal, double offset) {
  AnyDyad out;
  out.design = RP::Design{fixed, {normal, offset}};
  return out;
}
AnyDyad pp() {
  AnyDyad out;
  out.design = PP::Design{0.3};
  return out;
}

LinkageRecord only(const AnyDyad& a, const AnyDyad& b) {
  const auto all = linkages_of({a, b}, 1);
  EXPECT_EQ(all.size(), 1u);
  return all.empty() ? LinkageRecord{} : all[0];
}

// ---- Grashof ----

TEST(FourBarClass, FollowsTheShortestLink) {  // 2 + 9 < 6 + 7
  EXPECT_EQ(four_bar_class(6, 2, 7, 9, 0), "crank-rocker");
  EXPECT_EQ(four_bar_class(6, 9, 7, 2, 0), "rocker-crank");
  EXPECT_EQ(four_bar_class(2, 6, 7, 9, 0), "double-crank");
  EXPECT_EQ(four_bar_class(6, 7, 2, 9, 0), "double-rocker");
}

TEST(FourBarClass, TripleRockerWhereNoLinkTurnsFully) {  // 3 + 9 > 5 + 6, whichever is the shortest
  EXPECT_EQ(four_bar_class(3, 5, 6, 9, 0), "triple-rocker");
  EXPECT_EQ(four_bar_class(5, 3, 9, 6, 0), "triple-rocker");
  EXPECT_EQ(four_bar_class(9, 6, 3, 5, 0), "triple-rocker");
  EXPECT_EQ(four_bar_class(6, 9, 5, 3, 0), "triple-rocker");
}

TEST(FourBarClass, ChangePointAtEqualSums) {
  EXPECT_EQ(four_bar_class(4, 2, 4, 2, 0), "change-point");  // parallelogram
  EXPECT_EQ(four_bar_class(2, 2, 5, 5, 0), "change-point");  // kite
  EXPECT_EQ(four_bar_class(5, 2, 6, 9, 0), "change-point");  // 2 + 9 = 5 + 6
}

TEST(FourBarClass, ToleranceIsALength) {
  EXPECT_EQ(four_bar_class(5, 2, 6, 9 + 1e-6, 1e-5), "change-point");
  EXPECT_EQ(four_bar_class(5, 2, 6, 9 + 1e-4, 1e-5), "triple-rocker");
  EXPECT_EQ(four_bar_class(5, 2, 6, 9 - 1e-4, 1e-5), "crank-rocker");
}

// ---- Links of each type ----

TEST(Linkages, FourBar) {
  const LinkageRecord l = only(rr({0, 0}, {0, 0}, 2), rr({6, 0}, {3, 4}, 7));
  EXPECT_EQ(l.type, "RRRR");
  EXPECT_EQ(l.ground, 6);
  EXPECT_EQ(l.input, 2);
  EXPECT_EQ(l.coupler, 5);
  EXPECT_EQ(l.output, 7);
  EXPECT_EQ(l.motion_class, "crank-rocker");  // 2 + 7 < 5 + 6
  EXPECT_FALSE(l.offset || l.coupler_offset);
}

TEST(Linkages, FourBarClassesDependOnTheOrderOfDyads) {
  const AnyDyad crank = rr({0, 0}, {0, 0}, 2), rocker = rr({6, 0}, {0, 7}, 9);
  EXPECT_EQ(only(crank, rocker).motion_class, "crank-rocker");
  EXPECT_EQ(only(rocker, crank).motion_class, "rocker-crank");
}

TEST(Linkages, SliderCrank) {
  const AnyDyad crank = rr({1, 1}, {0, 0}, 1), guide = pr({3, 0}, {0, 1}, 1.5);
  const LinkageRecord l = only(crank, guide);
  EXPECT_EQ(l.type, "RRRP");
  EXPECT_EQ(l.input, 1);
  EXPECT_EQ(l.coupler, 3);
  EXPECT_EQ(l.offset, 0.5);
  EXPECT_FALSE(l.ground || l.output || l.coupler_offset);
  EXPECT_EQ(l.motion_class, "slider-crank");
  const LinkageRecord exchanged = only(guide, crank);
  EXPECT_EQ(exchanged.type, "RRRP");
  EXPECT_EQ(exchanged.dyads[0], 2);
  EXPECT_EQ(exchanged.dyads[1], 1);
}

TEST(Linkages, RockerSliderWhereTheCouplerIsTooShort) {  // 1.4 < 1 + 0.5
  EXPECT_EQ(only(rr({1, 1}, {0, 0}, 1), pr({1.4, 0}, {0, 1}, 1.5)).motion_class, "rocker-slider");
  EXPECT_EQ(only(rr({1, 1}, {0, 0}, 1), pr({1.6, 0}, {0, 1}, 1.5)).motion_class, "slider-crank");
  EXPECT_EQ(only(rr({1, 1}, {0, 0}, 1), pr({1.6, 0}, {0, 1}, 0.5)).motion_class,
            "slider-crank");  // either side
}

TEST(Linkages, InvertedSliderCrank) {
  const auto link = [](double crank, double ground, double offset) {
    return only(rr({0, 0}, {0, 0}, crank), rp({ground, 0}, {0, 1}, offset));
  };
  const LinkageRecord l = link(1, 3, 0.5);
  EXPECT_EQ(l.type, "RRPR");
  EXPECT_EQ(l.ground, 3);
  EXPECT_EQ(l.input, 1);
  EXPECT_EQ(l.offset, 0.5);
  EXPECT_FALSE(l.coupler || l.output);
  EXPECT_EQ(l.motion_class, "inverted slider-crank, swinging block");
  EXPECT_EQ(link(3, 1, 0.5).motion_class, "inverted slider-crank, turning block");
  EXPECT_EQ(link(1, 1.2, 0.5).motion_class, "inverted rocker-slider");
}

TEST(Linkages, WithTwoSliders) {
  const LinkageRecord trammel = only(pr({0, 0}, {0, 1}, 0), pr({2, 0}, {1, 0}, 0));
  EXPECT_EQ(trammel.type, "PRRP");
  EXPECT_EQ(trammel.coupler, 2);
  EXPECT_EQ(trammel.motion_class, "double slider");
  const LinkageRecord oldham = only(rp({0, 0}, {0, 1}, 0), rp({0, 2}, {1, 0}, 0));
  EXPECT_EQ(oldham.type, "RPPR");
  EXPECT_EQ(oldham.ground, 2);
  EXPECT_EQ(oldham.motion_class, "double block (Oldham)");
  const LinkageRecord mixed = only(pr({0, 3}, {0, 1}, 1), rp({5, 2}, {0, 1}, 1));
  EXPECT_EQ(mixed.type, "PRPR");
  EXPECT_EQ(mixed.offset, 1);          // of (5, 2) from y = 1, on the ground
  EXPECT_EQ(mixed.coupler_offset, 2);  // of (0, 3) from y = 1, on the coupler
  EXPECT_EQ(only(rr({0, 0}, {0, 0}, 1), pp()).motion_class, "Scotch yoke");
}

TEST(Linkages, AreNumberedPairs) {
  const std::vector<AnyDyad> dyads{rr({0, 0}, {0, 0}, 1), rr({1, 0}, {1, 1}, 1), rr({2, 0}, {2, 5}, 1),
                                   pr({0, 3}, {0, 1}, 0)};
  const auto all = linkages_of(dyads, 1);
  ASSERT_EQ(all.size(), 6u);
  const int expected[6][2] = {{1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(all[i].id, static_cast<int>(i) + 1);
    EXPECT_EQ(all[i].dyads[0], expected[i][0]);
    EXPECT_EQ(all[i].dyads[1], expected[i][1]);
  }
}

// With a common moving pivot the body is free, with a common fixed one it turns about it.
TEST(Linkages, HaveNoPivotInCommon) {
  const auto pairs = [](const AnyDyad& a, const AnyDyad& b) { return linkages_of({a, b}, 1).size(); };
  EXPECT_EQ(pairs(rr({0, 0}, {1, 2}, 1), rr({3, 0}, {1, 2}, 2)), 0u);
  EXPECT_EQ(pairs(rr({0, 0}, {1, 2}, 1), pr({1, 2}, {0, 1}, 4)), 0u);
  EXPECT_EQ(pairs(pr({1, 2}, {1, 0}, 0), pr({1, 2}, {0, 1}, 4)), 0u);
  EXPECT_EQ(pairs(rr({3, 0}, {1, 2}, 1), rr({3, 0}, {5, 2}, 2)), 0u);
  EXPECT_EQ(pairs(rr({3, 0}, {1, 2}, 1), rp({3, 0}, {0, 1}, 4)), 0u);
  EXPECT_EQ(pairs(rp({3, 0}, {1, 0}, 0), rp({3, 0}, {0, 1}, 4)), 0u);
  EXPECT_EQ(pairs(rr({1, 2}, {3, 0}, 1), rr({3, 0}, {1, 2}, 2)), 1u);  // one number, two pivots
  AnyDyad a = rr({3, 0}, {1, 2}, 1), b = rr({3 + 1e-12, 0}, {5, 2}, 2);
  EXPECT_EQ(pairs(a, b), 1u);
  a.certificate = b.certificate = {true, 6e-13, Rung::intervals};
  EXPECT_EQ(pairs(a, b), 0u);
  a.certificate.radius = 3e-13;
  EXPECT_EQ(pairs(a, b), 1u);
}

// An ill-conditioned change-point linkage is one as far as its data tell.
TEST(Linkages, ToleranceGrowsWithTheCondition) {
  AnyDyad a = rr({0, 0}, {0, 0}, 2), b = rr({5, 0}, {6, 0}, 9 + 1e-9);
  EXPECT_EQ(only(a, b).motion_class, "triple-rocker");
  a.condition = b.condition = 1e7;
  EXPECT_EQ(only(a, b).motion_class, "change-point");
}

}  // namespace
}  // namespace burmester::planar
