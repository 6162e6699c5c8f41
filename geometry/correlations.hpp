// Correlations: bilinear equations p^T N c = 0 between the points of two projective planes.
//
// Where a body has two positions, "p is as far from c in the one as in the other" is such an equation between the point
// p of the body and the point c of the frame, on the sphere as in the plane. So n positions give n - 1 of them: two
// leave one partner to each point, three leave partners only to the points of a cubic, five positions only to finitely
// many points.
#pragma once

#include <array>

#include "burmester/geometry/cubic.hpp"

namespace burmester {

template <class T>
using Correlation = Matrix<T, 3, 3>;

/// p^T N, the line on which the partner of p lies; exact zeros where N does not tell.
template <class T>
LinearForm<T> line_of_partners(const Correlation<T>& n, const Point2<T>& p) {
  return {T(p[0] * n(0, 0) + p[1] * n(1, 0) + p[2] * n(2, 0)), T(p[0] * n(0, 1) + p[1] * n(1, 1) + p[2] * n(2, 1)),
          T(p[0] * n(0, 2) + p[1] * n(1, 2) + p[2] * n(2, 2))};
}

/// The points that have a partner under three correlations: det(p^T N1; p^T N2; p^T N3) = 0.
template <class T>
Cubic<T> points_with_partner(const std::array<Correlation<T>, 3>& n) {
  const auto form = [&](int k, int column) -> LinearForm<T> { return n[k].col(column); };
  Cubic<T> out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Conic<T> minor;
    minor.add_product(form(1, j), form(2, k), 1);
    minor.add_product(form(1, k), form(2, j), -1);
    out.add_product(form(0, i), minor);
  }
  return out;
}

/// The point on three concurrent lines, from the two that determine it best; zero where all three are one line or zero.
template <class T>
Point2<T> concurrence(const std::array<LinearForm<T>, 3>& line) {
  Point2<T> best = Point2<T>::Zero();
  double largest = -1;
  for (int i = 0; i < 3; ++i) {
    const LinearForm<T>&a = line[i], &b = line[(i + 1) % 3];
    const Point2<T> p{T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
    const double x = approximate(p[0]), y = approximate(p[1]), z = approximate(p[2]), size = x * x + y * y + z * z;
    if (size > largest) largest = size, best = p;
  }
  return best;
}

/// The partner of a point under two correlations, where its two lines of partners meet. Zero where they are one line,
/// or where all points are partners in one of them.
template <class T>
Point2<T> partner(const std::array<Correlation<T>, 2>& n, const Point2<T>& p) {
  const LinearForm<T> a = line_of_partners(n[0], p), b = line_of_partners(n[1], p);
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}

/// The partner of a point of that cubic. Zero where every point of a line is a partner.
template <class T>
Point2<T> partner(const std::array<Correlation<T>, 3>& n, const Point2<T>& p) {
  return concurrence<T>({line_of_partners(n[0], p), line_of_partners(n[1], p), line_of_partners(n[2], p)});
}

/// The point p with p^T N = 0, for N of rank two: every c is its partner.
template <class T>
Point2<T> vertex(const Correlation<T>& n) {
  return concurrence<T>({n.col(0), n.col(1), n.col(2)});
}

}  // namespace burmester
