// Ternary forms of degree three as cubics over any number type, for tests.
#pragma once

#include "burmester/geometry/cubic.hpp"
#include "burmester/geometry/plane_curve.hpp"

namespace burmester {

template <class T>
Cubic<T> cubic_of(const PlaneCurve& f) {
  return Cubic<T>({T(f(3, 0)), T(f(2, 1)), T(f(2, 0)), T(f(1, 2)), T(f(1, 1)), T(f(1, 0)), T(f(0, 3)), T(f(0, 2)), T(f(0, 1)), T(f(0, 0))});
}

template <class T>
Point2<T> cast(const Point2<double>& p) {
  return {T(p[0]), T(p[1]), T(p[2])};
}

}  // namespace burmester
