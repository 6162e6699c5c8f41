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

Interval quadratic(const Interval& c0, const Interval& c1, const Interval& c2, const Interval& s) {
  return c0 + s * (c1 + s * c2);
}
Point1<Interval> line_at(const BranchForms<Interval>& f, const Interval& s) {
  return {quadratic(f.u[0][0], f.u[1][0], f.u[2][0], s), quadratic(f.u[0][1], f.u[1][1], f.u[2][1], s)};
}
Moving moving(const Interval& value, const Interval& slope) { return {value, Vector<Interval, 1>(slope)}; }

/// u(s) and 1 - s^2, both over |u_k(s)|, the larger one. Where u hardly turns, as between two roots that lie close,
/// this tells so: the slope of the quotient is (u0 u1' - u1 u0') / u_k^2.
struct MovingLine {
  MovingLine(const BranchForms<Interval>& f, const Part& part) {
    const Interval &s = part.over, turn = quadratic(f.turn[0], f.turn[1], f.turn[2], s),
                   rest_at_s = 1 - CGAL::square(s);
    const Point1<Interval> at = line_at(f, s), middle = line_at(f, part.middle);
    const int k = std::abs(approximate(middle[0])) > std::abs(approximate(middle[1])) ? 0 : 1, i = 1 - k;
    const Interval slope_of_k = f.u[1][k] + 2 * s * f.u[2][k];
    if (contains_zero(at[k])) {
      u[k] = moving(at[k], slope_of_k), u[i] = moving(at[i], f.u[1][i] + 2 * s * f.u[2][i]);
      rest = moving(rest_at_s, -2 * s);
      return;
    }
    const Interval sign(upper(at[k]) < 0 ? -1 : 1), slope = sign * (k == 0 ? turn : -turn) / CGAL::square(at[k]);
    u[k] = moving(sign, Interval(0));
    u[i] = moving(common(sign * at[i] / at[k], sign * middle[i] / middle[k] + slope * part.step), slope);
    rest = moving(rest_at_s, -2 * s) / moving(sign * at[k], sign * slope_of_k);
  }
  Point1<Moving> u;
  Moving rest;
};

Point2<Moving> points(const BranchForms<Interval>& branch, const Part& part, int sheet) {
  if (branch.line)
    return sharpened(branch.on_line(moving(part.over, Interval(1))), branch(part.middle, sheet), part.step);
  const MovingLine line(branch, part);
  return sharpened(branch.on_sheet(line.u, line.rest, sheet), branch(part.middle, sheet), part.step);
}

}  // namespace

Point2<Interval> box_of_points(const BranchForms<Interval>& branch, double from, double to, int sheet) {
  return values(points(branch, Part(from, to), sheet));
}

BranchBox box_with_partners(const BranchForms<Interval>& branch, const PartnerCurve& partners, double from, double to,
                            int sheet) {
  const Part part(from, to);
  const Point2<Moving> p = points(branch, part, sheet);
  std::array<Correlation<Moving>, 3> n;
  for (std::size_t j = 0; j < 3; ++j)
    for (int i = 0; i < 9; ++i) n[j](i) = Moving(partners.enclosing[j](i));
  const Point2<Interval> middle = partner<Interval>(partners.enclosing, branch(part.middle, sheet));
  return {values(p), values(sharpened(partner<Moving>(n, p), middle, part.step))};
}

}  // namespace burmester
