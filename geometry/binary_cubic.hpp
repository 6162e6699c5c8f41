// Real roots of a binary cubic form c0 s^3 + c1 s^2 t + c2 s t^2 + c3 t^3, as points (s : t) of the line.
//
// One real root by Newton's method from outside all roots, then deflation to a quadratic from the side that
// loses nothing: W. Kahan, "To solve a real cubic equation", UC Berkeley lecture notes (1986). A projective
// root needs no case for a vanishing leading coefficient: the form is read from its larger end.
// Backward stable: a root is one of a form whose coefficients differ by a few unit roundoffs of the largest.
// Precondition: coefficients that are not zero have magnitudes between 1e-40 and 1e40.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "burmester/geometry/error_free.hpp"

namespace burmester {

template <class T>
struct BinaryCubicRoots {
  int count = 0;                       ///< 1 or 3 (2 when a double root was seen as one); 0 for the zero form
  std::array<std::array<T, 2>, 3> at;  ///< (s, t), larger magnitude in [1, 2)
};

/// Real roots (s : t) of a s^2 + b s t + c t^2: the number of distinct ones, 0, 1 or 2 (0 also for the zero form).
/// `discriminant` receives b^2 - 4 a c.
template <class T>
int binary_quadratic_roots(const T& a, const T& b, const T& c, std::array<std::array<T, 2>, 2>& root,
                           T& discriminant) {
  using std::abs, std::sqrt;
  discriminant = b * b - 4 * a * c;
  if (discriminant < 0 || (a == 0 && b == 0 && c == 0)) return 0;
  const T r = sqrt(discriminant);
  const T q = b >= 0 ? T(-(b + r) / 2) : T((r - b) / 2);
  if (q == 0) {  // b = discriminant = 0: the form is a s^2 or c t^2
    root[0] = a != 0 ? std::array<T, 2>{T(0), T(1)} : std::array<T, 2>{T(1), T(0)};
    return 1;
  }
  root[0] = {q, a};
  root[1] = {c, q};
  return discriminant > 0 ? 2 : 1;
}

namespace detail {

template <class T>
std::array<T, 2> unit_pair(const T& s, const T& t) {
  using std::abs;
  const T factor(unit_scale(std::max(std::abs(approximate(s)), std::abs(approximate(t)))));
  return {T(s * factor), T(t * factor)};
}

/// An upper bound of the cube root of x >= 0, at most 0.4 % too large: one Newton step, which never lands below, from
/// a third of the exponent.
inline double cube_root_above(double x) {
  if (!(x > 0x1p-1000)) return x > 0 ? 0x1p-300 : 0;
  const double guess = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2aa0000000000000u);
  return (2 * guess + x / (guess * guess)) * (1.0001 / 3);
}

/// One real root of a x^3 + b x^2 + c x + d (a != 0), and the deflated quadratic a x^2 + b1 x + c2.
template <class T>
T outermost_root(const T& a, const T& b, const T& c, const T& d, T& b1, T& c2) {
  using std::abs, std::sqrt;
  T x = -(b / a) / 3, q0, slope, value;
  const auto evaluate = [&] {
    q0 = a * x;
    b1 = q0 + b;
    c2 = b1 * x + c;
    slope = (q0 + b1) * x + c2;
    value = c2 * x + d;
  };
  evaluate();
  const T t = value / a, steep = -slope / a;
  const T side = t < 0 ? T(-1) : T(1);
  T reach(cube_root_above(std::abs(approximate(t))));  // a bound is enough: it only has to be outside
  if (steep > 0) {
    const T half = sqrt(steep);
    reach = T(1.324718) * (half > reach ? half : reach);  // real root of r^3 = r + 1: outside the outermost root
  }
  T next = x - side * reach;
  if (next == x) return x;
  const T half_digits(std::ldexp(1.0, -std::numeric_limits<T>::digits / 2));
  for (int i = 0; i < 200; ++i) {  // monotone from outside; stops when rounding turns it back
    const T before = x;
    x = next;
    evaluate();
    if (abs(x - before) <= half_digits * abs(x)) break;  // quadratic convergence: the next step is rounding
    next = slope == 0 ? x : T(x - value / slope);
    if (side * next > side * x) continue;
    if (abs(next - x) <= half_digits * abs(x - before)) x = next, evaluate();  // the last step ended in its rounding
    break;
  }
  if (abs(a) * x * x > abs(d / x)) {
    c2 = -d / x;
    b1 = (c2 - c) / x;
  }
  return x;
}

}  // namespace detail

template <class T>
BinaryCubicRoots<T> binary_cubic_roots(const std::array<T, 4>& c) {
  using std::abs;
  BinaryCubicRoots<T> out;
  const bool reversed = abs(c[0]) < abs(c[3]);
  const T &a = reversed ? c[3] : c[0], &b = reversed ? c[2] : c[1], &e = reversed ? c[1] : c[2],
          &d = reversed ? c[0] : c[3];
  const auto add = [&](const T& s, const T& t) {
    out.at[out.count++] = reversed ? detail::unit_pair(t, s) : detail::unit_pair(s, t);
  };
  T b1, c2;
  if (a == 0) {  // then d = 0 as well: s t (b s + e t)
    if (b == 0 && e == 0) return out;
    add(T(0), T(1));
    add(T(1), T(0));
    if (b != 0 && e != 0) add(-e, b);
    return out;
  }
  if (d == 0) {
    add(T(0), T(1));
    b1 = b, c2 = e;
  } else {
    add(detail::outermost_root(a, b, e, d, b1, c2), T(1));
  }
  std::array<std::array<T, 2>, 2> pair;
  T discriminant;
  const int more = binary_quadratic_roots(a, b1, c2, pair, discriminant);
  for (int i = 0; i < more; ++i) add(pair[i][0], pair[i][1]);
  return out;
}

/// Discriminant relative to the fourth power of the largest coefficient: positive for three real roots, negative for
/// one, 0 for a double root (and for the zero form). Near a double root it is about the squared gap of the roots.
template <class T>
T relative_discriminant(const std::array<T, 4>& c) {
  double size = 0;
  for (const T& x : c) size = std::max(size, std::abs(approximate(x)));
  if (!(size > 0)) return T(0);
  const T scale(unit_scale(size)), p = c[0] * scale, q = c[1] * scale, r = c[2] * scale, s = c[3] * scale;
  return q * q * r * r - 4 * (p * r * r * r + q * q * q * s) - 27 * p * p * s * s + 18 * p * q * r * s;
}

}  // namespace burmester
