// Boxes that provably hold exactly one zero of a small square system.
//
// Krawczyk's operator (R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", Computing 4
// (1969); R. E. Moore, "A test for existence of solutions to nonlinear systems", SIAM J. Numer. Anal. 14 (1977)): for
// F(x) = 0, a point z, a box X around it and any regular matrix Y, if
//     K(X) = z - Y F(z) + (I - Y F'(X)) (X - z)
// lies in the interior of X, then X holds exactly one zero of F, and K(X) holds it too.
//
// A system has `static constexpr int size`, `value(x)` and `jacobian(x)` over vectors of Interval: any interval type
// with lower(), upper() and enclosing + - *. Where it needs a live rounding guard, so does everything here.
#pragma once

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

/// centre[i] - radius[i] <= x[i] <= centre[i] + radius[i]
template <int N>
struct Box {
  Vector<double, N> centre, radius;

  template <class Interval>
  Vector<Interval, N> hull() const {
    Vector<Interval, N> x;
    for (int i = 0; i < N; ++i) x[i] = Interval(centre[i]) + Interval(-radius[i], radius[i]);
    return x;
  }
};

namespace detail {

/// |I - Y J(X)|, entry by entry from above.
template <class Interval, int N>
Matrix<double, N, N> contraction(const Matrix<double, N, N>& Y, const Matrix<Interval, N, N>& J) {
  Matrix<double, N, N> out;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) {
      Interval sum = Interval(r == c ? 1.0 : 0.0);
      for (int k = 0; k < N; ++k) sum -= Interval(Y(r, k)) * J(k, c);
      out(r, c) = magnitude(sum);
    }
  return out;
}

}  // namespace detail

/// A box around z with exactly one zero; nothing where none could be proved (z is not near a simple zero, or the
/// system's coefficients are too wide).
template <class Interval, class System>
std::optional<Box<System::size>> krawczyk(const System& system, const Vector<double, System::size>& z) {
  constexpr int N = System::size;
  const Vector<Interval, N> centre = Box<N>{z, Vector<double, N>::Zero()}.template hull<Interval>();
  const Matrix<Interval, N, N> J = system.jacobian(centre);
  Matrix<double, N, N> middle;
  for (int i = 0; i < N * N; ++i) middle(i) = approximate(J(i));
  const Matrix<double, N, N> Y = middle.inverse();
  if (!Y.allFinite()) return std::nullopt;

  const Vector<Interval, N> f = system.value(centre);
  Vector<double, N> step;
  for (int r = 0; r < N; ++r) {
    Interval sum = Interval(Y(r, 0)) * f[0];
    for (int k = 1; k < N; ++k) sum += Interval(Y(r, k)) * f[k];
    step[r] = magnitude(sum);
  }
  constexpr double outward = 1 + 0x1p-48;  // covers the roundings of a line of doubles below, whatever their mode
  Box<N> box{z, 2 * step + Vector<double, N>::Constant(2 * step.maxCoeff() * 0x1p-10 + 1e-300)};
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Matrix<double, N, N> M = detail::contraction<Interval, N>(Y, system.jacobian(box.template hull<Interval>()));
    if (!M.allFinite()) return std::nullopt;
    const Vector<double, N> image = outward * (step + M * box.radius);
    if ((image.array() < box.radius.array()).all()) return Box<N>{z, image};
    box.radius = 2 * image + box.radius;
  }
  return std::nullopt;
}

}  // namespace burmester
