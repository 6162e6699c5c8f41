#include "burmester/spherical/exact_degeneracy.hpp"

#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester::spherical {
namespace {

using Direction = Vector<Rational, 3>;
using Equations = Bilinear<Rational>;

Direction direction_of(const Quaternion<Rational>& p) { return {p[1], p[2], p[3]}; }
bool is_zero(const Direction& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
Direction cross(const Direction& a, const Direction& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

/// Axes in E of the rotations between all pairs of poses; zero for equal ones.
std::vector<Direction> axes_between(FivePoses poses) {
  std::vector<Direction> out;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j)
      out.push_back(direction_of(relative_rotation<Rational>(poses[i], poses[j])));
  return out;
}

bool all_parallel(const std::vector<Direction>& axes) {
  for (const Direction& a : axes)
    if (!is_zero(cross(axes[0], a))) return false;
  return true;
}

/// Exact, however small the entries.
template <int Rows, int Cols>
int rank_of(Matrix<Rational, Rows, Cols> m) {
  int rank = 0;
  for (int c = 0; c < Cols && rank < Rows; ++c) {
    int row = rank;
    while (row < Rows && m(row, c) == 0) ++row;
    if (row == Rows) continue;
    m.row(row).swap(m.row(rank));
    for (int r = rank + 1; r < Rows; ++r) {
      const Rational factor = m(r, c) / m(rank, c);
      for (int k = c; k < Cols; ++k) m(r, k) -= factor * m(rank, k);
    }
    ++rank;
  }
  return rank;
}

Matrix<Rational, 4, 9> conditions(const Equations& n) {
  Matrix<Rational, 4, 9> out;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 9; ++i) out(j, i) = n[static_cast<std::size_t>(j)](i);
  return out;
}

/// Rank of M(a).
int rank_at(const Equations& n, const Direction& a) {
  Matrix<Rational, 4, 3> m;
  for (int j = 0; j < 4; ++j) m.row(j) = line_of_partners(n[static_cast<std::size_t>(j)], a).transpose();
  return rank_of(m);
}

Equations transposed(const Equations& n) {
  Equations out;
  for (std::size_t j = 0; j < 4; ++j) out[j] = n[j].transpose();
  return out;
}

/// An axis with rank one takes at most two places: two of the five poses put it in one place, so it is the axis of the
/// rotation between these.
bool some_axis_takes_two_places(const Equations& n, const std::vector<Direction>& axes) {
  for (const Direction& a : axes)
    if (!is_zero(a) && rank_at(n, a) < 2) return true;
  return false;
}

/// The same axes in S, seen from the first pose: Q_0^T Q_i a.
std::vector<Direction> seen_in_frame(FivePoses poses) {
  std::vector<Direction> out;
  const Quaternion<Rational> back = Space::conjugate<Rational>(Space::point<Rational>(poses[0]));
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j)
      out.push_back(Space::act<Rational>(quaternion_product<Rational>(back, Space::point<Rational>(poses[i])),
                                         direction_of(relative_rotation<Rational>(poses[i], poses[j]))));
  return out;
}

}  // namespace

Degeneracy exact_degeneracy(FivePoses poses) {
  const std::vector<Direction> axes = axes_between(poses);
  for (const Direction& a : axes)
    if (is_zero(a)) return Degeneracy::equal_orientations;
  const Equations n = bilinear_equations<Rational>(poses, 0);
  if (all_parallel(axes)) return Degeneracy::one_axis;
  if (rank_of(conditions(n)) < 4) return Degeneracy::rank_deficient;
  if (some_axis_takes_two_places(n, axes)) return Degeneracy::moving_on_circle;
  if (some_axis_takes_two_places(transposed(n), seen_in_frame(poses))) return Degeneracy::fixed_on_circle;
  return Degeneracy::none;
}

}  // namespace burmester::spherical
