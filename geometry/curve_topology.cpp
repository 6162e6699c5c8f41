#include "burmester/geometry/curve_topology.hpp"

#include <stdexcept>

#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/curve_analysis.hpp"
#include "burmester/geometry/enclosure.hpp"

namespace burmester {
namespace {

std::optional<CurveTopology> by_intervals(const Cubic<Rational>& f, const Point2<Rational>& on_curve) {
  const UpwardRounding upward;
  Cubic<Interval> rounded;
  for (std::size_t k = 0; k < 10; ++k) rounded.c[k] = enclosure(f.c[k]);
  const Point2<Interval> base{enclosure(on_curve[0]), enclosure(on_curve[1]), enclosure(on_curve[2])};
  if (auto branches = branches_by_intervals(rounded, base)) return std::move(branches->topology);
  return std::nullopt;
}

}  // namespace

CurveTopology topology_of(const TernaryForm<Rational>& curve, const std::optional<Point2<Rational>>& on_curve) {
  if (on_curve && (on_curve->isZero(0) || known_sign(curve(*on_curve)) != 0))
    throw std::invalid_argument("topology_of: the point given is not on the curve");
  if (on_curve && curve.degree == 3) {
    const Cubic<Rational> f = curve.cubic();
    if (auto topology = by_intervals(f, *on_curve)) return std::move(*topology);
    if (CurveTopology topology = branches_by_rationals(f, *on_curve).topology; topology.rung != Rung::none)
      return topology;
  }
  return analyse_curve(curve);
}

}  // namespace burmester
