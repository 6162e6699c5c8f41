#include "burmester/geometry/paired_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "burmester/geometry/enclosure.hpp"

namespace burmester {
namespace {

/// How far lines through a point of the cubic are from being part of it, zero where it is singular there. A line that
/// nearly splits off is run through while the pencil hardly turns.
double suitability(const Cubic<double>& f, const Point2<double>& base) {
  const CubicPencil<double> pencil(f, base.normalized());
  double out = std::numeric_limits<double>::infinity();
  const auto see = [&](const Point1<double>& direction) {
    const Point1<double> u = direction.normalized();
    out = std::min(out, std::max({std::abs(pencil.a(u)), std::abs(pencil.b(u)), std::abs(pencil.c(u))}));
  };
  if (!(std::abs(pencil.a.c[0]) + std::abs(pencil.a.c[1]) > 0)) return 0;  // also where it is not a number
  see({pencil.a.c[1], -pencil.a.c[0]});
  const double b0 = pencil.b.c[0], half = pencil.b.c[1] / 2, b2 = pencil.b.c[2],
               q = half + std::copysign(std::sqrt(std::max(0.0, half * half - b0 * b2)), half);
  for (const Point1<double>& root : {Point1<double>(b2, -q), Point1<double>(q, -b0)})
    if (root.squaredNorm() > 0) see(root);
  return out;
}

/// The vertices, the most suitable first.
std::array<std::size_t, 3> order_of_bases(const ThreeCorrelations<Interval>& enclosing) {
  ThreeCorrelations<double> n;
  for (std::size_t k = 0; k < 3; ++k) n[k] = enclosing[k].unaryExpr([](const Interval& x) { return approximate(x); });
  const Cubic<double> f = points_with_partner(n);
  std::array<double, 3> value;
  for (std::size_t k = 0; k < 3; ++k) value[k] = suitability(f, vertex(n[k]));
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return value[i] > value[k]; });
  return order;
}

std::optional<CubicBranches> branches_by_intervals(const ThreeCorrelations<Interval>& n,
                                                   const std::array<std::size_t, 3>& order) {
  const Cubic<Interval> f = points_with_partner(n);
  for (const std::size_t k : order)
    if (auto branches = branches_by_intervals(f, vertex(n[k]))) return branches;
  return std::nullopt;
}

/// Where two of the vertices are singular points, the cubic holds the line between them: it meets it too often.
CubicBranches branches_by_rationals(const ThreeCorrelations<Rational>& n, const std::array<std::size_t, 3>& order) {
  const Cubic<Rational> f = points_with_partner(n);
  std::vector<Point2<Rational>> bases;
  for (const std::size_t k : order) bases.push_back(vertex(n[k]));
  for (std::size_t k = 0; k < 3; ++k) bases.push_back(bases[k] + bases[(k + 1) % 3]);
  for (const Point2<Rational>& base : bases) {
    if (base.isZero(0)) continue;
    CubicBranches branches = branches_by_rationals(f, base);
    if (branches.topology.rung != Rung::none) return branches;
  }
  CubicBranches none;
  const bool zero = std::all_of(f.c.begin(), f.c.end(), [](const Rational& c) { return c == 0; });
  none.topology.reason = zero ? "every point lies on it" : "a line of it counts more than once";
  return none;
}

/// Coefficients (k, j), j < k: N_k less their sum of the N_j before it is orthogonal to these. Nothing where that
/// leaves a thousandth of each N or more. Two pairs of close positions make two of the N nearly multiples of each
/// other, and their common points and partners cancel.
std::optional<Matrix<double, 3, 3>> dependence(const ThreeCorrelations<Interval>& enclosing) {
  ThreeCorrelations<double> n;
  Matrix<double, 3, 3> out = Matrix<double, 3, 3>::Zero();
  bool some = false;
  for (int k = 0; k < 3; ++k) {
    auto& left = n[static_cast<std::size_t>(k)];
    left = enclosing[static_cast<std::size_t>(k)].unaryExpr([](const Interval& x) { return approximate(x); });
    const double size = left.norm();
    for (int j = 0; j < k; ++j) {
      const auto& other = n[static_cast<std::size_t>(j)];
      if (!(other.squaredNorm() > 0)) return std::nullopt;
      out(k, j) = left.cwiseProduct(other).sum() / other.squaredNorm();
      left -= out(k, j) * other;
    }
    some = some || left.norm() < 0x1p-6 * size;
  }
  return some && out.allFinite() ? std::optional(out) : std::nullopt;
}

/// The same points and partners: N_k less those multiples.
ThreeCorrelations<Rational> independent(ThreeCorrelations<Rational> n,
                                        const std::optional<Matrix<double, 3, 3>>& dependence) {
  for (int k = 0; dependence && k < 3; ++k)
    for (int j = 0; j < k; ++j)
      n[static_cast<std::size_t>(k)] -= Rational((*dependence)(k, j)) * n[static_cast<std::size_t>(j)];
  return n;
}

/// Each brought to size 1.
ThreeCorrelations<Interval> enclosures(const ThreeCorrelations<Rational>& n) {
  ThreeCorrelations<Interval> out;
  for (std::size_t k = 0; k < 3; ++k) {
    double size = 0;
    for (int i = 0; i < 9; ++i) size = std::max(size, std::abs(approximate(n[k](i))));
    const Rational scale(size > 0 ? 1 / power_of_two_below(size) : 1);
    for (int i = 0; i < 9; ++i) out[k](i) = enclosure(Rational(scale * n[k](i)));
  }
  return out;
}

}  // namespace

PairedCurves paired_curves(const DecidingCorrelations& correlations, TraceCurve trace, const TraceOptions& options) {
  const UpwardRounding upward;
  auto n = correlations.intervals();
  const auto order = order_of_bases(n);
  const auto nearly = dependence(n);
  // Chords go with the square root of the tolerance. Whole curves took fewer samples; more are of use only where
  // doubles do not tell.
  TraceOptions limited = options;
  limited.most_samples = static_cast<int>(
      std::min<double>(options.most_samples, 600 * std::sqrt(std::max(1.0, options.longest / options.tolerance))));
  if (const auto branches = nearly ? std::nullopt : branches_by_intervals(n, order)) {
    TracedCurve traced =
        trace(*branches, tube_curve(points_with_partner(n)), partner_curve(n, branches->frame), limited);
    if (traced.complete) return {branches->topology, std::move(traced)};
  }
  const CubicBranches branches = branches_by_rationals(correlations.rationals(), order);
  PairedCurves out{branches.topology, {}};
  if (branches.topology.rung == Rung::none) return out;
  const ThreeCorrelations<Rational> exact = independent(correlations.rationals(), nearly);
  const BranchFrame<Rational> frame{*branches.base, branches.frame.i, branches.frame.j};
  n = enclosures(exact);
  const auto seen = enclosures({frame.seen(exact[0]), frame.seen(exact[1]), frame.seen(exact[2])});
  out.traced = trace(branches, tube_curve(points_with_partner(n)), partner_curve(n, seen), limited);
  return out;
}

}  // namespace burmester
