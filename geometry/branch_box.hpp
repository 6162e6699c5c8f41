// Boxes about a part of a branch and about its partners, by the mean value form: for a smooth function y on an interval
// S with the middle m,
//     y(S) is in y(m) + y'(S) (S - m),
// which is wider than the truth by the square of S only, where y evaluated on S is wider by a multiple of S: near a
// node the lines of partners of a box are nearly one line, and the multiple is large. (R. E. Moore, "Interval
// Analysis", 1966, chapter 6.) y are the affine coordinates along the branch: those of the exact curve, whichever
// formula gave them. Only for targets that compile intervals.
#pragma once

#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/partner_curve.hpp"

namespace burmester {

/// The part of the branch over [from, to] or [to, from], and its partners; all of the projective plane, or not a
/// number, where they cannot be told. Below an UpwardRounding.
struct BranchBox {
  std::array<Point2<Interval>, 2> track;  ///< points, partners
  Point2<Interval> seen;                  ///< the points in the frame of the branch
};
/// In the frame.
Point2<Interval> box_seen(const BranchForms<Interval>& branch, double from, double to, int sheet);
Point2<Interval> box_of_points(const BranchForms<Interval>& branch, double from, double to, int sheet);
BranchBox box_with_partners(const BranchForms<Interval>& branch, const PartnerCurve& partners, double from, double to,
                            int sheet);

}  // namespace burmester
