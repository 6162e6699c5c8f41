// Inertia of a quadratic form and of its restriction to the hyperplane at infinity: together they are the
// affine class of the conic or quadric (ranks and signatures up to the common sign of the form; K. Borsuk,
// "Multidimensional Analytic Geometry", 1969).
//
// Numbers are read as exact. Doubles: intervals first, rationals where those cannot tell a sign.
#pragma once

#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rung.hpp"
#include "burmester/geometry/signature.hpp"

namespace burmester {

struct AffineInertia {
  Inertia whole, at_infinity;
  Rung rung = Rung::none;
};

/// Of x^T m x, where `infinity` . x = 0 is the hyperplane at infinity. N is 3 or 4, T double or Rational.
/// Preconditions: m symmetric, entries finite, infinity not zero.
template <class T, int N>
AffineInertia affine_inertia(const Matrix<T, N, N>& m, const Vector<T, N>& infinity);

/// 2 M of a conic or quadric x^T M x.
template <class T, int N, template <class> class Form>
Matrix<T, N, N> doubled_matrix(const Form<T>& form) {
  Matrix<T, N, N> m;
  for (int i = 0; i < N; ++i) {
    Vector<T, N> unit;
    for (int k = 0; k < N; ++k) unit[k] = T(k == i ? 1 : 0);
    m.col(i) = form.gradient(unit);
  }
  return m;
}

}  // namespace burmester
