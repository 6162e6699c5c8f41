// Jets: a value and its first derivatives by N variables, carried through any rational formula (forward
// differentiation).
//
// (f, f') with the rules of calculus: L. B. Rall, "Automatic Differentiation: Techniques and Applications", Lecture
// Notes in Computer Science 120 (1981). A formula that is a template on its number type needs no second version. Where
// it chooses (approximate), the value decides: the derivative is that of the branch taken.
#pragma once

#include <concepts>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class T, int N>
struct Jet {
  T value;
  Vector<T, N> slope;  ///< derivative by each variable

  Jet() : Jet(0) {}
  Jet(int x) : value(x), slope(Vector<T, N>::Zero()) {}  // implicit: the formulas write 2 * x
  template <class X>
  requires std::constructible_from<T, X>
  explicit Jet(const X& x) : value(x), slope(Vector<T, N>::Zero()) {}
  Jet(const T& f, const Vector<T, N>& df) : value(f), slope(df) {}
  /// The variable number i, scaled: x = `at` + `scale` times the variable.
  static Jet variable(double at, int i, double scale) {
    Jet x(at);
    x.slope[i] = T(scale);
    return x;
  }
  explicit operator double() const { return static_cast<double>(value); }

  Jet operator-() const { return {T(-value), Vector<T, N>(-slope)}; }
  Jet& operator+=(const Jet& o) {
    value += o.value, slope += o.slope;
    return *this;
  }
  Jet& operator-=(const Jet& o) {
    value -= o.value, slope -= o.slope;
    return *this;
  }
  Jet& operator*=(const Jet& o) {
    slope = slope * o.value + o.slope * value;
    value *= o.value;
    return *this;
  }
  Jet& operator/=(const Jet& o) {
    value /= o.value;
    slope = (slope - o.slope * value) / o.value;
    return *this;
  }
  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend Jet operator*(Jet a, const Jet& b) { return a *= b; }
  friend Jet operator/(Jet a, const Jet& b) { return a /= b; }
};

template <class T, int N>
double approximate(const Jet<T, N>& x) {
  return approximate(x.value);
}

}  // namespace burmester

template <class T, int N>
struct Eigen::NumTraits<burmester::Jet<T, N>> : Eigen::GenericNumTraits<burmester::Jet<T, N>> {
  using Real = burmester::Jet<T, N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = N,
    AddCost = N,
    MulCost = 2 * N
  };
};
