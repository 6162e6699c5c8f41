#include "burmester/geometry/curve_trace.hpp"
#include "burmester/geometry/trace_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <thread>

#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "cubics.hpp"
#include "curve_corpus.hpp"
#include "polylines.hpp"
#include "positions.hpp"

using namespace burmester;
using namespace burmester::corpus;

namespace {

using Point = Point2<double>;

struct Traced {
  CubicBranches branches;
  std::optional<PartnerCurve> partner;
  std::vector<CurvePiece> pieces;
};

Traced trace_plane_positions(const std::array<FourDoubles, 3>& d, const TraceOptions& options) {
  const UpwardRounding upward;
  const auto n = equidistant_in_plane<Interval>(d);
  const Cubic<Interval> f = points_with_partner(n);
  const auto exact = equidistant_in_plane<Rational>(d);
  Traced out{branches_of(points_with_partner(exact), vertex(exact[0])), std::nullopt, {}};
  out.partner = partner_curve(n, out.branches.frame);
  TracedCurve traced = trace_in_plane(out.branches, tube_curve(f), out.partner, options);
  EXPECT_TRUE(traced.complete);
  out.pieces = std::move(traced.pieces);
  return out;
}

std::array<FourDoubles, 3> random_positions(Random& random, FourDoubles make(Random&)) {
  return {make(random), make(random), make(random)};
}

std::array<Correlation<Rational>, 3> transposed(const std::array<Correlation<Rational>, 3>& n) {
  return {n[0].transpose(), n[1].transpose(), n[2].transpose()};
}

}  // namespace

TEST(CurveTrace, EveryPointOfThePolylineIsWithinTheErrorOfTheCurve) {
  Random random("CurveTrace.EveryPointOfThePolylineIsWithinTheErrorOfTheCurve");
  int checked = 0;
  for (int k = 0; k < 60; ++k) {
    const auto d = random_positions(random, random_plane_displacement);
    const auto n = equidistant_in_plane<Rational>(d);
    const Cubic<Rational> moving = points_with_partner(n), fixed = points_with_partner(transposed(n));
    for (const double tolerance : {1e-3, 1e-5}) {
      for (const CurvePiece& piece : trace_plane_positions(d, {tolerance, 0.5, 5}).pieces) {
        ASSERT_LE(piece.max_error, tolerance);
        ASSERT_EQ(piece.points.size(), piece.partners.size());
        const double e = piece.max_error * (1 + 1e-9);
        for_points_on_chords(piece.points, piece.closed, random, [&](const Point& p) {
          ASSERT_TRUE(meets_disc(moving, p, e)) << k;
          ++checked;
        });
        for_points_on_chords(piece.partners, piece.closed, random, [&](const Point& p) {
          ASSERT_TRUE(meets_disc(fixed, p, e)) << k;
          ++checked;
        });
      }
    }
  }
  EXPECT_GT(checked, 100000);
}

TEST(CurveTrace, EveryPointOfTheCurveInTheWindowIsWithinTheErrorOfThePolyline) {
  Random random("CurveTrace.EveryPointOfTheCurveInTheWindowIsWithinTheErrorOfThePolyline");
  int checked = 0;
  for (int k = 0; k < 40; ++k) {
    const TraceOptions options{1e-3, 0.5, 5};
    const Traced traced = trace_plane_positions(random_positions(random, random_plane_displacement), options);
    double error = 0;
    for (const CurvePiece& piece : traced.pieces) error = std::max(error, piece.max_error);
    for (const CubicBranch& branch : traced.branches.branches)
      for (const CubicBranch::Passage& passage : branch.passages)
        for (int n = 0; n < 50; ++n) {
          const Point seen = branch.approximate.seen(random.uniform(-1, 1), passage.sheet),
                      p = branch.approximate.frame.placed(seen), c = partner(traced.partner->approximate, seen);
          const auto inside = [&](const Point& x) {
            return std::max(std::abs(x[0]), std::abs(x[1])) < options.window * std::abs(x[2]);
          };
          if (!inside(p) || !inside(c)) continue;
          ++checked;
          EXPECT_LT(distance_to_pieces(p / p[2], traced.pieces, false), error + 1e-9) << k;
          EXPECT_LT(distance_to_pieces(c / c[2], traced.pieces, true), error + 1e-9) << k;
        }
  }
  EXPECT_GT(checked, 1500);
}

