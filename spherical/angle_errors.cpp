#include "burmester/spherical/angle_errors.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "burmester/geometry/jet.hpp"
#include "burmester/geometry/quad.hpp"
#include "burmester/spherical/equal_angles.hpp"
#include "burmester/spherical/five_pose_equations.hpp"

namespace burmester::spherical {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

using First = Jet<double, 4>;
using Second = Jet<First, 4>;  ///< its slope's slopes are the second derivatives
using Vector3J = Vector<Second, 3>;

Second variable(int i, double scale) {
  Vector<First, 4> slope = Vector<First, 4>::Zero();
  slope[i] = First(scale);
  return {First::variable(0, i, scale), slope};
}

/// v turned by the rotation vector r, to second order.
Vector3J turned(const Vector3J& r, const Vector3J& v) {
  const Vector3J across = r.cross(v);
  return v + across + Second(0.5) * r.cross(across);
}

/// k of (1) with derivatives: columns value, gradient, Hessian by rows (16 for 4 x 4).
using Expansion = Eigen::Matrix<double, 9, 21>;
Expansion expansion(const TurnedTask& task, const AxesAt& x) {
  const double length = length_of_alpha(task, x);
  const Second one(1), zero(0), p = variable(0, length), q = variable(1, length), half = Second(0.5) * (p * p + q * q),
                                C(x.cosine), S(x.sine);
  const Vector3J r(zero, variable(2, 1), variable(3, 1));
  // in the frame of x: b = (1, 0, 0), a its neighbour at (p, q) on the unit sphere, a x b
  const Vector3J a0(C - p * S - half * C, S + p * C - half * S, q), w0(zero, q, half * S - S - p * C);
  const Matrix<Second, 3, 3> frame = x.frame.template cast<Second>();
  const Vector3J b = frame * turned(r, {one, zero, zero}), a = frame * turned(r, a0), w = frame * turned(r, w0);
  Vector<Second, 9> k;
  const Second inverse(1 / task.e);
  for (int i = 0; i < 3; ++i) k[i] = inverse * w[i], k[3 + i] = a[i] * b[i];
  const auto mixed = [&](int i, int j) { return Second(0.5) * (a[i] * b[j] + a[j] * b[i]); };
  k[6] = mixed(0, 1), k[7] = mixed(0, 2), k[8] = mixed(1, 2);
  Expansion out;
  for (int i = 0; i < 9; ++i) {
    out(i, 0) = k[i].value.value;
    for (int m = 0; m < 4; ++m) {
      out(i, 1 + m) = k[i].value.slope[m];
      for (int n = 0; n < 4; ++n) out(i, 5 + 4 * m + n) = k[i].slope[m].slope[n];
    }
  }
  return out;
}

/// theta_j - theta_0 of all orientations, a column each with its derivatives, and the change of theta_0 itself.
struct Angles {
  Eigen::VectorXd change;
  Eigen::Matrix4Xd gradient;
  Eigen::Matrix<double, 16, Eigen::Dynamic> hessian;
  Eigen::Vector4d common = Eigen::Vector4d::Zero();
  Eigen::Matrix4d common_hessian = Eigen::Matrix4d::Zero();
};

/// With C_j = cos(theta_j) = C + y: S_j d(theta_j) = S d(theta_0) - dy, and once more.
Angles angles_of(const TurnedTask& task, const AxesAt& x) {
  Eigen::MatrixXd Y = task.rows * expansion(task, x);
  const Eigen::Vector3d a = moving_axis(x), b = x.frame.col(0), w = -x.sine / task.e * x.frame.col(2);
  for (Eigen::Index j = 0; j < Y.rows(); ++j) {  // as products of cross products, which are small about a common axis
    const Eigen::Vector3d t = task.t.col(j);
    Y(j, 0) = task.c[j] * t.dot(w) - t.cross(a).dot(t.cross(b));
  }
  Y *= 2 * task.e * task.e;
  const double C = x.cosine, S = x.sine, length = length_of_alpha(task, x);
  Angles out;
  out.common[0] = length;
  out.common_hessian(1, 1) = length * length * C / S;
  out.change.resize(Y.rows()), out.gradient.resize(4, Y.rows()), out.hessian.resize(16, Y.rows());
  const Eigen::Matrix4d squares = out.common * out.common.transpose();
  for (Eigen::Index j = 0; j < Y.rows(); ++j) {
    const double y = Y(j, 0), Cj = C + y, Sj = std::sqrt(std::max(S * S - y * (2 * C + y), 0.0)),
                 less = y * (2 * C + y) / (S + Sj);  // S - S_j
    out.change[j] = std::atan2(-(less * C + y * S), Sj * S + Cj * C);
    const Eigen::Vector4d g = (less * out.common - Y.row(j).segment<4>(1).transpose()) / Sj;
    const Eigen::Matrix4d mixed = g * out.common.transpose();
    out.gradient.col(j) = g;
    Eigen::Matrix4d h = less * out.common_hessian - y * squares - Cj * (mixed + mixed.transpose() + g * g.transpose());
    for (int m = 0; m < 4; ++m) h.row(m) -= Y.row(j).segment<4>(5 + 4 * m);
    Eigen::Map<Eigen::Matrix4d>(out.hessian.col(j).data()) = h / Sj;
  }
  return out;
}

/// A stretch below this, relative to the largest, is rounding: derivatives are known to some units of 2^-53, times up
/// to 2^6 for alpha of close axes.
constexpr double undetermined = 0x1p-44;

template <class D>
constexpr bool has_arc = std::is_same_v<D, RR>;

}  // namespace

