#include "burmester/planar/constraint_curve.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace burmester::planar {
namespace {

constexpr double pi = std::numbers::pi;

ConstraintManifold RR_about(Vector2 fixed, Vector2 moving, double length) {
  return ConstraintManifold(RR::Design{fixed, moving, length});
}
/// Coupler along the x axis of E from the origin, ground along that of S.
ConstraintCurve four_bar(double ground, double input, double coupler, double output) {
  return {RR_about({0, 0}, {0, 0}, input), RR_about({ground, 0}, {coupler, 0}, output)};
}

/// Poses off the circles by the rounding of a quadratic whose roots are `apart`: the roundoff over that, in units of
/// size.
TEST(ConstraintCurveOf, PosesMeetBothDyads) {
  Random random("ConstraintCurveOf.PosesMeetBothDyads");
  int found = 0;
  const auto check = [&]<class D, class E>() {
    for (int i = 0; i < 60; ++i) {
      const double unit = std::pow(10, 3 * (i % 3 - 1));
      const auto scaled = [unit](Family::Design d) {
        if (auto* rr = std::get_if<RR::Design>(&d)) rr->fixed *= unit, rr->moving *= unit, rr->length *= unit;
        if (auto* pr = std::get_if<PR::Design>(&d)) pr->moving *= unit, pr->line.offset *= unit;
        if (auto* rp = std::get_if<RP::Design>(&d)) rp->fixed *= unit, rp->line.offset *= unit;
        return ConstraintManifold(d);
      };
      const ConstraintManifold a = scaled(D::random_design(random)), b = scaled(E::random_design(random));
      const ConstraintCurve curve(a, b);
      const bool half_turn = i % 10 == 0;
      const double t = half_turn ? 1 : random.normal(), w = half_turn ? 0 : random.normal();
      const CommonPoses common = curve.at(t, w);
      EXPECT_FALSE(common.all);
      for (const Pose& x : common.poses) {
        ++found;
        EXPECT_NEAR(x.X3 * w, x.X4 * t, 1e-15) << D::name << E::name << " case " << i;
        const double size = unit + std::hypot(x.x, x.y);
        const double apart = common.poses.size() < 2 ? size
                                                     : std::hypot(common.poses[0].x - common.poses[1].x,
                                                                  common.poses[0].y - common.poses[1].y);
        const double tolerance = 1e-13 * size * (1 + size / apart) * (1 + size / unit);
        EXPECT_LT(a.distance(x), tolerance) << D::name << E::name << " case " << i;
        EXPECT_LT(b.distance(x), tolerance) << D::name << E::name << " case " << i;
      }
    }
  };
  check.operator()<RR, RR>();
  check.operator()<RR, PR>();
  check.operator()<RP, RR>();
  check.operator()<PR, PR>();
  check.operator()<RP, RP>();
  check.operator()<PR, RP>();
  EXPECT_GT(found, 250);
}

/// The orientations are those with common poses, on a grid of angles; ranges are closed.
TEST(ConstraintCurveOf, OrientationsAreThoseWithPoses) {
  Random random("ConstraintCurveOf.OrientationsAreThoseWithPoses");
  int with = 0, without = 0;
  for (int i = 0; i < 60; ++i) {
    const ConstraintManifold a(RR::random_design(random));
    const ConstraintManifold b(i % 3 == 0   ? Family::Design(PR::random_design(random))
                               : i % 3 == 1 ? Family::Design(RP::random_design(random))
                                            : Family::Design(RR::random_design(random)));
    const ConstraintCurve curve(a, b);
    const std::vector<Range> ranges = curve.orientations();
    for (int degrees = -180; degrees < 180; degrees += 7) {
      const double angle = degrees * pi / 180;
      bool inside = false, near = false;
      for (const Range& r : ranges)
        for (const double same : {angle, angle + 2 * pi}) {
          inside = inside || (r.low <= same && same <= r.high);
          near = near || std::min(std::abs(same - r.low), std::abs(same - r.high)) < 1e-9;
        }
      const bool has = !curve.at(std::sin(angle / 2), std::cos(angle / 2)).poses.empty();
      EXPECT_TRUE(near || inside == has) << "case " << i << " at " << degrees;
      ++(has ? with : without);
    }
  }
  EXPECT_GT(with, 500);
  EXPECT_GT(without, 500);
}

/// Grashof's rule read off the curve (F. Grashof, 1883): the coupler turns fully where it or the ground is the
/// shortest.
TEST(ConstraintCurveOf, RangesFollowGrashof) {
  EXPECT_EQ(four_bar(4, 1, 3, 3).orientations().size(), 2u);  // crank-rocker: two circuits, the coupler swings
  EXPECT_EQ(four_bar(3, 2, 3, 1).orientations().size(), 2u);  // rocker-crank, 3 + 1 < 2 + 3
  for (const ConstraintCurve& turning : {four_bar(1, 3, 4, 3), four_bar(4, 3, 1, 3)}) {  // double-crank, double-rocker
    ASSERT_EQ(turning.orientations().size(), 1u);
    EXPECT_EQ(turning.orientations()[0].low, -pi);
    EXPECT_EQ(turning.orientations()[0].high, pi);
  }
  EXPECT_EQ(four_bar(5, 2, 3, 3.5).orientations().size(), 1u);  // triple rocker
  EXPECT_TRUE(four_bar(9, 1, 3, 3).orientations().empty());     // cannot be closed
}

/// Ends where the distance of the moving circle's centre, |4 - e^(i angle)|^2 = 17 - 8 cos(angle), is that of touching.
TEST(ConstraintCurveOf, RangesEndWhereCirclesTouch) {
  const std::vector<Range> about_0 = four_bar(4, 1, 1, 3).orientations();  // 2 <= d <= 4
  ASSERT_EQ(about_0.size(), 1u);
  EXPECT_NEAR(about_0[0].low, -std::acos(1 / 8.0), 1e-15);
  EXPECT_NEAR(about_0[0].high, std::acos(1 / 8.0), 1e-15);
  const std::vector<Range> about_half_turns = four_bar(4, 1, 1, 5).orientations();  // 4 <= d <= 6
  ASSERT_EQ(about_half_turns.size(), 1u);
  EXPECT_NEAR(about_half_turns[0].low, std::acos(1 / 8.0), 1e-15);
  EXPECT_NEAR(about_half_turns[0].high, 2 * pi - std::acos(1 / 8.0), 4e-15);
}

TEST(ConstraintCurveOf, ATouchIsARangeOfOneAngle) {
  const std::vector<Range> at_0 = four_bar(4, 1, 1, 2).orientations();  // d >= 3 = 1 + 2
  ASSERT_EQ(at_0.size(), 1u);
  EXPECT_EQ(at_0[0].low, 0);
  EXPECT_EQ(at_0[0].high, 0);
  const std::vector<Range> at_half_turn = four_bar(4, 1, 1, 6).orientations();  // d <= 5 = 6 - 1
  ASSERT_EQ(at_half_turn.size(), 1u);
  EXPECT_EQ(at_half_turn[0].low, pi);
  EXPECT_EQ(at_half_turn[0].high, pi);
  EXPECT_TRUE(four_bar(4, 1, 1, std::nextafter(2, 0)).orientations().empty());
  const std::vector<Range> opened = four_bar(4, 1, 1, std::nextafter(2, 3)).orientations();
  ASSERT_EQ(opened.size(), 1u);
  EXPECT_GT(opened[0].high, 1e-9);
  EXPECT_LT(opened[0].high, 1e-7);
}

/// Translated: the whole circle of poses at one orientation; a crossing of two circuits inside one range.
TEST(ConstraintCurveOf, AParallelogramTranslatesFreely) {
  const ConstraintCurve curve = four_bar(2, 1, 2, 1);
  EXPECT_TRUE(curve.at(0, 1).all);
  EXPECT_FALSE(curve.at(0.1, 1).all);
  const std::vector<Range> ranges = curve.orientations();
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_NEAR(ranges[0].low, -pi / 3, 1e-15);  // 4 sin(angle / 2) = 2
  EXPECT_NEAR(ranges[0].high, pi / 3, 1e-15);
}

TEST(ConstraintCurveOf, OneSurfaceTwiceIsAllOfIt) {
  for (const Family::Design& d : {Family::Design(RR::Design{{1, 2}, {-1, 0.5}, 3}),
                                  Family::Design(PR::Design{{1, 2}, Line::through({0, 1}, 0.4)}),
                                  Family::Design(RP::Design{{1, 2}, Line::through({0, 1}, 0.4)})}) {
    const ConstraintCurve curve((ConstraintManifold(d)), (ConstraintManifold(d)));
    for (const double t : {0.0, 0.3, -2.0}) EXPECT_TRUE(curve.at(t, 1).all);
    EXPECT_TRUE(curve.at(1, 0).all);
    ASSERT_EQ(curve.orientations().size(), 1u);
    EXPECT_EQ(curve.orientations()[0].high, pi);
  }
}

/// Parallel guides: no pose but at infinity, or the whole line.
TEST(ConstraintCurveOf, ParallelGuidesMeetAtInfinity) {
  const ConstraintManifold a(PR::Design{{0, 0}, {{0, 1}, 0}}), b(PR::Design{{1, 0}, {{0, 1}, 0.5}});
  const CommonPoses at_0 = ConstraintCurve(a, b).at(0, 1);
  EXPECT_TRUE(at_0.poses.empty());
  EXPECT_FALSE(at_0.all);
  const CommonPoses at_30 = ConstraintCurve(a, b).at(std::sin(pi / 12), std::cos(pi / 12));  // 1 sin 30 deg = 0.5
  EXPECT_TRUE(at_30.all || at_30.poses.empty() || std::abs(at_30.poses[0].x) > 1e12);
}

}  // namespace
}  // namespace burmester::planar
