// A binary form near a place where it nearly vanishes twice.
//
// There the terms of c[0] u0^n + .. + c[n] u1^n cancel: near a root of multiplicity two, or two roots closer than the
// square root of a double's accuracy, nothing is left. In coordinates that are (1 : 0) at the place the first two
// coefficients are small numbers of their own, known to all digits if they come from exact ones, and nothing cancels.
#pragma once

#include "burmester/geometry/binary_form.hpp"

namespace burmester {

/// Coordinates in which the point r, one of whose coordinates is 1 and not exceeded by the other, is (1 : 0). Of
/// determinant 1: `vanishing_at` commutes with them.
template <class T>
Point1<T> seen_from(const Point1<double>& r, const Point1<T>& u) {
  if (r[0] == 1) return {u[0], T(u[1] - T(r[1]) * u[0])};
  return {u[1], T(T(r[0]) * u[1] - u[0])};
}

/// f in these coordinates.
template <class T>
BinaryForm<T> seen_from(const Point1<double>& r, const BinaryForm<T>& f) {
  const bool first = r[0] == 1;
  const BinaryForm<T> along = BinaryForm<T>(std::vector<T>{T(1), T(0)}),
                      beside = BinaryForm<T>(std::vector<T>{T(first ? r[1] : r[0]), T(first ? 1 : -1)});
  const BinaryForm<T>&u0 = first ? along : beside, &u1 = first ? beside : along;
  BinaryForm<T> value = BinaryForm<T>::constant(f.c[0]), power = u1;
  for (std::size_t k = 1; k <= f.degree; ++k) {
    value = value * u0 + BinaryForm<T>::constant(f.c[k]) * power;
    if (k < f.degree) power = power * u1;
  }
  return value;
}

/// A form, seen from a place.
template <class T>
struct LocalForm {
  Point1<double> from;
  BinaryForm<T> form;

  static constexpr double reach = 0x1p-4;  ///< "near": beyond it a double root leaves a 256th of the terms
  template <class X>
  bool is_near(const Point1<X>& u) const {
    return distance(u) < reach;
  }
  template <class X>
  double distance(const Point1<X>& u) const {
    const Point1<X> seen = seen_from(from, u);
    return std::abs(approximate(seen[1]) / approximate(seen[0]));
  }
  template <class X>
  X operator()(const Point1<X>& u) const {
    return form(seen_from(from, u));
  }
  /// As BinaryForm::divided_by_root. Precondition: the root is not near.
  void divide_by_root(const Point1<T>& u) { form = form.divided_from_first(seen_from(from, u)); }
};

}  // namespace burmester
