// One displacement as a correlation between the points of the body and those of the frame.
#pragma once

#include "burmester/geometry/correlations.hpp"
#include "burmester/planar/anchored_basis.hpp"

namespace burmester::planar {

/// |D p - c|^2 = |p - c|^2 for the displacement D from one pose to another, times the squared norms of their image
/// points: p and c seen from the first pose's origin, in fixed directions and a unit of length whose inverse is
/// `per_length`. P: Pose, or one whose members are T.
template <class T, class P>
Correlation<T> equidistance(const P& from, const P& to, double per_length) {
  const auto [s, c] = relative_turn<T>(from, to);
  const T x = (T(to.x) - T(from.x)) * T(per_length), y = (T(to.y) - T(from.y)) * T(per_length);
  const T n = s * s + c * c, cosine = c * c - s * s, sine = T(2) * s * c, versed = T(4) * s * s;
  Correlation<T> m;
  m << versed, T(-2) * sine, T(2) * (x * cosine + y * sine),  //
      T(2) * sine, versed, T(2) * (y * cosine - x * sine),    //
      T(-2) * n * x, T(-2) * n * y, n * (x * x + y * y);
  return m;
}

}  // namespace burmester::planar
