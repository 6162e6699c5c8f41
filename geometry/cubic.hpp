// Plane cubics: forms of degree three in three homogeneous coordinates (z = 1: a curve of the plane; as a cone: a curve
// of directions on the sphere).
//
// F(x, y, z) = c0 x^3 + c1 x^2 y + c2 x^2 z + c3 x y^2 + c4 x y z + c5 x z^2 + c6 y^3 + c7 y^2 z + c8 y z^2 + c9 z^3.
// No halves or thirds appear: everything is a polynomial with integer coefficients, exact over exact number types.
#pragma once

#include <array>
#include <cmath>

#include "burmester/geometry/conic.hpp"

namespace burmester {

template <class T>
struct Cubic {
  std::array<T, 10> c;

  Cubic() { c.fill(T(0)); }
  explicit Cubic(const std::array<T, 10>& coefficients) : c(coefficients) {}

  T operator()(const Point2<T>& p) const {
    const T &x = p[0], &y = p[1], &z = p[2];
    return x * (x * (c[0] * x + c[1] * y + c[2] * z) + y * (c[3] * y + c[4] * z) + c[5] * z * z) +
           y * (y * (c[6] * y + c[7] * z) + c[8] * z * z) + c[9] * z * z * z;
  }
  /// 3 F(p) = gradient(p) . p
  Vector<T, 3> gradient(const Point2<T>& p) const {
    const T &x = p[0], &y = p[1], &z = p[2];
    return {T(x * (3 * c[0] * x + 2 * (c[1] * y + c[2] * z)) + y * (c[3] * y + c[4] * z) + c[5] * z * z),
            T(x * (c[1] * x + 2 * c[3] * y + c[4] * z) + y * (3 * c[6] * y + 2 * c[7] * z) + c[8] * z * z),
            T(x * (c[2] * x + c[4] * y + 2 * c[5] * z) + y * (c[7] * y + 2 * c[8] * z) + 3 * c[9] * z * z)};
  }
  /// The bilinear form behind the gradient, twice: polar(p, p) = 2 gradient(p), and F(p + q) = F(p) + gradient(p) . q +
  /// gradient(q) . p + F(q).
  Vector<T, 3> polar(const Point2<T>& p, const Point2<T>& q) const {
    return gradient(p + q) - gradient(p) - gradient(q);
  }
  /// K with |polar(p, q)| <= 2 K |p| |q| and |gradient(p)| <= K |p|^2, to a few unit roundoffs.
  double gradient_bound() const {
    double sum = 0;
    const auto form = [&](int xx, double fx, int yy, double fy, int zz, double fz, int xy, double gx, int xz, double gy,
                          int yz, double gz) {
      const auto square = [&](int k, double f) { return std::pow(f * approximate(c[k]), 2); };
      sum += square(xx, fx) + square(yy, fy) + square(zz, fz) + (square(xy, gx) + square(xz, gy) + square(yz, gz)) / 2;
    };
    form(0, 3, 3, 1, 5, 1, 1, 2, 2, 2, 4, 1);
    form(1, 1, 6, 3, 8, 1, 3, 2, 4, 1, 7, 2);
    form(2, 1, 7, 1, 9, 3, 4, 1, 5, 2, 8, 2);
    return std::sqrt(sum);
  }
  /// this += factor l m n, a product of three linear forms
  void add_product(const LinearForm<T>& l, const LinearForm<T>& m, const LinearForm<T>& n, const T& factor) {
    Conic<T> q;
    q.add_product(m, n, 1);
    add_product(LinearForm<T>(factor * l), q);
  }
  /// this += l q
  void add_product(const LinearForm<T>& l, const Conic<T>& conic) {
    const std::array<T, 6>& q = conic.q;
    c[0] += l[0] * q[0];
    c[1] += l[0] * q[5] + l[1] * q[0];
    c[2] += l[0] * q[4] + l[2] * q[0];
    c[3] += l[0] * q[1] + l[1] * q[5];
    c[4] += l[0] * q[3] + l[1] * q[4] + l[2] * q[5];
    c[5] += l[0] * q[2] + l[2] * q[4];
    c[6] += l[1] * q[1];
    c[7] += l[1] * q[3] + l[2] * q[1];
    c[8] += l[1] * q[2] + l[2] * q[3];
    c[9] += l[2] * q[2];
  }
};

}  // namespace burmester
