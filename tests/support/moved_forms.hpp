// Conics and quadrics in other coordinates.
#pragma once

#include "burmester/geometry/affine_inertia.hpp"
#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/quadric.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {

/// Q(H x)
template <class T>
Conic<T> substituted(const Conic<T>& form, const Matrix<T, 3, 3>& H) {
  const Matrix<T, 3, 3> m = H.transpose() * doubled_matrix<T, 3>(form) * H;
  return Conic<T>({T(m(0, 0) / 2), T(m(1, 1) / 2), T(m(2, 2) / 2), m(1, 2), m(0, 2), m(0, 1)});
}
template <class T>
Quadric<T> substituted(const Quadric<T>& form, const Matrix<T, 4, 4>& H) {
  const Matrix<T, 4, 4> m = H.transpose() * doubled_matrix<T, 4>(form) * H;
  return {{T(m(0, 0) / 2), T(m(1, 1) / 2), T(m(2, 2) / 2), T(m(3, 3) / 2), m(0, 1), m(0, 2), m(0, 3), m(1, 2),
           m(1, 3), m(2, 3)}};
}

/// A product of elementary matrices with small integer entries: determinant 1. Affine: the last row is (0, .., 0, 1).
template <int N>
Matrix<double, N, N> random_unimodular(Random& random, bool affine) {
  Matrix<double, N, N> H = Matrix<double, N, N>::Identity();
  for (int k = 0; k < 3 * N; ++k) {
    const int i = random.below(affine ? N - 1 : N), j = random.below(N);
    if (i != j) H.row(i) += (random.below(3) - 1) * H.row(j);
  }
  return H;
}

/// Form<double> -> Form<Rational>
template <template <class> class Form>
Form<Rational> in_rationals(const Form<double>& form) {
  Form<Rational> out;
  for (std::size_t i = 0; i < form.q.size(); ++i) out.q[i] = Rational(form.q[i]);
  return out;
}

template <template <class> class Form>
Form<double> scaled(Form<double> form, double factor) {
  for (double& q : form.q) q *= factor;
  return form;
}

}  // namespace burmester
