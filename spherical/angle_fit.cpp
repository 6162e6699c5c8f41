#include "burmester/spherical/angle_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

/// Of alpha: 1 for wide angles, e for those of the size of the turns.
double length_of_alpha(const TurnedTask& task, const AxesAt& x) { return std::min(1.0, std::hypot(x.sine, task.e)); }

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
  const Eigen::MatrixXd Y = 2 * task.e * task.e * task.rows * expansion(task, x);
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

template <class D>
constexpr bool has_arc = std::is_same_v<D, RR>;

/// The neighbour of x at the given variables: a moves along its tangents, then both turn.
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

Eigen::Vector3d moving_axis(const AxesAt& x) {
  return (x.cosine * x.frame.col(0) + x.sine * x.frame.col(1)).normalized();
}

template <class D>
typename D::Design design_of(const TurnedTask& task, const AxesAt& x, double arc) {
  const auto reference = Space::point<double>(task.reference);
  const Axis fixed = Space::act<double>(reference, Axis(x.frame.col(0))).normalized();
  if constexpr (has_arc<D>)
    return {fixed, moving_axis(x), arc};
  else
    return {fixed, moving_axis(x)};
}

/// Newton steps in the eigenvectors of the Hessian, downwards along all of them.
struct Newton {
  Eigen::Matrix4d modes;
  Eigen::Vector4d slope, curvature;
  explicit Newton(const ErrorSum& at) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(at.hessian);
    modes = solver.eigenvectors(), curvature = solver.eigenvalues(), slope = modes.transpose() * at.gradient;
  }
  /// Of a step in modes, to second order.
  double gain(const Eigen::Vector4d& step) const { return -slope.dot(step) - step.cwiseAbs2().dot(curvature) / 2; }
  Eigen::Vector4d step(double shift) const {
    Eigen::Vector4d out = Eigen::Vector4d::Zero();
    for (int i = 0; i < 4; ++i)
      if (slope[i] != 0) out[i] = -slope[i] / (std::abs(curvature[i]) + shift);
    return out;
  }
  /// The least shift, to a tenth, that makes the step no longer than `radius`.
  double shift_for(double radius) const {
    if (step(0).norm() <= radius) return 0;
    double low = 0, high = slope.norm() / radius;
    for (int i = 0; i < 60 && low < 0.9 * high; ++i) {
      const double middle = low > 0 ? std::sqrt(low * high) : high * 0x1p-8;
      (step(middle).norm() > radius ? low : high) = middle;
    }
    return high;
  }
  /// Newton's step along the modes steeper than `shift`: back to the floor of a curved valley.
  Eigen::Vector4d back(double shift) const { return (curvature.array() > shift).select(step(0), 0.0); }
};

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

template <class D>
ErrorSum error_sum(const TurnedTask& task, const AxesAt& x) {
  Angles angles = angles_of(task, x);
  angles.change -= task.shift;
  const Eigen::VectorXd& w = task.weights;
  ErrorSum out;
  Eigen::Matrix4d common_hessian = Eigen::Matrix4d::Zero();
  if constexpr (has_arc<D>) {
    const double sum = w.sum(), mean = w.dot(angles.change) / sum;
    const Eigen::Vector4d slope = angles.gradient * w / sum;
    angles.change.array() -= mean, angles.gradient.colwise() -= slope;
    out.arc = std::atan2(x.sine, x.cosine) + mean;
  } else {
    angles.change.array() -= std::atan2(x.cosine, x.sine), angles.gradient.colwise() += angles.common;
    common_hessian = angles.common_hessian;
    out.arc = right_angle;
  }
  const Eigen::VectorXd weighted = w.cwiseProduct(angles.change);
  out.value = weighted.dot(angles.change) / 2;
  out.gradient = angles.gradient * weighted;
  const Eigen::Matrix<double, 16, 1> bent = angles.hessian * weighted;
  out.hessian = angles.gradient * w.asDiagonal() * angles.gradient.transpose() +
                Eigen::Map<const Eigen::Matrix4d>(bent.data()) + weighted.sum() * common_hessian;
  out.errors = angles.change;
  return out;
}

