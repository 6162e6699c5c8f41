// Five orientations: the four bilinear equations of their dyads, and the sextic that tells how many there are.
//
// Seen from the reference pose r the dyads are the pairs of a moving axis a (in E) and a fixed axis b' = Qr^T b with
//     a^T N_j b' = 0, j = 1 .. 4,   N_j^T = |p|^2 (R - I) / 2 = w [v]x + v v^T - |v|^2 I,
// where p = (w, v) = conj(q_r) q_j is the relative quaternion and R its rotation: the angle between a and b is the same
// in pose j as in pose r (J. M. McCarthy, G. S. Soh, "Geometric Design of Linkages", 2nd ed. 2011). So the 4 x 3 matrix
// M(a) with the rows a^T N_j has rank two or less, and b' is its kernel: six pairs over the complex numbers.
//
// The 3 x 3 minors of M(a) are four cubics. With a = (u0, u1, s) write them as C(u) (1, s, s^2, s^3)^T, where column k
// of C holds forms of degree 3 - k in u; then det C(u) is a sextic whose roots are the u of the six pairs. The proof,
// and what happens at multiple roots, is in docs/certificates.md.
#pragma once

#include <array>

#include "burmester/geometry/binary_form.hpp"
#include "burmester/spherical/equal_angles.hpp"
#include "burmester/spherical/five_pose_equations.hpp"

namespace burmester::spherical {

/// The four equations: a^T N b' = 0.
template <class T>
using Bilinear = std::array<Correlation<T>, 4>;

template <class T>
Bilinear<T> bilinear_equations(FivePoses poses, int reference) {
  Bilinear<T> out;
  for (int j = 0, k = 0; j < 5; ++j)
    if (j != reference)
      out[static_cast<std::size_t>(k++)] = equal_angles(
          relative_rotation<T>(poses[static_cast<std::size_t>(reference)], poses[static_cast<std::size_t>(j)]));
  return out;
}

/// Coordinates in which the sextic is formed: a = a'0 chart[0] + a'1 chart[1] + a'2 chart[2]. The six a are projected
/// from chart[2]. Determinant 1.
using Chart = std::array<std::array<int, 3>, 3>;
inline constexpr std::array<Chart, 6> charts{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                              {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
                                              {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
                                              {{{1, 0, 0}, {4, 1, 0}, {-11, 5, 1}}},
                                              {{{0, 1, 0}, {0, 9, 1}, {1, 17, -13}}},
                                              {{{0, 0, 1}, {1, 0, -8}, {23, 1, 19}}}}};

template <class T>
Point2<T> from_chart(const Chart& chart, const Point2<T>& a) {
  Point2<T> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[static_cast<int>(i)] = chart[0][i] * a[0] + chart[1][i] * a[1] + chart[2][i] * a[2];
  return out;
}

/// The same equations for a'.
template <class T>
Bilinear<T> in_chart(const Bilinear<T>& n, const Chart& chart) {
  Bilinear<T> out;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        out[j](static_cast<int>(i), k) = chart[i][0] * n[j](0, k) + chart[i][1] * n[j](1, k) + chart[i][2] * n[j](2, k);
  return out;
}

/// The four minors of M(a), up to signs.
template <class T>
std::array<Cubic<T>, 4> minors(const Bilinear<T>& n) {
  const auto pair = [&](std::size_t i, std::size_t j) {
    std::array<Conic<T>, 3> cross;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      cross[static_cast<std::size_t>(c)].add_product(n[i].col(d), n[j].col(e), 1);
      cross[static_cast<std::size_t>(c)].add_product(n[i].col(e), n[j].col(d), -1);
    }
    return cross;
  };
  const auto triple = [&](std::size_t i, const std::array<Conic<T>, 3>& cross) {
    Cubic<T> out;
    for (int c = 0; c < 3; ++c) out.add_product(LinearForm<T>(n[i].col(c)), cross[static_cast<std::size_t>(c)]);
    return out;
  };
  const auto first = pair(0, 1), last = pair(2, 3);
  return {triple(0, last), triple(1, last), triple(2, first), triple(3, first)};
}

/// C[j][k]: what minor j has with s^k, a form of degree 3 - k in u.
template <class T>
using MinorForms = std::array<std::array<BinaryForm<T>, 4>, 4>;

template <class T>
MinorForms<T> minor_forms(const Bilinear<T>& n) {
  const std::array<Cubic<T>, 4> m = minors(n);
  constexpr std::array<std::array<std::size_t, 4>, 4> with_power{{{0, 1, 3, 6}, {2, 4, 7}, {5, 8}, {9}}};
  MinorForms<T> out;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k) {
      out[j][k].degree = 3 - k;
      for (std::size_t i = 0; i < 4 - k; ++i) out[j][k].c[i] = m[j].c[with_power[k][i]];
    }
  return out;
}

/// det C, by Laplace's rule on two columns and two.
template <class T>
BinaryForm<T> sextic(const MinorForms<T>& c) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
    return c[i][k] * c[j][k + 1] - c[j][k] * c[i][k + 1];
  };
  return minor(0, 1, 0) * minor(2, 3, 2) - minor(0, 2, 0) * minor(1, 3, 2) + minor(0, 3, 0) * minor(1, 2, 2) +
         minor(1, 2, 0) * minor(0, 3, 2) - minor(1, 3, 0) * minor(0, 2, 2) + minor(2, 3, 0) * minor(0, 1, 2);
}

}  // namespace burmester::spherical
