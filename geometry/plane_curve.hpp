// Plane algebraic curves of degree up to 6, as ternary forms.
//
// Notation: F(x, y, z) = sum of c(i, j) x^i y^j z^(d - i - j) over i + j <= d. Stored order: j ascending, for
// each j i ascending: z^d, x z^(d-1), .., x^d, y z^(d-1), x y z^(d-2), .., y^d. Everything here is a
// polynomial with integer coefficients: exact over exact number types. Coefficients of type double stand for
// exactly these numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/cubic.hpp"
#include "burmester/geometry/number.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class T>
struct TernaryForm {
  static constexpr int highest_degree = 6;

  int degree = 0;
  std::array<T, (highest_degree + 1) * (highest_degree + 2) / 2> coefficients;  ///< the first size() count

  /// The zero form. Precondition: 0 <= d <= highest_degree.
  explicit TernaryForm(int d = 0) : degree(d) {
    coefficients.fill(T(0));
  }  // not every number type starts at 0
  explicit TernaryForm(const LinearForm<T>& l) : TernaryForm(1) {
    (*this)(1, 0) = l[0], (*this)(0, 1) = l[1], (*this)(0, 0) = l[2];
  }
  explicit TernaryForm(const Conic<T>& c) : TernaryForm(2) {
    (*this)(2, 0) = c.q[0], (*this)(0, 2) = c.q[1], (*this)(0, 0) = c.q[2];
    (*this)(0, 1) = c.q[3], (*this)(1, 0) = c.q[4], (*this)(1, 1) = c.q[5];
  }
  explicit TernaryForm(const Cubic<T>& f) : TernaryForm(3) {
    std::size_t k = 0;
    for (int rest = 0; rest <= 3; ++rest)
      for (int j = rest; j >= 0; --j) (*this)(3 - rest, j) = f.c[k++];
  }
  /// The same form over another number type. Precondition: the numbers are numbers of U, or are rounded.
  template <class U>
  TernaryForm<U> cast() const {
    TernaryForm<U> out(degree);
    for (int k = 0; k < size(); ++k) out.coefficients[index(k)] = U(coefficients[index(k)]);
    return out;
  }

  /// Precondition: degree three.
  Cubic<T> cubic() const {
    Cubic<T> f;
    std::size_t k = 0;
    for (int rest = 0; rest <= 3; ++rest)
      for (int j = rest; j >= 0; --j) f.c[k++] = (*this)(3 - rest, j);
    return f;
  }

  int size() const { return (degree + 1) * (degree + 2) / 2; }
  /// Coefficient of x^i y^j z^(degree - i - j). Precondition: i, j >= 0, i + j <= degree.
  T& operator()(int i, int j) { return coefficients[index(j * (2 * degree + 3 - j) / 2 + i)]; }
  const T& operator()(int i, int j) const { return coefficients[index(j * (2 * degree + 3 - j) / 2 + i)]; }

  T operator()(const Point2<T>& p) const {
    T value(0);
    for (int j = degree; j >= 0; --j) {  // Horner's rule in y, for each of its coefficients in x
      T row = (*this)(degree - j, j), z(1);
      for (int i = degree - j - 1; i >= 0; --i) {
        z *= p[2];
        row = row * p[0] + (*this)(i, j) * z;
      }
      value = value * p[1] + row;
    }
    return value;
  }
  /// The derivative by x, y or z (0, 1 or 2). Precondition: degree > 0.
  TernaryForm derivative(int variable) const {
    TernaryForm out(degree - 1);
    for (int j = 0; j < degree; ++j)
      for (int i = 0; i + j < degree; ++i)
        out(i, j) = variable == 0   ? (*this)(i + 1, j) * T(i + 1)
                    : variable == 1 ? (*this)(i, j + 1) * T(j + 1)
                                    : (*this)(i, j) * T(degree - i - j);
    return out;
  }
  /// On the curve: the tangent there, 0 at a singular point.
  LinearForm<T> gradient(const Point2<T>& p) const {
    return {derivative(0)(p), derivative(1)(p), derivative(2)(p)};
  }

  /// Precondition: equal degrees.
  TernaryForm& operator+=(const TernaryForm& o) {
    for (int k = 0; k < size(); ++k) coefficients[index(k)] += o.coefficients[index(k)];
    return *this;
  }
  TernaryForm& operator*=(const T& factor) {
    for (int k = 0; k < size(); ++k) coefficients[index(k)] *= factor;
    return *this;
  }
  friend TernaryForm operator+(TernaryForm a, const TernaryForm& b) { return a += b; }
  friend TernaryForm operator*(TernaryForm a, const T& factor) { return a *= factor; }
  /// Precondition: the degrees add up to at most highest_degree.
  friend TernaryForm operator*(const TernaryForm& a, const TernaryForm& b) {
    TernaryForm out(a.degree + b.degree);
    for (int j = 0; j <= a.degree; ++j)
      for (int i = 0; i + j <= a.degree; ++i)
        for (int l = 0; l <= b.degree; ++l)
          for (int k = 0; k + l <= b.degree; ++k) out(i + k, j + l) += a(i, j) * b(k, l);
    return out;
  }

  /// F(m p) as a form in p: the curve seen from coordinates p, where m p are the present ones.
  TernaryForm substituted(const Matrix<T, 3, 3>& m) const {
    const auto row = [&m](int r) { return TernaryForm(LinearForm<T>(m(r, 0), m(r, 1), m(r, 2))); };
    const TernaryForm x = row(0), y = row(1), z = row(2);
    TernaryForm out;
    for (int j = degree; j >= 0; --j) {  // as in the evaluation
      TernaryForm inner, power;
      inner(0, 0) = (*this)(degree - j, j), power(0, 0) = T(1);
      for (int i = degree - j - 1; i >= 0; --i) {
        power = power * z;
        inner = inner * x + power * (*this)(i, j);
      }
      out = j == degree ? inner : out * y + inner;
    }
    return out;
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
};

/// Largest magnitude among the coefficients.
template <class T>
double size_of(const TernaryForm<T>& f) {
  double size = 0;
  for (const T& c : f.coefficients) size = std::max(size, std::abs(approximate(c)));
  return size;
}

using PlaneCurve = TernaryForm<double>;

}  // namespace burmester
