// The real roots of a binary form F(s, t) = sum c_k s^k t^(N-k) with interval coefficients, when all of them are simple
// and the intervals are narrow enough to prove it. Only for targets that compile intervals, below an UpwardRounding.
//
// Descartes' rule on Bernstein coefficients: the number of roots in an open interval, counted with multiplicities, is
// the number of sign changes or less by an even number; so none without a change, one with a single one. Otherwise de
// Casteljau's subdivision (J. M. Lane and R. F. Riesenfeld, "Bounds on a polynomial", BIT 21 (1981)). Boxes shrink by
// the interval Newton operator (R. E. Moore, "Interval Analysis", 1966). Every statement holds for each form with
// coefficients in the intervals. Two charts cover the projective line: s/t in [-r, r] and t/s in [-1/r, 1/r] with r =
// 1; with r = 2 or 1/2 where 1 or -1 may be a root. No allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester {

/// A part of the projective line of the points (s : t).
struct ProjectiveBox {
  bool reciprocal = false;  ///< false: s/t is in `at`; true: t/s is
  Range at;                 ///< within [-2, 2]
};

/// In the order of ascending s/t, from -r through 0, r and infinity back to -r.
template <int N>
struct SimpleRoots {
  int count = 0;
  std::array<ProjectiveBox, N> at;
};

namespace detail {

template <int N>
using Coefficients = std::array<Interval, N + 1>;

template <int N>
Interval horner(const Coefficients<N>& c, const Interval& x) {
  Interval value = c[N];
  for (int k = N; k-- > 0;) value = value * x + c[k];
  return value;
}

template <int N>
Interval horner_of_derivative(const Coefficients<N>& c, const Interval& x) {
  Interval value = N * c[N];
  for (int k = N; k-- > 1;) value = value * x + k * c[k];
  return value;
}

/// Bernstein coefficients on [-r, r], r a power of two: those of q(u) = p(r (2 u - 1)) on [0, 1].
template <int N>
Coefficients<N> bernstein(Coefficients<N> c, double r) {
  double power = 1;
  for (int k = 0; k <= N; ++k, power *= 2 * r) c[k] *= power;  // v = u - 1/2
  for (int i = 1; i <= N; ++i)
    for (int k = N; k >= i; --k) c[k - 1] -= c[k] / 2;
  for (int i = 0, choose = 1; i <= N; choose = choose * (N - i) / (i + 1), ++i) c[i] /= choose;
  for (int i = 1; i <= N; ++i)
    for (int k = N; k >= i; --k) c[k] += c[k - 1];
  return c;
}

/// The largest number of sign changes that numbers in the intervals can have.
template <int N>
int most_sign_changes(const Coefficients<N>& b) {
  constexpr int never = -2 * N - 2;
  int ending_above = 0, ending_below = 0;  // after a number above (below) zero
  for (const Interval& x : b) {
    const int above = std::max(ending_above, ending_below + 1), below = std::max(ending_below, ending_above + 1);
    const std::optional<int> sign = known_sign(x);
    if (sign == 0) continue;
    ending_above = sign == -1 ? never : &x == b.data() ? 0 : above;
    ending_below = sign == 1 ? never : &x == b.data() ? 0 : below;
  }
  return std::max({ending_above, ending_below, 0});
}

/// One chart: its polynomial, ascending, on [-r, r], and the roots found so far.
template <int N>
class ChartRoots {
 public:
  ChartRoots(const Coefficients<N>& c, double r) : c_(c), b_(bernstein<N>(c, r)), r_(r) {}

  bool may_vanish_at_an_end() const { return contains_zero(b_[0]) || contains_zero(b_[N]); }
  /// All roots; false where not all are proved. Precondition: no end may be a root.
  bool find() { return find(b_, -r_, r_, 0); }
  int count() const { return count_; }
  const Range& operator[](int i) const { return found_[static_cast<std::size_t>(i)]; }

 private:
  static constexpr int deepest = 40;

