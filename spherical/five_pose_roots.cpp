#include "burmester/spherical/five_pose_roots.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "burmester/geometry/binary_roots.hpp"

namespace burmester::spherical {
namespace {

/// Roots of the sextic about 2^-19 apart, real or not, may be a sign of infinitely many dyads: the other path tells.
constexpr int close_depth = 20;
/// Those 2^-26 apart: rounding, whose effect on a double root is its square root, decides whether they are real.
constexpr int merging_depth = 27;
/// Relative size below which rounding (2^-53, over a pivot of 2^-12 at least) leaves nothing of the sextic or of an
/// axis.
constexpr double undetermined = 0x1p-40;

/// Vectors of binary forms: coefficient k belongs to u0^(n-k) u1^k.
template <int degree>
using Forms = std::array<Vector3, degree + 1>;

template <int n>
Vector3 value(const Forms<n>& f, double u0, double u1) {
  Vector3 out = f[0];
  double power = u1;
  for (std::size_t k = 1; k <= n; ++k, power *= u1) out = out * u0 + power * f[k];
  return out;
}

template <int n>
double largest(const Forms<n>& f) {
  double out = 0;
  for (const Vector3& v : f) out = std::max(out, v.squaredNorm());
  return std::sqrt(out);
}

/// x b = P b with P = u0 P[0] + u1 P[1], and c . b = 0, where a = (x, u0, u1) from coordinate `x` on, cyclically.
struct Pencil {
  int x = 0;
  double pivot = 0;
  std::array<Matrix<double, 3, 3>, 2> P;
  Forms<1> c;

