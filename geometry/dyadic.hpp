// The ring of the doubles: numbers m 2^e with integers m, e. Exact + - *, no division.
//
// A polynomial with integer coefficients in doubles has such a value, so its sign needs no fraction: no
// greatest common divisor is ever taken, which makes this three to five times faster than Rational. The
// mantissa is Boost's cpp_int also where GMP is there: up to 256 bits it lives in the object, and what
// predicates need is shorter than an allocation takes to be worth it. m is odd when it comes from a double; a
// sum is aligned to the smaller exponent.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/sign.hpp"

namespace burmester {

class Dyadic {
 public:
  using Mantissa = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<256>,
                                                 boost::multiprecision::et_off>;

  Dyadic() = default;              // 0
  Dyadic(int x) : mantissa_(x) {}  // implicit: the formulas write 2 * x
  /// Precondition: x is finite.
  explicit Dyadic(double x) {
    if (x == 0) return;
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
    mantissa_ = digits / (std::int64_t{1} << zeros);
    exponent_ = exponent - 53 + zeros;
  }

  /// The value is mantissa() 2^exponent().
  const Mantissa& mantissa() const { return mantissa_; }
  int exponent() const { return exponent_; }

  int sign() const { return mantissa_.sign(); }
  /// Within a few units in the last place, like approximate(); infinite where it overflows.
  explicit operator double() const {
    if (sign() == 0) return 0;
    const int excess = static_cast<int>(msb(abs(mantissa_))) - 63;
    if (excess <= 0) return std::ldexp(static_cast<double>(mantissa_), exponent_);
    return std::ldexp(static_cast<double>(Mantissa(mantissa_ >> excess)), exponent_ + excess);
  }

  Dyadic operator-() const { return {Mantissa(-mantissa_), exponent_}; }
  Dyadic& operator+=(const Dyadic& o) {
    if (o.sign() == 0) return *this;
    if (sign() == 0) return *this = o;
    if (exponent_ < o.exponent_) {
      mantissa_ += Mantissa(o.mantissa_ << (o.exponent_ - exponent_));
    } else {
      mantissa_ <<= exponent_ - o.exponent_;
      mantissa_ += o.mantissa_;
      exponent_ = o.exponent_;
    }
    return *this;
  }
  Dyadic& operator-=(const Dyadic& o) {
    negate();  // a - b = -(-a + b), in place
    *this += o;
    negate();
    return *this;
  }
  Dyadic& operator*=(const Dyadic& o) { return *this = *this * o; }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {Mantissa(a.mantissa_ * b.mantissa_), a.exponent_ + b.exponent_};
  }
  friend Dyadic operator+(Dyadic a, const Dyadic& b) { return std::move(a += b); }
  friend Dyadic operator-(Dyadic a, const Dyadic& b) { return std::move(a -= b); }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }

 private:
  Dyadic(Mantissa&& mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
  void negate() { mantissa_.backend().negate(); }

  Mantissa mantissa_ = 0;
  int exponent_ = 0;
};

template <>
inline std::optional<int> known_sign(const Dyadic& x) {
  return x.sign();
}

}  // namespace burmester
