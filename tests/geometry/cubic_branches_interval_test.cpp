#include "burmester/geometry/cubic_branches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/range.hpp"
#include "cubics.hpp"
#include "curve_corpus.hpp"

using namespace burmester;
using namespace burmester::corpus;

namespace {

int number_of(const CurveTopology& t, SingularKind kind) {
  int n = 0;
  for (const SingularPoint& p : t.singular) n += p.kind == kind;
  return n;
}

void expect_topology(const CurveTopology& t, const CorpusCurve& c) {
  EXPECT_EQ(t.components, c.components) << c.name;
  EXPECT_EQ(t.ovals, c.ovals) << c.name;
  EXPECT_EQ(t.isolated, c.isolated) << c.name;
  EXPECT_EQ(number_of(t, SingularKind::crossing), c.crossings) << c.name;
  EXPECT_EQ(number_of(t, SingularKind::cusp), c.cusps) << c.name;
  EXPECT_EQ(number_of(t, SingularKind::isolated), c.points) << c.name;
  EXPECT_EQ(static_cast<int>(t.lines.size()), c.lines) << c.name;
  EXPECT_EQ(static_cast<int>(t.conics.size()), c.conics) << c.name;
  EXPECT_EQ(t.repeated, c.repeated) << c.name;
}

/// Every corpus cubic with a point, and moved copies of it.
std::vector<CorpusCurve> cubics_with_a_point() {
  Random random("CubicBranches.cubics_with_a_point");
  std::vector<CorpusCurve> out;
  for (const CorpusCurve& c : corpus_cubics()) {
    if (!c.on_curve) continue;
    out.push_back(c);
    for (int k = 0; k < 5; ++k) out.push_back(moved(c, random_projective_map(random)));
  }
  for (int k = 0; k < 200; ++k) out.push_back(random_cubic("CubicBranches.random." + std::to_string(k)));
  return out;
}

}  // namespace

TEST(CubicBranches, RationalsTellTheTopologyOfEveryCubicInTheCorpus) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const CubicBranches found = branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve));
    ASSERT_EQ(found.topology.rung, Rung::exact) << c.name;
    expect_topology(found.topology, c);
  }
}

TEST(CubicBranches, IntervalsAnswerForSmoothCurvesOnlyAndRightly) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const UpwardRounding upward;
    const auto found = branches_by_intervals(cubic_of<Interval>(c.curve), cast<Interval>(*c.on_curve));
    if (!found) continue;
    EXPECT_EQ(found->topology.rung, Rung::intervals);
    EXPECT_EQ(c.crossings + c.cusps + c.points + c.lines, 0) << c.name;
    expect_topology(found->topology, c);
  }
}

TEST(CubicBranches, IntervalsSettleRandomCubics) {
  int answered = 0;
  const int all = 500;
  for (int k = 0; k < all; ++k) {
    const CorpusCurve c = random_circular_cubic("CubicBranches.IntervalsSettleRandomCubics." + std::to_string(k));
    const CurveTopology exact =
        branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve)).topology;
    const UpwardRounding upward;
    const auto found = branches_by_intervals(cubic_of<Interval>(c.curve), cast<Interval>(*c.on_curve));
    if (!found) continue;
    ++answered;
    EXPECT_EQ(found->topology.components, exact.components) << c.name;
    EXPECT_EQ(found->topology.ovals, exact.ovals) << c.name;
    EXPECT_EQ(found->topology.at_infinity.size(), exact.at_infinity.size()) << c.name;
    EXPECT_EQ(exact.singular.size(), 0u) << c.name;
  }
  EXPECT_GE(answered, all - 1);
}

TEST(CubicBranches, SameTopologyFromEveryPointOfTheCurve) {
  // Weierstrass cubics with many rational points: y^2 = (x - a) (x - b) (x - c) has (a, 0), (b, 0), (c, 0) and (0 : 1 :
  // 0).
  Random random("CubicBranches.SameTopologyFromEveryPointOfTheCurve");
  for (int k = 0; k < 100; ++k) {
    const double a = random.below(9), b = a + random.below(4), c = b + random.below(4);
    const Cubic<Rational> f = cubic_of<Rational>(weierstrass(-a - b - c, a * b + b * c + c * a, -a * b * c));
    const CurveTopology from_infinity = branches_by_rationals(f, cast<Rational>(Point2<double>(0, 1, 0))).topology;
    const int roots = (a != b) + (b != c);
    EXPECT_EQ(from_infinity.components, roots == 2 ? 2 : a == b && b != c ? 2 : 1) << a << " " << b << " " << c;
    for (const double x : {a, b, c}) {
      const CurveTopology t = branches_by_rationals(f, cast<Rational>(Point2<double>(x, 0, 1))).topology;
      const bool singular = (x == a) + (x == b) + (x == c) > 1;
      ASSERT_EQ(t.rung, singular ? Rung::none : Rung::exact);
      if (singular) continue;
      EXPECT_EQ(t.components, from_infinity.components) << a << " " << b << " " << c << " from " << x;
      EXPECT_EQ(t.ovals, from_infinity.ovals);
      EXPECT_EQ(t.isolated, from_infinity.isolated);
      EXPECT_EQ(t.singular.size(), from_infinity.singular.size());
    }
  }
}

