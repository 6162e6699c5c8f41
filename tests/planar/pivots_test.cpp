// Two and three poses, and given pivots: what follows from the geometry of perpendicular bisectors,
// whatever the formulas.
#include "burmester/planar/pivots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/planar/linkage.hpp"

namespace burmester::planar {
namespace {

using Poses = std::vector<Pose>;
using Points = std::vector<std::vector<double>>;

Poses random_poses(Random& random, int count) {
  Poses out;
  for (int i = 0; i < count; ++i) out.push_back(Space::random_pose(random));
  return out;
}
std::vector<double> point(const Vector2& p) { return {p[0], p[1]}; }
Vector2 vec(const std::vector<double>& p) { return {p[0], p[1]}; }

PlanarReport solve(const Poses& poses, const Points& fixed, const Points& moving = {}) {
  Problem problem;
  problem.fixed = fixed, problem.moving = moving;
  return GivenPivots<Pivots>(problem, poses).solve();
}
RR::Design only_RR(const PlanarReport& report) {
  EXPECT_EQ(report.dyads.size(), 1u) << report.message;
  return std::get<RR::Design>(report.dyads.at(0).design);
}
double scale_of(const RR::Design& d) { return 1 + d.fixed.norm() + d.moving.norm() + d.length; }

Poses inverse(const Poses& poses) {
  Poses out;
  for (const Pose& p : poses) out.push_back(Space::pose(Space::conjugate<double>(Space::point<double>(p))));
  return out;
}

TEST(GivenPivots, DistancesFromThePartnerAreEqual) {
  Random random("GivenPivots.DistancesFromThePartnerAreEqual");
  for (int i = 0; i < 500; ++i) {
    const Poses poses = random_poses(random, 3);
    const Vector2 given = Space::random_feature(random);
    for (const bool fixed : {true, false}) {
      const PlanarReport report = fixed ? solve(poses, {point(given)}) : solve(poses, {}, {point(given)});
      EXPECT_EQ(report.status, Status::exact);
      EXPECT_EQ(report.counts.dimension, 0);
      EXPECT_EQ(report.counts.complex, 1);
      EXPECT_TRUE(report.counts.certified);
      const RR::Design d = only_RR(report);
      EXPECT_EQ(fixed ? d.fixed : d.moving, given);
      for (const Pose& pose : poses)
        EXPECT_NEAR((to_fixed(pose, d.moving) - d.fixed).norm(), d.length, 1e-12 * scale_of(d)) << i;
    }
  }
}

TEST(GivenPivots, PartnersArePartnersOfEachOther) {
  Random random("GivenPivots.PartnersArePartnersOfEachOther");
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const Vector2 given = Space::random_feature(random);
    const RR::Design there = only_RR(solve(poses, {}, {point(given)}));
    const auto back = solve(poses, {point(there.fixed)});
    const double condition = *back.dyads.at(0).condition;
    EXPECT_LT((only_RR(back).moving - given).norm(), 1e-13 * condition * scale_of(there)) << i;
  }
}

TEST(GivenPivots, InversionExchangesFixedAndMoving) {
  Random random("GivenPivots.InversionExchangesFixedAndMoving");
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const Vector2 given = Space::random_feature(random);
    const auto report = solve(poses, {point(given)});
    const RR::Design d = only_RR(report), other = only_RR(solve(inverse(poses), {}, {point(given)}));
    const double tolerance = 1e-13 * (1 + *report.dyads[0].condition) * scale_of(d);
    EXPECT_LT((d.moving - other.fixed).norm(), tolerance) << i;
    EXPECT_NEAR(d.length, other.length, tolerance);
  }
}

