// Two and three orientations, and given axes on the sphere.
#include "burmester/spherical/pivots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/spherical/linkage.hpp"

namespace burmester::spherical {
namespace {

using Poses = std::vector<Pose>;
using Axes = std::vector<std::vector<double>>;
using ImagePoint = Space::Point<double>;

Poses random_poses(Random& random, int count) {
  Poses out;
  for (int i = 0; i < count; ++i) out.push_back(Space::random_pose(random));
  return out;
}
std::vector<double> shown(const Axis& a) { return {a[0], a[1], a[2]}; }
Axis placed(const Pose& pose, const Axis& a) { return Space::act<double>(Space::point<double>(pose), a).normalized(); }

Report<Dyads> solve(const Poses& poses, const Axes& fixed, const Axes& moving = {}) {
  Problem problem;
  problem.fixed = fixed, problem.moving = moving;
  return solve_linear(problem, poses);
}
RR::Design only_RR(const Report<Dyads>& report) {
  EXPECT_EQ(report.dyads.size(), 1u) << report.message;
  return std::get<RR::Design>(report.dyads.at(0).design);
}
/// Of axes as lines.
double distance(const Axis& a, const Axis& b) { return std::min((a - b).norm(), (a + b).norm()); }

TEST(GivenAxes, AnglesFromThePartnerAreEqual) {
  Random random("GivenAxes.AnglesFromThePartnerAreEqual");
  for (int i = 0; i < 300; ++i) {
    const Poses poses = random_poses(random, 3);
    const Axis given = Space::random_feature(random);
    for (const bool fixed : {true, false}) {
      const auto report = fixed ? solve(poses, {shown(given)}) : solve(poses, {}, {shown(given)});
      EXPECT_EQ(report.status, Status::exact);
      EXPECT_EQ(report.counts.complex, 1);
      EXPECT_TRUE(report.counts.certified);
      const RR::Design d = only_RR(report);
      EXPECT_LT((given - (fixed ? d.fixed : d.moving)).norm(), 1e-15);
      EXPECT_LT(report.dyads[0].certificate.radius, 1e-13);
      for (const Pose& pose : poses)
        EXPECT_NEAR(Space::distance(d.fixed, placed(pose, d.moving)), d.arc, 1e-13 * *report.dyads[0].condition) << i;
    }
  }
}

TEST(GivenAxes, DyadsThatShareOneMakeNoLinkage) {
  Random random("GivenAxes.DyadsThatShareOneMakeNoLinkage");
  const std::string none = "; all these dyads share the given ";
  for (int i = 0; i < 20; ++i) {
    const Poses poses = random_poses(random, 4 + i % 3);
    const std::vector<double> a = shown(Space::random_feature(random)), b = shown(Space::random_feature(random)),
                              longer = {-3 * b[0], -3 * b[1], -3 * b[2]};
    for (const auto& [report, body] : {std::pair{solve(poses, {a}), "fixed"}, {solve(poses, {}, {a}), "moving"}}) {
      EXPECT_EQ(report.dyads.size(), 2u) << i;
      EXPECT_TRUE(linkages_of(report.dyads).empty()) << i;
      EXPECT_NE(report.message.find(none + body + " axis: no two of them make a linkage"), std::string::npos) << i;
    }
    const auto two = solve(poses, {a}, {b});
    EXPECT_EQ(two.message.find(none), std::string::npos) << two.message;
    EXPECT_EQ(linkages_of(two.dyads).size(), 4u) << i;
    EXPECT_TRUE(linkages_of(solve(poses, {b, longer}).dyads).empty()) << i;
  }
}

// Equation 8 of the document as it stands: b = c1 x c2, c_j = (Q_j - 1) a0, with Q_0 = 1.
TEST(GivenAxes, EquationEight) {
  Random random("GivenAxes.EquationEight");
  for (int i = 0; i < 200; ++i) {
    const Poses poses{{}, Space::random_pose(random), Space::random_pose(random)};
    const Axis a = Space::random_feature(random);
    const Axis b = (placed(poses[1], a) - a).cross(placed(poses[2], a) - a).normalized();
    const auto report = solve(poses, {}, {shown(a)});
    EXPECT_LT(distance(only_RR(report).fixed, b), 1e-14 * (1 + *report.dyads[0].condition)) << i;
  }
}

TEST(GivenAxes, InversionMultiplicationOrderAndSigns) {
  Random random("GivenAxes.InversionMultiplicationOrderAndSigns");
  for (int i = 0; i < 200; ++i) {
    const Poses poses = random_poses(random, 3);
    const Axis given = Space::random_feature(random);
    const auto report = solve(poses, {}, {shown(given)});
    const RR::Design d = only_RR(report);
    const double tolerance = 1e-13 * (1 + *report.dyads[0].condition);
    const auto g = Space::point<double>(Space::random_pose(random)),
               h = Space::point<double>(Space::random_pose(random));
    Poses inverse, framed, negated;
    for (const Pose& p : poses) {
      inverse.push_back(Space::pose(Space::conjugate<double>(Space::point<double>(p))));
      framed.push_back(Space::pose(reframed<Space>(g, Space::point<double>(p), h)));
      negated.push_back(i % 2 ? p : Pose{-3 * p.w, -3 * p.x, -3 * p.y, -3 * p.z});
    }
    EXPECT_LT(distance(only_RR(solve(inverse, {shown(given)})).moving, d.fixed), tolerance) << i;
    const RR::Design seen = RR::moved(d, g, h);
    EXPECT_LT(distance(only_RR(solve(framed, {}, {shown(seen.moving)})).fixed, seen.fixed), tolerance) << i;
    EXPECT_LT(distance(only_RR(solve(negated, {}, {shown(given)})).fixed, d.fixed), tolerance) << i;
    EXPECT_LT(distance(only_RR(solve({poses[1], poses[2], poses[0]}, {}, {shown(given)})).fixed, d.fixed), tolerance)
        << i;
    EXPECT_LT(distance(only_RR(solve(poses, {}, {shown(7 * given)})).fixed, d.fixed), tolerance) << i;
  }
}

TEST(GivenAxes, PlacesOnAGreatCircleMakeASlider) {
  Random random("GivenAxes.PlacesOnAGreatCircleMakeASlider");
  for (int i = 0; i < 100; ++i) {
    const Axis b = Space::random_feature(random), e = b.unitOrthogonal(), a = Space::random_feature(random);
    Poses poses;
    for (int j = 0; j < 3; ++j) {  // a to a place on the circle, then any turn about it
      const double t = random.uniform(-3, 3);
      const Axis to = std::cos(t) * e + std::sin(t) * b.cross(e), axis = a.cross(to).normalized();
      const double angle = Space::distance(a, to);
      const Pose there = pose_from_axis_radians({axis[0], axis[1], axis[2]}, angle);
      const Pose turn = pose_from_axis_radians({to[0], to[1], to[2]}, random.uniform(-3, 3));
      poses.push_back(Space::pose(Space::product<double>(Space::point<double>(turn), Space::point<double>(there))));
    }
    const auto report = solve(poses, {}, {shown(a)});
    ASSERT_EQ(report.dyads.size(), 1u);
    const auto* pr = std::get_if<PR::Design>(&report.dyads[0].design);
    ASSERT_TRUE(pr) << i;
    EXPECT_LT(distance(pr->fixed, b), 1e-9);
    EXPECT_LT(report.dyads[0].residual, 1e-12);
  }
}

TEST(GivenAxes, TheRadiusOfASliderHoldsItsDeparture) {
  const std::string stream = "GivenAxes.TheRadiusOfASliderHoldsItsDeparture";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 50; ++i) {
    const double departure = random.uniform(1e-11, 9e-10), arc = std::numbers::pi / 2 - departure;
    const Axis a = Axis::UnitZ(), b = std::cos(arc) * a + std::sin(arc) * Axis::UnitX();
    Poses poses(1);
    for (int j = 0; j < 2; ++j) {  // a on its cone about b, then any turn about a's place
      const Pose on = pose_from_axis_radians({b[0], b[1], b[2]}, random.uniform(-3, 3));
      const Pose turn = pose_from_axis_radians({a[0], a[1], a[2]}, random.uniform(-3, 3));
      poses.push_back(Space::pose(Space::product<double>(Space::point<double>(on), Space::point<double>(turn))));
    }
    const auto report = solve(poses, {}, {shown(a)});
    ASSERT_EQ(report.dyads.size(), 1u);
    const auto& found = report.dyads[0];
    ASSERT_TRUE(std::holds_alternative<PR::Design>(found.design)) << i;
    EXPECT_NEAR(found.departure.value(), departure, 1e-14 * (1 + *found.condition)) << i;
    EXPECT_GE(found.certificate.radius, found.departure.value()) << i;
  }
}

TEST(GivenAxes, AxesOfRotationAreNamed) {
  Random random("GivenAxes.AxesOfRotationAreNamed");
  const Poses poses{{}, pose_from_axis_degrees({0, 0, 1}, 90), pose_from_axis_degrees({1, 2, 2}, 40)};
  for (const auto& report : {solve(poses, {{0, 0, 2}}), solve(poses, {}, {{0, 0, 2}})}) {
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_TRUE(report.dyads.empty());
    EXPECT_NE(report.message.find("it is the axis of rotation of poses 1 and 2"), std::string::npos) << report.message;
    EXPECT_NE(report.message.find("its partners fill a great circle"), std::string::npos) << report.message;
    ASSERT_EQ(report.family.partners.size(), 1u);
  }
  for (int i = 0; i < 50; ++i)
    for (const PoleRecord& pole : poles_of<Pivots>(random_poses(random, 3))) EXPECT_GT(pole.angle, 0);
  EXPECT_NE(solve({{}, {-1, 0, 0, 0}, poses[1]}, {{0, 1, 0}}).message.find("poses 1 and 2 are equal"),
            std::string::npos);
  EXPECT_THROW(solve(poses, {{0, 0, 0}}), InputError);
}

TEST(GivenAxes, PolesStayInPlace) {
  Random random("GivenAxes.PolesStayInPlace");
  for (int i = 0; i < 100; ++i) {
    const Poses poses = random_poses(random, 2);
    const auto poles = poles_of<Pivots>(poses);
    ASSERT_EQ(poles.size(), 1u);
    const Axis m(poles[0].moving[0], poles[0].moving[1], poles[0].moving[2]),
        f(poles[0].fixed[0], poles[0].fixed[1], poles[0].fixed[2]);
    for (const Pose& pose : poses) EXPECT_LT((placed(pose, m) - f).norm(), 1e-14);
    const Axis across = f.unitOrthogonal(),
               seen = Space::act<double>(Space::conjugate<double>(Space::point<double>(poses[0])), across).normalized();
    EXPECT_NEAR(Space::distance(across, placed(poses[1], seen)), poles[0].angle, 1e-14);
  }
}

TEST(GivenAxes, TwoOrientationsLeaveAGreatCircle) {
  Random random("GivenAxes.TwoOrientationsLeaveAGreatCircle");
  for (int i = 0; i < 100; ++i) {
    const Poses poses = random_poses(random, 2);
    const Axis given = Space::random_feature(random);
    for (const auto& report : {solve(poses, {}, {shown(given)}), solve(poses, {shown(given)})}) {
      EXPECT_EQ(report.status, Status::family);
      EXPECT_EQ(report.counts.dimension, 1);
      EXPECT_NE(report.message.find("the partners of the axis fill a great circle"), std::string::npos);
      ASSERT_EQ(report.family.partners.size(), 1u);
      ASSERT_EQ(report.family.samples.size(), 12u);
      int sliders = 0;
      for (const DyadRecord& d : report.family.samples) {
        EXPECT_LT(d.residual, 1e-13);
        sliders += d.type == "PR";
      }
      EXPECT_EQ(sliders, 1);
    }
  }
}

TEST(GivenAxes, OneAxisOfRotationLeavesEveryPartner) {
  const auto turn = [](double degrees) { return pose_from_axis_degrees({0, 0, 1}, degrees); };
  for (const Poses& poses : {Poses{turn(0), turn(30)}, Poses{turn(0), turn(30), turn(80)}}) {
    const auto report = solve(poses, {{0, 0, 1}});
    EXPECT_EQ(report.counts.dimension, 2) << report.message;
    EXPECT_NE(report.message.find("every moving axis is a partner"), std::string::npos) << report.message;
  }
}

TEST(GivenAxes, FamiliesAreSampled) {
  Random random("GivenAxes.FamiliesAreSampled");
  for (const int count : {2, 3}) {
    const auto report = solve(random_poses(random, count), {});
    EXPECT_EQ(report.status, Status::family);
    EXPECT_EQ(report.counts.dimension, 5 - count);
    EXPECT_GE(report.family.samples.size(), 36u);
    for (const DyadRecord& d : report.family.samples) EXPECT_LT(d.residual, 1e-12);
    const auto sliders = std::ranges::count(report.family.samples, PR::name, &DyadRecord::type);
    EXPECT_EQ(sliders, count == 2 ? 36 : 0);  // of two orientations every fixed axis has one
  }
}

TEST(GivenAxes, EqualAndCoaxialOrientationsAreNamed) {
  const Pose a, b = pose_from_axis_degrees({1, 2, 3}, 40), b_scaled{0.3 * b.w, 0.3 * b.x, 0.3 * b.y, 0.3 * b.z};
  const auto message = [](const Poses& poses) { return solve(poses, {}).message; };
  EXPECT_EQ(message({b, b}), "poses 1 and 2 are equal: in effect 1 pose, met by every dyad");
  EXPECT_EQ(message({b, b_scaled}), "poses 1 and 2 are equal: in effect 1 pose, met by every dyad, within rounding");
  EXPECT_EQ(message({a, b, b_scaled}),
            "poses 2 and 3 are equal: in effect 2 poses, in general met by a three-dimensional family of dyads, within "
            "rounding");
  EXPECT_EQ(message({a, a, a}), "poses 1 and 2 and 3 are equal: in effect 1 pose, met by every dyad");
  const std::string words =
                        "all rotations from one orientation to another have one axis, (0.267261, 0.534522, 0.801784)",
                    family = "; a two-dimensional family of dyads (samples)";
  for (const double off : {0.0, 1e-12}) {
    const Poses poses{a, b, Space::nudged(pose_from_axis_degrees({1, 2, 3}, 70), {off, 0, 0})};
    const auto report = solve(poses, {});
    EXPECT_EQ(report.status, Status::family);
    EXPECT_EQ(report.counts.dimension, 2);
    EXPECT_EQ(report.message.starts_with(words), off == 0) << report.message;
    EXPECT_EQ(report.message.ends_with(", within rounding" + family), off == 0) << report.message;
    for (const DyadRecord& d : report.family.samples) EXPECT_LT(d.residual, 1e-12);
  }
  const std::string exact = message({a, {3, 0, 0, 1}, {0, 0, 0, 1}});
  EXPECT_TRUE(exact.starts_with("all rotations from one orientation to another have one axis, (0, 0, 1):")) << exact;
  EXPECT_EQ(exact.find("within rounding"), std::string::npos) << exact;
}

TEST(GivenAxes, MoreOrientationsAreFittedOrMet) {
  Random random("GivenAxes.MoreOrientationsAreFittedOrMet");
  for (int i = 0; i < 40; ++i) {
    const Poses poses = random_poses(random, 4 + i % 3);
    const Axis given = Space::random_feature(random);
    const auto report = solve(poses, {shown(given)});
    EXPECT_EQ(report.status, Status::approximate);
    ASSERT_EQ(report.dyads.size(), 2u);  // a circle, and the slider
    Poses met;
    const Axis centre = Space::random_feature(random);
    for (const Pose& p : poses) {  // turned after p so that the angle from the centre is 40 deg
      const Axis place = placed(p, given), axis = centre.cross(place).normalized();
      const double by = 40 * std::numbers::pi / 180 - Space::distance(centre, place);
      met.push_back(Space::pose(Space::product<double>(
          Space::point<double>(pose_from_axis_radians({axis[0], axis[1], axis[2]}, by)), Space::point<double>(p))));
    }
    const auto exact = solve(met, {}, {shown(given)});
    EXPECT_EQ(exact.status, Status::exact) << i << exact.message;
    EXPECT_LT(distance(only_RR(exact).fixed, centre), 1e-10) << i;
  }
}

}  // namespace
}  // namespace burmester::spherical
