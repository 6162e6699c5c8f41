// Conics of the projective plane: coefficients, evaluation, pencils.
//
// Notation: Q(x) = q0 x^2 + q1 y^2 + q2 z^2 + q3 y z + q4 x z + q5 x y. Determinants and adjugates are those of
// 2 M, where M is the symmetric matrix with Q(x) = x^T M x, so that no halves appear and everything here is a
// polynomial with integer coefficients (exact over exact number types).
#pragma once

#include <array>
#include <cmath>

#include "burmester/geometry/error_free.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class T>
using Point2 = Vector<T, 3>;  ///< homogeneous coordinates of a point (or of a line) of the projective plane

template <class T>
using LinearForm = Vector<T, 3>;

template <class T>
struct Conic {
  std::array<T, 6> q;

  Conic() { q.fill(T(0)); }  // not every number type starts at 0
  explicit Conic(const std::array<T, 6>& coefficients) : q(coefficients) {}

  T operator()(const Point2<T>& p) const {
    return p[0] * (q[0] * p[0] + q[5] * p[1] + q[4] * p[2]) + p[1] * (q[1] * p[1] + q[3] * p[2]) + q[2] * p[2] * p[2];
  }
  /// 2 u^T M v: the polar form; polar(u, u) = 2 Q(u).
  T polar(const Point2<T>& u, const Point2<T>& v) const { return gradient(u).dot(v); }
  Vector<T, 3> gradient(const Point2<T>& p) const {
    return {T(2 * q[0] * p[0] + q[5] * p[1] + q[4] * p[2]), T(q[5] * p[0] + 2 * q[1] * p[1] + q[3] * p[2]),
            T(q[4] * p[0] + q[3] * p[1] + 2 * q[2] * p[2])};
  }
  /// this += factor l m, a product of two linear forms
  void add_product(const LinearForm<T>& l, const LinearForm<T>& m, int factor) {
    const T a = l[0] * factor, b = l[1] * factor, c = l[2] * factor;
    q[0] += a * m[0];
    q[1] += b * m[1];
    q[2] += c * m[2];
    q[3] += b * m[2] + c * m[1];
    q[4] += a * m[2] + c * m[0];
    q[5] += a * m[1] + b * m[0];
  }
};

/// The symmetric matrix 2 M.
template <class T>
Matrix<T, 3, 3> matrix_of(const Conic<T>& c) {
  Matrix<T, 3, 3> m;
  m << T(2 * c.q[0]), c.q[5], c.q[4], c.q[5], T(2 * c.q[1]), c.q[3], c.q[4], c.q[3], T(2 * c.q[2]);
  return m;
}

/// lambda A + mu B
template <class T>
Conic<T> pencil_member(const Conic<T>& a, const T& lambda, const Conic<T>& b, const T& mu) {
  Conic<T> out;
  for (int i = 0; i < 6; ++i) out.q[i] = lambda * a.q[i] + mu * b.q[i];
  return out;
}

/// Largest magnitude among the coefficients.
template <class T>
double size_of(const Conic<T>& c) {
  double size = 0;
  for (const T& q : c.q) size = std::max(size, std::abs(approximate(q)));
  return size;
}

/// Adjugate of the matrix 2 M of a conic. For a pair of lines Q = l m it is -(l x m)(l x m)^T.
template <class T>
struct Adjugate {
  T xx, yy, zz, yz, xz, xy;
  explicit Adjugate(const Conic<T>& c)
      : xx(4 * c.q[1] * c.q[2] - c.q[3] * c.q[3]),
        yy(4 * c.q[0] * c.q[2] - c.q[4] * c.q[4]),
        zz(4 * c.q[0] * c.q[1] - c.q[5] * c.q[5]),
        yz(c.q[4] * c.q[5] - 2 * c.q[0] * c.q[3]),
        xz(c.q[3] * c.q[5] - 2 * c.q[1] * c.q[4]),
        xy(c.q[3] * c.q[4] - 2 * c.q[2] * c.q[5]) {}

  T trace() const { return xx + yy + zz; }
  /// trace(adj(2 M) 2 N) for another conic N
  T trace_with(const Conic<T>& n) const {
    return 2 * (xx * n.q[0] + yy * n.q[1] + zz * n.q[2] + yz * n.q[3] + xz * n.q[4] + xy * n.q[5]);
  }
  /// det(2 M) of the conic itself, expanded along its first row
  T determinant(const Conic<T>& c) const { return 2 * c.q[0] * xx + c.q[5] * xy + c.q[4] * xz; }
};

/// det(2 (s A + t B)) as a binary cubic in (s, t), leading coefficient first.
template <class T>
std::array<T, 4> pencil_determinant(const Conic<T>& a, const Conic<T>& b) {
  const Adjugate<T> adj_a(a), adj_b(b);
  return {adj_a.determinant(a), adj_a.trace_with(b), adj_b.trace_with(a), adj_b.determinant(b)};
}

}  // namespace burmester
