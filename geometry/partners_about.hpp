// Partners of all points of a box, seen from one point: sharp where they are nearly that point.
//
// Where poles coincide a whole line of points has one partner c. Lines of partners p^T N, evaluated over a box of such
// p, hide it; sums of correlations N whose lines of partners all pass c show it.
// Only for targets that compile intervals.
#pragma once

#include "burmester/geometry/partner_curve.hpp"

namespace burmester {

/// Encloses the partners of the points of the box p, from two sums of the correlations whose lines of partners pass c
/// as near as they can, in a basis with c in it. Zero where they cannot be told. Below an UpwardRounding.
Point2<Interval> partners_about(const PartnerCurve& partners, const Point2<double>& c, const Point2<Interval>& p);

}  // namespace burmester
