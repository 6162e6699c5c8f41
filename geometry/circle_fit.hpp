// The circle or straight line that points of the plane lie on, exactly or nearly: K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3
// = 0 with K the right singular vector of least singular value of the rows (X^2 + Y^2, 2 X, 2 Y, 1)
// (M. J. D. Hayes, lecture notes ME 401 / MECH 5507, unit 3: line and circle feature extraction).
//
// It minimises the sum of squares of the left side over |K| = 1. That depends on the frame and on the unit: take the
// centroid of noisy points as origin and their spread as unit, unless a printed K is to be met. The line of least
// squared distances, in any frame, is fit_line (line_fit.hpp).
#pragma once

#include <optional>
#include <span>

#include "burmester/geometry/vector.hpp"

namespace burmester {

struct FittedCircle {
  Vector<double, 4> K;                ///< of norm 1 and either sign
  Vector<double, 4> singular_values;  ///< descending
  int rank = 0;                       ///< above m epsilon of the first, m points; 3: the points lie on the curve
  /// K0 is 0 to within the errors. Errors of the rows as large as the residual, the last singular value s4, turn K by
  /// the angle s4 / s3 at most, to first order (P.-A. Wedin, BIT 12, 1972); and m epsilon s1 of rounding.
  bool straight = false;
};

/// Empty where the points do not determine a curve: fewer than three different ones.
std::optional<FittedCircle> fit_circle(std::span<const Vector<double, 2>> points);

}  // namespace burmester