TEST(CurveTrace, PairedPointsAreEquidistantInAllPositions) {
  Random random("CurveTrace.PairedPointsAreEquidistantInAllPositions");
  for (int k = 0; k < 50; ++k) {
    const auto d = random_positions(random, random_plane_displacement);
    for (const CurvePiece& piece : trace_plane_positions(d, {1e-4, 0.5, 5}).pieces)
      for (std::size_t i = 0; i < piece.points.size(); ++i) {
        const double x = piece.points[i][0], y = piece.points[i][1], cx = piece.partners[i][0],
                     cy = piece.partners[i][1];
        const double length = std::hypot(x - cx, y - cy);
        for (const FourDoubles& pose : d) {
          const double cosine = pose[3] * pose[3] - pose[2] * pose[2], sine = 2 * pose[2] * pose[3];
          const double moved = std::hypot(pose[0] + cosine * x - sine * y - cx, pose[1] + sine * x + cosine * y - cy);
          EXPECT_NEAR(moved, length, 1e-9 * (1 + length)) << k;
        }
      }
  }
}

TEST(CurveTrace, CorpusCurvesAreTracedThroughTheirSingularPoints) {
  for (const CorpusCurve& c : corpus_cubics()) {
    if (!c.on_curve || c.repeated) continue;
    const Cubic<Rational> exact = cubic_of<Rational>(c.curve);
    const CubicBranches branches = branches_by_rationals(exact, cast<Rational>(*c.on_curve));
    const UpwardRounding upward;
    const auto pieces =
        trace_in_plane(branches, tube_curve(cubic_of<Interval>(c.curve)), std::nullopt, {1e-3, 0.5, 4}).pieces;
    Random random("CurveTrace." + c.name);
    std::map<int, int> closed, open;
    for (const CurvePiece& piece : pieces) {
      ++(piece.closed ? closed : open)[piece.component];
      EXPECT_TRUE(piece.partners.empty());
      if (c.name.find("tangent") != std::string::npos) continue;  // where branches touch, F hardly changes its sign
      for_points_on_chords(piece.points, piece.closed, random, [&](const Point& p) {
        ASSERT_TRUE(meets_disc(exact, p, piece.max_error * (1 + 1e-9))) << c.name;
      });
    }
    for (const CubicBranch& branch : branches.branches)
      for (const CubicBranch::Passage& passage : branch.passages)
        for (int n = 0; n < 100; ++n) {
          const Point p = branch.approximate(random.uniform(-1, 1), passage.sheet);
          if (std::max(std::abs(p[0]), std::abs(p[1])) > 3.99 * std::abs(p[2])) continue;
          EXPECT_LT(distance_to_pieces(p / p[2], pieces, false), 1.001e-3) << c.name;
        }
  }
}

TEST(CurveTrace, AnOvalIsOneClosedPiece) {
  // y^2 = x (x - 1) (x + 1): the oval is in -1 <= x <= 0
  const PlaneCurve f = weierstrass(0, -1, 0);
  const CubicBranches branches = branches_by_rationals(cubic_of<Rational>(f), cast<Rational>(Point(0, 1, 0)));
  const UpwardRounding upward;
  const auto pieces = trace_in_plane(branches, tube_curve(cubic_of<Interval>(f)), std::nullopt, {1e-4, 0.1, 3}).pieces;
  ASSERT_EQ(pieces.size(), 2u);
  for (const CurvePiece& piece : pieces) {
    const bool oval = piece.points.front()[0] < 0.5;
    EXPECT_EQ(piece.closed, oval);
    for (const Point& p : piece.points) EXPECT_EQ(p[0] < 0.5, oval);
  }
  EXPECT_NE(pieces[0].component, pieces[1].component);
}