TEST(GivenPivots, FramesScaleAndOrderDoNotMatter) {
  Random random("GivenPivots.FramesScaleAndOrderDoNotMatter");
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const Vector2 given = Space::random_feature(random);
    const auto report = solve(poses, {}, {point(given)});
    const RR::Design d = only_RR(report);
    const double tolerance = 1e-12 * (1 + *report.dyads[0].condition) * scale_of(d);

    const auto g = Space::point<double>(Space::random_pose(random)),
               h = Space::point<double>(Space::random_pose(random));
    Poses framed, scaled;
    for (const Pose& p : poses) {
      framed.push_back(Space::pose(reframed<Space>(g, Space::point<double>(p), h)));
      scaled.push_back({1e3 * p.x, 1e3 * p.y, p.X3, p.X4});
    }
    const RR::Design seen = RR::moved(d, g, h), there = only_RR(solve(framed, {}, {point(seen.moving)}));
    EXPECT_LT((there.fixed - seen.fixed).norm(), tolerance) << i;
    const RR::Design large = only_RR(solve(scaled, {}, {point(1e3 * given)}));
    EXPECT_LT((large.fixed - 1e3 * d.fixed).norm(), 1e3 * tolerance);
    const RR::Design ordered = only_RR(solve({poses[2], poses[0], poses[1]}, {}, {point(given)}));
    EXPECT_LT((ordered.fixed - d.fixed).norm(), tolerance);
  }
}

TEST(GivenPivots, CertificateHoldsForTheExactPartner) {
  // The circumcentre of the three places, in 64 bits and by another formula.
  Random random("GivenPivots.CertificateHoldsForTheExactPartner");
  using Real = long double;
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const Vector2 given = Space::random_feature(random);
    const auto report = solve(poses, {}, {point(given)});
    const RR::Design d = only_RR(report);
    Real x[3], y[3];
    for (int j = 0; j < 3; ++j) {
      const Pose& p = poses[static_cast<std::size_t>(j)];
      const Real s = p.X3, c = p.X4, n = s * s + c * c;
      x[j] = p.x + ((c * c - s * s) * given[0] - 2 * s * c * given[1]) / n;
      y[j] = p.y + ((c * c - s * s) * given[1] + 2 * s * c * given[0]) / n;
    }
    const Real a = x[1] - x[0], b = y[1] - y[0], e = x[2] - x[0], f = y[2] - y[0], area = 2 * (a * f - b * e);
    const Real u = (f * (a * a + b * b) - b * (e * e + f * f)) / area,
               v = (a * (e * e + f * f) - e * (a * a + b * b)) / area;
    const double off =
        static_cast<double>(std::hypot(x[0] + u - d.fixed[0], y[0] + v - d.fixed[1], std::hypot(u, v) - d.length));
    const double oracle = 1e-18 * scale_of(d) * (1 + *report.dyads[0].condition);
    EXPECT_LE(off, report.dyads[0].certificate.radius + oracle) << i;
    EXPECT_LT(report.dyads[0].certificate.radius, 1e-15 * scale_of(d));
  }
}

TEST(GivenPivots, CollinearPlacesMakeASlider) {
  Random random("GivenPivots.CollinearPlacesMakeASlider");
  for (int i = 0; i < 100; ++i) {
    const Vector2 moving = Space::random_feature(random), start = Space::random_feature(random);
    const double direction = random.uniform(0, std::numbers::pi);
    Poses poses;
    for (int j = 0; j < 3; ++j) {
      const Pose turn = pose_from_radians(0, 0, random.uniform(-3, 3));
      const Vector2 place = start + random.normal() * Vector2(std::cos(direction), std::sin(direction));
      const Vector2 origin = place - rotated(turn, moving);
      poses.push_back({origin[0], origin[1], turn.X3, turn.X4});
    }
    const auto report = solve(poses, {}, {point(moving)});
    ASSERT_EQ(report.dyads.size(), 1u);
    const auto* pr = std::get_if<PR::Design>(&report.dyads[0].design);
    ASSERT_TRUE(pr) << i;
    EXPECT_LT(std::abs(std::remainder(pr->line.record().angle - direction, std::numbers::pi)), 1e-9);
    EXPECT_LT(report.dyads[0].residual, 1e-12);
    EXPECT_TRUE(report.dyads[0].certificate.certified);
    const auto inverted = solve(inverse(poses), {point(moving)});
    ASSERT_EQ(inverted.dyads.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<RP::Design>(inverted.dyads[0].design));
    EXPECT_LT(inverted.dyads[0].residual, 1e-12);
  }
}

