// Intervals with rational ends: exact enclosures where intervals of doubles are too coarse. Slow,
// needs no rounding mode.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

class RationalInterval {
 public:
  RationalInterval() = default;
  explicit RationalInterval(double x) : low_(x), high_(x) {}
  RationalInterval(int x) : low_(x), high_(x) {}  // implicit: the formulas write 2 * x
  explicit RationalInterval(const Rational& x) : low_(x), high_(x) {}
  RationalInterval(const Rational& low, const Rational& high) : low_(low), high_(high) {}
  RationalInterval(double low, double high) : low_(low), high_(high) {}

  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }

  RationalInterval operator-() const { return {Rational(-high_), Rational(-low_)}; }
  RationalInterval& operator+=(const RationalInterval& o) {
    low_ += o.low_, high_ += o.high_;
    return *this;
  }
  RationalInterval& operator-=(const RationalInterval& o) { return *this += -o; }
  RationalInterval& operator*=(const RationalInterval& o) {
    const Rational p[4] = {low_ * o.low_, low_ * o.high_, high_ * o.low_, high_ * o.high_};
    low_ = *std::min_element(p, p + 4), high_ = *std::max_element(p, p + 4);
    return *this;
  }
  /// Precondition: o does not contain 0.
  RationalInterval& operator/=(const RationalInterval& o) {
    return *this *= RationalInterval(Rational(1 / o.high_), Rational(1 / o.low_));
  }
  friend RationalInterval operator+(RationalInterval a, const RationalInterval& b) { return a += b; }
  friend RationalInterval operator-(RationalInterval a, const RationalInterval& b) { return a -= b; }
  friend RationalInterval operator*(RationalInterval a, const RationalInterval& b) { return a *= b; }
  friend RationalInterval operator/(RationalInterval a, const RationalInterval& b) { return a /= b; }
  friend RationalInterval operator*(int a, const RationalInterval& b) { return RationalInterval(a) * b; }
  friend RationalInterval operator*(const RationalInterval& a, int b) { return RationalInterval(b) * a; }

 private:
  Rational low_, high_;
};

/// The ends as doubles, moved outward over the rounding of the conversion.
inline double lower(const RationalInterval& x) {
  const double d = static_cast<double>(x.low());
  if (!std::isfinite(d)) return d < 0 ? d : std::numeric_limits<double>::max();
  return Rational(d) <= x.low() ? d : std::nextafter(d, -std::numeric_limits<double>::infinity());
}
inline double upper(const RationalInterval& x) {
  const double d = static_cast<double>(x.high());
  if (!std::isfinite(d)) return d > 0 ? d : std::numeric_limits<double>::lowest();
  return Rational(d) >= x.high() ? d : std::nextafter(d, std::numeric_limits<double>::infinity());
}

template <>
inline double approximate(const RationalInterval& x) {
  return static_cast<double>(Rational((x.low() + x.high()) / 2));
}

}  // namespace burmester
