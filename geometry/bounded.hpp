// Doubles with a running error bound: the first rung of an exact sign.
//
// Beside the computed value v of an expression runs its magnitude m: the same expression with every term positive.
//     argument x                    v = x             m = |x|
//     a +- b                        v = va +- vb      m = ma + mb
//     a b                           v = va vb         m = ma mb + eta, eta = 2^-1022
//     a - b of two arguments        v = va - vb       m = |v|             (difference)
// Everything is rounded. With w = 2^-52 and the depth k (argument 0, sum 1 + max, product 1 + ka + kb, difference 1)
//     |v - exact| <= bound(k) m,    bound(k) = k w (1 + 2^-40),  k <= 512.
//
// Proof. Rounding to nearest or upward makes of z a double z' with |z' - z| <= w |z|, |z' - z| <= w |z'|, and
// where a product underflows instead |z' - z| <= 2^-1074 = w eta (sums do not underflow). Let S be m without
// rounding, except that S = |exact| for a difference. By induction
//     |v - exact| <= ((1 + w)^k - 1) S  and  S <= (1 + w)^(3k) m.
// Product, A = (1 + w)^ka, B = (1 + w)^kb: |va vb - exact| <= (A B - 1) Sa Sb and |va vb| <= A B Sa Sb, so
// that the rounding adds at most w A B Sa Sb + w eta, together at most ((1 + w) A B - 1)(Sa Sb + eta). For m:
// ma mb becomes at least ma mb / (1 + w) - w eta, the sum with eta at least (ma mb / (1 + w) + (1 - w) eta) /
// (1 + w) >= (ma mb + eta) / (1 + w)^3. Sum: (max(A, B) - 1) S, the rounding adds at most w max(A, B) S; m
// loses one factor 1 + w. Difference: one rounding. At last ((1 + w)^k - 1)(1 + w)^(3k) <= k w (1 + 4.1 k w)
// <= bound(k).
//
// |v| > fl(bound m) implies |v| > bound m, rounding being monotone. Overflow: |v| <= m throughout (again
// monotone, and m rounds up where v does), so where v overflows m is infinite and nothing is decided; nor
// where either is not a number. J. H. Wilkinson, "Rounding Errors in Algebraic Processes", 1963; the use for
// predicates: S. Fortune, C. J. Van Wyk, "Static analysis yields efficient exact integer arithmetic for
// computational geometry", ACM Trans. Graphics 15 (1996).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "burmester/geometry/number.hpp"

namespace burmester {

class Bounded {
 public:
  Bounded() = default;
  Bounded(int x) : Bounded(static_cast<double>(x)) {}  // implicit: the formulas write 2 * x
  explicit Bounded(double x) : Bounded(x, std::abs(x)) {}

  double value() const { return value_; }
  double magnitude() const { return magnitude_; }

  Bounded operator-() const { return {-value_, magnitude_}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value_ + b.value_, a.magnitude_ + b.magnitude_};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value_ - b.value_, a.magnitude_ + b.magnitude_};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return {a.value_ * b.value_, a.magnitude_ * b.magnitude_ + std::numeric_limits<double>::min()};
  }
  friend Bounded difference(const Bounded& a, const Bounded& b) { return Bounded(a.value_ - b.value_); }

 private:
  Bounded(double value, double magnitude) : value_(value), magnitude_(magnitude) {}

  double value_ = 0, magnitude_ = 0;
};

/// The number k of the header comment: the same expression evaluated over it gives its depth.
class Depth {
 public:
  constexpr Depth(int = 0) {}

  constexpr int value() const { return k_; }

  constexpr Depth operator-() const { return *this; }
  friend constexpr Depth operator+(Depth a, Depth b) { return of(std::max(a.k_, b.k_) + 1); }
  friend constexpr Depth operator-(Depth a, Depth b) { return a + b; }
  friend constexpr Depth operator*(Depth a, Depth b) { return of(a.k_ + b.k_ + 1); }
  /// Not constant, and therefore an error of compilation, unless both are arguments.
  friend constexpr Depth difference(Depth a, Depth b) {
    if (a.k_ != 0 || b.k_ != 0) throw "difference() is for two arguments of the expression";
    return of(1);
  }

 private:
  static constexpr Depth of(int k) {
    Depth out;
    out.k_ = k;
    return out;
  }
  int k_ = 0;
};

/// a - b of two arguments of an expression (coordinates, say), better bounded than a - b: far from the origin
/// it decides as well as near it.
template <class T>
constexpr T difference(const T& a, const T& b) {
  return a - b;
}

/// f of the arguments x, each turned into a T.
template <class F, class T, std::size_t N>
inline T evaluate(const std::array<double, N>& x) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) { return F{}(std::array<T, N>{T(x[i])...}); }
  (std::make_index_sequence<N>());
}

/// 1 or -1 if plain doubles prove it (rounding to nearest or upward), nothing otherwise; never 0. F: see ladder.hpp.
template <class F, std::size_t N>
inline std::optional<int> sign_by_doubles(const std::array<double, N>& x) {
  constexpr int k = F{}(std::array<Depth, N>{}).value();
  static_assert(k <= 512, "the bound is proved for expressions of depth up to 512");
  constexpr double bound = k * (1 + 0x1p-40) * 0x1p-52;
  const Bounded f = evaluate<F, Bounded>(x);
  if (std::abs(f.value()) > bound * f.magnitude()) return f.value() > 0 ? 1 : -1;
  return std::nullopt;
}

}  // namespace burmester
