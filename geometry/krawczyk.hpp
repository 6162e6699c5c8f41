// Boxes that provably hold exactly one zero of a small square system.
//
// Krawczyk's operator (R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", Computing
// 4 (1969); R. E. Moore, "A test for existence of solutions to nonlinear systems", SIAM J. Numer. Anal. 14 (1977)): for
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

/// Half widths of a box around the exact point z with exactly one zero; nothing where none could be proved (z is not
/// near a simple zero, or the system's coefficients are too wide). `centre` encloses z, tightly, and `value` encloses
/// F(z): where that was found with more precision than Interval has, the box is smaller than a rounding of z.
template <class Interval, class System>
std::optional<Vector<double, System::size>> krawczyk_radius(const System& system,
                                                            const Vector<Interval, System::size>& centre,
                                                            const Vector<Interval, System::size>& value) {
  constexpr int N = System::size;
  using Radius = Vector<double, N>;
  const Matrix<Interval, N, N> J = system.jacobian(centre);
  Matrix<double, N, N> middle;
  for (int i = 0; i < N * N; ++i) middle(i) = approximate(J(i));
  const Matrix<double, N, N> Y = middle.inverse();
  if (!Y.allFinite()) return std::nullopt;

  Radius step;
  for (int r = 0; r < N; ++r) {
    Interval sum = Interval(Y(r, 0)) * value[0];
    for (int k = 1; k < N; ++k) sum += Interval(Y(r, k)) * value[k];
    step[r] = magnitude(sum);
  }
  constexpr double outward = 1 + 0x1p-48;  // covers the roundings of a line of doubles below, whatever their mode
  Radius radius = 2 * step + Radius::Constant(2 * step.maxCoeff() * 0x1p-10 + 1e-300);
  for (int attempt = 0; attempt < 4; ++attempt) {
    Vector<Interval, N> x;
    for (int i = 0; i < N; ++i) x[i] = centre[i] + Interval(-radius[i], radius[i]);
    const Matrix<double, N, N> M = detail::contraction<Interval, N>(Y, system.jacobian(x));
    if (!M.allFinite()) return std::nullopt;
    const Radius image = outward * (step + M * radius);
    if ((image.array() < radius.array()).all()) return image;
    radius = 2 * image + radius;
  }
  return std::nullopt;
}

/// The same around a point of doubles.
template <class Interval, class System>
std::optional<Box<System::size>> krawczyk(const System& system, const Vector<double, System::size>& z) {
  Box<System::size> box{z, Vector<double, System::size>::Zero()};
  const Vector<Interval, System::size> centre = box.template hull<Interval>();
  const auto radius = krawczyk_radius<Interval>(system, centre, system.value(centre));
  if (!radius) return std::nullopt;
  box.radius = *radius;
  return box;
}

}  // namespace burmester
