// One rotation as a correlation between the axes of the body and those of the frame.
#pragma once

#include "burmester/geometry/correlations.hpp"
#include "burmester/spherical/space.hpp"

namespace burmester::spherical {

/// Q_to conj(Q_from): the rotation from one pose to another, seen from the fixed frame; quaternions of any norm.
template <class T>
Space::Point<T> rotation_between(const Space::Point<T>& from, const Space::Point<T>& to) {
  return Space::product<T>(to, Space::conjugate<T>(from));
}

/// (R p - p) . c = 0 for the rotation R from one pose to another, times its squared norm: equation 6 of the spherical
/// Burmester problem (J. Angeles, S. Bai). p: an axis of the body in the first pose, seen from the fixed frame as c is.
template <class T>
Correlation<T> equidistance(const Space::Point<T>& from, const Space::Point<T>& to) {
  const Space::Point<T> q = rotation_between<T>(from, to);
  const T &w = q[0], &x = q[1], &y = q[2], &z = q[3];
  Correlation<T> m;                                                              // row: coordinate of p; column: of R p
  m << T(-2) * (y * y + z * z), T(2) * (x * y + z * w), T(2) * (x * z - y * w),  //
      T(2) * (x * y - z * w), T(-2) * (x * x + z * z), T(2) * (y * z + x * w),   //
      T(2) * (x * z + y * w), T(2) * (y * z - x * w), T(-2) * (x * x + y * y);
  return m;
}

}  // namespace burmester::spherical