  template <int n>
  Forms<n + 1> times(const Forms<n>& f) const {  // f P
    Forms<n + 1> out;
    out[0] = P[0].transpose() * f[0];
    for (std::size_t k = 1; k <= n; ++k) out[k] = P[0].transpose() * f[k] + P[1].transpose() * f[k - 1];
    out[n + 1] = P[1].transpose() * f[n];
    return out;
  }
};

/// Coefficients of a_i b_0, a_i b_1, a_i b_2 in the four equations.
Matrix<double, 4, 3> block(const FivePoseEquations& equations, int i) {
  const auto& r = equations.rows;
  const double scale = 1 / equations.e;
  static constexpr int symmetric[3][3] = {{3, 6, 7}, {6, 4, 8}, {7, 8, 5}};
  Matrix<double, 4, 3> out;
  const int j = (i + 1) % 3, k = (i + 2) % 3;  // (a x b)_k = a_i b_j - a_j b_i
  out.col(i) = r.col(symmetric[i][i]);
  out.col(j) = r.col(symmetric[i][j]) / 2 + scale * r.col(k);
  out.col(k) = r.col(symmetric[i][k]) / 2 - scale * r.col(j);
  return out;
}

/// Gauss-Jordan elimination of x b, with complete pivoting among its 4 x 3 coefficients.
Pencil eliminate(const FivePoseEquations& equations, int x) {
  Pencil out;
  out.x = x;
  Matrix<double, 4, 9> m;
  for (int i = 0; i < 3; ++i) m.middleCols<3>(3 * i) = block(equations, (x + i) % 3);
  double first = 0;
  int column[3] = {};
  for (int k = 0; k < 3; ++k) {
    int row = k;
    double largest = -1;
    for (int r = k; r < 4; ++r)
      for (int c = 0; c < 3; ++c)
        if (std::abs(m(r, c)) > largest) largest = std::abs(m(r, c)), row = r, column[k] = c;
    if (k == 0) first = largest;
    out.pivot = largest / first;
    if (!(largest > 0)) return out;
    m.row(row).swap(m.row(k));
    m.row(k) /= m(k, column[k]);
    for (int r = 0; r < 4; ++r) {
      if (r == k) continue;
      const double factor = m(r, column[k]);
      m.row(r) -= factor * m.row(k);
      m(r, column[k]) = 0;
    }
  }
  for (int side = 0; side < 2; ++side) {
    for (int k = 0; k < 3; ++k) out.P[static_cast<std::size_t>(side)].row(column[k]) = -m.block<1, 3>(k, 3 + 3 * side);
    out.c[static_cast<std::size_t>(side)] = m.block<1, 3>(3, 3 + 3 * side).transpose();
  }
  out.pivot = std::min(out.pivot, m.row(3).cwiseAbs().maxCoeff() / first);
  return out;
}

/// The elimination with a small pivot only if all are. Where the axes nearly agree two of the dyads are near the
/// complex (1, +-i, 0) (x) (1, +-i, 0): there only elimination along the common axis keeps them apart.
Pencil best_elimination(const FivePoseEquations& equations, double least_pivot) {
  Pencil best = eliminate(equations, 2);
  for (int x = 0; x < 2 && best.pivot < least_pivot && equations.d == 1; ++x)
    if (Pencil other = eliminate(equations, x); other.pivot > best.pivot) best = other;
  return best;
}

void add(FivePoseRoots& out, ScaledDyad x, int steps) {
  for (int i = 0; i < steps; ++i)
    if (improve(out.equations, x) < 0x1p-40) break;
  out.root[static_cast<std::size_t>(out.count++)] = x;
}

FivePoseRoots prepared(FivePoses poses) {
  FivePoseRoots out;
  out.equations = five_pose_equations(poses);
  if (out.equations.closest <= same_tolerance)
    out.what = Degeneracy::equal_orientations;
  else if (out.equations.spread <= same_tolerance)
    out.what = Degeneracy::one_axis;
  if (out.what != Degeneracy::none) return out;
  out.indistinct = std::min(out.equations.closest, out.equations.spread) < indistinct_tolerance;
  return out;
}

/// Equations of rank three always come here: their fourth pivot is no pivot.
void take_action_path(FivePoses poses, FivePoseRoots& out) {
  out.path = FivePosePath::action;
  out.count = 0;
  const NearDegeneracy near = axis_in_two_places(poses);
  out.what = near.kind;
  out.indistinct = out.indistinct || near.distance < indistinct_tolerance;
  if (out.what == Degeneracy::none) out.decided = detail::add_action_roots(out);
}

}  // namespace

bool detail::add_sextic_roots(double least_pivot, FivePoseRoots& out) {
  const Pencil pencil = best_elimination(out.equations, least_pivot);
  out.pivot = pencil.pivot;
  if (!(pencil.pivot > 0 && pencil.pivot >= least_pivot)) return false;
  const Forms<2> d = pencil.times<1>(pencil.c);
  const Forms<3> f = pencil.times<2>(d);
  Forms<3> b{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  for (std::size_t i = 0; i <= 1; ++i)
    for (std::size_t k = 0; k <= 2; ++k) b[i + k] += pencil.c[i].cross(d[k]);
  std::array<double, 7> sextic{};
  for (std::size_t i = 0; i <= 3; ++i)
    for (std::size_t k = 0; k <= 3; ++k) sextic[i + k] += b[i].dot(f[k]);
  double size = 0;
  for (const double coefficient : sextic) size = std::max(size, std::abs(coefficient));
  const double b_size = largest<3>(b);
  if (!(size > undetermined * b_size * largest<3>(f))) return false;  // zero: a curve of dyads
  const BinaryRoots<6> roots = binary_roots<6>(sextic);               // of (u1, u0)
  out.close = roots.depth >= close_depth;
  out.merging = roots.depth >= merging_depth;
  for (int i = 0; i < roots.count; ++i) {
    const double u0 = roots.at[static_cast<std::size_t>(i)][1], u1 = roots.at[static_cast<std::size_t>(i)][0];
    const Vector3 axis = value<3>(b, u0, u1);
    const double x = axis.dot(u0 * (pencil.P[0] * axis) + u1 * (pencil.P[1] * axis)) / axis.squaredNorm();
    if (!(axis.norm() > undetermined * b_size)) return out.count = 0, false;  // one moving axis for many fixed ones
    Vector3 a;
    a[pencil.x] = x, a[(pencil.x + 1) % 3] = u0, a[(pencil.x + 2) % 3] = u1;
    add(out, scaled_dyad(a, axis, out.equations.e), 1);
  }
  return true;
}

FivePoseRoots five_pose_roots(FivePoses poses, FivePosePath path) {
  FivePoseRoots out = prepared(poses);
  if (out.what != Degeneracy::none) return out;
  if (path == FivePosePath::sextic)
    detail::add_sextic_roots(0, out);
  else
    take_action_path(poses, out);
  return out;
}

FivePoseRoots five_pose_roots(FivePoses poses) {
  FivePoseRoots out = prepared(poses);
  if (out.what != Degeneracy::none) return out;
  if (!detail::add_sextic_roots(least_sextic_pivot, out) || out.close) take_action_path(poses, out);
  return out;
}

}  // namespace burmester::spherical
