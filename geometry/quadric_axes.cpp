#include "burmester/geometry/quadric_axes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace burmester {
namespace {

using Vector3 = Vector<double, 3>;

/// Q = sum value[i] u_i^2 + 2 linear[i] u_i + constant, u_i = axis[i] . x, with coefficients of order 1.
struct Principal {
  std::array<Vector3, 3> axis;
  std::array<double, 3> value, linear;
  double constant;

  explicit Principal(const Quadric<double>& given) {
    const double size = size_of(given);
    std::array<double, 10> q;
    for (std::size_t k = 0; k < 10; ++k) q[k] = given.q[k] / size;
    Matrix<double, 3, 3> a;
    a << q[0], q[4] / 2, q[5] / 2, q[4] / 2, q[1], q[7] / 2, q[5] / 2, q[7] / 2, q[2];
    const Vector3 b(q[6] / 2, q[8] / 2, q[9] / 2);
    const Eigen::SelfAdjointEigenSolver<Matrix<double, 3, 3>> eigen(a);
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      axis[k] = eigen.eigenvectors().col(i), value[k] = eigen.eigenvalues()[i], linear[k] = b.dot(axis[k]);
    }
    constant = q[3];
  }
};

}  // namespace

QuadricAxes axes_of(const Quadric<double>& quadric) {
  const Principal p(quadric);
  QuadricAxes out;
  out.centre = Vector3::Zero();
  double there = p.constant;
  for (std::size_t i = 0; i < 3; ++i) {
    const double u = -p.linear[i] / p.value[i];
    out.centre += u * p.axis[i];
    there += p.linear[i] * u;
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return -there / p.value[i] > -there / p.value[k]; });
  for (std::size_t i = 0; i < 3; ++i) out.axis[i] = p.axis[order[i]], out.square[i] = -there / p.value[order[i]];
  out.axis[2] = out.axis[0].cross(out.axis[1]);
  return out;
}

ParaboloidFrame paraboloid_frame(const Quadric<double>& quadric) {
  const Principal p(quadric);
  std::array<std::size_t, 3> order{0, 1, 2};  // the eigenvalue 0 last
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return std::abs(p.value[i]) > std::abs(p.value[k]); });
  const std::size_t n = order[2];
  ParaboloidFrame out;
  out.axis = p.axis[n], out.vertex = Vector3::Zero();
  double rest = p.constant;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t k = order[i];
    const double u = -p.linear[k] / p.value[k];
    out.vertex += u * p.axis[k];
    rest += p.linear[k] * u;
    out.principal[i] = p.axis[k], out.parameter[i] = -p.linear[n] / p.value[k];
  }
  out.vertex -= rest / (2 * p.linear[n]) * out.axis;
  if (std::abs(out.parameter[0]) < std::abs(out.parameter[1])) {
    std::swap(out.parameter[0], out.parameter[1]);
    std::swap(out.principal[0], out.principal[1]);
  }
  if (out.parameter[0] < 0) {
    out.axis = -out.axis;
    for (double& parameter : out.parameter) parameter = -parameter;
  }
  out.principal[1] = out.axis.cross(out.principal[0]);
  return out;
}

}  // namespace burmester
