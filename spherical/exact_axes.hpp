// Five orientations over rationals: every real dyad, found and enclosed by elimination alone (five_pose_sextic.hpp).
//
// Needs no approximate solution, so nothing can be missed: the real roots of the sextic are isolated exactly, and each
// is narrowed until both axes are known far beyond doubles. About a millisecond.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burmester/geometry/rational_interval.hpp"
#include "burmester/geometry/real_roots.hpp"
#include "burmester/spherical/five_pose_sextic.hpp"

namespace burmester::spherical {

/// Of three polynomials each, in arrays or vectors.
template <class V>
std::array<Polynomial<Rational>, 3> cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class U, class V>
Polynomial<Rational> dot(const U& a, const V& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline bool vanishes(const Polynomial<Rational>& p, RealRoot& t) { return sign_at(p, t) == 0; }

/// A real dyad: directions of its axes, of any length, each coordinate within 2^-60 of the largest.
struct EnclosedAxes {
  Vector<RationalInterval, 3> moving, fixed;  ///< in E, and in S seen from the reference pose
  int multiplicity = 1;                       ///< of the solution of the equations
};

/// All different real solutions of the equations. Nothing where no chart shows each of them alone: there are infinitely
/// many.
std::optional<std::vector<EnclosedAxes>> exact_axes(const Bilinear<Rational>& equations);

/// The real moving axes (1, t, s) in one line through the centre of a chart.
struct AxesOnLine {
  enum { none, one, hidden } axes = hidden;   ///< hidden: more than one, or it is not told
  std::array<Polynomial<Rational>, 2> place;  ///< of one: (1 : s), as polynomials of t
};
/// The s with r[0] + r[1] s + r[2] s^2 = 0 at t. Precondition: r[2] not zero there.
AxesOnLine roots_on_line(const std::array<Polynomial<Rational>, 3>& r, RealRoot& t);

/// The solution whose moving axis is in that place of the chart: t is refined until both axes are known. Nothing where
/// they do not become narrow, as where the axis has more than one partner.
std::optional<EnclosedAxes> enclosed_axes(RealRoot& t, const Chart& chart,
                                          const std::array<Polynomial<Rational>, 2>& place,
                                          const Bilinear<Rational>& equations);

}  // namespace burmester::spherical