TEST(CurveTrace, OnTheSphereEachBranchIsOneClosedPieceWithinItsError) {
  Random random("CurveTrace.OnTheSphereEachBranchIsOneClosedPieceWithinItsError");
  for (int k = 0; k < 30; ++k) {
    const auto d = random_positions(random, random_rotation);
    const auto exact = equidistant_on_sphere<Rational>(d);
    const Cubic<Rational> moving = points_with_partner(exact), fixed = points_with_partner(transposed(exact));
    const UpwardRounding upward;
    const auto n = equidistant_on_sphere<Interval>(d);
    const Cubic<Interval> f = points_with_partner(n);
    const auto branches = branches_by_intervals(f, vertex(n[0]));
    ASSERT_TRUE(branches);
    const auto pieces =
        trace_on_sphere(*branches, tube_curve(f), partner_curve(n, branches->frame), {1e-4, 0.2}).pieces;
    ASSERT_EQ(pieces.size(), branches->branches.size());
    int odd = 0;
    for (const CurvePiece& piece : pieces) {
      EXPECT_TRUE(piece.closed);
      EXPECT_LE(piece.max_error, 1e-4);
      const std::size_t size = piece.points.size();
      odd += size % 2 == 0 && (piece.points[0] + piece.points[size / 2]).norm() < 1e-12;
      for (std::size_t i = 0; i < size; ++i) {
        EXPECT_NEAR(piece.points[i].norm(), 1, 1e-14);
        EXPECT_LT((piece.points[i] - piece.points[(i + 1) % size]).norm(), 0.21) << k;
        EXPECT_LT((piece.partners[i] - piece.partners[(i + 1) % size]).norm(), 0.21) << k;
      }
      const double e = piece.max_error * (1 + 1e-9);
      for_points_on_chords(piece.points, true, random,
                           [&](const Point& p) { ASSERT_TRUE(meets_disc(moving, p.normalized(), e)) << k; });
      for_points_on_chords(piece.partners, true, random,
                           [&](const Point& p) { ASSERT_TRUE(meets_disc(fixed, p.normalized(), e)) << k; });
    }
    EXPECT_EQ(odd, 1) << "the odd branch comes back to the opposite point; " << k;
  }
}

TEST(CurveTrace, TheTubeOfAChordOfACircleIsItsSagitta) {
  Cubic<double> f;  // z (x^2 + y^2 - z^2)
  f.c[2] = 1, f.c[7] = 1, f.c[9] = -1;
  const TubeCurve circle(f);
  for (const double angle : {0.001, 0.01, 0.1, 0.3}) {
    const Point x(1, 0, 1), y(std::cos(angle), std::sin(angle), 1), n(std::cos(angle / 2), std::sin(angle / 2), 0);
    const auto radius = tube(circle, TubePoint(x, circle), TubePoint(y, circle), HalfChord::between(x, y, n));
    ASSERT_TRUE(radius) << angle;
    EXPECT_GE(radius->radius, 1 - std::cos(angle / 2));
    EXPECT_LE(radius->radius, 1.5 * (1 - std::cos(angle / 2)) + 1e-14) << angle;
  }
}

TEST(CurveTrace, TheTubeTestRefusesChordsAcrossANodeAndBetweenBranches) {
  const TubeCurve node(cubic_of<double>(weierstrass(1, 0, 0)));  // y^2 = x^2 (x + 1), slopes 1 and -1 at the node
  const auto point = [&](double x, double sign) { return TubePoint({x, sign * x * std::sqrt(x + 1), 1}, node); };
  const Vector<double, 3> along(-std::sqrt(0.5), std::sqrt(0.5), 0), across(0, 1, 0);
  const auto is_tube = [&](const TubePoint& x, const TubePoint& y, const Vector<double, 3>& n) {
    return tube(node, x, y, HalfChord::between(x.at, y.at, n)).has_value();
  };
  EXPECT_FALSE(is_tube(point(-0.01, 1), point(0.01, 1), along));
  EXPECT_FALSE(is_tube(point(0.1, 1), point(0.1, -1), Vector<double, 3>(1, 0, 0)));
  EXPECT_FALSE(is_tube(point(0.1, 1), point(0.11, -1), across));
  EXPECT_TRUE(is_tube(point(0.1, 1), point(0.11, 1), along));
}

