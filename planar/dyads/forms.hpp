// The lifted form k of a point that one plane carries along a circle or straight line of the other (family.hpp).
#pragma once

#include "burmester/geometry/vector.hpp"

namespace burmester::planar {

/// The point p of E stays on K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3 = 0 in S: RR and PR, the upper signs of the
/// constraint manifold equation.
template <class T>
Vector<T, 8> form_of_moving_point(const Vector<T, 4>& K, const Vector<T, 2>& p) {
  return Vector<T, 8>{{K[0], K[1], K[2], T(K[0] * p[0]), T(K[0] * p[1]), T(K[0] * (p[0] * p[0] + p[1] * p[1]) + K[3]),
                       T(K[1] * p[0] + K[2] * p[1]), T(K[2] * p[0] - K[1] * p[1])}};
}

/// The point F of S stays on K0 (x^2 + y^2) + 2 K1 x + 2 K2 y + K3 = 0 in E: RR seen from the body, and RP; the lower
/// signs.
template <class T>
Vector<T, 8> form_of_fixed_point(const Vector<T, 4>& K, const Vector<T, 2>& F) {
  return Vector<T, 8>{{K[0], T(-K[0] * F[0]), T(-K[0] * F[1]), T(-K[1]), T(-K[2]),
                       T(K[0] * (F[0] * F[0] + F[1] * F[1]) + K[3]), T(K[1] * F[0] + K[2] * F[1]),
                       T(K[1] * F[1] - K[2] * F[0])}};
}

}  // namespace burmester::planar
