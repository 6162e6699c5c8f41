// The straight line of least squared distances to points of the plane (total least squares).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "burmester/geometry/vector.hpp"

namespace burmester {

struct FittedLine {
  Vector<double, 2> centre, direction;  ///< centroid of the points; unit vector
  double departure = 0;                 ///< largest distance of a point from the line
};

/// At least one point. Coinciding points fit any line through them.
inline FittedLine fit_line(std::span<const Vector<double, 2>> points) {
  FittedLine line{Vector<double, 2>::Zero(), {1, 0}, 0};
  for (const auto& p : points) line.centre += p / static_cast<double>(points.size());
  double xx = 0, yy = 0, xy = 0;
  for (const auto& p : points) {
    const Vector<double, 2> d = p - line.centre;
    xx += d[0] * d[0], yy += d[1] * d[1], xy += d[0] * d[1];
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;  // principal axis of the second moments
  line.direction = {std::cos(angle), std::sin(angle)};
  for (const auto& p : points) {
    const Vector<double, 2> d = p - line.centre;
    line.departure = std::max(line.departure, std::abs(d[0] * line.direction[1] - d[1] * line.direction[0]));
  }
  return line;
}

}  // namespace burmester
