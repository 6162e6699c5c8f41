#include "burmester/geometry/paired_curves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace burmester {
namespace {

std::optional<CubicBranches> branches_by_intervals(const DecidingCorrelations& correlations) {
  const UpwardRounding upward;
  const auto n = correlations.intervals();
  const Cubic<Interval> f = points_with_partner(n);
  for (const Correlation<Interval>& from : n)
    if (auto branches = branches_by_intervals(f, vertex(from))) return branches;
  return std::nullopt;
}

/// Where two of the vertices are singular points, the cubic holds the line between them: it meets it too often.
CubicBranches branches_by_rationals(const DecidingCorrelations& correlations) {
  const auto n = correlations.rationals();
  const Cubic<Rational> f = points_with_partner(n);
  std::vector<Point2<Rational>> bases;
  for (const Correlation<Rational>& from : n) bases.push_back(vertex(from));
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
  if (auto branches = branches_by_intervals(correlations)) return std::move(*branches);
  return branches_by_rationals(correlations);
}

/// A passage of length 20 that bends like the unit circle takes 20 / sqrt(8 tolerance) chords; ten times as many, and it
/// stands still: where the curve nearly splits in two, a partner may run along a line while its point moves by less
/// than doubles tell.
TraceOptions limited(TraceOptions options) {
  check(options);
  options.most_samples = static_cast<int>(std::min<double>(options.most_samples, 70 / std::sqrt(options.tolerance)));
  return options;
}

}  // namespace

PairedCurves paired_curves(const DecidingCorrelations& correlations, TraceCurve trace, const TraceOptions& options) {
  const CubicBranches branches = branches_of(correlations);
  PairedCurves out{branches.topology, {}};
  if (branches.topology.rung == Rung::none) return out;
  const UpwardRounding upward;
  const auto n = correlations.intervals();
  out.traced = trace(branches, tube_curve(points_with_partner(n)), partner_curve(n), limited(options));
  return out;
}

}  // namespace burmester
