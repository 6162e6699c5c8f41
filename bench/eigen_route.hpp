// The peer: five-pose synthesis as one writes it with Eigen's decompositions. It gets the same rows (relative poses,
// length unit, anchored basis), so that the comparison is of the algebra and not of the formulation.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <complex>

#include "burmester/planar/five_pose_roots.hpp"
#include "burmester/planar/tasks.hpp"

namespace eigen_route {

using namespace burmester;
using namespace burmester::planar;

using Quadratic = Eigen::Vector3d;  // coefficients of x^2, x, 1
using Quartic = Eigen::Matrix<double, 5, 1>;

/// The conic as a polynomial in y whose coefficients are polynomials in x (z = 1): y2 y^2 + y1(x) y + y0(x).
struct InY {
  double y2;
  Eigen::Vector2d y1;  // x, 1
  Quadratic y0;
  explicit InY(const Conic<double>& c) : y2(c.q[1]), y1(c.q[5], c.q[3]), y0(c.q[0], c.q[4], c.q[2]) {}
};

inline Eigen::Vector4d cubic_of(const Eigen::Vector2d& a, const Quadratic& b) {
  return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1], a[1] * b[2]};
}

/// Resultant with respect to y: (a2 b0 - a0 b2)^2 - (a2 b1 - a1 b2)(a1 b0 - a0 b1).
inline Quartic resultant(const InY& a, const InY& b) {
  const Quadratic u = a.y2 * b.y0 - b.y2 * a.y0;
  const Eigen::Vector2d v = a.y2 * b.y1 - b.y2 * a.y1;
  const Eigen::Vector4d w = cubic_of(a.y1, b.y0) - cubic_of(b.y1, a.y0);
  Quartic r;
  r << u[0] * u[0], 2 * u[0] * u[1], u[1] * u[1] + 2 * u[0] * u[2], 2 * u[1] * u[2], u[2] * u[2];
  r[0] -= v[0] * w[0];
  r[1] -= v[0] * w[1] + v[1] * w[0];
  r[2] -= v[0] * w[2] + v[1] * w[1];
  r[3] -= v[0] * w[3] + v[1] * w[2];
  r[4] -= v[1] * w[3];
  return r;
}

inline Eigen::Vector4cd companion_roots(const Quartic& r) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion(1, 0) = companion(2, 1) = companion(3, 2) = 1;
  for (int i = 0; i < 4; ++i) companion(i, 3) = -r[4 - i] / r[0];
  return Eigen::EigenSolver<Eigen::Matrix4d>(companion, false).eigenvalues();
}

inline Eigen::Matrix<double, 7, 3> null_space_by_svd(const FivePoseTask& task, const Anchor& anchor) {
  const Eigen::Matrix<double, 4, 7> rows = anchored_rows<double>(task, anchor);
  return Eigen::JacobiSVD<Eigen::Matrix<double, 4, 7>>(rows, Eigen::ComputeFullV).matrixV().rightCols<3>();
}

inline FivePoseRoots<double> solve(const FivePoseTask& task) {
  FivePoseRoots<double> out;
  out.anchor = choose_anchor(task).anchor;
  const Matrix<double, 7, 3> basis = null_space_by_svd(task, out.anchor);
  const auto conics = relation_conics<double>(basis, out.anchor.turn);
  const InY a(conics[0]), b(conics[1]);
  const Eigen::Vector4cd roots = companion_roots(resultant(a, b));
  for (int i = 0; i < 4; ++i) {
    if (std::abs(roots[i].imag()) > 1e-8 * (1 + std::abs(roots[i]))) continue;
    const double x = roots[i].real();
    const Quadratic powers(x * x, x, 1);
    const double u = (a.y2 * b.y0 - b.y2 * a.y0).dot(powers);
    const double v = (a.y2 * b.y1 - b.y2 * a.y1).dot(powers.tail<2>());
    out.w[out.count++] = basis * Vector<double, 3>(x, -u / v, 1);
  }
  return out;
}

/// The decompositions alone, on matrices of the right kind.
inline double kernels(const FivePoseTask& task) {
  const Eigen::Matrix<double, 7, 3> basis = null_space_by_svd(task, choose_anchor(task).anchor);
  Quartic r;
  r << 1, basis.col(0).head<4>();
  return companion_roots(r)[0].real();
}

}  // namespace eigen_route
