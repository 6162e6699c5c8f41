#include "burmester/geometry/curve_topology.hpp"

#include <stdexcept>
#include <utility>

#include "burmester/geometry/arc_trace.hpp"
#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/curve_analysis.hpp"
#include "burmester/geometry/curve_trace.hpp"
#include "burmester/geometry/enclosure.hpp"

namespace burmester {
namespace {

/// By the pencil through the point; nothing where there is none, or where it tells nothing.
std::optional<CubicBranches> branches_of(const TernaryForm<Rational>& curve,
                                         const std::optional<Point2<Rational>>& on_curve) {
  if (on_curve && (on_curve->isZero(0) || known_sign(curve(*on_curve)) != 0))
    throw std::invalid_argument("the point given is not on the curve");
  if (!on_curve || curve.degree != 3) return std::nullopt;
  CubicBranches branches = burmester::branches_of(curve.cubic(), *on_curve);
  return branches.topology.rung == Rung::none ? std::nullopt : std::optional(std::move(branches));
}

}  // namespace

CurveTopology topology_of(const TernaryForm<Rational>& curve, const std::optional<Point2<Rational>>& on_curve) {
  const auto branches = branches_of(curve, on_curve);
  return branches ? branches->topology : analyse_curve(curve);
}

CurvePicture picture_of(const TernaryForm<Rational>& curve, const TraceOptions& options,
                        const std::optional<Point2<Rational>>& on_curve) {
  check(options);
  const auto branches = branches_of(curve, on_curve);
  CurvePicture out{branches ? branches->topology : analyse_curve(curve), {}};
  if (branches && out.topology.isolated == 0) {
    const UpwardRounding upward;
    out.traced = trace_in_plane(*branches, tube_curve(enclosure(curve.cubic())), std::nullopt, options);
    return out;
  }
  out.traced.complete = false;
  if (out.topology.rung == Rung::none) return out;
  const CurveArcs arcs = arcs_of(curve);
  if (arcs.rung != Rung::none) out.traced = trace_arcs(arcs, options);
  return out;
}

}  // namespace burmester
