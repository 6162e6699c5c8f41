// The topology of a real plane algebraic curve, and polylines that show it, proved: start here.
//
// Two routes. A cubic with a known rational point: one quartic discriminant (cubic_branches.hpp), in intervals first.
// Any other curve of degree up to six: CGAL's exact analysis (curve_analysis.hpp), some hundred times slower, and only
// in builds with GMP. Circle-point and centre-point curves always have such a point: a pole.
#pragma once

#include <optional>

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// Coefficients and point are exact numbers. Throws std::invalid_argument where the point is not on the curve.
CurveTopology topology_of(const TernaryForm<Rational>& curve,
                          const std::optional<Point2<Rational>>& on_curve = std::nullopt);

struct CurvePicture {
  CurveTopology topology;
  /// No piece, not complete, where the topology is not available (cubics with an isolated point need GMP).
  TracedCurve traced;
};

/// Its components within the window |x|, |y| <= options.window as polylines, each with an error that is proved;
/// isolated points are pieces of one point. Throws as topology_of(),
/// and std::invalid_argument for options that are not positive.
CurvePicture picture_of(const TernaryForm<Rational>& curve, const TraceOptions& options = {},
                        const std::optional<Point2<Rational>>& on_curve = std::nullopt);

}  // namespace burmester
