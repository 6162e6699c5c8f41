// A plane cubic seen from one of its own points: the lines through it meet the curve in two points each.
//
// P on the cubic F, and X = v P + u0 Qi + u1 Qj with two coordinate directions Qi, Qj: then
//     F(X) = A(u) v^2 + B(u) v + C(u),     A, B, C binary forms in (u0 : u1) of degree 1, 2, 3,
// and the line u meets the curve in real points where the quartic D = B^2 - 4 A C >= 0. So the real roots of one
// quartic, with their multiplicities, tell the topology of the curve;
// and no point of the curve is special, infinity included.
#pragma once

#include <array>
#include <cmath>

#include "burmester/geometry/binary_form.hpp"
#include "burmester/geometry/cubic.hpp"

namespace burmester {

template <class T>
struct CubicPencil {
  Point2<T> base;
  int k = 2, i = 0, j = 1;  ///< base[k] is its largest coordinate; u0 and u1 go along the coordinate directions i and j
  BinaryForm<T> a, b, c;

  /// Precondition: F(on_curve) = 0 (not looked at), on_curve not zero. A = 0 exactly where it is a singular point.
  CubicPencil(const Cubic<T>& f, const Point2<T>& on_curve) : base(on_curve) {
    k = 0;
    for (int n = 1; n < 3; ++n)
      if (std::abs(approximate(base[n])) > std::abs(approximate(base[k]))) k = n;
    i = (k + 1) % 3, j = (k + 2) % 3;
    const T zero(0);
    const Point2<T> ei = direction({T(1), zero}), ej = direction({zero, T(1)});
    const Vector<T, 3> at_base = f.gradient(base), at_i = f.gradient(ei), at_j = f.gradient(ej);
    a = BinaryForm<T>({at_base[i], at_base[j]});
    b = BinaryForm<T>({T(at_i.dot(base)), T(f.polar(ei, ej).dot(base)), T(at_j.dot(base))});
    c = BinaryForm<T>({f(ei), at_i[j], at_j[i], f(ej)});
  }

  /// D = B^2 - 4 A C
  BinaryForm<T> discriminant() const { return b * b - 4 * (a * c); }

  /// u0 Qi + u1 Qj
  Point2<T> direction(const Point1<T>& u) const {
    Point2<T> q(T(0), T(0), T(0));
    q[i] = u[0], q[j] = u[1];
    return q;
  }
};

}  // namespace burmester