  /// b: Bernstein coefficients on [low, high], the first and the last of known sign.
  bool find(const Coefficients<N>& b, double low, double high, int depth) {
    const int changes = most_sign_changes<N>(b);
    if (changes == 0) return true;
    if (changes == 1) {  // the ends have different signs: otherwise the number would be even
      found_[static_cast<std::size_t>(count_++)] = narrowed(low, high, *known_sign(b[0]));
      return true;
    }
    return depth < deepest && split(b, low, high, depth);
  }

  /// Where the polynomial is not 0 for certain, and where doubles can name the place.
  bool split(const Coefficients<N>& b, double low, double high, int depth) {
    for (const double part : {1.0 / 2, 7.0 / 16, 5.0 / 8}) {
      const Interval middle = Interval(low) + (Interval(high) - Interval(low)) * part;
      Coefficients<N> left, right = b;
      for (int i = 0; i <= N; ++i) {
        left[i] = right[0];
        for (int k = 0; k < N - i; ++k) right[k] += part * (right[k + 1] - right[k]);
      }
      if (contains_zero(right[0]) || !middle.is_point()) continue;
      return find(left, low, middle.inf(), depth + 1) && find(right, middle.inf(), high, depth + 1);
    }
    return false;
  }

  /// Newton and bisection. Precondition: exactly one root between low and high, where the signs are known.
  Range narrowed(double low, double high, int sign_at_low) const {
    for (;;) {
      const double width = high - low;
      double point = low;
      Interval value;
      for (const double part : {1.0 / 2, 1.0 / 4, 3.0 / 4}) {
        point = std::min(low + part * width, high);
        value = horner<N>(c_, Interval(point));
        const std::optional<int> sign = known_sign(value);
        if (!sign) continue;
        if (*sign == 0) return {point, point};
        (*sign == sign_at_low ? low : high) = point;
        break;
      }
      const Interval slope = horner_of_derivative<N>(c_, Interval(low, high));
      if (!contains_zero(slope)) {
        const Interval newton = Interval(point) - value / slope;
        low = std::max(low, newton.inf()), high = std::min(high, newton.sup());
      }
      if (!(high - low < 0.8 * width)) return {low, high};
    }
  }

  Coefficients<N> c_, b_;
  double r_;
  int count_ = 0;
  std::array<Range, N> found_;
};

}  // namespace detail

/// All real roots of the form, each proved simple and alone in its box (roots at infinity too); nothing where that
/// could not be proved. c[k] is the coefficient of s^k t^(N-k).
template <int N>
std::optional<SimpleRoots<N>> simple_roots(std::array<Interval, N + 1> c) {
  static_assert(N >= 1 && N <= 16);
  double size = 0;
  for (const Interval& x : c) size = std::max(size, magnitude(x));
  if (!(size > 0x1p-1000 && size < 0x1p1000)) return std::nullopt;
  for (Interval& x : c) x *= unit_scale(size);
  detail::Coefficients<N> reversed = c;
  std::reverse(reversed.begin(), reversed.end());
  for (const double r : {1.0, 2.0, 0.5}) {
    detail::ChartRoots<N> finite(c, r), infinite(reversed, 1 / r);
    if (finite.may_vanish_at_an_end() || infinite.may_vanish_at_an_end()) continue;
    if (!finite.find() || !infinite.find()) return std::nullopt;
    SimpleRoots<N> out;
    for (int i = 0; i < finite.count(); ++i) out.at[static_cast<std::size_t>(out.count++)] = {false, finite[i]};
    for (int i = infinite.count(); i-- > 0;) out.at[static_cast<std::size_t>(out.count++)] = {true, infinite[i]};
    return out;
  }
  return std::nullopt;
}

/// Disjoint boxes for all real roots of a polynomial (constant term first), ascending, if they are finite and proved
/// simple. Nothing for degrees above 12.
std::optional<std::vector<Range>> boxes_of_simple_roots(std::span<const Interval> coefficients);

}  // namespace burmester
