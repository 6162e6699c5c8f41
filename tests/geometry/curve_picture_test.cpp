// Polylines of general curves (picture_of, trace_arcs): their error, what they miss, and the two routes side by side.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

#include "burmester/geometry/arc_trace.hpp"
#include "burmester/geometry/curve_topology.hpp"
#include "burmester/geometry/real_roots.hpp"
#include "cubics.hpp"
#include "curve_corpus.hpp"
#include "polylines.hpp"
#include "repetitions.hpp"

namespace burmester {
namespace {

using namespace corpus;

using Form = TernaryForm<Rational>;

TEST(CurvePicture, OptionsMustBePositive) {
  const Form circle = corpus::circle(0, 0, 1).cast<Rational>();
  EXPECT_THROW(picture_of(circle, {0, 0.5, 4}), std::invalid_argument);
  EXPECT_THROW(picture_of(circle, {1e-3, -1, 4}), std::invalid_argument);
  EXPECT_THROW(picture_of(circle, {1e-3, 0.5, NAN}), std::invalid_argument);
  EXPECT_THROW(picture_of(circle, {}, Point2<Rational>(1, 1, 1)), std::invalid_argument);
}

TEST(CurvePicture, WhatIsNoCurveIsNotShown) {
  const CurvePicture picture = picture_of(Form(3));
  EXPECT_EQ(picture.topology.rung, Rung::none);
  EXPECT_FALSE(picture.topology.reason.empty());
  EXPECT_TRUE(picture.traced.pieces.empty());
  EXPECT_FALSE(picture.traced.complete);
}

#ifdef BURMESTER_WITHOUT_GMP

TEST(CurvePicture, WithoutGmpOnlyCubicsThroughAGivenPoint) {
  const Form f = weierstrass(0, -1, 0).cast<Rational>();
  EXPECT_FALSE(picture_of(f).traced.complete);
  EXPECT_TRUE(picture_of(f, {}, Point2<Rational>(0, 1, 0)).traced.complete);
}

#else

TracedCurve traced_by_arcs(const Form& f, const TraceOptions& options) {
  const CurveArcs arcs = arcs_of(f);
  EXPECT_EQ(arcs.rung, Rung::exact) << arcs.reason;
  return trace_arcs(arcs, options);
}

struct NamedCurve {
  std::string name;
  Form form;
};

const FourBar four_bars[] = {{5, 2, 5, 4, 5, 1}, {5, 2, 5, 4, 6, -2}, {2, 5, 4, 5, 1, 2},
                             {5, 4, 2, 5, 4, 1}, {6, 3, 4, 4, 2, 1},  {6, 5, 4, 4, -1, 2}};

/// The corpus, the corpus in other coordinates, coupler curves, and random forms. No repeated factors:
/// F changes its sign.
std::vector<NamedCurve> curves(const std::string& seed) {
  Random random(seed);
  std::vector<NamedCurve> out;
  for (const CorpusCurve& c : curve_corpus()) {
    if (c.repeated) continue;
    out.push_back({c.name, c.curve.cast<Rational>()});
    const CorpusCurve other = moved(c, random_projective_map(random));
    out.push_back({other.name, other.curve.cast<Rational>()});
  }
  for (const FourBar& l : four_bars) out.push_back({"coupler curve", coupler_curve<Rational>(l)});
  for (int degree = 1; degree <= 6; ++degree)
    out.push_back({"random form", random_form(random, degree).cast<Rational>()});
  return out;
}

/// The real points of the curve on y = h.
std::vector<Point2<double>> points_at_height(const Form& f, double h) {
  std::vector<Rational> c;
  for (int i = 0; i <= f.degree; ++i) {
    c.push_back(0);
    for (int j = f.degree - i; j >= 0; --j) c.back() = c.back() * Rational(h) + f(i, j);
  }
  const Polynomial<Rational> p(c);
  std::vector<Point2<double>> out;
  if (!p.is_zero())
    for (const RealRoot& x : real_roots(p)) out.emplace_back(x.approximate(), h, 1);
  return out;
}

bool in_window(const Point2<double>& p, double window) {
  return std::max(std::abs(p[0]), std::abs(p[1])) <= window * std::abs(p[2]);
}

/// Whether one of eight lines through p meets the curve within e of p: also where the curve is thin, as at a cusp.
bool line_meets_curve(const Form& f, const Point2<double>& p, double e) {
  for (int k = 0; k < 8; ++k) {
    const double angle = 0.4 * k;
    Matrix<Rational, 3, 3> m = Matrix<Rational, 3, 3>::Zero();
    m.col(0) = cast<Rational>(Point2<double>(e * std::cos(angle), e * std::sin(angle), 0));
    m.col(2) = cast<Rational>(p);
    const Form on_line = f.substituted(m);
    std::vector<Rational> c;
    for (int i = 0; i <= f.degree; ++i) c.push_back(on_line(i, 0));
    for (const RealRoot& t : real_roots(Polynomial<Rational>(c)))
      if (std::abs(t.approximate()) <= 1) return true;
  }
  return false;
}

TEST(CurvePicture, EveryPointOfThePolylineIsWithinTheErrorOfTheCurve) {
  const std::string seed = "CurvePicture.EveryPointOfThePolylineIsWithinTheErrorOfTheCurve";
  Random random(seed);
  constexpr double finest = repetitions(10) < 10 ? 3e-3 : 1e-4;  // tracing finely is what takes the time
  int checked = 0;
  for (const NamedCurve& c : curves(seed))
    for (const double tolerance : std::set{3e-3, finest}) {
      const TracedCurve traced = traced_by_arcs(c.form, {tolerance, 0.5, 4});
      EXPECT_TRUE(traced.complete) << c.name;
      for (const CurvePiece& piece : traced.pieces) {
        ASSERT_LE(piece.max_error, tolerance) << c.name;
        for (const Point2<double>& p : piece.points) ASSERT_TRUE(in_window(p, 4 * 1.02)) << c.name;
        for_points_on_chords(piece.points, piece.closed, random, [&](const Point2<double>& p) {
          const double e = piece.max_error * (1 + 1e-9);
          ASSERT_TRUE(meets_disc(c.form, p, e) || line_meets_curve(c.form, p, e)) << c.name;
          ++checked;
        });
      }
    }
  EXPECT_GT(checked, repetitions(50000));
}

TEST(CurvePicture, EveryPointOfTheCurveInTheWindowIsWithinTheErrorOfThePolyline) {
  const std::string seed = "CurvePicture.EveryPointOfTheCurveInTheWindowIsWithinTheErrorOfThePolyline";
  Random random(seed);
  int checked = 0;
  for (const NamedCurve& c : curves(seed)) {
    const TracedCurve traced = traced_by_arcs(c.form, {1e-3, 0.5, 4});
    double error = 0;
    for (const CurvePiece& piece : traced.pieces) error = std::max(error, piece.max_error);
    for (int k = 0; k < 30; ++k)
      for (const Point2<double>& p : points_at_height(c.form, random.uniform(-4, 4)))
        if (in_window(p, 4)) {
          EXPECT_LT(distance_to_pieces(p, traced.pieces), error + 1e-9) << c.name;
          ++checked;
        }
  }
  EXPECT_GT(checked, 3000);
}

/// Numbers of pieces, open and closed ones, of the components that are seen.
std::multimap<int, int> pieces_of_components(const TracedCurve& traced) {
  std::map<int, std::pair<int, int>> count;
  for (const CurvePiece& piece : traced.pieces)
    ++(piece.closed ? count[piece.component].first : count[piece.component].second);
  std::multimap<int, int> out;
  for (const auto& [component, n] : count) out.insert({n.first, n.second});
  return out;
}

void expect_same_picture(const NamedCurve& c, const Point2<Rational>& on_curve) {
  const TraceOptions options{1e-3, 0.5, 4};
  const TracedCurve one = picture_of(c.form, options, on_curve).traced, two = traced_by_arcs(c.form, options);
  EXPECT_TRUE(one.complete && two.complete) << c.name;
  EXPECT_EQ(pieces_of_components(one), pieces_of_components(two)) << c.name;
  for (const auto& [a, b] : {std::pair(one, two), std::pair(two, one)})
    for (const CurvePiece& piece : a.pieces)
      for (const Point2<double>& p : piece.points)
        if (in_window(p, 4)) {
          EXPECT_LT(distance_to_pieces(p, b.pieces), 2e-3) << c.name;
        }
}

TEST(CurvePicture, BothRoutesAgree) {
  Random random("CurvePicture.BothRoutesAgree");
  for (const CorpusCurve& c : corpus_cubics())
    if (c.on_curve && !c.repeated) expect_same_picture({c.name, c.curve.cast<Rational>()}, cast<Rational>(*c.on_curve));
  for (int k = 0; k < 10; ++k) {
    const CorpusCurve c = random_cubic("CurvePicture.BothRoutesAgree." + std::to_string(k));
    expect_same_picture({c.name, c.curve.cast<Rational>()}, cast<Rational>(*c.on_curve));
    const CorpusCurve d = random_circular_cubic("CurvePicture.BothRoutesAgree.circular." + std::to_string(k));
    expect_same_picture({d.name, d.curve.cast<Rational>()}, cast<Rational>(*d.on_curve));
  }
}

TEST(CurvePicture, ComponentsOvalsAndIsolatedPointsAreThoseOfTheTopology) {
  for (const auto& list : {corpus_conics_and_lines(), corpus_quartics(), corpus_quintics_and_sextics()})
    for (const CorpusCurve& c : list) {
      const TracedCurve traced = traced_by_arcs(c.curve.cast<Rational>(), {1e-2, 2, 20});
      std::map<int, std::vector<const CurvePiece*>> components;
      for (const CurvePiece& piece : traced.pieces) components[piece.component].push_back(&piece);
      int isolated = 0;
      for (const auto& [number, pieces] : components) isolated += pieces.size() == 1 && pieces[0]->points.size() == 1;
      const bool point_at_infinity = c.name == "two complex conics";  // (1 : 0 : 0) is one of them
      EXPECT_EQ(components.size() + point_at_infinity, static_cast<std::size_t>(c.components)) << c.name;
      EXPECT_EQ(isolated + point_at_infinity, c.isolated) << c.name;
      EXPECT_TRUE(components.empty() || components.rbegin()->first < c.components) << c.name;
    }
}

TEST(CurvePicture, CouplerCurvesAreClosedAndRunThroughTheirDoublePoints) {
  for (const FourBar& l : four_bars) {
    const CurvePicture picture = picture_of(coupler_curve<Rational>(l), {1e-3, 0.5, 20});
    ASSERT_TRUE(picture.traced.complete);
    int isolated = 0, closed = 0;
    for (const CurvePiece& piece : picture.traced.pieces) (piece.closed ? closed : isolated) += 1;
    EXPECT_EQ(isolated, picture.topology.isolated);
    // Two circuits, or one; a double point does not end them.
    EXPECT_EQ(closed, grashof(l) ? 2 : 1);
  }
}

TEST(CurvePicture, AnOvalSmallerThanTheToleranceIsShown) {
  const Form f = weierstrass(-1, 0, 0x1p-40).cast<Rational>();  // y^2 = x^2 (x - 1) + 2^-40: an oval of width 2^-19
  const TracedCurve traced = traced_by_arcs(f, {1e-3, 0.5, 4});
  EXPECT_TRUE(traced.complete);
  ASSERT_EQ(traced.pieces.size(), 2u);
  const CurvePiece& oval = traced.pieces[traced.pieces[0].closed ? 0 : 1];
  EXPECT_TRUE(oval.closed);
  for (const Point2<double>& p : oval.points) EXPECT_LT(std::hypot(p[0], p[1]), 0x1p-19);
}

TEST(CurvePicture, ToleranceOfTheSizeOfTheWindowAndFarBelow) {
  const Form f = weierstrass(0, -1, 0).cast<Rational>();
  for (const TraceOptions& options : {TraceOptions{5, 5, 1}, TraceOptions{1e-8, 1, 2}, TraceOptions{1e-3, 1, 1000}}) {
    const TracedCurve traced = traced_by_arcs(f, options);
    EXPECT_TRUE(traced.complete);
    EXPECT_EQ(traced.pieces.size(), 2u);
  }
}

TEST(CurvePicture, WhatTheNumberOfSamplesDoesNotAllowIsTold) {
  const TracedCurve traced = traced_by_arcs(weierstrass(0, -1, 0).cast<Rational>(), {1e-9, 1, 2, 100});
  EXPECT_FALSE(traced.complete);
}

/// CGAL keeps what it has refined, for all threads: the last digits of the samples may differ,
/// what is said of the curve not.
TEST(CurvePicture, TwoThreadsTraceAlikeAndTheRoundingModeIsRestored) {
  const auto trace = [] {
    std::vector<TracedCurve> all;
    for (const CorpusCurve& c : corpus_quartics())
      all.push_back(picture_of(c.curve.cast<Rational>(), {1e-2, 1, 4}).traced);
    return all;
  };
  std::vector<TracedCurve> one, two;
  std::thread first([&] { one = trace(); }), second([&] { two = trace(); });
  first.join(), second.join();
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  ASSERT_EQ(one.size(), two.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].complete, two[i].complete);
    ASSERT_EQ(one[i].pieces.size(), two[i].pieces.size());
    for (std::size_t k = 0; k < one[i].pieces.size(); ++k) {
      const CurvePiece &a = one[i].pieces[k], &b = two[i].pieces[k];
      EXPECT_EQ(a.component, b.component);
      EXPECT_EQ(a.closed, b.closed);
      ASSERT_EQ(a.points.size(), b.points.size());
      for (std::size_t n = 0; n < a.points.size(); ++n) EXPECT_LT((a.points[n] - b.points[n]).norm(), 1e-9) << i;
      points += a.points.size();
    }
  }
  EXPECT_GT(points, 500u);
}

#endif

}  // namespace
}  // namespace burmester
