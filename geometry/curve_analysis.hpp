// Exact topology of any real plane algebraic curve of degree up to 6.
//
// The curve is made square-free and seen from random integer coordinates of the plane (determinant 1) in
// which the line at infinity meets it in as many complex points as its degree and no such point is the
// vertical one. There CGAL's Curve_analysis_2 (A. Eigenwillig, M. Kerber, N. Wolpert, "Fast and exact
// geometric analysis of real algebraic plane curves", ISSAC 2007) gives its arcs over the intervals between
// critical x and how they meet. Arcs are joined at infinity (the i-th right end from below is the i-th left
// end from above), and the rest is counting:
// - components: classes of joined arcs and points; a class met by a vertical line an even number of times, without
//   singular points, is an oval;
// - singular points: by their real half-branches, 0 isolated, 2 cusp (or smooth to the eye), 4 and more crossing;
//   a point with 2 is singular if the discriminant has a multiple root there and both derivatives vanish,
//   exactly;
// - lines and conics: curve_factors.hpp, which says what is not found. The rest does not depend on it.
//
// Nothing is rounded on the way: the answer is that of the given numbers.
#pragma once

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// Rung::exact, or Rung::none with a reason: not a curve, or a library built without GMP. Positions, lines,
/// conics and asymptotes are rounded from approximations within 2^-100, or from the exact numbers where they
/// are rational. Safe to call from several threads; the same answer each time. Milliseconds for a cubic, some
/// tens for a sextic.
CurveTopology analyse_curve(const TernaryForm<Rational>& curve);
CurveTopology analyse_curve(const PlaneCurve& curve);

}  // namespace burmester