TEST(CurveTrace, TwoTubesSideBySideAreThoseOneByOne) {
  Random random("CurveTrace.TwoTubes");
  int proved = 0;
  for (int k = 0; k < 2000; ++k) {
    std::array<Cubic<double>, 2> f;
    for (Cubic<double>& cubic : f)
      for (double& c : cubic.c) c = random.normal();
    const TubeCurve a(f[0]), b(f[1], 1e-9);
    const Point x(random.normal(), random.normal(), 1),
        step = std::ldexp(random.uniform(), -random.below(20)) * Point(1, 0, 0);
    const auto on = [&](const TubeCurve& curve, Point p) {  // near the curve, by Newton's method along y
      for (int i = 0; i < 30; ++i) p[1] -= TubePoint(p, curve).value / curve.form().gradient(p)[1];
      return p;
    };
    const std::array<Point, 2> first{on(a, x), on(b, x)}, second{on(a, first[0] + step), on(b, first[1] + step)};
    const Vector<double, 3> n(0, 1, 0);
    const auto one =
                   tube(a, TubePoint(first[0], a), TubePoint(second[0], a), HalfChord::between(first[0], second[0], n)),
               two =
                   tube(b, TubePoint(first[1], b), TubePoint(second[1], b), HalfChord::between(first[1], second[1], n));
    const TubeCurveOf<Lanes> both(a, b);
    const auto pair = [](const std::array<Point, 2>& p) { return detail::side_by_side(p[0], p[1]); };
    const auto together = tube(both, {pair(first), both}, {pair(second), both},
                               HalfChordOf<Lanes>::between(pair(first), pair(second), detail::side_by_side(n, n)));
    ASSERT_EQ(together.has_value(), one && two) << k;
    if (!together) continue;
    ++proved;
    EXPECT_EQ(together->radius[0], one->radius);
    EXPECT_EQ(together->radius[1], two->radius);
    EXPECT_EQ(together->width[0], one->width);
    EXPECT_EQ(together->width[1], two->width);
  }
  EXPECT_GT(proved, 300);
}

/// A random chord: in the plane of two points with z = 1 and n in the plane, on the sphere of unit vectors.
struct RandomChord {
  Point x, y;
  HalfChord chord;
};
RandomChord random_chord(Random& random, bool on_sphere) {
  const auto vector = [&] { return Point(random.normal(), random.normal(), random.normal()); };
  const double step = std::ldexp(random.uniform(), -random.below(25));
  RandomChord out;
  if (on_sphere) {
    out.x = vector().normalized(), out.y = (out.x + step * vector()).normalized();
    out.chord = detail::chord_between_axes(out.x, out.y);
  } else {
    out.x = Point(3 * random.normal(), 3 * random.normal(), 1);
    out.y = out.x + step * Point(random.normal(), random.normal(), 0);
    out.chord = *detail::Plane::chord(out.x, out.y);
  }
  return out;
}

TEST(CurveTrace, APointOverAChordIsSeenThereHoweverFarOffItMayBe) {
  Random random("CurveTrace.APointOverAChord");
  const TubeCurve any{Cubic<double>()};
  int beside = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto [x, y, chord] = random_chord(random, k % 2 == 0);
    const TubePoint a(x, any), b(y, any);
    const double radius = chord.length * std::ldexp(random.uniform(), -random.below(20)),
                 off = k % 3 == 0 ? 0 : std::ldexp(random.uniform(), -10 - random.below(30));
    const Point m = (x + y) / 2, over = m + random.uniform(-1, 1) * chord.d + random.uniform(-1, 1) * radius * chord.n,
                moved(random.normal(), random.normal(), random.normal());
    const Point z = (k % 5 == 0 ? -1 : 1) * (over.normalized() + 0.999 * off * moved.normalized()).normalized();
    EXPECT_TRUE(over_chord(a, b, chord, radius, z, off)) << k;
    EXPECT_FALSE(beside_chord(a, b, chord, radius, z, off)) << k;
    if (chord.length < 1e-4) continue;  // roundings of 1e-9 are allowed for
    const Point away = m + (2 + random.uniform()) * (k % 2 == 0 ? chord.length : -chord.length) * chord.n;
    const double told = 0.1 * chord.length / m.squaredNorm();  // well below the distance
    EXPECT_FALSE(over_chord(a, b, chord, chord.length / 2, away.normalized(), std::min(off, told))) << k;
    beside += beside_chord(a, b, chord, chord.length / 2, Point(away.normalized()), std::min(off, told));
  }
  EXPECT_GT(beside, 4000);
}

