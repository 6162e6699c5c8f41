// Polynomials in one variable, dense: p(x) = c[0] + c[1] x + .. + c[n] x^n.
//
// Trimmed: the last coefficient is not known to be zero, the zero polynomial has none. Over exact types everything
// here is exact.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "burmester/geometry/sign.hpp"

namespace burmester {

template <class T>
class Polynomial {
 public:
  Polynomial() = default;  ///< the zero polynomial
  /// Coefficients, constant term first.
  explicit Polynomial(std::vector<T> coefficients) : c_(std::move(coefficients)) { trim(); }

  int degree() const { return static_cast<int>(c_.size()) - 1; }  ///< -1 for the zero polynomial
  bool is_zero() const { return c_.empty(); }
  const std::vector<T>& coefficients() const { return c_; }
  /// Coefficient of x^k, 0 <= k <= degree.
  const T& operator[](int k) const { return c_[static_cast<std::size_t>(k)]; }
  /// Precondition: not zero.
  const T& leading() const { return c_.back(); }

  /// Horner's rule over the type of x (T itself, or intervals that T converts to).
  template <class X>
  X operator()(const X& x) const {
    X value(0);
    for (std::size_t k = c_.size(); k-- > 0;) value = value * x + X(c_[k]);
    return value;
  }

  Polynomial derivative() const {
    std::vector<T> d;
    for (std::size_t k = 1; k < c_.size(); ++k) d.push_back(c_[k] * static_cast<int>(k));
    return Polynomial(std::move(d));
  }
  /// x^degree p(1/x)
  Polynomial reversed() const { return Polynomial(std::vector<T>(c_.rbegin(), c_.rend())); }
  /// p(x + h)
  Polynomial shifted(const T& h) const {
    std::vector<T> s = c_;
    for (std::size_t i = 1; i < s.size(); ++i)
      for (std::size_t k = s.size() - 1; k >= i; --k) s[k - 1] += h * s[k];
    return Polynomial(std::move(s));
  }

  Polynomial operator-() const {
    Polynomial out = *this;
    for (T& c : out.c_) c = -c;
    return out;
  }
  friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    const bool a_is_longer = a.c_.size() > b.c_.size();
    std::vector<T> sum = a_is_longer ? a.c_ : b.c_;
    const std::vector<T>& other = a_is_longer ? b.c_ : a.c_;
    for (std::size_t k = 0; k < other.size(); ++k) sum[k] += other[k];
    return Polynomial(std::move(sum));
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    std::vector<T> product(a.c_.size() + b.c_.size() - 1, T(0));
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      for (std::size_t k = 0; k < b.c_.size(); ++k) product[i + k] += a.c_[i] * b.c_[k];
    return Polynomial(std::move(product));
  }
  friend Polynomial operator*(const Polynomial& a, const T& factor) {
    Polynomial out = a;
    for (T& c : out.c_) c *= factor;
    out.trim();
    return out;
  }
  friend bool operator==(const Polynomial& a, const Polynomial& b) { return a.c_ == b.c_; }

 private:
  void trim() {
    while (!c_.empty() && known_sign(c_.back()) == 0) c_.pop_back();
  }
  std::vector<T> c_;
};

}  // namespace burmester
