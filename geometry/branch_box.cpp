#include "burmester/geometry/branch_box.hpp"

#include <algorithm>
#include <cmath>

#include "burmester/geometry/jet.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester {
namespace {

using Moving = Jet<Interval, 1>;  // along the branch

Interval common(const Interval& a, const Interval& b) {
  const double low = std::max(lower(a), lower(b)), high = std::min(upper(a), upper(b));
  if (low <= high) return {low, high};
  return std::isnan(lower(b)) || std::isnan(upper(b)) ? a : Interval::largest();  // both hold the truth, so they meet
}

/// The same point, its largest coordinate 1 and the others by the mean value form. step: S - m.
Point2<Moving> sharpened(const Point2<Moving>& over, const Point2<Interval>& middle, const Interval& step) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(approximate(over[i])) > std::abs(approximate(over[k]))) k = i;
  if (contains_zero(over[k].value) || contains_zero(middle[k])) return over;
  Point2<Moving> out;
  for (int i = 0; i < 3; ++i) {
    if (i == k) out[i] = Moving(1);
    if (i == k) continue;
    out[i] = over[i] / over[k];
    out[i].value = common(out[i].value, middle[i] / middle[k] + out[i].slope[0] * step);
  }
  return out;
}

Point2<Interval> values(const Point2<Moving>& p) { return {p[0].value, p[1].value, p[2].value}; }

/// [from, to], its middle, and the difference.
struct Part {
  Part(double from, double to)
      : over(std::min(from, to), std::max(from, to)), middle(from + (to - from) / 2), step(over - middle) {}
  Interval over, middle, step;
};

Moving moving(const Interval& value, const Interval& slope) { return {value, Vector<Interval, 1>(slope)}; }

Point1<Interval> slope_of_line(const BranchForms<Interval>& f, const Interval& s) {
  if (!f.turns) return {-2 * s, Interval(2)};
  const bool first = approximate(s) < 0;
  const auto slope = [&](int k) {
    return first ? 2 * (1 + s) * f.u[2][k] - 4 * f.u[0][k] : 4 * f.u[1][k] - 2 * (1 - s) * f.u[2][k];
  };
  return {slope(0), slope(1)};
}

/// u(s) and 1 - s^2, both over |u_k(s)|, the larger one. Where u hardly turns, as between two roots that lie close,
/// this tells so: the slope of the quotient is (u0 u1' - u1 u0') / u_k^2.
struct MovingLine {
  MovingLine(const BranchForms<Interval>& f, const Part& part) {
    const Interval &s = part.over, rest_at_s = (1 - s) * (1 + s),
                   turn = f.turns ? -4 * f.across * rest_at_s : 2 + 2 * CGAL::square(s);
    const Point1<Interval> at = f.line_at(s), middle = f.line_at(part.middle), slope_at_s = slope_of_line(f, s);
    const int k = std::abs(approximate(middle[0])) > std::abs(approximate(middle[1])) ? 0 : 1, i = 1 - k;
    if (contains_zero(at[k])) {
      u[k] = moving(at[k], slope_at_s[k]), u[i] = moving(at[i], slope_at_s[i]);
      rest = moving(rest_at_s, -2 * s);
      return;
    }
    const Interval sign(upper(at[k]) < 0 ? -1 : 1), slope = sign * (k == 0 ? turn : -turn) / CGAL::square(at[k]);
    u[k] = moving(sign, Interval(0));
    u[i] = moving(common(sign * at[i] / at[k], sign * middle[i] / middle[k] + slope * part.step), slope);
    rest = moving(rest_at_s, -2 * s) / moving(sign * at[k], sign * slope_at_s[k]);
  }
  Point1<Moving> u;
  Moving rest;
};

/// In the frame.
Point2<Moving> seen(const BranchForms<Interval>& branch, const Part& part, int sheet) {
  if (branch.line)
    return sharpened(branch.on_line(moving(part.over, Interval(1))), branch.seen(part.middle, sheet), part.step);
  const MovingLine line(branch, part);
  return sharpened(branch.on_sheet(line.u, line.rest, sheet), branch.seen(part.middle, sheet), part.step);
}

Point2<Moving> placed(const BranchForms<Interval>& branch, const Point2<Moving>& seen, const Part& part, int sheet) {
  return sharpened(branch.frame.placed(seen), branch(part.middle, sheet), part.step);
}

}  // namespace

Point2<Interval> box_of_points(const BranchForms<Interval>& branch, double from, double to, int sheet) {
  const Part part(from, to);
  return values(placed(branch, seen(branch, part, sheet), part, sheet));
}

BranchBox box_with_partners(const BranchForms<Interval>& branch, const PartnerCurve& partners, double from, double to,
                            int sheet) {
  const Part part(from, to);
  const Point2<Moving> p = seen(branch, part, sheet);
  std::array<Correlation<Moving>, 3> n;
  for (std::size_t j = 0; j < 3; ++j)
    for (int i = 0; i < 9; ++i) n[j](i) = Moving(partners.enclosing[j](i));
  const Point2<Interval> middle = partner<Interval>(partners.enclosing, branch.seen(part.middle, sheet));
  return {{values(placed(branch, p, part, sheet)), values(sharpened(partner<Moving>(n, p), middle, part.step))},
          values(p)};
}

}  // namespace burmester