TEST(CurveTrace, ErrorsOfTheCoefficientsCount) {
  Cubic<double> f;
  f.c[2] = 1, f.c[7] = 1, f.c[9] = -1;
  const TubeCurve exact(f), vague(f, 1e-6), hopeless(f, 0.5);
  const Point x(1, 0, 1), y(std::cos(0.01), std::sin(0.01), 1), n(std::cos(0.005), std::sin(0.005), 0);
  const auto sharp = tube(exact, TubePoint(x, exact), TubePoint(y, exact), HalfChord::between(x, y, n)),
             wide = tube(vague, TubePoint(x, vague), TubePoint(y, vague), HalfChord::between(x, y, n));
  ASSERT_TRUE(sharp && wide);
  EXPECT_GT(wide->radius, sharp->radius + 1e-6);  // a circle of radius 1 +- 1e-6 or so
  EXPECT_FALSE(tube(hopeless, TubePoint(x, hopeless), TubePoint(y, hopeless), HalfChord::between(x, y, n)));
}

TEST(CurveTrace, TwoThreadsTraceAlikeAndTheRoundingModeIsRestored) {
  const auto trace = [] {
    Random random("CurveTrace.TwoThreads");
    std::vector<CurvePiece> all;
    for (int k = 0; k < 20; ++k)
      for (CurvePiece& piece :
           trace_plane_positions(random_positions(random, random_plane_displacement), {1e-4, 0.5, 5}).pieces)
        all.push_back(std::move(piece));
    return all;
  };
  std::vector<CurvePiece> one, two;
  std::thread first([&] { one = trace(); }), second([&] { two = trace(); });
  first.join(), second.join();
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].points, two[k].points);
}

/// (y - 3/7 (x + z))^2 z = (x + z)(x^2 + 2^-2n z^2): from (-1 : 0 : 1) the two turning lines differ by 2^-n.
TracedCurve traced_from_turning_lines_that_differ_by_two_to(int minus_n) {
  const Rational seventh = Rational(3) / 7, tiny = Rational(1) / Rational(Integer(1) << (2 * minus_n)), zero(0), one(1);
  const LinearForm<Rational> x(one, zero, zero), z(zero, zero, one), sum(one, zero, one),
      l(Rational(-seventh), one, Rational(-seventh));
  Cubic<Rational> f;
  f.add_product(l, l, z, one);
  f.add_product(sum, x, x, Rational(-1));
  f.add_product(sum, z, z, Rational(-tiny));
  const CubicBranches branches = branches_by_rationals(f, {Rational(-1), zero, one});
  EXPECT_EQ(branches.topology.components, 1);
  const UpwardRounding upward;
  return trace_in_plane(branches, tube_curve(enclosure(f)), std::nullopt, {1e-3, 0.5, 4});
}

TEST(CurveTrace, ABranchBetweenTurningPointsThatAgreeInDoublesIsTraced) {
  for (const int n : {20, 40, 60, 100}) {
    const TracedCurve traced = traced_from_turning_lines_that_differ_by_two_to(n);
    EXPECT_TRUE(traced.complete) << n;
    ASSERT_EQ(traced.pieces.size(), 1u) << n;  // the loop, and both arms to the border of the window
    EXPECT_LT(traced.pieces[0].points.size(), 400u) << n;
    EXPECT_GT(std::abs(traced.pieces[0].points.front()[1]), 3.9) << n;
    EXPECT_GT(std::abs(traced.pieces[0].points.back()[1]), 3.9) << n;
  }
}

TEST(CurveTrace, ABranchWhoseTurningPointsAgreeInFortyDigitsIsCountedButNotShown) {
  const TracedCurve traced = traced_from_turning_lines_that_differ_by_two_to(200);
  EXPECT_TRUE(traced.pieces.empty());
  EXPECT_FALSE(traced.complete);
}

TEST(CurveTrace, OptionsMustBePositive) {
  const PlaneCurve f = weierstrass(0, -1, 0);
  const CubicBranches branches = branches_by_rationals(cubic_of<Rational>(f), cast<Rational>(Point(0, 1, 0)));
  const UpwardRounding upward;
  const TubeCurve curve = tube_curve(cubic_of<Interval>(f));
  EXPECT_THROW(trace_in_plane(branches, curve, std::nullopt, {0, 0.5, 4}), std::invalid_argument);
  EXPECT_THROW(trace_in_plane(branches, curve, std::nullopt, {1e-3, 0, 4}), std::invalid_argument);
  EXPECT_THROW(trace_in_plane(branches, curve, std::nullopt, {1e-3, 0.5, std::nan("")}), std::invalid_argument);
}
