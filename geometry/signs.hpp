// Ready exact signs of geometry, for every target: determinants, orientations, incircle, the closure of a dyad.
//
// Each is a polynomial, for exact_sign of ladder.hpp, and a function on vectors and matrices that calls it.
// The data are the doubles, read as exact numbers. Costs: bench/signs.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "burmester/geometry/ladder.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

// ---- The polynomials ----

/// of the rows (a, b), (c, d)
template <class T>
constexpr T determinant2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}
/// of m row by row
template <class T>
constexpr T determinant3(const std::array<T, 9>& m) {
  return m[0] * determinant2(m[4], m[5], m[7], m[8]) - m[1] * determinant2(m[3], m[5], m[6], m[8]) +
         m[2] * determinant2(m[3], m[4], m[6], m[7]);
}

/// n x n, row by row (or column by column); n = 2, 3, 4.
template <int n>
struct Determinant;
template <>
struct Determinant<2> {
  template <class T>
  constexpr T operator()(const std::array<T, 4>& m) const {
    return determinant2(m[0], m[1], m[2], m[3]);
  }
};
template <>
struct Determinant<3> {
  template <class T>
  constexpr T operator()(const std::array<T, 9>& m) const {
    return determinant3(m);
  }
};
/// By Laplace's expansion: 2 x 2 minors of the upper two rows times those of the lower two.
template <>
struct Determinant<4> {
  template <class T>
  constexpr T operator()(const std::array<T, 16>& m) const {
    const auto upper = [&](std::size_t i, std::size_t j) {
      return determinant2(m[i], m[j], m[4 + i], m[4 + j]);
    };
    const auto lower = [&](std::size_t i, std::size_t j) {
      return determinant2(m[8 + i], m[8 + j], m[12 + i], m[12 + j]);
    };
    return upper(0, 1) * lower(2, 3) - upper(0, 2) * lower(1, 3) + upper(0, 3) * lower(1, 2) +
           upper(1, 2) * lower(0, 3) - upper(1, 3) * lower(0, 2) + upper(2, 3) * lower(0, 1);
  }
};

/// a, b, c of the plane: det(b - a, c - a), twice the area of the triangle.
struct Orientation2 {
  template <class T>
  constexpr T operator()(const std::array<T, 6>& p) const {
    return determinant2(difference(p[2], p[0]), difference(p[3], p[1]), difference(p[4], p[0]),
                        difference(p[5], p[1]));
  }
};
/// a, b, c, d of space: det(b - a, c - a, d - a), six times the volume of the tetrahedron.
struct Orientation3 {
  template <class T>
  constexpr T operator()(const std::array<T, 12>& p) const {
    std::array<T, 9> m;
    for (std::size_t i = 0; i < 9; ++i) m[i] = difference(p[3 + i], p[i % 3]);
    return determinant3(m);
  }
};
/// a, b, c, d of the plane: det of the rows (x, y, x^2 + y^2) of a - d, b - d, c - d.
struct InCircle {
  template <class T>
  constexpr T operator()(const std::array<T, 8>& p) const {
    std::array<T, 9> m;
    for (std::size_t i = 0; i < 3; ++i) {
      const T x = difference(p[2 * i], p[6]), y = difference(p[2 * i + 1], p[7]);
      m[3 * i] = x;
      m[3 * i + 1] = y;
      m[3 * i + 2] = x * x + y * y;
    }
    return determinant3(m);
  }
};
/// a, b, c, d of the plane: 4 r p - (r + p - q)^2 with r = |b - a|^2, p = |c - b|^2, q = |c - d|^2: sixteen
/// times the squared area of the triangle with the sides sqrt(r), sqrt(p), sqrt(q) (Heron), negative where
/// there is none.
struct DyadClosure {
  template <class T>
  constexpr T operator()(const std::array<T, 8>& x) const {
    const auto distance_squared = [&](std::size_t i, std::size_t j) {
      const T dx = difference(x[i], x[j]), dy = difference(x[i + 1], x[j + 1]);
      return T(dx * dx + dy * dy);
    };
    const T r = distance_squared(2, 0), p = distance_squared(4, 2), q = distance_squared(4, 6);
    const T s = r + p - q;
    return 4 * r * p - s * s;
  }
};

// ---- The same on vectors and matrices ----

namespace detail {

template <class... M>
auto concatenated(const M&... m) {
  std::array<double, (std::size_t{M::SizeAtCompileTime} + ...)> out;
  double* end = out.data();
  ((end = std::copy_n(m.data(), std::size_t{M::SizeAtCompileTime}, end)), ...);
  return out;
}

}  // namespace detail

/// Of a matrix or an expression of Eigen, 2 x 2, 3 x 3 or 4 x 4.
template <class M>
Sign determinant_sign(const Eigen::MatrixBase<M>& m) {
  static_assert(int{M::RowsAtCompileTime} == int{M::ColsAtCompileTime});
  return exact_sign<Determinant<M::RowsAtCompileTime>>(detail::concatenated(m.eval()));
}

/// 1: a, b, c turn counter-clockwise; 0: they lie on one line.
inline Sign orientation(const Vector<double, 2>& a, const Vector<double, 2>& b, const Vector<double, 2>& c) {
  return exact_sign<Orientation2>(detail::concatenated(a, b, c));
}
/// 1: seen from d the triangle a, b, c turns counter-clockwise; 0: they lie in one plane.
inline Sign orientation(const Vector<double, 3>& a, const Vector<double, 3>& b, const Vector<double, 3>& c,
                        const Vector<double, 3>& d) {
  return exact_sign<Orientation3>(detail::concatenated(a, b, c, d));
}
/// 1: d lies inside the circle through the counter-clockwise a, b, c, -1 outside (clockwise: reversed); 0: on
/// it, or a, b, c, d lie on one line.
inline Sign in_circle(const Vector<double, 2>& a, const Vector<double, 2>& b, const Vector<double, 2>& c,
                      const Vector<double, 2>& d) {
  return exact_sign<InCircle>(detail::concatenated(a, b, c, d));
}
/// Two links a b and b c, joined at b; the far pivot a moves to d, c stays. 1: they close in two ways, mirror
/// images in d c; 0: in one, stretched or folded (a dead centre); -1: not at all.
inline Sign dyad_closure(const Vector<double, 2>& a, const Vector<double, 2>& b, const Vector<double, 2>& c,
                         const Vector<double, 2>& d) {
  return exact_sign<DyadClosure>(detail::concatenated(a, b, c, d));
}

// ---- Compiled in signs.cpp ----

extern template Sign sign_beyond_doubles<Determinant<2>>(const std::array<double, 4>&);
extern template Sign sign_beyond_doubles<Determinant<3>>(const std::array<double, 9>&);
extern template Sign sign_beyond_doubles<Determinant<4>>(const std::array<double, 16>&);
extern template Sign sign_beyond_doubles<Orientation2>(const std::array<double, 6>&);
extern template Sign sign_beyond_doubles<Orientation3>(const std::array<double, 12>&);
extern template Sign sign_beyond_doubles<InCircle>(const std::array<double, 8>&);
extern template Sign sign_beyond_doubles<DyadClosure>(const std::array<double, 8>&);

}  // namespace burmester
