// Arguments of the polynomials of geometry/signs.hpp: random ones, and such whose exact value is zero but for
// the rounding of the arguments themselves.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/signs.hpp"

namespace burmester {

template <std::size_t n>
std::array<double, n> random_arguments(Random& random) {
  std::array<double, n> out;
  for (double& x : out) x = random.normal();
  return out;
}

/// n x n: the last row is a combination of the others.
template <std::size_t n>
std::array<double, n * n> near_singular(Random& random) {
  auto m = random_arguments<n * n>(random);
  std::array<double, n> factors;
  for (double& f : factors) f = random.normal();
  for (std::size_t c = 0; c < n; ++c) {
    m[n * (n - 1) + c] = 0;
    for (std::size_t r = 0; r + 1 < n; ++r) m[n * (n - 1) + c] += factors[r] * m[n * r + c];
  }
  return m;
}

/// near_degenerate(F(), random): arguments for F.
inline auto near_degenerate(Determinant<2>, Random& random) { return near_singular<2>(random); }
inline auto near_degenerate(Determinant<3>, Random& random) { return near_singular<3>(random); }
inline auto near_degenerate(Determinant<4>, Random& random) { return near_singular<4>(random); }

/// Points of a line.
inline auto near_degenerate(Orientation2, Random& random) {
  auto p = random_arguments<6>(random);
  const double s = random.normal();
  for (std::size_t i = 0; i < 2; ++i) p[4 + i] = p[i] + s * (p[2 + i] - p[i]);
  return p;
}
/// Points of a plane.
inline auto near_degenerate(Orientation3, Random& random) {
  auto p = random_arguments<12>(random);
  const double s = random.normal(), t = random.normal();
  for (std::size_t i = 0; i < 3; ++i) p[9 + i] = p[i] + s * (p[3 + i] - p[i]) + t * (p[6 + i] - p[i]);
  return p;
}
/// Points of a circle.
inline auto near_degenerate(InCircle, Random& random) {
  std::array<double, 8> p;
  const double x = random.normal(), y = random.normal(), radius = random.uniform(0.5, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    p[2 * i] = x + radius * std::cos(angle);
    p[2 * i + 1] = y + radius * std::sin(angle);
  }
  return p;
}
/// A dyad at a dead centre, stretched or folded.
inline auto near_degenerate(DyadClosure, Random& random) {
  auto x = random_arguments<8>(random);
  const double first = std::hypot(x[2] - x[0], x[3] - x[1]), second = std::hypot(x[4] - x[2], x[5] - x[3]);
  const double reach = random.below(2) ? first + second : first - second;
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  x[6] = x[4] + reach * std::cos(angle);
  x[7] = x[5] + reach * std::sin(angle);
  return x;
}

}  // namespace burmester
