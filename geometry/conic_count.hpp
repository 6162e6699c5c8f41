// How many real points two conics have in common, proved without computing them.
//
// Let f(s, t) = det(s A + t B) have three different roots, so that A and B have four different common points. At a
// root the member s A + t B is a pair of lines, and -trace adj is positive for a pair of real lines, negative for a
// pair of complex ones. Diagonalise A and B together: with three real roots the diagonals give squares X : Y : Z of
// the points' coordinates, all of one sign (four real points, three real pairs of lines) or not (no real point, one
// real pair); with one real root two points are real and the real member is a real pair. In every case
//     number of real common points = 1 + sum over the real roots of sign(-trace adj).
// That sum is the signature of Hermite's trace form: H[j][k] = sum over all roots of P(x) x^(j+k), P = -trace adj, a
// rational function of the coefficients (C. Hermite 1853; Basu, Pollack, Roy, "Algorithms in Real Algebraic
// Geometry", 2006, section 4.3). H is regular exactly when f has three different roots and P vanishes at none of them:
// not at real ones unless the member is a double line, at complex ones only by chance (P depends on the coordinates).
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/signature.hpp"

namespace burmester {

namespace detail {

/// H of the monic cubic x^3 + p x^2 + q x + r and P = P0 x^2 + P1 x + P2; power sums by Newton's identities.
template <class T>
Matrix<T, 3, 3> hermite_form(const T& p, const T& q, const T& r, const std::array<T, 3>& P) {
  std::array<T, 7> s{T(3), T(-p), T(p * p - 2 * q)};
  for (std::size_t k = 3; k < 7; ++k) s[k] = -(p * s[k - 1] + q * s[k - 2] + r * s[k - 3]);
  std::array<T, 5> h;
  for (std::size_t k = 0; k < 5; ++k) h[k] = P[0] * s[k + 2] + P[1] * s[k + 1] + P[2] * s[k];
  Matrix<T, 3, 3> H;
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) H(j, k) = h[static_cast<std::size_t>(j + k)];
  return H;
}

}  // namespace detail

namespace detail {

/// Inertia of H; nothing where the number type cannot tell, or f vanishes identically.
template <class T>
std::optional<Inertia> hermite_inertia(Conic<T> a, Conic<T> b) {
  std::array<T, 4> f = pencil_determinant(a, b);
  if (std::abs(approximate(f[0])) < std::abs(approximate(f[3]))) {
    std::swap(a, b);
    std::swap(f[0], f[3]);
    std::swap(f[1], f[2]);
  }
  for (int k = 1; k < 3 && known_sign(f[0]) == 0; ++k) {  // A and B both singular: take A + k B for A
    a = pencil_member(a, T(1), b, T(1));
    f = pencil_determinant(a, b);
  }
  const std::optional<int> leading = known_sign(f[0]);
  if (!leading || *leading == 0) return std::nullopt;
  const T p = f[1] / f[0], q = f[2] / f[0], r = f[3] / f[0];
  return inertia(hermite_form(p, q, r, PencilSeparation<T>(a, b).top()));
}

/// The conic in coordinates (x, y / 2, z / 5).
template <class T>
Conic<T> stretched(Conic<T> c) {
  c.q[1] *= T(4), c.q[2] *= T(25), c.q[3] *= T(10), c.q[4] *= T(5), c.q[5] *= T(2);
  return c;
}

}  // namespace detail

/// 0, 2 or 4. Nothing where the number type cannot tell, or where the pencil is degenerate (a common point of higher
/// multiplicity, a double line): over exact types only the latter. At a pair of complex roots P may vanish by chance;
/// not in stretched coordinates too.
template <class T>
std::optional<int> count_common_points(const Conic<T>& a, const Conic<T>& b) {
  std::optional<Inertia> form = detail::hermite_inertia(a, b);
  if (form && form->rank < 3) form = detail::hermite_inertia(detail::stretched(a), detail::stretched(b));
  if (!form || form->rank < 3) return std::nullopt;
  return 1 + form->signature;
}

}  // namespace burmester