template <class D>
AngleFit<D> nearest_fit(const TurnedTask& task, const AxesAt& start, int steps) {
  AngleFit<D> out{start, {}, 0, {}, false};
  ErrorSum here = error_sum<D>(task, out.axes);
  const double rounding = task.weights.sum() * std::pow(0x1p-48 * task.e, 2);
  double radius = 0.25, last = 1;
  for (int i = 0; i < steps && std::isfinite(here.value) && here.hessian.allFinite(); ++i) {
    const Newton newton(here);
    const double shift = newton.shift_for(radius);
    const Eigen::Vector4d step = newton.step(shift);
    const double expected = newton.gain(step);
    out.least = newton.curvature.minCoeff() >= -0x1p-46 * newton.curvature.cwiseAbs().maxCoeff() &&
                expected <= std::max(0x1p-44 * here.value, rounding);
    if (out.least && !(step.norm() < last / 2)) break;
    AxesAt next = moved(task, out.axes, newton.modes * step);
    ErrorSum there = error_sum<D>(task, next);
    if (!out.least && !(here.value - there.value > 0.25 * expected) && there.hessian.allFinite()) {
      const Newton again(there);
      const Eigen::Vector4d back = again.back(shift);
      if (back.norm() < radius) {
        const AxesAt floor = moved(task, next, again.modes * back);
        const ErrorSum on_floor = error_sum<D>(task, floor);
        if (on_floor.value < there.value) next = floor, there = on_floor;
      }
    }
    const double gained = here.value - there.value;
    // the sum does not show the last steps, they end where they grow no shorter
    if (out.least || gained > 0) out.axes = next, here = there;
    if (out.least) {
      last = step.norm();
      continue;
    }
    if (!(gained > 0.25 * expected))
      radius = 0.25 * std::min(radius, step.norm());
    else if (gained > 0.75 * expected)
      radius = std::min(1.0, std::max(radius, 2.5 * step.norm()));
    if (radius < 0x1p-60) break;
  }
  out.design = design_of<D>(task, out.axes, here.arc);
  out.sum = 2 * here.value, out.errors = here.errors;
  return out;
}

template <class D>
std::optional<AngleFit<D>> met_exactly(TurnedTask task, const AngleFit<D>& fit, std::span<const Eigen::Index> which,
                                       int steps) {
  AngleFit<D> out = fit;
  for (int round = 0; round < 50; ++round) {
    double largest = 0, sum = out.sum;
    for (const Eigen::Index j : which) {
      const double error = out.errors[j] + task.shift[j];
      largest = std::max(largest, std::abs(error));
      sum -= task.weights[j] * out.errors[j] * out.errors[j];
      task.shift[j] -= error;
    }
    if (out.least && largest <= 0x1p-46 * task.e) {
      out.sum = sum;
      return out;
    }
    out = nearest_fit<D>(task, out.axes, steps);
  }
  return std::nullopt;
}

template <class D>
bool same_fit(const TurnedTask& task, const AngleFit<D>& x, const AngleFit<D>& y, double same) {
  const auto near = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v, double tolerance) {
    return std::min((u - v).norm(), (u + v).norm()) <= tolerance;
  };
  const AxesAt &p = x.axes, &q = y.axes;
  const double scale = std::max(length_of_alpha(task, p), length_of_alpha(task, q));
  return near(p.frame.col(0), q.frame.col(0), same) && near(moving_axis(p), moving_axis(q), same) &&
         near(p.sine * p.frame.col(2), q.sine * q.frame.col(2), same * scale);
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
  return least > 0x1p-44 * stretch[0] ? 1 / least : std::numeric_limits<double>::infinity();
}

template ErrorSum error_sum<RR>(const TurnedTask&, const AxesAt&);
template ErrorSum error_sum<PR>(const TurnedTask&, const AxesAt&);
template AngleFit<RR> nearest_fit(const TurnedTask&, const AxesAt&, int);
template AngleFit<PR> nearest_fit(const TurnedTask&, const AxesAt&, int);
template std::optional<AngleFit<RR>> met_exactly(TurnedTask, const AngleFit<RR>&, std::span<const Eigen::Index>, int);
template std::optional<AngleFit<PR>> met_exactly(TurnedTask, const AngleFit<PR>&, std::span<const Eigen::Index>, int);
template bool same_fit(const TurnedTask&, const AngleFit<RR>&, const AngleFit<RR>&, double);
template bool same_fit(const TurnedTask&, const AngleFit<PR>&, const AngleFit<PR>&, double);
template double condition_of<RR>(const TurnedTask&, const AxesAt&);
template double condition_of<PR>(const TurnedTask&, const AxesAt&);

}  // namespace burmester::spherical