TEST(GivenPivots, PolesAreNamed) {
  Random random("GivenPivots.PolesAreNamed");
  for (int i = 0; i < 50; ++i) {
    const Poses poses = random_poses(random, 3);
    for (const PoleRecord& pole : poles_of<Pivots>(poses)) {
      const Pose &from = poses[static_cast<std::size_t>(pole.poses[0] - 1)],
                 &to = poses[static_cast<std::size_t>(pole.poses[1] - 1)];
      const double size = 1 + vec(pole.fixed).norm();
      EXPECT_LT((to_fixed(from, vec(pole.moving)) - vec(pole.fixed)).norm(), 1e-13 * size);
      EXPECT_LT((to_fixed(to, vec(pole.moving)) - vec(pole.fixed)).norm(),
                1e-12 * size / std::abs(std::sin(pole.angle / 2)));
      EXPECT_NEAR(std::remainder(angle_of(to) - angle_of(from) - pole.angle, 2 * std::numbers::pi), 0, 1e-14);
    }
  }
  // Half turns about two places: poles that are doubles.
  const Poses poses{{0, 0, 0, 1}, {2, 4, 1, 0}, {-2, 6, 1, 0}};
  for (const auto& [report, word] :
       {std::pair{solve(poses, {{1, 2}}), "fixed[0]"}, {solve(poses, {}, {{1, 2}}), "moving[0]"}}) {
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_TRUE(report.dyads.empty());
    EXPECT_NE(report.message.find(word + std::string(": it is the pole of poses 1 and 2, its partners fill a line")),
              std::string::npos)
        << report.message;
    ASSERT_EQ(report.family.partners.size(), 1u);
  }
  const auto image =
      solve({{1, 0, 0, 1}, {0, 0, 0, 1}, {2, 4, 1, 0}}, {}, {{1, 2}});  // the pole of poses 2 and 3 on the body
  EXPECT_NE(image.message.find("it is the pole of poses 2 and 3"), std::string::npos) << image.message;
  const auto equal = solve({{1, 0, 0, 1}, {1, 0, 0, 1}, {2, 4, 1, 0}}, {}, {{1, 2}});
  EXPECT_NE(equal.message.find("poses 1 and 2 are equal"), std::string::npos) << equal.message;
}

bool mentions(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

TEST(GivenPivots, APoleComputedInDoublesIsNamedInAWarning) {
  Random random("GivenPivots.APoleComputedInDoublesIsNamedInAWarning");
  int named = 0;
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const PoleRecord pole = poles_of<Pivots>(poses)[0];
    const PlanarReport there = solve(poses, {pole.fixed}),
                       beside = solve(poses, {point(vec(pole.fixed) + Vector2(1e-6, 0))});
    named += mentions(there.warnings, "fixed[0]: within rounding it is the pole of poses 1 and 2");
    EXPECT_EQ(beside.status, Status::exact);
    EXPECT_TRUE(beside.warnings.empty());
  }
  EXPECT_GT(named, 150);  // rounding of the pole, more than once, may exceed one rounding of the data
}

TEST(GivenPivots, WhatOnlyRoundingCannotTellApartHasItsExactAnswer) {
  const double h = unit_roundoff;
  for (const double step : {8 * h, 2 * h}) {  // three places of the pivot, a right angle between the steps
    const Pose a = pose_from_degrees(1, 1, 10), b = pose_from_degrees(1 + step, 1, 10),
               c = pose_from_degrees(1, 1 + step, 10);
    const PlanarReport report = solve({a, b, c}, {}, {{3, 4}});
    EXPECT_EQ(report.status, Status::exact) << report.message;
    EXPECT_EQ(report.counts.dimension, 0);
    EXPECT_TRUE(mentions(report.warnings, "moving[0]: within rounding "));
    const RR::Design d = only_RR(report);
    EXPECT_NEAR(d.length, step / std::sqrt(2), 1e-3 * step);
    const PlanarReport two = solve({a, b}, {}, {{3, 4}});
    EXPECT_EQ(two.counts.dimension, 1) << two.message;
    EXPECT_EQ(two.family.partners.size(), 1u);
    EXPECT_TRUE(mentions(two.warnings, "moving[0]: within rounding "));
  }
}

