#include "burmester/spherical/angle_fit.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace burmester::spherical {
namespace {

template <class D>
typename D::Design design_of(const TurnedTask& task, const AxesAt& x, double arc) {
  const auto reference = Space::point<double>(task.reference);
  const Axis fixed = Space::act<double>(reference, Axis(x.frame.col(0))).normalized();
  if constexpr (std::is_same_v<D, RR>)
    return {fixed, moving_axis(x), arc};
  else
    return {fixed, moving_axis(x)};
}

/// A sweep squares what is left off the diagonal: five or six do, of any matrix.
constexpr int most_sweeps = 20;

/// Jacobi's rotations: the symmetric `matrix` becomes diagonal to the rounding of its rows and columns, whatever their
/// sizes; `modes` times the rotations.
void diagonalise(Eigen::Matrix4d& matrix, Eigen::Matrix4d& modes) {
  bool more = true;
  for (int sweep = 0; sweep < most_sweeps && more; ++sweep) {
    more = false;
    for (int p = 0; p < 4; ++p)
      for (int q = p + 1; q < 4; ++q) {
        Eigen::JacobiRotation<double> turn;
        if (!(std::abs(matrix(p, q)) > 0x1p-52 * std::sqrt(std::abs(matrix(p, p) * matrix(q, q))))) continue;
        if (!turn.makeJacobi(matrix, p, q)) continue;
        matrix.applyOnTheLeft(p, q, turn.adjoint()), matrix.applyOnTheRight(p, q, turn);
        matrix(p, q) = matrix(q, p) = 0;
        modes.applyOnTheRight(p, q, turn);
        more = true;
      }
  }
}

/// Newton steps in the modes of the second derivatives, downwards along all of them.
struct Newton {
  Eigen::Matrix4d modes;
  Eigen::Vector4d slope, curvature;
  Eigen::VectorXd across;  ///< errors times the roots of the weights, the part across their derivatives
  Newton(const TurnedTask& task, const AngleErrors& at) {
    const Eigen::VectorXd root = task.weights.cwiseSqrt(), E = root.cwiseProduct(at.values);
    const Eigen::HouseholderQR<Eigen::MatrixX4d> qr(root.asDiagonal() * at.slopes.transpose());
    Eigen::VectorXd turned = qr.householderQ().adjoint() * E;
    const Eigen::JacobiSVD<Eigen::Matrix4d> svd(
        Eigen::Matrix4d(qr.matrixQR().topRows<4>().triangularView<Eigen::Upper>()),
        Eigen::ComputeFullU | Eigen::ComputeFullV);
    modes = svd.matrixV();
    slope = svd.singularValues().cwiseProduct(svd.matrixU().transpose() * turned.head<4>());
    turned.head<4>().setZero();
    across = qr.householderQ() * turned;
    find_modes((at.bends * root.cwiseProduct(across)).reshaped(4, 4), svd.singularValues());
  }
  /// From those of the first derivatives to those of the second.
  void find_modes(const Eigen::Matrix4d& bend, const Eigen::Vector4d& stretch) {
    Eigen::Matrix4d hessian = modes.transpose() * (bend + bend.transpose()) * modes / 2;
    hessian.diagonal() += stretch.cwiseAbs2();
    Eigen::Matrix4d turns = Eigen::Matrix4d::Identity();
    diagonalise(hessian, turns);
    modes *= turns, slope = (turns.transpose() * slope).eval(), curvature = hessian.diagonal();
  }
  /// How large a curvature is rounding: that of the errors, 2^-51 e, times the bends along the mode, and theirs.
  double rounding(const TurnedTask& task, const AngleErrors& at, int mode) const {
    const Eigen::Matrix4d square = modes.col(mode) * modes.col(mode).transpose();
    const Eigen::VectorXd bends = (square.reshaped().transpose() * at.bends).transpose().cwiseAbs(),
                          sizes = at.bends.colwise().norm().transpose(), root = task.weights.cwiseSqrt();
    return 0x1p-51 * (task.e * task.weights.dot(bends) + root.cwiseProduct(across).cwiseAbs().dot(sizes));
  }
  bool bends_down(const TurnedTask& task, const AngleErrors& at) const {
    for (int i = 0; i < 4; ++i)
      if (curvature[i] < 0 && curvature[i] < -rounding(task, at, i)) return true;
    return false;
  }
  bool bends_up(const TurnedTask& task, const AngleErrors& at) const {
    for (int i = 0; i < 4; ++i)
      if (!(curvature[i] > rounding(task, at, i))) return false;
    return true;
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

struct Place {
  AxesAt axes;
  AngleErrors errors;
  double value;  ///< half the sum; infinite where errors or derivatives are not finite
};

template <class D>
Place place_at(const TurnedTask& task, const AxesAt& axes) {
  Place out{axes, angle_errors<D>(task, axes), std::numeric_limits<double>::infinity()};
  const AngleErrors& at = out.errors;
  if (at.values.allFinite() && at.slopes.allFinite() && at.bends.allFinite())
    out.value = task.weights.dot(at.values.cwiseAbs2()) / 2;
  return out;
}

/// From a place beside a curved valley one step across it, where that is lower.
template <class D>
Place on_floor(const TurnedTask& task, Place from, double shift, double radius) {
  if (!std::isfinite(from.value)) return from;
  const Newton newton(task, from.errors);
  const Eigen::Vector4d back = newton.back(shift);
  if (!(back.norm() < radius)) return from;
  Place floor = place_at<D>(task, moved(task, from.axes, newton.modes * back));
  return floor.value < from.value ? floor : from;
}

/// Of an error that is met, in units of e: 64 roundings.
constexpr double met_to = 0x1p-46;

/// Newton's last step at a place that is sure, in (alpha, beta): a thousandth. Where it is not less, rounding makes it.
constexpr double least_known = 1e-3;

/// Whether a place is a minimum. `cut`: the step is shorter than Newton's; where errors are more than rounding, a slope
/// without curvature goes on.
template <class D>
void judge(AngleFit<D>& fit, const TurnedTask& task, const Newton& newton, const Place& here,
           const Eigen::Vector4d& step, bool cut) {
  fit.met = here.errors.values.cwiseAbs().maxCoeff() <= met_to * task.e;
  const double noise = 0x1p-50 * task.e * std::sqrt(task.weights.sum()),  // of all errors: eight roundings each
      unseen = noise * std::max(std::sqrt(here.value), 4 * noise);        // of the sum
  fit.least = !newton.bends_down(task, here.errors) && (!cut || fit.met) &&
              newton.gain(step) <= std::max(0x1p-44 * here.value, unseen);
  fit.known = step.norm(), fit.sure = newton.bends_up(task, here.errors) && fit.known < least_known;
}

/// Of steps, in (alpha, beta): the first, and those that rounding of the axes hides.
constexpr double first_radius = 0.25, least_radius = 0x1p-60;

}  // namespace

template <class D>
AngleFit<D> nearest_fit(const TurnedTask& task, const AxesAt& start, int steps) {
  AngleFit<D> out;
  Place here = place_at<D>(task, start);
  double radius = first_radius, last = 1;
  for (int i = 0; i < steps && radius >= least_radius && std::isfinite(here.value); ++i) {
    const Newton newton(task, here.errors);
    const double shift = newton.shift_for(radius);
    const Eigen::Vector4d step = newton.step(shift);
    judge(out, task, newton, here, step, shift > 0);
    if (out.least && !(step.norm() < last / 2)) break;
    Place next = place_at<D>(task, moved(task, here.axes, newton.modes * step));
    if (out.least) {  // the sum does not show the last steps, they end where they grow no shorter
      if (!std::isfinite(next.value)) break;
      here = std::move(next), last = step.norm();
      continue;
    }
    const double expected = newton.gain(step);
    if (!(here.value - next.value > 0.25 * expected)) next = on_floor<D>(task, std::move(next), shift, radius);
    const double gained = here.value - next.value;
    if (gained > 0) here = std::move(next);
    if (!(gained > 0.25 * expected))
      radius = 0.25 * std::min(radius, step.norm());
    else if (gained > 0.75 * expected)
      radius = std::min(1.0, std::max(radius, 2.5 * step.norm()));
  }
  out.axes = here.axes, out.design = design_of<D>(task, here.axes, here.errors.arc);
  out.sum = 2 * here.value, out.errors = std::move(here.errors.values);
  return out;
}

/// Rounds of multipliers; where one leaves more than the given part, weights are too small and grow.
constexpr int most_rounds = 50;
constexpr double left_by_round = 0.25, growth = 10;

template <class D>
std::optional<AngleFit<D>> met_exactly(TurnedTask task, const AngleFit<D>& fit, std::span<const Eigen::Index> which,
                                       int steps) {
  AngleFit<D> out = fit;
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    double largest = 0, sum = out.sum;
    for (const Eigen::Index j : which) {
      const double error = out.errors[j] + task.shift[j];
      largest = std::max(largest, std::abs(error));
      sum -= task.weights[j] * out.errors[j] * out.errors[j];
      task.shift[j] -= error;
    }
    if (out.least && largest <= met_to * task.e) {
      out.sum = sum;
      return out;
    }
    if (!(largest <= left_by_round * last))  // the multipliers, weights times shifts, stay
      for (const Eigen::Index j : which) task.weights[j] *= growth, task.shift[j] /= growth;
    last = largest;
    out = nearest_fit<D>(task, out.axes, steps);
  }
  return std::nullopt;
}

template <class D>
bool same_fit(const TurnedTask& task, const AngleFit<D>& x, const AngleFit<D>& y, double same) {
  same = std::max(same, 8 * (x.known + y.known));  // Newton's last steps: in a row they halve, or are rounding
  const auto near = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v, double tolerance) {
    return std::min((u - v).norm(), (u + v).norm()) <= tolerance;
  };
  const AxesAt &p = x.axes, &q = y.axes;
  const double scale = std::max(length_of_alpha(task, p), length_of_alpha(task, q));
  return near(p.frame.col(0), q.frame.col(0), same) && near(moving_axis(p), moving_axis(q), same) &&
         near(p.sine * p.frame.col(2), q.sine * q.frame.col(2), same * scale);
}

template AngleFit<RR> nearest_fit(const TurnedTask&, const AxesAt&, int);
template AngleFit<PR> nearest_fit(const TurnedTask&, const AxesAt&, int);
template std::optional<AngleFit<RR>> met_exactly(TurnedTask, const AngleFit<RR>&, std::span<const Eigen::Index>, int);
template std::optional<AngleFit<PR>> met_exactly(TurnedTask, const AngleFit<PR>&, std::span<const Eigen::Index>, int);
template bool same_fit(const TurnedTask&, const AngleFit<RR>&, const AngleFit<RR>&, double);
template bool same_fit(const TurnedTask&, const AngleFit<PR>&, const AngleFit<PR>&, double);

}  // namespace burmester::spherical
