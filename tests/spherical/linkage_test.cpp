#include "burmester/spherical/linkage.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "burmester/spherical/family.hpp"
#include "spherical_examples.hpp"

namespace burmester::spherical {
namespace {

constexpr double pi = std::numbers::pi;

/// Whether the linkage closes for every angle of the crank `a`: from its end to the other fixed axis no less than
/// |h - b| and no more than h + b, or round the back.
bool turns(double g, double a, double h, double b) {
  for (int i = 0; i < 720; ++i) {
    const double cosine = std::cos(g) * std::cos(a) + std::sin(g) * std::sin(a) * std::cos(i * pi / 360);
    const double diagonal = std::acos(std::clamp(cosine, -1.0, 1.0));
    if (diagonal < std::abs(h - b) || diagonal > std::min(h + b, 2 * pi - h - b)) return false;
  }
  return true;
}

TEST(SphericalClass, IsWhatTurnsFully) {
  Random random("SphericalClass.IsWhatTurnsFully");
  std::set<std::string> seen;
  for (int i = 0; i < 2000; ++i) {
    const double g = random.uniform(0.05, pi - 0.05), a = random.uniform(0.05, pi - 0.05),
                 h = random.uniform(0.05, pi - 0.05), b = random.uniform(0.05, pi - 0.05);
    if (four_bar_class(g, a, h, b, 0.01) == "change-point") continue;
    const std::string name = four_bar_class(g, a, h, b, 0);
    seen.insert(name);
    EXPECT_EQ(name == "crank-rocker" || name == "double-crank", turns(g, a, h, b))
        << g << ' ' << a << ' ' << h << ' ' << b;
    EXPECT_EQ(name == "rocker-crank" || name == "double-crank", turns(g, b, h, a))
        << g << ' ' << a << ' ' << h << ' ' << b;
    if (name != "double-rocker") continue;
    EXPECT_EQ(four_bar_class(h, a, g, b, 0), "double-crank");  // standing on the coupler
  }
  EXPECT_EQ(seen.size(), 5u);
}

TEST(SphericalClass, DoesNotDependOnWhichEndOfAnAxisIsTaken) {
  Random random("SphericalClass.DoesNotDependOnWhichEndOfAnAxisIsTaken");
  for (int i = 0; i < 500; ++i) {
    const double g = random.uniform(0, pi), a = random.uniform(0, pi), h = random.uniform(0, pi),
                 b = random.uniform(0, pi);
    const std::string name = four_bar_class(g, a, h, b, 1e-9);
    EXPECT_EQ(name, four_bar_class(pi - g, a, pi - h, b, 1e-9));  // both axes of a dyad
    EXPECT_EQ(name, four_bar_class(g, pi - a, pi - h, b, 1e-9));  // a moving axis
    EXPECT_EQ(name, four_bar_class(pi - g, pi - a, h, b, 1e-9));  // a fixed axis
  }
}

TEST(SphericalClass, SmallLinkagesAreThoseOfThePlane) {
  const double s = 1e-4;
  EXPECT_EQ(four_bar_class(6 * s, 2 * s, 7 * s, 9 * s, 0), "crank-rocker");
  EXPECT_EQ(four_bar_class(2 * s, 6 * s, 7 * s, 9 * s, 0), "double-crank");
  EXPECT_EQ(four_bar_class(6 * s, 7 * s, 2 * s, 9 * s, 0), "double-rocker");
  EXPECT_EQ(four_bar_class(3 * s, 5 * s, 6 * s, 9 * s, 0), "triple-rocker");
  EXPECT_EQ(four_bar_class(4 * s, 2 * s, 4 * s, 2 * s, 1e-12), "change-point");
}

TEST(SphericalLinkages, AreAllPairsWithTheArcsOfTheirAxes) {
  const testing::SphericalExample example = testing::angeles_bai_2_exact();
  std::vector<Found<Dyads::Design>> dyads;
  for (const RR::Design& d : example.dyads) dyads.push_back({*Family::decode(RR::encode(d)), 0, {}, {}, {}, {}});
  const std::vector<LinkageRecord> linkages = linkages_of(dyads);
  ASSERT_EQ(linkages.size(), 6u);
  const std::vector<DyadRecord> records = example.answer().dyads;
  for (const LinkageRecord& l : linkages) {
    const DyadRecord &a = records[static_cast<std::size_t>(l.dyads[0] - 1)],
                     &b = records[static_cast<std::size_t>(l.dyads[1] - 1)];
    const auto between = [](const std::vector<double>& u, const std::vector<double>& v) {
      return std::acos(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
    };
    const bool slider = l.dyads[1] == 4;
    EXPECT_EQ(l.type, slider ? "RRRP" : "RRRR");
    EXPECT_NEAR(*l.input, *a.arc, 1e-12);
    EXPECT_NEAR(*l.coupler, between(a.moving, b.moving), 1e-12);
    EXPECT_EQ(l.ground.has_value(), !slider);
    EXPECT_EQ(l.offset.has_value(), slider);
    const double ground = between(a.fixed, b.fixed);
    EXPECT_NEAR(slider ? *l.offset : *l.ground, slider ? std::abs(pi / 2 - ground) : ground, 1e-12);
    EXPECT_EQ(
        *l.motion_class == "slider-crank" || *l.motion_class == "crank-rocker" || *l.motion_class == "double-crank",
        turns(ground, *a.arc, *l.coupler, *b.arc))
        << l.id;
  }
}

TEST(SphericalLinkages, ArcsBelongToTheAxesShown) {
  for (const double z : {1e-17, -1e-17})  // nothing is known of its sign
    for (const Certificate& proof : {Certificate{true, 1e-15, Rung::intervals}, Certificate{false, HUGE_VAL, {}}}) {
      Report<Dyads> report;
      report.dyads.push_back({RR::Design{{0, 0, 1}, {0.6, 0.8, z}, 1.2}, 0, {}, {}, {}, proof});
      report.dyads.push_back({RR::Design{{1, 0, 0}, {0, 0.6, 0.8}, 0.7}, 0, {}, {}, {}, proof});
      const std::vector<DyadRecord> shown = records_of(report);
      const auto between = [](const std::vector<double>& u, const std::vector<double>& v) {
        return std::acos(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
      };
      const std::vector<LinkageRecord> linkages = linkages_of(report.dyads);
      ASSERT_EQ(linkages.size(), 1u);
      EXPECT_NEAR(*linkages[0].coupler, between(shown[0].moving, shown[1].moving), 1e-15) << z << proof.certified;
      EXPECT_NEAR(*linkages[0].ground, between(shown[0].fixed, shown[1].fixed), 1e-15) << z << proof.certified;
      EXPECT_EQ(*linkages[0].input, *shown[0].arc) << z << proof.certified;
    }
}

TEST(SphericalLinkages, HaveNoAxisInCommon) {
  const auto pairs = [](const Dyads::Design& a, const Dyads::Design& b) {
    return linkages_of({{a, 0, {}, {}, {}, {}}, {b, 0, {}, {}, {}, {}}}).size();
  };
  Random random("SphericalLinkages.HaveNoAxisInCommon");
  for (int i = 0; i < 100; ++i) {
    const Axis f = Space::random_feature(random), m = Space::random_feature(random), n = Space::random_feature(random);
    const double scale = random.uniform(0.1, 10);  // another length and direction of the same axis
    const Axis same_f = Axis(-scale * f).normalized(), same_m = Axis(-scale * m).normalized();
    EXPECT_EQ(pairs(RR::Design{f, m, 1.1}, RR::Design{same_f, n, 0.4}), 0u) << i;
    EXPECT_EQ(pairs(RR::Design{f, m, 1.1}, PR::Design{same_f, n}), 0u) << i;
    EXPECT_EQ(pairs(RR::Design{f, m, 1.1}, RR::Design{n, same_m, 1.8}), 0u) << i;
    EXPECT_EQ(pairs(PR::Design{f, m}, PR::Design{n, same_m}), 0u) << i;
    EXPECT_EQ(pairs(RR::Design{f, m, 1.1}, RR::Design{m, n, 0.4}), 1u) << i;
    const Axis near_f = f + 1e-14 * m.cross(f).normalized();
    EXPECT_EQ(pairs(RR::Design{f, m, 1.1}, RR::Design{near_f, n, 0.4}), 1u) << i;
  }
}

TEST(SphericalLinkages, ASliderCrankThroughAChangePointIsOneInEveryFrame) {
  Random random("SphericalLinkages.ASliderCrankThroughAChangePointIsOneInEveryFrame");
  const auto at = [](double angle) { return Axis(std::sin(angle), 0, std::cos(angle)); };
  // ground 1.2, crank 0.9, coupler a quarter turn less 0.3: g - a = b - h
  for (const auto& [crank, expected] :
       {std::pair{0.9, "slider-crank"}, {0.9 - 1e-9, "slider-crank"}, {0.9 + 1e-9, "rocker-slider"}})
    for (int i = 0; i < 100; ++i) {
      const auto g = Space::point<double>(Space::random_pose(random)),
                 h = Space::point<double>(Space::random_pose(random));
      const std::vector<Found<Dyads::Design>> dyads{
          {RR::moved({at(0), at(0.2), crank}, g, h), 0, {}, {}, {}, {}},
          {PR::moved({at(1.2), at(0.2 + pi / 2 - 0.3)}, g, h), 0, {}, {}, {}, {}}};
      EXPECT_EQ(*linkages_of(dyads)[0].motion_class, expected) << crank << ' ' << i;
    }
}

}  // namespace
}  // namespace burmester::spherical