TEST(CubicBranches, SingularPointsLieWhereTheGradientVanishes) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const Cubic<double> f = cubic_of<double>(c.curve);
    for (const SingularPoint& p :
         branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve)).topology.singular)
      EXPECT_LT(f.gradient(p.at).norm(), 1e-6 * f.gradient_bound()) << c.name;  // roots split by 2^-40 are 2^-20 apart
  }
}

TEST(CubicBranches, FactorsMultiplyToTheCubic) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const CurveTopology t = branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve)).topology;
    if (t.lines.empty() || t.repeated) continue;
    PlaneCurve product(t.lines[0]);
    for (std::size_t k = 1; k < t.lines.size(); ++k) product = product * PlaneCurve(t.lines[k]);
    for (const Conic<double>& q : t.conics) product = product * PlaneCurve(q);
    ASSERT_EQ(product.degree, 3);
    Vector<double, 10> ours, theirs;
    for (int k = 0; k < 10; ++k)
      ours[k] = product.coefficients[static_cast<std::size_t>(k)],
      theirs[k] = c.curve.coefficients[static_cast<std::size_t>(k)];
    ours.normalize(), theirs.normalize();
    EXPECT_LT(std::min((ours - theirs).norm(), (ours + theirs).norm()), 1e-12) << c.name;
  }
}

TEST(CubicBranches, PointsAtInfinityAndAsymptotes) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const Cubic<double> f = cubic_of<double>(c.curve);
    const auto at_infinity =
        branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve)).topology.at_infinity;
    for (const PointAtInfinity& p : at_infinity) {
      EXPECT_EQ(p.at[2], 0);
      EXPECT_LT(std::abs(f(p.at)), 1e-11 * f.gradient_bound()) << c.name;
      if (f.gradient(p.at).norm() < 1e-3 * f.gradient_bound()) continue;  // (nearly) singular there
      EXPECT_LT(std::abs(p.tangent.dot(p.at)), 1e-9) << c.name;
    }
    EXPECT_LE(at_infinity.size(), 3u);
  }
  // x (x^2 + y^2) = y^2 - x^2 has the asymptote x = 1.
  const auto strophoid = branches_by_rationals(cubic_of<Rational>(circular_cubic(1, 0, 1, 0, -1, 0, 0, 0)),
                                               cast<Rational>(Point2<double>(0, 1, 0)))
                             .topology;
  ASSERT_EQ(strophoid.at_infinity.size(), 1u);
  EXPECT_NEAR(strophoid.at_infinity[0].tangent[0] + strophoid.at_infinity[0].tangent[2], 0, 1e-15);
  EXPECT_EQ(strophoid.at_infinity[0].tangent[1], 0);
}

TEST(CubicBranches, BranchesLieOnTheCurveAndBoxesHoldThem) {
  for (const CorpusCurve& c : cubics_with_a_point()) {
    const UpwardRounding upward;
    const Cubic<double> f = cubic_of<double>(c.curve);
    const Cubic<Interval> enclosing = cubic_of<Interval>(c.curve);
    for (const CubicBranch& branch :
         branches_by_rationals(cubic_of<Rational>(c.curve), cast<Rational>(*c.on_curve)).branches)
      for (const CubicBranch::Passage& passage : branch.passages)
        for (double s = -1; s <= 1; s += 0.125) {
          const Point2<double> p = branch.approximate(s, passage.sheet);
          ASSERT_GT(p.norm(), 0) << c.name;
          EXPECT_LT(std::abs(f(p.normalized())), 1e-7 * f.gradient_bound()) << c.name << " at " << s;
          EXPECT_TRUE(contains_zero(enclosing(branch.enclosing(Interval(s), passage.sheet)))) << c.name << " at " << s;
        }
  }
}

TEST(CubicBranches, ASingularBasePointIsRefusedWithAReason) {
  const CubicBranches node =
      branches_by_rationals(cubic_of<Rational>(weierstrass(1, 0, 0)), cast<Rational>(Point2<double>(0, 0, 1)));
  EXPECT_EQ(node.topology.rung, Rung::none);
  EXPECT_FALSE(node.topology.reason.empty());
  EXPECT_TRUE(node.branches.empty());
}

TEST(CubicBranches, TheUnitOfTheCoefficientsDoesNotMatter) {
  for (const CorpusCurve& c : corpus_cubics()) {
    if (!c.on_curve) continue;
    for (const int exponent : {-1500, 1500}) {
      const Integer power = Integer(1) << 1500;
      const Rational factor = exponent > 0 ? Rational(power) : Rational(Rational(1) / Rational(power));
      Cubic<Rational> f = cubic_of<Rational>(c.curve);
      for (Rational& x : f.c) x *= factor;
      const Point2<Rational> p = cast<Rational>(*c.on_curve) * factor;
      const CurveTopology t = branches_by_rationals(f, p).topology;
      expect_topology(t, c);
      for (const PointAtInfinity& at : t.at_infinity) EXPECT_TRUE(at.tangent.allFinite()) << c.name;
    }
  }
}
