#include "burmester/geometry/paired_curves.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace burmester {
namespace {

/// How far the cubic is from being singular at a point of it and from holding its tangent there; zero where it is or
/// does. A line through the base that nearly splits off is run through while the pencil hardly turns.
double suitability(const Cubic<double>& f, const Point2<double>& base) {
  const CubicPencil<double> pencil(f, base.normalized());
  const Point1<double> u{pencil.a.c[1], -pencil.a.c[0]}, tangent = u.normalized();
  const double out = u.norm() * std::max(std::abs(pencil.b(tangent)), std::abs(pencil.c(tangent)));
  return out > 0 ? out : 0;  // not a number: singular
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

CubicBranches branches_of(const DecidingCorrelations& correlations) {
  const UpwardRounding upward;
  const auto n = correlations.intervals();
  const auto order = order_of_bases(n);
  if (auto branches = branches_by_intervals(n, order)) return std::move(*branches);
  return branches_by_rationals(correlations.rationals(), order);
}

}  // namespace

PairedCurves paired_curves(const DecidingCorrelations& correlations, TraceCurve trace, const TraceOptions& options) {
  const CubicBranches branches = branches_of(correlations);
  PairedCurves out{branches.topology, {}};
  if (branches.topology.rung == Rung::none) return out;
  const UpwardRounding upward;
  const auto n = correlations.intervals();
  out.traced = trace(branches, tube_curve(points_with_partner(n)), partner_curve(n), options);
  return out;
}

}  // namespace burmester
