// What the templated formulas ask of a number type, beyond + - *.
//
// Rational steps (rows, elimination, conics) run over double, Quad, Interval and Rational; root steps
// (square and cube roots) over double and Quad. A formula never asks which type it got; where it must
// choose (a pivot, a scale) it looks at `approximate(x)`, and a choice may only affect accuracy, never truth.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace burmester {

/// A double within a few units in the last place of x (Interval: a point of it). For choices, not verdicts.
inline double approximate(double x) { return x; }
template <class T>
double approximate(const T& x) {
  return static_cast<double>(x);
}

/// The power of two in (x/2, x], for scalings that lose nothing. Precondition: x normal and positive.
inline double power_of_two_below(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u);
}
/// 1 / power_of_two_below(x), without a division. Precondition: x normal, positive and below 2^1023.
inline double unit_scale(double x) {
  return std::bit_cast<double>(0x7fe0000000000000u - (std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u));
}

/// Unit roundoff of double, 2^-53.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

}  // namespace burmester
