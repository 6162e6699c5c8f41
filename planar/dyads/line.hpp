// A straight line of the fixed or of the moving plane: normal . P = offset.
#pragma once

#include <cmath>
#include <numbers>

#include "burmester/modules/framework/record.hpp"
#include "burmester/planar/space.hpp"

namespace burmester::planar {

struct Line {
  Vector2 normal{0, 1};  ///< unit vector
  double offset = 0;     ///< length units

  /// Through a point, in the direction (cos angle, sin angle).
  static Line through(const Vector2& p, double angle) {
    const Vector2 n(-std::sin(angle), std::cos(angle));
    return {n, n.dot(p)};
  }
  double signed_distance(const Vector2& p) const { return normal.dot(p) - offset; }
  Line turned(double angle) const {  ///< about the foot of the perpendicular from the origin
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]}, offset};
  }
  Line moved(const Pose& g) const {
    const Vector2 n = rotated(g, normal);
    return {n, offset + n.dot(Vector2(g.x, g.y))};
  }
  LineRecord record() const {
    double angle = std::atan2(-normal[0], normal[1]);  // direction (normal[1], -normal[0]) up to sign
    if (angle < 0) angle += std::numbers::pi;
    if (angle >= std::numbers::pi) angle = 0;
    return {{offset * normal[0] + 0.0, offset * normal[1] + 0.0}, angle + 0.0};
  }
  static Line random(Random& random) {
    const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    return {{std::cos(angle), std::sin(angle)}, random.normal()};
  }
};

}  // namespace burmester::planar
