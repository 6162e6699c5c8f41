#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "burmester/geometry/null_space.hpp"
#include "burmester/spherical/five_pose_roots.hpp"

namespace burmester::spherical {
namespace {

constexpr int quadratic_count = 15, cubic_count = 35;

/// Place of the monomial z_i z_j (z_i z_j z_k) in a list of all of them; the order of i, j, k does not matter.
struct Places {
  int quadratic[5][5] = {}, cubic[5][5][5] = {};
  constexpr Places() {
    for (int i = 0, q = 0, c = 0; i < 5; ++i)
      for (int j = i; j < 5; ++j) {
        quadratic[i][j] = quadratic[j][i] = q++;
        for (int k = j; k < 5; ++k, ++c)
          cubic[i][j][k] = cubic[i][k][j] = cubic[j][i][k] = cubic[j][k][i] = cubic[k][i][j] = cubic[k][j][i] = c;
      }
  }
};
constexpr Places place;

using Basis = Eigen::Matrix<double, 9, 5>;                   // k = basis z
using Quadrics = Eigen::Matrix<double, 9, quadratic_count>;  // the relations in z
using Point4 = Vector<double, 5>;

Basis orthonormal_null_space(const FivePoseEquations& equations) {
  const Basis basis = null_space(equations.rows).basis;
  return Eigen::HouseholderQR<Basis>(basis).householderQ() * Basis::Identity();
}

Quadrics quadrics(const Basis& basis, double e) {
  std::array<Lifted, 5> own;
  for (int i = 0; i < 5; ++i) own[static_cast<std::size_t>(i)] = scaled_relations(basis.col(i), e);
  Quadrics out;
  for (int i = 0; i < 5; ++i)
    for (int j = i; j < 5; ++j) {
      const Lifted &f = own[static_cast<std::size_t>(i)], &g = own[static_cast<std::size_t>(j)];
      out.col(place.quadratic[i][j]) = i == j ? f : Lifted(scaled_relations(basis.col(i) + basis.col(j), e) - f - g);
    }
  return out;
}

/// The linear functions on cubic forms that vanish on the ideal, as values on the monomials: 35 x 6, spanned by the
/// values at the six points. Empty where the ideal leaves more.
using Dual = Eigen::Matrix<double, cubic_count, 6>;
std::optional<Dual> dual_of_cubics(const Quadrics& relation) {
  using Macaulay = Eigen::Matrix<double, cubic_count, 45>;  // transposed
  Macaulay m = Macaulay::Zero();
  for (int z = 0, column = 0; z < 5; ++z)
    for (int r = 0; r < 9; ++r, ++column)
      for (int i = 0; i < 5; ++i)
        for (int j = i; j < 5; ++j) m(place.cubic[z][i][j], column) += relation(r, place.quadratic[i][j]);
  const Eigen::ColPivHouseholderQR<Macaulay> qr(m);
  if (!(std::abs(qr.matrixR()(28, 28)) > 0x1p-40 * std::abs(qr.matrixR()(0, 0)))) return std::nullopt;
  Dual last = Dual::Zero();
  last.bottomRows<6>().setIdentity();
  return qr.householderQ() * last;
}

/// Those functions, each first multiplied by a linear form: as values on the quadratic monomials.
Eigen::Matrix<double, quadratic_count, 6> contracted(const Dual& dual, const Point4& form) {
  Eigen::Matrix<double, quadratic_count, 6> out = decltype(out)::Zero();
  for (int i = 0; i < 5; ++i)
    for (int j = i; j < 5; ++j)
      for (int k = 0; k < 5; ++k) out.row(place.quadratic[i][j]) += form[k] * dual.row(place.cubic[i][j][k]);
  return out;
}

/// z from the values of its cubic monomials: those divisible by the square of the largest coordinate.
Point4 point_of(const Eigen::Matrix<double, cubic_count, 1>& cubes) {
  int largest = 0;
  for (int i = 1; i < 5; ++i)
    if (std::abs(cubes[place.cubic[i][i][i]]) > std::abs(cubes[place.cubic[largest][largest][largest]])) largest = i;
  Point4 z;
  for (int k = 0; k < 5; ++k) z[k] = cubes[place.cubic[largest][largest][k]];
  return z;
}

}  // namespace

std::optional<detail::Action> detail::action_of(const FivePoseEquations& equations) {
  const Basis basis = orthonormal_null_space(equations);
  const auto dual = dual_of_cubics(quadrics(basis, equations.e));
  if (!dual) return std::nullopt;
  // two linear forms in general position: no two dyads have the same quotient, none makes the divisor vanish
  const Point4 divisor{0.61, -0.47, 0.33, 0.42, -0.36}, form{-0.29, 0.53, 0.57, -0.31, -0.46};
  return Action{basis, *dual, contracted(*dual, divisor).colPivHouseholderQr().solve(contracted(*dual, form))};
}

bool detail::add_action_roots(FivePoseRoots& out) {
  const double e = out.equations.e;
  const auto action = action_of(out.equations);
  if (!action) return false;
  const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> eigen(Eigen::Matrix<double, 6, 6>(action->matrix));
  for (int i = 0; i < 6; ++i) {
    if (eigen.eigenvalues()[i].imag() != 0) continue;
    ScaledDyad x = scaled_dyad(Lifted(action->basis * point_of(action->dual * eigen.eigenvectors().col(i).real())), e);
    for (int step = 0; step < 3; ++step)
      if (improve(out.equations, x) < 0x1p-40) break;
    out.root[static_cast<std::size_t>(out.count++)] = x;
  }
  return true;
}

}  // namespace burmester::spherical