TurnedTask turned_task(std::span<const Pose> poses, std::span<const double> weights) {
  TurnedTask task;
  const Eigen::Index n = static_cast<Eigen::Index>(poses.size());
  task.reference = poses[0];
  task.c.resize(n), task.t.resize(3, n), task.rows.resize(n, 9), task.weights.resize(n);
  task.shift = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto exact = relative_rotation<Quad>(poses[0], poses[static_cast<std::size_t>(j)]);
    const Vector<double, 4> q = exact.unaryExpr([](const Quad& x) { return static_cast<double>(x); });
    const double norm = q.norm();
    task.c[j] = q[0] / norm, task.t.col(j) = q.tail<3>() / norm;
    task.weights[j] = weights[static_cast<std::size_t>(j)];
    if (task.weights[j] > 0) task.e = std::max(task.e, task.t.col(j).norm());
  }
  if (!(task.e > 0)) return task;
  task.t /= task.e;
  for (Eigen::Index j = 0; j < n; ++j) task.rows.row(j) = kept_angle(task.c[j], task.t.col(j), 1).transpose();
  return task;
}

AxesAt axes_at(const Eigen::Vector3d& fixed, const Eigen::Vector3d& moving) {
  const Eigen::Vector3d b = fixed.normalized(), a = moving.normalized(), n = b.cross(a);
  const Eigen::Vector3d across = n.squaredNorm() > 0 ? n.cross(b).normalized() : b.unitOrthogonal();
  AxesAt out{{}, b.dot(a), n.norm()};
  out.frame << b, across, b.cross(across);
  return out;
}

Eigen::Vector3d moving_axis(const AxesAt& x) {
  return (x.cosine * x.frame.col(0) + x.sine * x.frame.col(1)).normalized();
}

double length_of_alpha(const TurnedTask& task, const AxesAt& x) { return std::min(1.0, std::hypot(x.sine, task.e)); }

AxesAt moved(const TurnedTask& task, const AxesAt& x, const Eigen::Vector4d& u) {
  const double length = length_of_alpha(task, x), p = length * u[0], q = length * u[1];
  const double along = x.cosine - p * x.sine, across = x.sine + p * x.cosine, norm = std::hypot(along, across, q);
  const Eigen::Vector3d r(0, u[2], u[3]);
  const double angle = r.norm();
  Eigen::Matrix3d turn = Eigen::AngleAxisd(std::atan2(q, across), Eigen::Vector3d::UnitX()).toRotationMatrix();
  if (angle > 0) turn = Eigen::AngleAxisd(angle, r / angle).toRotationMatrix() * turn;
  const Eigen::Matrix3d frame = x.frame * turn;
  return {Eigen::Quaterniond(frame).normalized().toRotationMatrix(), along / norm, std::hypot(across, q) / norm};
}

template <class D>
AngleErrors angle_errors(const TurnedTask& task, const AxesAt& x) {
  Angles angles = angles_of(task, x);
  AngleErrors out{right_angle, angles.change - task.shift, std::move(angles.gradient), std::move(angles.hessian)};
  if constexpr (has_arc<D>) {
    const Eigen::VectorXd share = task.weights / task.weights.sum();
    const double mean = share.dot(out.values);
    const Eigen::Vector4d slope = out.slopes * share;
    const Eigen::Matrix<double, 16, 1> bend = out.bends * share;
    out.values.array() -= mean, out.slopes.colwise() -= slope, out.bends.colwise() -= bend;
    out.arc = std::atan2(x.sine, x.cosine) + mean;
  } else {
    out.values.array() -= std::atan2(x.cosine, x.sine), out.slopes.colwise() += angles.common;
    out.bends.colwise() += angles.common_hessian.reshaped();
  }
  return out;
}

template <class D>
double condition_of(const TurnedTask& task, const AxesAt& x) {
  const Angles angles = angles_of(task, x);
  const double length = length_of_alpha(task, x);
  // change of b along frame columns 1, 2 and of a along its tangents, by (alpha, beta)
  Eigen::Matrix4d natural = Eigen::Matrix4d::Zero();
  natural(0, 3) = 1, natural(1, 2) = -1;
  natural(2, 0) = length, natural(2, 3) = 1;
  natural(3, 1) = length, natural(3, 2) = -x.cosine;
  Eigen::MatrixXd J(task.rows.rows(), D::parameters);
  J.leftCols<4>() = (angles.gradient.colwise() + angles.common).transpose() * natural.inverse();
  if constexpr (has_arc<D>) J.col(4).setConstant(-1);
  const Eigen::VectorXd stretch = Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues();
  const double least = stretch[D::parameters - 1];
  return least > undetermined * stretch[0] ? 1 / least : std::numeric_limits<double>::infinity();
}

template AngleErrors angle_errors<RR>(const TurnedTask&, const AxesAt&);
template AngleErrors angle_errors<PR>(const TurnedTask&, const AxesAt&);
template double condition_of<RR>(const TurnedTask&, const AxesAt&);
template double condition_of<PR>(const TurnedTask&, const AxesAt&);

}  // namespace burmester::spherical
