// The topology of a real plane algebraic curve, proved: start here.
//
// Two routes. A cubic with a known rational point: one quartic discriminant (cubic_branches.hpp), in intervals first. Any
// other curve of degree up to six: CGAL's exact analysis (curve_analysis.hpp), some hundred times slower, and only in
// builds with GMP. Circle-point and centre-point curves always have such a point: a pole.
#pragma once

#include <optional>

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// Coefficients and point are exact numbers. Throws std::invalid_argument where the point is not on the curve.
CurveTopology topology_of(const TernaryForm<Rational>& curve,
                          const std::optional<Point2<Rational>>& on_curve = std::nullopt);

}  // namespace burmester
