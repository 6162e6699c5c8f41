// The real roots of a binary form F(s, t) = sum c[k] s^k t^(N-k) of even degree in doubles: fast, and not proved.
//
// Isolation by Descartes' rule on Bernstein coefficients with subdivision (J. M. Lane and R. F. Riesenfeld, "Bounds on
// a polynomial", BIT 21 (1981)) in two charts, s/t and t/s in [-1, 1], that agree on the signs at their common ends, so
// that the number of roots is always even; then Newton's method kept between the ends. simple_roots.hpp proves its
// roots at about three times the cost. No allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "burmester/geometry/vector.hpp"

namespace burmester {

template <int N>
struct BinaryRoots {
  int count = 0;
  std::array<Vector<double, 2>, N> at;  ///< (s, t), the larger of the two is 1
  /// Bisections of [-1, 1] that it took: two roots, or a pair of complex ones, may be 2^(1 - depth) apart. At `deepest`
  /// no more is tried, and they are listed as two equal roots.
  int depth = 0;
  static constexpr int deepest = 48;
};

namespace detail {

template <int N>
class BernsteinChart {
 public:
  using Coefficients = std::array<double, N + 1>;

  /// c ascending; the values at -1 and 1 are given, the same doubles for both charts.
  BernsteinChart(const Coefficients& c, double at_minus_one, double at_one, bool reciprocal, BinaryRoots<N>& out)
      : c_(c), reciprocal_(reciprocal), out_(out) {
    Coefficients b{};
    for (int k = 0; k <= N; ++k)
      for (int i = 0; i <= N; ++i) b[i] += c[k] * from_power[k][i];
    b[0] = at_minus_one, b[N] = at_one;
    isolate(b, -1, 2, 0);
  }

 private:
  using Table = std::array<std::array<double, N + 1>, N + 1>;

  /// x^k on [-1, 1] with x = 2 v - 1: the coefficients of (y - 1)^k (y + 1)^(N-k), y = v / (1 - v), over binomials.
  static constexpr Table from_power = [] {
    Table out{};
    for (int k = 0; k <= N; ++k) {
      std::array<double, N + 1> p{1};
      for (int factor = 0; factor < N; ++factor)
        for (int i = N; i >= 0; --i) p[i] = (factor < k ? -p[i] : p[i]) + (i > 0 ? p[i - 1] : 0);
      double choose = 1;
      for (int i = 0; i <= N; choose = choose * (N - i) / (i + 1), ++i) out[k][i] = p[i] / choose;
    }
    return out;
  }();

  void isolate(const Coefficients& b, double low, double width, int depth) {
    int changes = 0, change = 0;  // the last one
    out_.depth = std::max(out_.depth, depth);
    for (int i = 0; i < N; ++i)
      if ((b[i] < 0) != (b[i + 1] < 0)) ++changes, change = i;
    if (changes == 0) return;
    if (changes == 1 || depth == out_.deepest) {
      const double start = low + width * (change + b[change] / (b[change] - b[change + 1])) / N;  // of the polygon
      if ((b[0] < 0) != (b[N] < 0)) return add(narrowed(low, low + width, b[0] < 0, start));
      add(low), add(low);
      return;
    }
    Coefficients left, right = b;
    for (int i = 0; i <= N; ++i) {
      left[i] = right[0];
      for (int k = 0; k < N - i; ++k) right[k] = (right[k] + right[k + 1]) / 2;
    }
    isolate(left, low, width / 2, depth + 1);
    isolate(right, low + width / 2, width / 2, depth + 1);
  }

  void add(double x) {
    if (out_.count == N) return;  // rounding cannot list more roots than there are
    out_.at[static_cast<std::size_t>(out_.count++)] = reciprocal_ ? Vector<double, 2>{1, x} : Vector<double, 2>{x, 1};
  }

  double narrowed(double low, double high, bool rising, double x) const {
    const double smallest_step = 0x1p-30 * (high - low);  // the next one would be its square
    for (int i = 0; i < 80; ++i) {
      // even and odd powers apart: two short chains
      const double y = x * x;
      double even = c_[N], odd = c_[N - 1], even_slope = even, odd_slope = 0;
      for (int k = N - 2;; k -= 2) {
        even = even * y + c_[k];
        if (k == 0) break;
        even_slope = even_slope * y + even;
        odd_slope = odd_slope * y + odd, odd = odd * y + c_[k - 1];
      }
      const double value = even + x * odd, slope = odd + 2 * (x * even_slope + y * odd_slope);
      ((value < 0) == rising ? low : high) = x;
      double next = x - value / slope;
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (std::abs(next - x) <= smallest_step || next == low || next == high) return next;
      x = next;
    }
    return x;
  }

  const Coefficients& c_;
  bool reciprocal_;
  BinaryRoots<N>& out_;
};

}  // namespace detail

/// Precondition: finite coefficients, not all zero.
template <int N>
BinaryRoots<N> binary_roots(const std::array<double, N + 1>& c) {
  static_assert(N >= 2 && N % 2 == 0);
  BinaryRoots<N> out;
  double at_one = 0, at_minus_one = 0;
  for (int k = 0; k <= N; ++k) at_one += c[k], at_minus_one += k % 2 == 0 ? c[k] : -c[k];
  std::array<double, N + 1> reversed = c;
  std::reverse(reversed.begin(), reversed.end());
  detail::BernsteinChart<N>(c, at_minus_one, at_one, false, out);
  detail::BernsteinChart<N>(reversed, at_minus_one, at_one, true, out);
  return out;
}

}  // namespace burmester
