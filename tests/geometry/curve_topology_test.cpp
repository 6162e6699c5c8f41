#include "burmester/geometry/curve_topology.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "burmester/geometry/correlations.hpp"
#include "burmester/geometry/curve_analysis.hpp"
#include "burmester/geometry/random.hpp"
#include "cubics.hpp"
#include "curve_corpus.hpp"
#include "positions.hpp"

using namespace burmester;
using namespace burmester::corpus;

namespace {

#ifndef BURMESTER_WITHOUT_GMP
std::array<int, 3> kinds(const CurveTopology& t) {
  std::array<int, 3> n{};
  for (const SingularPoint& p : t.singular) ++n[static_cast<std::size_t>(p.kind)];
  return n;
}

/// Everything that can be counted.
void expect_same(const CurveTopology& a, const CurveTopology& b, const std::string& name) {
  EXPECT_EQ(a.components, b.components) << name;
  EXPECT_EQ(a.ovals, b.ovals) << name;
  EXPECT_EQ(a.isolated, b.isolated) << name;
  EXPECT_EQ(a.repeated, b.repeated) << name;
  EXPECT_EQ(kinds(a), kinds(b)) << name;
  EXPECT_EQ(a.lines.size(), b.lines.size()) << name;
  EXPECT_EQ(a.conics.size(), b.conics.size()) << name;
  EXPECT_EQ(a.at_infinity.size(), b.at_infinity.size()) << name;
}

TEST(CurveTopology, BothRoutesAgreeOnTheCorpus) {
  Random random("CurveTopology.BothRoutesAgreeOnTheCorpus");
  for (const CorpusCurve& original : corpus_cubics())
    for (const CorpusCurve& c : {original, moved(original, random_projective_map(random))}) {
      if (!c.on_curve) continue;
      const auto curve = c.curve.cast<Rational>();
      expect_same(topology_of(curve, cast<Rational>(*c.on_curve)), analyse_curve(curve), c.name);
    }
}

TEST(CurveTopology, BothRoutesAgreeOnCircularCubics) {
  for (int k = 0; k < 40; ++k) {
    const CorpusCurve c = random_circular_cubic("CurveTopology.BothRoutesAgreeOnCircularCubics." + std::to_string(k));
    const auto curve = c.curve.cast<Rational>();
    expect_same(topology_of(curve, cast<Rational>(*c.on_curve)), analyse_curve(curve), c.name);
  }
}

TEST(CurveTopology, BothRoutesAgreeOnCirclePointCurvesAndCones) {
  Random random("CurveTopology.BothRoutesAgreeOnCirclePointCurvesAndCones");
  for (int k = 0; k < 10; ++k)
    for (const bool sphere : {false, true}) {
      const auto make = sphere ? random_rotation : random_plane_displacement;
      const std::array<FourDoubles, 3> d{make(random), make(random), make(random)};
      const auto n = sphere ? equidistant_on_sphere<Rational>(d) : equidistant_in_plane<Rational>(d);
      const TernaryForm<Rational> curve(points_with_partner(n));
      const CurveTopology by_cgal = analyse_curve(curve);
      for (const auto& one : n)  // from each pole
        expect_same(topology_of(curve, vertex(one)), by_cgal, std::to_string(k) + (sphere ? " sphere" : " plane"));
    }
}

TEST(CurveTopology, ASingularPointLeadsToTheOtherRoute) {
  const CurveTopology t = topology_of(weierstrass(1, 0, 0).cast<Rational>(), cast<Rational>(Point2<double>(0, 0, 1)));
  EXPECT_EQ(t.rung, Rung::exact);
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.singular.size(), 1u);
}
#else
TEST(CurveTopology, WithoutGmpCubicsWithAPointAreAnsweredAndOthersAreNot) {
  const auto curve = weierstrass(0, -1, 0).cast<Rational>();
  EXPECT_EQ(topology_of(curve, cast<Rational>(Point2<double>(0, 1, 0))).components, 2);
  const CurveTopology t = topology_of(curve);
  EXPECT_EQ(t.rung, Rung::none);
  EXPECT_NE(t.reason.find("not available"), std::string::npos) << t.reason;
}
#endif

TEST(CurveTopology, APointBesideTheCurveIsRefused) {
  const auto curve = weierstrass(0, -1, 0).cast<Rational>();
  EXPECT_THROW(topology_of(curve, cast<Rational>(Point2<double>(2, 1, 1))), std::invalid_argument);
  EXPECT_THROW(topology_of(curve, cast<Rational>(Point2<double>(0, 0, 0))), std::invalid_argument);
}

}  // namespace
