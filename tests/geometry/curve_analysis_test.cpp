#include "burmester/geometry/curve_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>
#include <vector>

#include "cgal_leaks.hpp"
#include "curve_corpus.hpp"
#include "exact_roots.hpp"

namespace burmester {
namespace {

#ifdef BURMESTER_WITHOUT_GMP

TEST(CurveAnalysis, SaysThatItNeedsGmp) {
  const CurveTopology t = analyse_curve(corpus::circle(0, 0, 1));
  EXPECT_EQ(t.rung, Rung::none);
  EXPECT_NE(t.reason.find("GMP"), std::string::npos);
}

#else

using corpus::CorpusCurve;
using corpus::FourBar;

int count(const CurveTopology& t, SingularKind kind) {
  return static_cast<int>(
      std::count_if(t.singular.begin(), t.singular.end(), [kind](const auto& s) { return s.kind == kind; }));
}

void expect_topology(const CorpusCurve& c, const CurveTopology& t) {
  SCOPED_TRACE(c.name);
  ASSERT_EQ(t.rung, Rung::exact) << t.reason;
  EXPECT_EQ(t.components, c.components);
  EXPECT_EQ(t.ovals, c.ovals);
  EXPECT_EQ(t.isolated, c.isolated);
  EXPECT_EQ(count(t, SingularKind::crossing), c.crossings);
  EXPECT_EQ(count(t, SingularKind::cusp), c.cusps);
  EXPECT_EQ(count(t, SingularKind::isolated), c.points);
  EXPECT_EQ(t.lines.size(), static_cast<std::size_t>(c.lines));
  EXPECT_EQ(t.conics.size(), static_cast<std::size_t>(c.conics));
  EXPECT_EQ(t.repeated, c.repeated);
}

/// What is given as numbers lies where it should. Bound: the double coordinates of lines and points carry one
/// rounding each, which moves F by at most a few hundred (monomials times degree) of them, in units of the
/// largest coefficient.
void expect_positions(const CorpusCurve& c, const CurveTopology& t) {
  const double bound = 400 * unit_roundoff * size_of(c.curve);
  for (const SingularPoint& s : t.singular) {
    EXPECT_EQ(s.at.cwiseAbs().maxCoeff(), 1) << c.name;
    EXPECT_LT(std::abs(c.curve(s.at)), bound) << c.name;
    EXPECT_LT(c.curve.gradient(s.at).norm(), c.curve.degree * bound) << c.name;
  }
  for (const PointAtInfinity& p : t.at_infinity) {
    EXPECT_EQ(p.at[2], 0) << c.name;
    EXPECT_LT(std::abs(c.curve(p.at)), bound) << c.name;
    EXPECT_LT(std::abs(p.tangent.dot(p.at)), 3 * unit_roundoff) << c.name;
  }
  for (const LinearForm<double>& l : t.lines)
    for (int k = 0; k < 3; ++k)  // the line's points on the three axes
      EXPECT_LT(std::abs(c.curve(l.cross(Point2<double>::Unit(k)))), bound)
          << c.name << ", line " << l.transpose();
}

TEST(CurveAnalysis, FindsTheTopologyOfTheCorpusInAnyCoordinates) {
  Random random("CurveAnalysis.FindsTheTopologyOfTheCorpusInAnyCoordinates");
  for (const CorpusCurve& c : corpus::curve_corpus())
    for (const CorpusCurve& one : {c, moved(c, corpus::random_projective_map(random))}) {
      const CurveTopology t = analyse_curve(one.curve);
      expect_topology(one, t);
      expect_positions(one, t);
    }
}

TEST(CurveAnalysis, ScalingChangesNothing) {
  const CorpusCurve c = corpus::corpus_cubics()[0];
  for (const double factor : {-3.0, 0x1p-900, 0x1p900}) {
    CorpusCurve scaled = c;
    scaled.curve *= factor;
    expect_topology(c, analyse_curve(scaled.curve));
  }
  expect_topology(c, analyse_curve(TernaryForm<Rational>(c.curve.cast<Rational>() * Rational(1, 3))));
}

TEST(CurveAnalysis, GivesReasonsForWhatIsNoCurve) {
  PlaneCurve f(3);
  for (const double c :
       {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    f(1, 1) = c;
    EXPECT_EQ(analyse_curve(f).rung, Rung::none) << c;
    EXPECT_NE(analyse_curve(f).reason, "") << c;
  }
  EXPECT_EQ(analyse_curve(PlaneCurve(0)).rung, Rung::none);
}

TEST(CurveAnalysis, LinesAndConicsAreTheFactors) {
  Random random("CurveAnalysis.LinesAndConicsAreTheFactors");
  const auto same = [](auto a, auto b) {  // up to scale; the cosine carries some ten roundings
    return std::abs(std::abs(a.dot(b)) / (a.norm() * b.norm()) - 1) < 1e-14;
  };
  for (int i = 0; i < 2; ++i) {
    const PlaneCurve line = corpus::random_form(random, 1), conic = corpus::random_form(random, 2),
                     other = corpus::random_form(random, 3);
    for (const PlaneCurve& f : {line * conic, line * conic * other}) {
      const CurveTopology t = analyse_curve(f);
      ASSERT_EQ(t.lines.size(), 1u);
      EXPECT_TRUE(same(t.lines[0], LinearForm<double>(line(1, 0), line(0, 1), line(0, 0)))) << t.lines[0];
      ASSERT_EQ(t.conics.size(), 1u);
      const PlaneCurve found(t.conics[0]);
      const auto vector = [](const PlaneCurve& c) { return Vector<double, 6>(c.coefficients.data()); };
      EXPECT_TRUE(same(vector(found), vector(conic)));
    }
  }
}

TEST(CurveAnalysis, PointsAtInfinityAndTheirTangents) {
  const auto ends = [](const CorpusCurve& c) { return analyse_curve(c.curve).at_infinity; };
  // x y = z^2: the axes are the asymptotes.
  const auto hyperbola = ends({"hyperbola", corpus::conic(0, 0, -1, 0, 0, 1)});
  ASSERT_EQ(hyperbola.size(), 2u);
  for (const PointAtInfinity& p : hyperbola) {
    EXPECT_EQ(p.at.cwiseAbs().sum(), 1) << p.at;
    EXPECT_EQ(p.tangent.cwiseAbs().sum(), 1) << p.tangent;
    EXPECT_EQ(p.tangent[2], 0);
  }
  // x^2 = y z touches the line at infinity.
  const auto parabola = ends({"parabola", corpus::conic(1, 0, 0, -1)});
  ASSERT_EQ(parabola.size(), 1u);
  EXPECT_EQ(parabola[0].tangent.cwiseAbs(), LinearForm<double>(0, 0, 1));
  // (x^2 + y^2) x = y^2: the cissoid's asymptote x = 1.
  const auto cissoid = ends({"cissoid", corpus::circular_cubic(1, 0, 0, 0, -1, 0, 0, 0)});
  ASSERT_EQ(cissoid.size(), 1u);
  EXPECT_EQ(cissoid[0].tangent.cwiseAbs(), LinearForm<double>(1, 0, 1));
  EXPECT_LT(cissoid[0].tangent[0] * cissoid[0].tangent[2], 0);
  EXPECT_TRUE(ends({"circle", corpus::circle(1, 2, 3)}).empty());
  // y z^2 = x^3: a cusp at (0 : 1 : 0), where there is no asymptote.
  const CurveTopology cusp = analyse_curve(corpus::line(0, 1, 0) * corpus::conic(0, 0, 1) +
                                           corpus::power(corpus::line(1, 0, 0), 3) * -1.0);
  ASSERT_EQ(cusp.at_infinity.size(), 1u);
  EXPECT_EQ(cusp.at_infinity[0].tangent, LinearForm<double>(0, 0, 0));
  ASSERT_EQ(cusp.singular.size(), 1u);
  EXPECT_EQ(cusp.singular[0].at.cwiseAbs(), Point2<double>(0, 1, 0));
}

/// Lines through a point p of a cubic meet it in two more points, real where a binary quartic is positive:
/// B^2 - 4 A C, where F(w + s p) = A(w) s^2 + B(w) s + C(w). Four real roots, or none: two components; two:
/// one. (Smooth cubics.)
int components_by_pencil(const PlaneCurve& curve, const Point2<double>& p) {
  Matrix<Rational, 3, 3> m = Matrix<Rational, 3, 3>::Identity();
  Eigen::Index largest = 0;
  p.cwiseAbs().maxCoeff(&largest);
  m.col(largest).swap(m.col(2));
  m.col(2) = p.cast<Rational>();
  const TernaryForm<Rational> f = curve.cast<Rational>().substituted(m);
  const auto part = [&f](int degree) {  // coefficients of z^(3 - degree), as a form of degree 3
    TernaryForm<Rational> out(degree);
    for (int j = 0; j <= degree; ++j) out(degree - j, j) = f(degree - j, j);
    return out;
  };
  const TernaryForm<Rational> d = part(2) * part(2) + part(1) * part(3) * Rational(-4);
  const int roots = exact::count_real_roots_of_form({d(4, 0), d(3, 1), d(2, 2), d(1, 3), d(0, 4)}).distinct;
  return roots == 2 ? 1 : 2;
}

TEST(CurveAnalysis, CubicsHaveTheComponentsThatTheirPencilTells) {
  for (const CorpusCurve& c : corpus::corpus_cubics())
    if (c.on_curve && c.crossings + c.cusps + c.points + c.lines == 0) {
      EXPECT_EQ(components_by_pencil(c.curve, *c.on_curve), c.components) << c.name;
    }
  int two = 0;
  for (int i = 0; i < 40; ++i) {
    const CorpusCurve c = corpus::random_circular_cubic("curve_analysis.circular." + std::to_string(i));
    const CurveTopology t = analyse_curve(c.curve);
    ASSERT_TRUE(t.singular.empty()) << c.name;
    EXPECT_EQ(t.components, components_by_pencil(c.curve, *c.on_curve)) << c.name;
    EXPECT_EQ(t.ovals, t.components - 1) << c.name;
    EXPECT_EQ(t.at_infinity.size(), 1u) << c.name;
    if (t.components == 2) ++two;
  }
  EXPECT_GT(two, 5);
  EXPECT_LT(two, 35);
}

/// A. Harnack (1876): at most (d - 1) (d - 2) / 2 + 1 components; F. Klein: smooth curves of odd degree have
/// one that is no oval, of even degree none.
TEST(CurveAnalysis, SmoothCurvesObeyHarnackAndParity) {
  Random random("CurveAnalysis.SmoothCurvesObeyHarnackAndParity");
  for (int d = 1; d <= 6; ++d)
    for (int i = 0; i < 5; ++i) {
      const PlaneCurve f = corpus::random_form(random, d);
      const CurveTopology t = analyse_curve(f),
                          other = analyse_curve(f.substituted(corpus::random_projective_map(random).matrix));
      ASSERT_TRUE(t.singular.empty());
      EXPECT_LE(t.components, (d - 1) * (d - 2) / 2 + 1);
      EXPECT_EQ(t.components - t.ovals, d % 2);
      EXPECT_EQ(t.isolated, 0);
      EXPECT_LE(t.at_infinity.size(), static_cast<std::size_t>(d));
      EXPECT_EQ(t.at_infinity.size() % 2, static_cast<std::size_t>(d % 2));
      EXPECT_EQ(other.components, t.components);
      EXPECT_EQ(other.ovals, t.ovals);
    }
}

// ---- Coupler curves, drawn by the linkage itself ----

using Plane = Vector<double, 2>;

/// The circuits as closed polygons: the crank swings through its ranges, the triangle is on one side on the
/// way forth and on the other on the way back; a crank that turns fully has a circuit for each side.
std::vector<std::vector<Plane>> circuits(const FourBar& l, int steps) {
  const auto at = [&l](double phi, int side) {
    const Plane c = l.crank * Plane(std::cos(phi), std::sin(phi)), to_b = Plane(l.ground, 0) - c;
    const double d = to_b.norm(), along = (l.coupler * l.coupler + d * d - l.rocker * l.rocker) / (2 * d);
    const double height = side * std::sqrt(std::max(0.0, l.coupler * l.coupler - along * along));
    const Plane e = to_b / d, u = (along * e + height * Plane(-e[1], e[0])) / l.coupler;
    return Plane(c + l.s * u + l.t * Plane(-u[1], u[0]));
  };
  const auto cosine = [&l](double reach) {  // of the crank angle at which the pins are `reach` apart
    return (l.crank * l.crank + l.ground * l.ground - reach * reach) / (2 * l.crank * l.ground);
  };
  const double pi = std::numbers::pi, far = cosine(l.coupler + l.rocker),
               near = cosine(std::abs(l.coupler - l.rocker));
  std::vector<std::array<double, 2>> ranges;
  if (far > -1 && near < 1)
    ranges = {{std::acos(near), std::acos(far)}, {-std::acos(far), -std::acos(near)}};
  else if (near < 1)
    ranges = {{std::acos(near), 2 * pi - std::acos(near)}};
  else if (far > -1)
    ranges = {{-std::acos(far), std::acos(far)}};
  std::vector<std::vector<Plane>> out;
  for (const auto& [from, to] : ranges) {
    out.emplace_back();
    for (int k = 0; k < steps; ++k) {
      const double tau = 2 * pi * (k + 0.5) / steps;
      out.back().push_back(at((from + to) / 2 - (to - from) / 2 * std::cos(tau), tau < pi ? 1 : -1));
    }
  }
  if (ranges.empty())
    for (const int side : {1, -1}) {
      out.emplace_back();
      for (int k = 0; k < steps; ++k) out.back().push_back(at(2 * pi * (k + 0.5) / steps, side));
    }
  return out;
}

struct Crossings {
  int count = 0;
  bool join = false;  ///< two circuits cross
};
Crossings crossings(const std::vector<std::vector<Plane>>& circuits) {
  const auto side = [](const Plane& a, const Plane& b, const Plane& p) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0;
  };
  struct Edge {
    Plane a, b;
    std::size_t circuit, index, of;
  };
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < circuits.size(); ++c)
    for (std::size_t k = 0, n = circuits[c].size(); k < n; ++k)
      edges.push_back({circuits[c][k], circuits[c][(k + 1) % n], c, k, n});
  Crossings out;
  for (const Edge& e : edges)
    for (const Edge& f : edges) {
      if (&e >= &f || (e.circuit == f.circuit && (f.index - e.index == 1 || f.index - e.index == e.of - 1)))
        continue;
      if (side(e.a, e.b, f.a) == side(e.a, e.b, f.b) || side(f.a, f.b, e.a) == side(f.a, f.b, e.b)) continue;
      ++out.count;
      if (e.circuit != f.circuit) out.join = true;
    }
  return out;
}

TEST(CurveAnalysis, CouplerCurvesAreWhatTheLinkageDraws) {
  const FourBar linkages[] = {
      {5, 2, 5, 4, 5, 1},
      {5, 2, 5, 4, 2, 1},
      {5, 2, 5, 4, 6, -2},  // crank and rocker
      {2, 5, 4, 5, 1, 2},
      {2, 5, 4, 5, 3, -1},  // two cranks
      {5, 4, 2, 5, 1, 3},
      {5, 4, 2, 5, 4, 1},  // two rockers, turning coupler
      {6, 3, 4, 4, 2, 1},
      {6, 3, 4, 4, 5, 2},
      {6, 5, 4, 4, -1, 2},                           // no Grashof linkages
      {5.0625, 1.96875, 5.125, 4.25, 5.5, 1.03125},  // fractions
  };
  for (const FourBar& l : linkages) {
    const std::vector<std::vector<Plane>> drawn = circuits(l, 600);
    ASSERT_EQ(drawn.size(), corpus::grashof(l) ? 2u : 1u);
    const Crossings drawn_crossings = crossings(drawn);
    const CurveTopology t = analyse_curve(corpus::coupler_curve<Rational>(l));
    SCOPED_TRACE(::testing::Message() << l.ground << ' ' << l.crank << ' ' << l.coupler << ' ' << l.rocker
                                      << ", point " << l.s << ' ' << l.t);
    ASSERT_EQ(t.rung, Rung::exact) << t.reason;
    EXPECT_EQ(t.components - t.isolated, drawn_crossings.join ? 1 : static_cast<int>(drawn.size()));
    EXPECT_EQ(count(t, SingularKind::crossing), drawn_crossings.count);
    EXPECT_EQ(t.isolated, count(t, SingularKind::isolated));
    EXPECT_LE(t.singular.size(), 3u);  // S. Roberts: three double points besides those at the circular points
    EXPECT_TRUE(t.at_infinity.empty());
  }
}

TEST(CurveAnalysis, TwoThreadsGetTheSameAnswers) {
  const auto all = [] {
    std::vector<std::array<int, 3>> out;
    for (const CorpusCurve& c : corpus::corpus_cubics()) {
      const CurveTopology t = analyse_curve(c.curve);
      out.push_back({t.components, t.ovals, static_cast<int>(t.singular.size())});
    }
    return out;
  };
  auto one = std::async(std::launch::async, all), two = std::async(std::launch::async, all);
  const auto alone = all();
  EXPECT_EQ(one.get(), alone);
  EXPECT_EQ(two.get(), alone);
}

#endif

}  // namespace
}  // namespace burmester
