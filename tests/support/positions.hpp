// Correlations of positions of a body in the plane and on the sphere, for tests of curves with partners.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "burmester/geometry/correlations.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {

/// A displacement as four doubles: plane (x, y, sine and cosine of half the angle), sphere a quaternion (x, y, z, w).
using FourDoubles = std::array<double, 4>;

inline FourDoubles random_plane_displacement(Random& random) {
  const double half = random.uniform(-std::numbers::pi / 2, std::numbers::pi / 2);
  return {random.uniform(-1, 1), random.uniform(-1, 1), std::sin(half), std::cos(half)};
}

inline FourDoubles random_rotation(Random& random) {
  FourDoubles q{random.normal(), random.normal(), random.normal(), random.normal()};
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q) x /= size;
  return q;
}

/// |D p - c|^2 = |p - c|^2 for p = (x, y, z) and c = (X, Y, Z) homogeneous, times (X3^2 + X4^2).
template <class T>
Correlation<T> equidistant_in_plane(const FourDoubles& d) {
  const T x(d[0]), y(d[1]), s(d[2]), c(d[3]);
  const T n = s * s + c * c, cosine = c * c - s * s, sine = T(2) * s * c;
  Correlation<T> m;
  m << T(2) * (n - cosine), T(-2) * sine, T(2) * (x * cosine + y * sine),  //
      T(2) * sine, T(2) * (n - cosine), T(2) * (y * cosine - x * sine),    //
      T(-2) * n * x, T(-2) * n * y, n * (x * x + y * y);
  return m;
}

/// (R p - p) . c = 0 for the rotation R of a quaternion, times its squared norm.
template <class T>
Correlation<T> equidistant_on_sphere(const FourDoubles& q) {
  const T x(q[0]), y(q[1]), z(q[2]), w(q[3]);
  Correlation<T> m;                                                              // row: coordinate of p; column: of R p
  m << T(-2) * (y * y + z * z), T(2) * (x * y + z * w), T(2) * (x * z - y * w),  //
      T(2) * (x * y - z * w), T(-2) * (x * x + z * z), T(2) * (y * z + x * w),   //
      T(2) * (x * z + y * w), T(2) * (y * z - x * w), T(-2) * (x * x + y * y);
  return m;
}

template <class T>
std::array<Correlation<T>, 3> equidistant_in_plane(const std::array<FourDoubles, 3>& d) {
  return {equidistant_in_plane<T>(d[0]), equidistant_in_plane<T>(d[1]), equidistant_in_plane<T>(d[2])};
}
template <class T>
std::array<Correlation<T>, 3> equidistant_on_sphere(const std::array<FourDoubles, 3>& d) {
  return {equidistant_on_sphere<T>(d[0]), equidistant_on_sphere<T>(d[1]), equidistant_on_sphere<T>(d[2])};
}

}  // namespace burmester
