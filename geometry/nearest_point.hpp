// The point of a cubic nearest to a given one, in the plane or on the sphere, from polylines that follow the curve.
//
// Plane and sphere are the surfaces z = 1 and |c| = 1 in space; the cubic F(c) = 0 is met by them, and the point q lies
// on them. Nearest to q: |c - q|^2 / 2 + lambda F(c) stationary along the surface, F(c) = 0 (on the sphere the chord is
// least where the angle is). With orthonormal tangents T of the surface at c, Newton's method moves c by T s, and back
// onto the surface:
//     (k + lambda T^T F'' T) s + T^T F' dlambda = - T^T (c - q + lambda F'),    F' . T s = - F,
// where k, the second derivative of |c - q|^2 / 2 along the surface, is 1 in the plane and c . q on the sphere.
#pragma once

#include <optional>
#include <vector>

#include "burmester/geometry/cubic.hpp"
#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "burmester/geometry/surface.hpp"

namespace burmester {

struct NearestPoint {
  Point2<double> at;  ///< on the surface, on the sphere on the side of q; F(at) = 0 but for the rounding of `at`
  bool end;           ///< of an open piece: the curve goes on where nothing is traced
};

/// Nearest to q among the points of the curve that `pieces` follow; nothing where there are no pieces. Newton's method
/// starts from each place of them that is nearest but for their errors; where it leads away, or farther from q, the
/// place itself is put on the curve. Chords up to 0.25 long.
std::optional<NearestPoint> nearest_point(Surface surface, const Cubic<Rational>& f,
                                          const std::vector<CurvePiece>& pieces, const Point2<double>& q);

/// A box around a segment through c, across the curve, as short as exact signs allow: F has opposite signs at its ends,
/// so the curve passes through the box. On the sphere the box is one of directions of any length. Nothing where no
/// segment up to 1e-6 long has this, as at double points. c: on the surface and close to the curve.
std::optional<Point2<RationalInterval>> crossing(Surface surface, const Cubic<Rational>& f, const Point2<double>& c);

}  // namespace burmester
