// Four poses: reports of the curve of their dyads, for geometries in which their pivots make two paired curves.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "burmester/geometry/curve.hpp"
#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/report.hpp"

namespace burmester {

struct FourPoseCurves {
  CurveTopology topology;  ///< of the circle-point curve; rung none: the poses are degenerate, `reason` says how
  std::vector<CurveRecord> pieces;  ///< moving pivots in E, fixed pivots in S
  bool complete = true;             ///< not so where a part in the window could not be proved, and is not shown
  int lines_of_partners = 0;        ///< circle points with a whole line of centre points, each a piece of its own
};

/// A piece in the frames of the bodies. Task: length() is the unit of the traced points, moving(p) and fixed(c) their
/// coordinates in E and in S.
template <class Task>
CurveRecord record_of(const CurvePiece& piece, const Task& task) {
  CurveRecord out{piece.component, piece.closed, piece.max_error * task.length(), {}, {}};
  double farthest = 0;
  const auto add = [&](std::vector<PointRecord>& to, const auto& p) {
    farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    if constexpr (std::remove_cvref_t<decltype(p)>::SizeAtCompileTime == 2)
      to.emplace_back(p[0], p[1]);
    else
      to.emplace_back(p[0], p[1], p[2]);
  };
  out.moving.reserve(piece.points.size()), out.fixed.reserve(piece.partners.size());
  for (const Point2<double>& p : piece.points) add(out.moving, task.moving(p));
  for (const Point2<double>& c : piece.partners) add(out.fixed, task.fixed(c));
  out.max_error += 16 * unit_roundoff * (farthest + 8 * task.length());  // the change of frame, rounded
  return out;
}

template <class Task>
FourPoseCurves curves_in_frames(const PairedCurves& curves, const Task& task) {
  FourPoseCurves out{curves.topology, {}, curves.traced.complete, curves.lines_of_partners};
  for (const CurvePiece& piece : curves.traced.pieces) out.pieces.push_back(record_of(piece, task));
  return out;
}

/// How a geometry speaks of its curves.
struct CurveWords {
  const char* line;   ///< what splits off: "line", "great circle"
  const char* conic;  ///< "conic", "quadric cone"
};

/// "a curve of dyads: circle points and centre points, in 2 components, one of them an oval, proved"
std::string description_of(const CurveTopology& topology, const CurveWords& words);

/// The report without sliders; status degenerate where there are no curves.
template <class List>
Report<List> curve_report(FourPoseCurves curves, const CurveWords& words) {
  Report<List> report;
  if (curves.topology.rung == Rung::none) {
    report.status = Status::degenerate;
    report.message = "the circle-point curve degenerates: " + curves.topology.reason;
    return report;
  }
  report.status = Status::family;
  report.message = description_of(curves.topology, words);
  report.counts.dimension = 1;
  report.curves = std::move(curves.pieces);
  if (curves.lines_of_partners > 0)
    report.message += fmt::format("; {} of its points {} a whole {} of centre points", curves.lines_of_partners,
                                  curves.lines_of_partners == 1 ? "has" : "each have", words.line);
  if (curves.topology.isolated > curves.lines_of_partners)
    report.warnings.push_back("a component of the circle-point curve is a single point and is not listed");
  if (!curves.complete) report.warnings.push_back("a part of the curves could not be proved and is not listed");
  if (curves.complete && report.curves.empty())
    report.warnings.push_back("no part of the curves with both pivots is in the window that is listed");
  return report;
}

/// A slider that lies on the curves.
template <class D, class List>
Found<typename List::Design> found_slider(const typename D::Design& design,
                                          std::span<const typename D::Space::Pose> poses) {
  Found<typename List::Design> found;
  found.design = design;
  found.residual = largest_residual<D>(design, poses);
  found.condition = condition<D>(design, poses);
  found.departure = found.residual;
  return found;
}

}  // namespace burmester