TEST(GivenPivots, TheDimensionIsThatOfThePartners) {
  const auto turn = [](double degrees) { return pose_from_degrees(0, 0, degrees); };
  const auto expect = [](const PlanarReport& report, int dimension, const std::string& words) {
    EXPECT_EQ(report.counts.dimension, dimension) << report.message;
    EXPECT_NE(report.message.find(words), std::string::npos) << report.message;
  };
  const Poses turns{turn(0), turn(30), turn(80)}, two{turn(0), turn(30)};
  expect(solve(turns, {{0, 0}}), 2, "fixed[0]: it is at one place in all poses, every moving pivot is a partner");
  expect(solve(turns, {}, {{0, 0}}), 2, "moving[0]: it is at one place in all poses, every fixed pivot is a partner");
  expect(solve({turn(0), turn(30), pose_from_degrees(3, 1, 80)}, {{0, 0}}), 1, "its partners fill a line");
  const PlanarReport pole = solve(two, {{0, 0}});
  expect(pole, 2, "two poses and a given pivot: a two-dimensional family of dyads; fixed[0]: it is the pole");
  EXPECT_EQ(pole.message.find("line"), std::string::npos) << pole.message;
  expect(solve(two, {{1, 0}}), 1, "a one-dimensional family of dyads, the partners of the pivot fill a line");
  expect(solve(two, {{1, 0}, {2, 0}}), 1, "two poses and given pivots: a one-dimensional family of dyads, the partners "
                                          "of each pivot fill a line");
  expect(solve(two, {{0, 0}, {1, 0}}), 2, "a two-dimensional family of dyads, the partners of each other pivot fill a "
                                          "line (partners, samples); fixed[0]: it is the pole of poses 1 and 2, every "
                                          "moving pivot is a partner");
}

TEST(GivenPivots, OtherPivotsAreListedBesideAPole) {
  const auto report = solve({{0, 0, 0, 1}, {2, 4, 1, 0}, {-2, 6, 1, 0}}, {{1, 2}, {5, 5}}, {{0.5, 0}});
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_EQ(report.dyads.size(), 2u);
}

TEST(GivenPivots, TwoPosesLeaveALine) {
  Random random("GivenPivots.TwoPosesLeaveALine");
  for (int i = 0; i < 100; ++i) {
    const Poses poses = random_poses(random, 2);
    const Vector2 given = Space::random_feature(random);
    const auto report = solve(poses, {}, {point(given)});
    EXPECT_EQ(report.status, Status::family);
    EXPECT_EQ(report.counts.dimension, 1);
    EXPECT_TRUE(report.dyads.empty());
    ASSERT_EQ(report.family.partners.size(), 1u);
    const LineRecord line = *report.family.partners[0].line;
    const Vector2 a = to_fixed(poses[0], given), b = to_fixed(poses[1], given), middle = (a + b) / 2;
    const Vector2 direction(std::cos(line.angle), std::sin(line.angle)), off = middle - vec(line.point);
    EXPECT_NEAR(direction.dot(a - b), 0, 1e-12);
    EXPECT_NEAR(off[0] * direction[1] - off[1] * direction[0], 0, 1e-12 * (1 + off.norm()));
    ASSERT_EQ(report.family.samples.size(), 12u);
    for (const DyadRecord& d : report.family.samples) {
      EXPECT_EQ(d.type, &d == &report.family.samples.back() ? "PR" : "RR") << i;  // the point at infinity
      EXPECT_FALSE(d.slider) << i;  // two places lie on a line: no RR is near a slider for that
      EXPECT_LT(d.residual, 1e-12);
    }
  }
}

