// Five orientations by another elimination: exact counts of real dyads to hold the library's against. Slow and obvious.
//
// b^T (Q_j - Q_0) a = 0, j = 1 .. 4, with the rotation matrices themselves over rationals. For a fixed axis b the 4 x 3
// matrix with the rows b^T (Q_j - Q_0) must have rank two. On the line b = (1, t, s) of a chart the two cubics det(1, 2, 3)
// and det(1, 2, 4) in s have a resultant R(t) of degree nine; three of its roots are where rows 1 and 2 are dependent,
// the zeros of a cubic e(t), and the dyads are the other six: R / e. Values at integers, interpolated.
#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "burmester/geometry/polynomial.hpp"
#include "burmester/geometry/vector.hpp"
#include "burmester/spherical/pose.hpp"
#include "exact_roots.hpp"

namespace burmester::exact {

using RationalPolynomial = burmester::Polynomial<Rational>;

inline Rational determinant(std::vector<std::vector<Rational>> m) {
  Rational out = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t row = k;
    while (row < m.size() && m[row][k] == 0) ++row;
    if (row == m.size()) return 0;
    if (row != k) std::swap(m[row], m[k]), out = -out;
    out *= m[k][k];
    for (std::size_t r = k + 1; r < m.size(); ++r) {
      const Rational factor = m[r][k] / m[k][k];
      for (std::size_t c = k; c < m.size(); ++c) m[r][c] -= factor * m[k][c];
    }
  }
  return out;
}

inline Matrix<Rational, 3, 3> rotation_matrix(const spherical::Pose& p) {
  const Rational w(p.w), x(p.x), y(p.y), z(p.z), n = w * w + x * x + y * y + z * z;
  Matrix<Rational, 3, 3> q;
  q << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return q / n;
}

/// The sextic R / e for the fixed axes b = (1, t, s) chart, values at integers interpolated. The zero polynomial where R
/// vanishes identically.
class FixedAxes {
 public:
  FixedAxes(std::span<const spherical::Pose, 5> poses, const Matrix<Rational, 3, 3>& chart) : chart_(chart) {
    const Matrix<Rational, 3, 3> first = rotation_matrix(poses[0]);
    for (std::size_t j = 0; j < 4; ++j) difference_[j] = rotation_matrix(poses[j + 1]) - first;
  }

  RationalPolynomial sextic() const {
    std::vector<Rational> at, value;
    for (int t = -4; at.size() < 8; ++t) {
      const auto [r, e] = values(Rational(t));
      if (e == 0) continue;
      at.push_back(t), value.push_back(r / e);
    }
    // Newton's interpolation: all divided differences, the eighth being zero.
    for (std::size_t k = 1; k < 8; ++k)
      for (std::size_t i = 7; i >= k; --i) value[i] = (value[i] - value[i - 1]) / (at[i] - at[i - k]);
    if (value[7] != 0) throw std::logic_error("R / e is not of degree six");
    RationalPolynomial p;
    for (std::size_t i = 8; i-- > 0;)
      p = p * RationalPolynomial({Rational(-at[i]), 1}) + RationalPolynomial({value[i]});
    return p;
  }

 private:
  using Row = std::array<RationalPolynomial, 3>;  // linear in s

  struct Values {
    Rational resultant, extraneous;
  };
  Values values(const Rational& t) const {
    std::array<Row, 4> row;
    for (std::size_t j = 0; j < 4; ++j)
      for (int c = 0; c < 3; ++c) {
        const Vector<Rational, 3> column = chart_ * difference_[j].col(c);
        row[j][static_cast<std::size_t>(c)] = RationalPolynomial({column[0] + t * column[1], column[2]});
      }
    const Row both = cross(row[0], row[1]);
    return {resultant(dot(row[2], both), dot(row[3], both)),
            determinant({coefficients(both[0], 2), coefficients(both[1], 2), coefficients(both[2], 2)})};
  }
  static Row cross(const Row& a, const Row& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static RationalPolynomial dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static std::vector<Rational> coefficients(const RationalPolynomial& p, std::size_t degree) {
    std::vector<Rational> c = p.coefficients();
    c.resize(degree + 1, Rational(0));
    return c;
  }
  static Rational resultant(const RationalPolynomial& f, const RationalPolynomial& g) {  // of formal degree three
    const std::vector<Rational> a = coefficients(f, 3), b = coefficients(g, 3);
    std::vector<std::vector<Rational>> sylvester(6, std::vector<Rational>(6, Rational(0)));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k) sylvester[i][i + k] = a[k], sylvester[i + 3][i + k] = b[k];
    return determinant(sylvester);
  }

  Matrix<Rational, 3, 3> chart_;
  std::array<Matrix<Rational, 3, 3>, 4> difference_;
};

/// Real dyads of five orientations whose dyads are finitely many and lie apart in the chart used here (those of random
/// tasks and of small integers do).
inline RootCount count_spherical_dyads(std::span<const spherical::Pose, 5> poses) {
  Matrix<Rational, 3, 3> chart;
  chart << 1, 2, -5, 3, 7, 4, -6, 1, 9;
  const RationalPolynomial f = FixedAxes(poses, chart).sextic();
  if (f.degree() != 6) throw std::logic_error("not six dyads in this chart");
  return count_real_roots(polynomial(f.coefficients()));
}

}  // namespace burmester::exact
