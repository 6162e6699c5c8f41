#include "burmester/geometry/branch_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

bool told(const Point2<Interval>& p) {
  return std::any_of(p.data(), p.data() + 3, [](const Interval& x) { return !contains_zero(x); });
}

/// Sum of the widths, the largest coordinate 1 or -1.
double width(const Point2<Interval>& p) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(approximate(p[i])) > std::abs(approximate(p[k]))) k = i;
  if (contains_zero(p[k])) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == k) continue;
    const Interval at = p[i] / p[k];
    sum += upper(at) - lower(at);
  }
  return sum;
}

/// Whether the part is proved to run through the point. A line through the base and a double point meets the curve
/// there twice: u(s) is that line where both sheets are the point. But where the line is part of the curve only one of
/// its two other points need be.
bool runs_through(const BranchForms<Interval>& branch, const PointWithLine& point, const Part& part, int sheet) {
  const Point2<Interval>& p = point.at;
  if (branch.line && !point.sees_base) return false;
  const auto side = [&](double s) {
    if (branch.line) {
      const int k = magnitude(branch.u[0][0]) > magnitude(branch.u[0][1]) ? 1 : 2;
      const Point2<Interval> at = branch.on_line(Interval(s));
      return at[0] * p[k] - at[k] * p[0];
    }
    const Point1<Interval> u = branch.line_at(Interval(s));
    return u[0] * p[2] - u[1] * p[1];
  };
  if (!(upper(side(lower(part.over)) * side(upper(part.over))) < 0)) return false;
  return branch.line || !point.sees_base || told(values(seen(branch, part, -sheet)).cross(p));
}

/// A part that is proved to run through the point, with this part and little more. Nothing where the point is far:
/// `least` and `most` decide only how many parts are tried, what is returned is proved.
std::optional<Part> hull_with(const BranchForms<Interval>& branch, const PointWithLine& point, const Part& part,
                              int sheet) {
  constexpr double least = 0x1p-44,
                   most = 0x1p-10;  // at the ends of a part the doubles do not tell on which side it is
  const double from = lower(part.over), to = upper(part.over);
  for (double beyond = least; beyond < most; beyond *= 4)
    for (const Part& wide : {Part(from - beyond, to + least), Part(from - least, to + beyond)})
      if (runs_through(branch, point, wide, sheet)) return wide;
  return std::nullopt;
}

/// The partners of a part that runs through such a point: beside it X(s)^T N = (s - s0) X'^T N, X' from the part.
Point2<Interval> partners_through(const BranchForms<Interval>& branch, const PointWithLine& point, const Part& part,
                                  int sheet) {
  const Point2<Moving> p = seen(branch, part, sheet);
  const Point2<Interval> along{p[0].slope[0], p[1].slope[0], p[2].slope[0]};
  return concurrence<Interval>({line_of_partners(point.through, values(p)), line_of_partners(point.beside[0], along),
                                line_of_partners(point.beside[1], along)});
}

}  // namespace

Point2<Interval> box_seen(const BranchForms<Interval>& branch, double from, double to, int sheet) {
  return values(seen(branch, Part(from, to), sheet));
}

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
  BranchBox out{{values(placed(branch, p, part, sheet)), values(sharpened(partner<Moving>(n, p), middle, part.step))},
                values(p)};
  for (const PointWithLine& point : partners.with_line)
    if (const auto hull = hull_with(branch, point, part, sheet))
      if (const auto through = partners_through(branch, point, *hull, sheet); width(through) < width(out.track[1]))
        out.track[1] = through;
  return out;
}

}  // namespace burmester
