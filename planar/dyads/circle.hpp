// Circles and straight lines of the fixed or of the moving plane by their common coordinates K:
//   K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3 = 0.
// Circle: centre (-K1, -K2) / K0, radius^2 = (K1^2 + K2^2 - K0 K3) / K0^2. Straight line, K0 = 0: with the angle xi of
// its direction and a point (X, Y) on it K = (0, -1/2 sin xi, 1/2 cos xi, X sin xi - Y cos xi).
// (M. J. D. Hayes, T. Luu, X.-W. Chang, ARK 2004.) Through three points: circle_through of geometry/grassmann.hpp.
#pragma once

#include <optional>
#include <variant>

#include "burmester/planar/dyads/line.hpp"

namespace burmester::planar {

struct Circle {
  Vector2 centre{0, 0};
  double radius = 0;  ///< length units, not negative

  double signed_distance(const Vector2& p) const { return (p - centre).norm() - radius; }
};

using CircleOrLine = std::variant<Circle, Line>;

inline Vector<double, 4> coordinates_of(const Circle& c) {
  return {1, -c.centre[0], -c.centre[1], c.centre.squaredNorm() - c.radius * c.radius};
}
inline Vector<double, 4> coordinates_of(const Line& l) { return {0, l.normal[0] / 2, l.normal[1] / 2, -l.offset}; }

/// K of any scale. Empty where it is no real curve of the plane: an imaginary circle, K1 = K2 = 0 without K0. K0 is
/// read as exact: a circle with the tiniest K0 is a circle, and whether it may pass for a line depends on how much of
/// it is in use (classify.hpp, geometry/circle_fit.hpp).
inline std::optional<CircleOrLine> curve_of(const Vector<double, 4>& K) {
  const Vector2 n = K.segment<2>(1);
  if (K[0] == 0) {
    const double size = n.norm();
    if (!(size > 0)) return std::nullopt;
    return Line{n / size, -K[3] / (2 * size)};
  }
  const Vector2 centre = -n / K[0];
  const double square = centre.squaredNorm() - K[3] / K[0];
  if (!(square >= 0)) return std::nullopt;
  return Circle{centre, std::sqrt(square)};
}

}  // namespace burmester::planar
