// The curve of the partners of a traced curve, and curves whose coefficients lie in intervals, as the tube test wants
// them. Only for targets that compile intervals.
#pragma once

#include <array>
#include <vector>

#include "burmester/geometry/correlations.hpp"
#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/curve_tube.hpp"
#include "burmester/geometry/interval.hpp"

namespace burmester {

/// A double point of the traced curve that has a whole line of partners, in the frame of the branches. The curve runs
/// through it, and there its partner is one of them: the three lines p^T N all become that line.
struct PointWithLine {
  Point2<Interval> at;
  bool sees_base;                               ///< along a line that is part of the curve
  Correlation<Interval> through;                ///< at^T N: the line
  std::array<Correlation<Interval>, 2> beside;  ///< sums of the three N, at^T N = 0 exactly
};

/// The curve of the partners: of the points p of the traced curve, in the frame of its branches, c with p^T N c = 0 for
/// three correlations N.
struct PartnerCurve {
  std::array<Correlation<double>, 3> approximate;
  std::array<double, 3> squares;  ///< of the norms of `approximate`: sums of the squares of all entries
  std::array<Correlation<Interval>, 3> enclosing;
  TubeCurve curve;
  std::vector<PointWithLine> with_line = {};
};

/// What the tube test needs of a cubic whose coefficients lie in intervals.
TubeCurve tube_curve(const Cubic<Interval>& f);
/// Below an UpwardRounding. n: between the plane's own points; seen: the same, of points in the frame.
PartnerCurve partner_curve(const std::array<Correlation<Interval>, 3>& n,
                           const std::array<Correlation<Interval>, 3>& seen);
PartnerCurve partner_curve(const std::array<Correlation<Interval>, 3>& n, const BranchFrame<Interval>& frame);

}  // namespace burmester
