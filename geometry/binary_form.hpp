// Binary forms of degree at most eight: f(u0, u1) = sum c[k] u0^(n-k) u1^k, functions on the projective line.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/sign.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

/// A point (u0 : u1) of the projective line.
template <class T>
using Point1 = Vector<T, 2>;

template <class T>
struct BinaryForm {
  static constexpr std::size_t highest_degree = 8;
  std::size_t degree = 0;
  std::array<T, highest_degree + 1> c;  ///< those behind c[degree] are zero

  BinaryForm(int constant = 0) {  // implicit: the formulas of conic.hpp write 2 * x
    c.fill(T(0));
    c[0] = T(constant);
  }
  /// Degree: one less than there are coefficients.
  explicit BinaryForm(const std::vector<T>& coefficients) : BinaryForm() {
    degree = coefficients.size() - 1;
    for (std::size_t k = 0; k <= degree; ++k) c[k] = coefficients[k];
  }
  static BinaryForm constant(const T& value) { return BinaryForm(std::vector<T>{value}); }
  /// The linear form that vanishes at u.
  static BinaryForm vanishing_at(const Point1<T>& u) { return BinaryForm(std::vector<T>{u[1], T(-u[0])}); }

  std::vector<T> coefficients() const { return {c.begin(), c.begin() + static_cast<std::ptrdiff_t>(degree) + 1}; }

  T operator()(const T& u0, const T& u1) const { return (*this)(Point1<T>(u0, u1)); }
  /// X: T, or a type that T converts to.
  template <class X>
  X operator()(const Point1<X>& u) const {
    X value(c[0]), power = u[1];
    for (std::size_t k = 1; k <= degree; ++k) {
      value = value * u[0] + X(c[k]) * power;
      if (k < degree) power = power * u[1];
    }
    return value;
  }
  /// Known to be zero in every coefficient.
  bool is_zero() const {
    for (std::size_t k = 0; k <= degree; ++k)
      if (known_sign(c[k]) != 0) return false;
    return true;
  }

  friend BinaryForm operator*(const BinaryForm& f, const BinaryForm& g) {
    BinaryForm out;
    out.degree = f.degree + g.degree;
    assert(out.degree <= highest_degree);
    for (std::size_t i = 0; i <= f.degree; ++i)
      for (std::size_t k = 0; k <= g.degree; ++k) out.c[i + k] += f.c[i] * g.c[k];
    return out;
  }
  /// Precondition of sums: equal degrees.
  friend BinaryForm operator+(BinaryForm f, const BinaryForm& g) {
    assert(f.degree == g.degree);
    for (std::size_t k = 0; k <= f.degree; ++k) f.c[k] += g.c[k];
    return f;
  }
  friend BinaryForm operator-(BinaryForm f, const BinaryForm& g) {
    assert(f.degree == g.degree);
    for (std::size_t k = 0; k <= f.degree; ++k) f.c[k] -= g.c[k];
    return f;
  }

  /// f / vanishing_at(u) for a root u of f; the remainder is dropped. In the direction in which roundings do not grow.
  BinaryForm divided_by_root(const Point1<T>& u) const {
    return std::abs(approximate(u[0])) >= std::abs(approximate(u[1])) ? divided_from_last(u) : divided_from_first(u);
  }
  /// The same, c[0] first: small first coefficients keep their relative accuracy. Precondition: u[1] is not 0.
  BinaryForm divided_from_first(const Point1<T>& u) const {
    BinaryForm q;
    q.degree = degree - 1;
    q.c[0] = c[0] / u[1];
    for (std::size_t k = 1; k < degree; ++k) q.c[k] = (c[k] + u[0] * q.c[k - 1]) / u[1];
    return q;
  }

 private:
  BinaryForm divided_from_last(const Point1<T>& u) const {
    BinaryForm q;
    q.degree = degree - 1;
    q.c[degree - 1] = -c[degree] / u[0];
    for (std::size_t k = degree - 1; k > 0; --k) q.c[k - 1] = (u[1] * q.c[k] - c[k]) / u[0];
    return q;
  }
};

/// The coefficients in another number type.
template <class To, class From, class Convert>
BinaryForm<To> converted(const BinaryForm<From>& f, Convert convert) {
  BinaryForm<To> out;
  out.degree = f.degree;
  for (std::size_t k = 0; k <= f.degree; ++k) out.c[k] = convert(f.c[k]);
  return out;
}

}  // namespace burmester