TEST(GivenPivots, MorePosesAreFittedOrMet) {
  Random random("GivenPivots.MorePosesAreFittedOrMet");
  for (int i = 0; i < 60; ++i) {
    const int count = 4 + i % 4;
    Poses poses = random_poses(random, count);
    const Vector2 given = Space::random_feature(random);
    const auto report = solve(poses, {}, {point(given)});
    EXPECT_EQ(report.status, Status::approximate);
    ASSERT_GE(report.dyads.size(), 1u);
    for (const auto& found : report.dyads) {
      const auto* rr = std::get_if<RR::Design>(&found.design);
      if (!rr) continue;
      // No circle near it has a smaller sum of squares.
      const auto sum = [&](const Vector2& c, double r) {
        double s = 0;
        for (const Pose& p : poses) s += std::pow((to_fixed(p, given) - c).norm() - r, 2);
        return s;
      };
      const double h = 1e-4 * (1 + rr->length), best = sum(rr->fixed, rr->length);
      for (int k = 0; k < 3; ++k)
        for (const double step : {-h, h})
          EXPECT_GE(sum(rr->fixed + step * Vector2(k == 0, k == 1), rr->length + step * (k == 2)), best * (1 - 1e-9))
              << i;
    }
    // Poses that carry the pivot along a circle are met.
    const Vector2 centre = Space::random_feature(random);
    for (Pose& pose : poses) {
      const double t = random.uniform(-3, 3);
      const Vector2 origin = centre + 0.7 * Vector2(std::cos(t), std::sin(t)) - rotated(pose, given);
      pose.x = origin[0], pose.y = origin[1];
    }
    for (const auto& met : {solve(poses, {}, {point(given)}), solve(poses, {point(centre)})}) {
      EXPECT_EQ(met.status, Status::exact) << i << ' ' << met.message;
      EXPECT_NEAR(only_RR(met).length, 0.7, 1e-10) << i;
    }
  }
}

TEST(GivenPivots, PartnersOfEachOtherAreListedOnce) {
  const Poses circle{pose_from_degrees(1, 0, 5), pose_from_degrees(0, 1, 30), pose_from_degrees(-1, 0, 80),
                     pose_from_degrees(0, -1, 10), pose_from_degrees(0.6, 0.8, 0)};
  for (const std::size_t count : {3u, 4u, 5u}) {
    const Poses poses(circle.begin(), circle.begin() + static_cast<int>(count));
    const PlanarReport report = solve(poses, {{0, 0}, {3, 4}}, {{0, 0}});
    EXPECT_EQ(report.dyads.size(), solve(poses, {{0, 0}, {3, 4}}).dyads.size()) << count;
    EXPECT_TRUE(mentions(report.warnings, "two of the given pivots lead to the same RR dyad: listed once")) << count;
    EXPECT_EQ(solve(poses, {{0, 0}, {1e-6, 0}}).dyads.size(), solve(poses, {{0, 0}}).dyads.size() +
                                                                  solve(poses, {{1e-6, 0}}).dyads.size());
  }
  EXPECT_EQ(solve(circle, {{0, 0}}, {{0, 0}}).counts.real, 1);
}

TEST(GivenPivots, DyadsThatShareOneMakeNoLinkage) {
  Random random("GivenPivots.DyadsThatShareOneMakeNoLinkage");
  const Poses poses = random_poses(random, 5);
  const std::string none = "; all these dyads share the given ";
  for (const auto& [report, body] :
       {std::pair{solve(poses, {{5, 0}}), "fixed"}, {solve(poses, {}, {{5, 0}}), "moving"}}) {
    EXPECT_EQ(report.dyads.size(), 2u) << body;
    EXPECT_TRUE(linkages_of(report.dyads, 1).empty()) << body;
    EXPECT_NE(report.message.find(none + body + " pivot: no two of them make a linkage"), std::string::npos)
        << report.message;
  }
  const auto two = solve(poses, {{5, 0}}, {{1, 2}});
  EXPECT_EQ(two.message.find(none), std::string::npos) << two.message;
  EXPECT_EQ(linkages_of(two.dyads, 1).size(), 4u);

  // The body's point at the pole (1, 2) of poses 1 and 2 has all centres on the bisector of its two places.
  const Poses three{pose_from_degrees(0, 0, 0), pose_from_degrees(2, 4, 180), pose_from_degrees(-2, 6, 90)};
  const auto at_pole = solve(three, {{-1.5, 4.5}, {2.5, 8.5}});
  ASSERT_EQ(at_pole.dyads.size(), 2u);
  EXPECT_TRUE(linkages_of(at_pole.dyads, task_size(three)).empty());
  EXPECT_EQ(linkages_of(solve(three, {{-1.5, 4.5}, {2.5, 9}}).dyads, task_size(three)).size(), 1u);
}

