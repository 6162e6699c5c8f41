// What two orientations ask of a dyad: that the angle between its axes is the same in both, a correlation.
//
// Seen from pose r, with p = (w, v) = conj(q_r) q_j, its rotation R,
// the moving axis a in E and the fixed one b' = Qr^T b,
//     a^T N b' = 0,   N^T = |p|^2 (R - I) / 2 = w [v]x + v v^T - |v|^2 I
// (J. M. McCarthy, G. S. Soh, "Geometric Design of Linkages", 2nd ed. 2011). Its vertex is v, the axis of the rotation.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "burmester/geometry/correlations.hpp"
#include "burmester/spherical/space.hpp"

namespace burmester::spherical {

/// A pose of the closest pair, the one nearer to the others: there the small rotation is seen at its own scale.
/// Precondition: two to five poses.
int reference_of(std::span<const Pose> poses);

/// s, a power of two with a sign, so that s y is about as long as x and on its side: the difference of x and s y is
/// small where they are close as points of the space.
inline double factor_towards(const Space::Point<double>& x, const Space::Point<double>& y) {
  const double size = power_of_two_below(std::sqrt(2 * x.squaredNorm() / y.squaredNorm()));
  return x.dot(y) < 0 ? -size : size;
}

/// conj(a) b up to a factor, from the difference of the two: what nearly equal poses have in common does not cancel.
template <class T>
Quaternion<T> relative_rotation(const Pose& a, const Pose& b) {
  const Quaternion<T> from = Space::point<T>(a), to = Space::point<T>(b);
  const T s(factor_towards(Space::point<double>(a), Space::point<double>(b))), dw = s * to[0] - from[0];
  const Vector<T, 3> v(from[1], from[2], from[3]), d(T(s * to[1] - v[0]), T(s * to[2] - v[1]), T(s * to[3] - v[2]));
  const T along = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
  return {T(Space::norm<T>(from) + from[0] * dw + along), T(from[0] * d[0] - dw * v[0] - (v[1] * d[2] - v[2] * d[1])),
          T(from[0] * d[1] - dw * v[1] - (v[2] * d[0] - v[0] * d[2])),
          T(from[0] * d[2] - dw * v[2] - (v[0] * d[1] - v[1] * d[0]))};
}

/// N of one rotation.
template <class T>
Correlation<T> angle_kept(const Quaternion<T>& p) {
  const T &w = p[0], &x = p[1], &y = p[2], &z = p[3];
  const T xx = x * x, yy = y * y, zz = z * z, xy = x * y, yz = y * z, zx = z * x, wx = w * x, wy = w * y, wz = w * z;
  Correlation<T> n;
  n << T(-(yy + zz)), T(xy + wz), T(zx - wy),  //
      T(xy - wz), T(-(zz + xx)), T(yz + wx),   //
      T(zx + wy), T(yz - wx), T(-(xx + yy));
  return n;
}

/// N times a power of two, its largest entry about 1 (zero for the identity).
template <class T>
Correlation<T> equal_angles(const Quaternion<T>& p) {
  Correlation<T> n = angle_kept(p);
  double size = 0;
  for (int i = 0; i < 9; ++i) size = std::max(size, std::abs(approximate(n(i))));
  if (size >= std::numeric_limits<double>::min())
    for (int i = 0; i < 9; ++i) n(i) = n(i) * T(unit_scale(size));
  return n;
}

}  // namespace burmester::spherical
