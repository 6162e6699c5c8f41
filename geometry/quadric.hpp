// Quadrics of projective space: coefficients, evaluation, polar form.
//
// Notation: Q(x) = q0 x0^2 + q1 x1^2 + q2 x2^2 + q3 x3^2 + q4 x0 x1 + q5 x0 x2 + q6 x0 x3 + q7 x1 x2 + q8 x1 x3
// + q9 x2 x3. Gradients and polar forms are those of 2 M, where M is the symmetric matrix with Q(x) = x^T M x, so
// that no halves appear (as in conic.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class T>
using Point3 = Vector<T, 4>;  ///< homogeneous coordinates of a point (or of a plane) of projective space

template <class T>
struct Quadric {
  std::array<T, 10> q{};

  T operator()(const Point3<T>& p) const {
    return p[0] * (q[0] * p[0] + q[4] * p[1] + q[5] * p[2] + q[6] * p[3]) +
           p[1] * (q[1] * p[1] + q[7] * p[2] + q[8] * p[3]) + p[2] * (q[2] * p[2] + q[9] * p[3]) +
           q[3] * p[3] * p[3];
  }
  /// 2 M p: the polar plane of p; where p lies on the quadric its tangent plane, 0 at a singular point.
  Point3<T> gradient(const Point3<T>& p) const {
    return {T(2 * q[0] * p[0] + q[4] * p[1] + q[5] * p[2] + q[6] * p[3]),
            T(q[4] * p[0] + 2 * q[1] * p[1] + q[7] * p[2] + q[8] * p[3]),
            T(q[5] * p[0] + q[7] * p[1] + 2 * q[2] * p[2] + q[9] * p[3]),
            T(q[6] * p[0] + q[8] * p[1] + q[9] * p[2] + 2 * q[3] * p[3])};
  }
  /// 2 u^T M v: the polar form; polar(u, u) = 2 Q(u).
  T polar(const Point3<T>& u, const Point3<T>& v) const { return gradient(u).dot(v); }

  /// this += factor l m, a pair of planes
  void add_product(const Point3<T>& l, const Point3<T>& m, const T& factor) {
    for (int i = 0, k = 4; i < 4; ++i) {
      q[i] += factor * (l[i] * m[i]);
      for (int j = i + 1; j < 4; ++j, ++k) q[k] += factor * (l[i] * m[j] + l[j] * m[i]);
    }
  }
};

/// Largest magnitude among the coefficients.
template <class T>
double size_of(const Quadric<T>& s) {
  double size = 0;
  for (const T& q : s.q) size = std::max(size, std::abs(approximate(q)));
  return size;
}

}  // namespace burmester
