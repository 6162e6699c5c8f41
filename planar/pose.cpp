#include "burmester/planar/pose.hpp"

#include <cmath>
#include <numbers>

namespace burmester::planar {

// sin and cos of a half angle in long double, rounded once to double.
Pose pose_from_radians(double x, double y, double angle) {
  const long double half = static_cast<long double>(angle) / 2;
  return {x, y, static_cast<double>(std::sin(half)), static_cast<double>(std::cos(half))};
}

Pose pose_from_degrees(double x, double y, double angle) {
  // Quarter turns of the half angle are taken off in degrees, where they are exact.
  const double half = std::fmod(angle, 720.0) / 2;
  const double quarters = std::nearbyint(half / 90);
  const long double rest = (half - 90 * quarters) * (std::numbers::pi_v<long double> / 180);
  const double s = static_cast<double>(std::sin(rest)), c = static_cast<double>(std::cos(rest));
  switch (static_cast<int>(quarters) & 3) {
    case 0: return {x, y, s, c};
    case 1: return {x, y, c, -s + 0.0};
    case 2: return {x, y, -s + 0.0, -c};
    default: return {x, y, -c, s};
  }
}

// sin : cos of half the angle = sin : (1 + cos) = (1 - cos) : sin, whichever does not cancel.
Pose pose_from_arrow(double tail_x, double tail_y, double tip_x, double tip_y) {
  const double u = tip_x - tail_x, v = tip_y - tail_y, length = std::hypot(u, v);
  const double s = u >= 0 ? v : length - u, c = u >= 0 ? length + u : v, n = std::hypot(s, c);
  return {tail_x, tail_y, s / n, c / n};
}

double angle_of(const Pose& pose) {
  // The pair is projective: (X3, X4) and (-X3, -X4) are the same pose.
  const double angle = 2 * std::atan2(pose.X4 < 0 ? -pose.X3 : pose.X3, std::abs(pose.X4));
  return angle > -std::numbers::pi ? angle : std::numbers::pi;
}

}  // namespace burmester::planar
