// The arcs of any real plane algebraic curve of degree up to 6, and how they meet: what it takes to trace it, exactly.
//
// The plane is turned and scaled by integers a, b:
//     (x, y) = (a u - b v, b u + a v),     distances are sqrt(a^2 + b^2) times those in (u, v),
// such that no point at infinity lies on the lines u = constant. Over the open intervals between the critical u the
// curve consists of arcs v = v_k(u), each a graph, v_0 < v_1 < ..; their number is the same all over an interval. On a
// critical line they end in points, or pass.
//
// From the same analysis by CGAL as curve_analysis.hpp, in the projective coordinates (1 : v : u - c), c an integer
// such that the line u = c meets the curve in as many different complex points as its degree. There the order of arcs
// on a line is that in the plane, or the opposite one for u < c; and arcs that meet at infinity meet on the line at 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

/// A point of the curve on a critical line, with the arcs that end there.
struct ArcEnds {
  RationalInterval v;        ///< encloses it, about 2^-100 wide; only where known_place
  bool known_place = false;  ///< not so where one arc from the left goes on as one to the right
  int component = 0;
  int first_left = 0, left = 0;    ///< arcs first_left .. first_left + left - 1 of the interval on the left
  int first_right = 0, right = 0;  ///< and on the right
};

struct CriticalLine {
  RationalInterval u;           ///< encloses it, about 2^-100 wide; those of different lines are disjoint
  std::vector<ArcEnds> points;  ///< ascending
};

struct CurveArcs {
  Rung rung = Rung::none;  ///< exact; none: not available, `reason` says why
  std::string reason;
  int a = 1, b = 0;
  /// G(u, v, 1) = 0: the curve with each factor once and without the line at infinity,
  /// in the turned plane. Coefficients up to 1.
  TernaryForm<Rational> form;
  std::vector<CriticalLine> lines;          ///< ascending
  std::vector<std::vector<int>> component;  ///< [i][k]: of arc k between lines i - 1 and i
  int components = 0;  ///< of the projective curve, as in CurveTopology; some may have no point in the plane
};

/// Safe to call from several threads; the same answer each time. About as long as analyse_curve().
CurveArcs arcs_of(const TernaryForm<Rational>& curve);

}  // namespace burmester
