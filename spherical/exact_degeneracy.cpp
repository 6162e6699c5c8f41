#include "burmester/spherical/exact_degeneracy.hpp"

#include "burmester/geometry/exact_rank.hpp"
#include "burmester/spherical/exact_orientations.hpp"

namespace burmester::spherical {
namespace {

using Equations = Bilinear<Rational>;

/// Axes of the rotations between all pairs of poses.
struct TurnAxes {
  std::vector<ExactAxis> moving, fixed;  ///< in E, and in S seen from the first pose: Q_0^T Q_i a
};

TurnAxes axes_between(FivePoses poses) {
  TurnAxes out;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) {
      out.moving.push_back(turn_axis(poses[i], poses[j]));
      out.fixed.push_back(Space::act<Rational>(relative_rotation<Rational>(poses[0], poses[i]), out.moving.back()));
    }
  return out;
}

bool some_are_equal(FivePoses poses) {
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j)
      if (equal_exactly(poses[i], poses[j])) return true;
  return false;
}

Matrix<Rational, 4, 9> conditions(const Equations& n) {
  Matrix<Rational, 4, 9> out;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 9; ++i) out(j, i) = n[static_cast<std::size_t>(j)](i);
  return out;
}

/// M(a)
Matrix<Rational, 4, 3> lines_of_partners(const Equations& n, const ExactAxis& a) {
  Matrix<Rational, 4, 3> m;
  for (int j = 0; j < 4; ++j) m.row(j) = line_of_partners(n[static_cast<std::size_t>(j)], a).transpose();
  return m;
}

Equations transposed(const Equations& n) {
  Equations out;
  for (std::size_t j = 0; j < 4; ++j) out[j] = n[j].transpose();
  return out;
}

/// An axis with rank one takes at most two places: two of the five poses put it in one place, so it is the axis of the
/// rotation between these.
std::optional<ExactAxis> axis_in_two_places(const Equations& n, const std::vector<ExactAxis>& axes) {
  for (const ExactAxis& a : axes)
    if (exact_rank(lines_of_partners(n, a)) < 2) return a;
  return std::nullopt;
}

/// Orthogonal to all rows, which have rank two.
ExactAxis only_partner(const Matrix<Rational, 4, 3>& rows) {
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const ExactAxis b = ExactAxis(rows.row(i)).cross(ExactAxis(rows.row(j)));
      if (!b.isZero(0)) return b;
    }
  return ExactAxis::Zero();
}

/// The largest coordinate 1 or -1.
Vector<RationalInterval, 3> enclosed(const ExactAxis& a) {
  Rational size = 0;
  for (const Rational& x : a) size = std::max(size, Rational(abs(x)));
  Vector<RationalInterval, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = RationalInterval(Rational(a[i] / size));
  return out;
}

/// The partner that an axis of the other body has outside the family of `a` (docs/certificates.md). n: seen from these
/// others, so that M of one is the lines of its partners.
std::optional<EnclosedAxes> isolated_dyad(const Equations& n, const std::vector<ExactAxis>& others,
                                          const ExactAxis& a) {
  for (const ExactAxis& b : others) {
    const Matrix<Rational, 4, 3> rows = lines_of_partners(n, b);
    if (exact_rank(rows) != 2) continue;
    if (const ExactAxis partner = only_partner(rows); !parallel(partner, a))
      return EnclosedAxes{enclosed(partner), enclosed(b), 1};
  }
  return std::nullopt;
}

}  // namespace

ExactDegeneracy exact_degeneracy(FivePoses poses) {
  if (some_are_equal(poses)) return {Degeneracy::equal_orientations, {}};
  if (one_axis_exactly(poses)) return {Degeneracy::one_axis, {}};
  const Equations n = bilinear_equations<Rational>(poses, 0), back = transposed(n);
  if (exact_rank(conditions(n)) < 4) return {Degeneracy::rank_deficient, {}};
  const TurnAxes axes = axes_between(poses);
  const auto moving = axis_in_two_places(n, axes.moving), fixed = axis_in_two_places(back, axes.fixed);
  if (moving && fixed) return {Degeneracy::both_on_circles, {}};
  if (moving) return {Degeneracy::moving_on_circle, isolated_dyad(back, axes.fixed, *moving)};
  if (!fixed) return {};
  ExactDegeneracy out{Degeneracy::fixed_on_circle, isolated_dyad(n, axes.moving, *fixed)};
  if (out.isolated) std::swap(out.isolated->moving, out.isolated->fixed);
  return out;
}

}  // namespace burmester::spherical
