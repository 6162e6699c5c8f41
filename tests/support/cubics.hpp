// Cubics and points in other number types, for tests.
#pragma once

#include "burmester/geometry/plane_curve.hpp"

namespace burmester {

template <class T>
Cubic<T> cubic_of(const PlaneCurve& f) {
  return f.cast<T>().cubic();
}

template <class T>
Point2<T> cast(const Point2<double>& p) {
  return {T(p[0]), T(p[1]), T(p[2])};
}

}  // namespace burmester