TEST(GivenPivots, RoundingOfAFarPivotProvesNothing) {
  Random random("GivenPivots.RoundingOfAFarPivotProvesNothing");
  const Poses poses = random_poses(random, 4);
  const PlanarReport far = solve(poses, {{1e15, 0}}), near = solve(poses, {{5, 0}});
  EXPECT_EQ(far.status, Status::approximate) << far.message;
  EXPECT_TRUE(mentions(far.warnings, "fixed[0]: rounding of numbers so large")) << far.message;
  EXPECT_TRUE(near.warnings.empty());
}

TEST(GivenPivots, PlacesThatDoNotTellAreNamed) {
  const Pose a{0, 0, 0, 1}, b{1, 2, 0.6, 0.8};
  const auto report = solve({a, b, a, b}, {{3, 3}});
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_NE(report.message.find("fixed[0]: fewer than three different places"), std::string::npos) << report.message;
  EXPECT_THROW(solve({a, b, {3, 1, 0, 1}}, {{1e200, 0}}), InputError);
  const auto far = solve({a, b, {3, 1, 0, 1}}, {}, {{1e100, 1e90}});  // nothing that is not a number
  for (const DyadRecord& record : records_of(far))
    EXPECT_TRUE(std::isfinite(record.residual + record.length.value_or(0)));
}

// MECH 576, section 5 (three poses, fixed centres (0, 0) and (16, 0)): table 16, equations 14 to 19. x is printed
// 7.35221, hand calculation; the 15 digits are the exact solution of the printed poses. The coupler is printed 8.2479.
TEST(GivenPivots, Mech576ThreePositionProblem) {
  const Poses poses{pose_from_degrees(-1.221, 22.394, 36.868), pose_from_degrees(12.779, 28.394, -45),
                    pose_from_degrees(8.154, 12.519, 67.38)};
  const auto report = solve(poses, {{0, 0}, {16, 0}});
  ASSERT_EQ(report.dyads.size(), 2u);
  const auto &a = std::get<RR::Design>(report.dyads[0].design), &b = std::get<RR::Design>(report.dyads[1].design);
  EXPECT_LT((a.moving - Vector2(7.352058590438461, -5.780259849944223)).norm(), 1e-13);
  EXPECT_NEAR(a.length, 23.62332646967654, 1e-13);
  EXPECT_LT((b.moving - Vector2(7.076702762857621, -14.02358240987242)).norm(), 1e-13);
  EXPECT_NEAR(b.length, 15.73827233465615, 1e-13);
  EXPECT_NEAR(*linkages_of(report.dyads, 1).at(0).coupler, 8.247920202014804, 1e-13);
  const double printed[][3] = {{7.35221, -5.7803, 23.6233}, {7.0767, -14.0236, 15.7383}};
  EXPECT_NEAR(a.moving[0], printed[0][0], 2e-4);  // rounded on the way in the document
  EXPECT_NEAR(a.moving[1], printed[0][1], 5e-5);
  EXPECT_NEAR(a.length, printed[0][2], 5e-5);
  EXPECT_NEAR(b.moving[0], printed[1][0], 5e-5);
  EXPECT_NEAR(b.moving[1], printed[1][1], 5e-5);
  EXPECT_NEAR(b.length, printed[1][2], 5e-5);
}

}  // namespace
}  // namespace burmester::planar
