// A dyad type near a design and a pose: what follows from its residual and its local coordinates alone.
//
// Derivatives are central differences, (f(h) - f(-h)) / 2h with h = cbrt(epsilon), good to about 1e-10 where
// coordinates are of size 1: for searches, laws and condition numbers, not for certificates. Where lengths
// are smaller pass a step that is smaller by as much (step_for).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "burmester/modules/framework/dyad_type.hpp"

namespace burmester {

/// cbrt(2^-52): balances the h^2 of the difference against the epsilon / h of rounding.
inline constexpr double difference_step = 6.1e-6;

/// Distance from one image of the origin to the farthest one, the one being that farthest from the first: no less than
/// half of the largest distance between two. 1 where all coincide, as on the sphere. Precondition: one pose or more.
template <PoseSpace S>
double extent(std::span<const typename S::Pose> poses) {
  const auto origin = [](const typename S::Pose& pose) -> FeatureOf<S> {
    const PointOf<S> x = S::template point<double>(pose);
    return S::template act<double>(x, FeatureOf<S>::Zero()) / S::template norm<double>(x);
  };
  std::vector<FeatureOf<S>> origins;
  for (const auto& p : poses) origins.push_back(origin(p));
  const auto away = [&](const FeatureOf<S>& from) {
    return [&](const FeatureOf<S>& a, const FeatureOf<S>& b) { return S::distance(from, a) < S::distance(from, b); };
  };
  const FeatureOf<S>& one = *std::max_element(origins.begin(), origins.end(), away(origins[0]));
  const double largest = S::distance(one, *std::max_element(origins.begin(), origins.end(), away(one)));
  return largest > 0 ? largest : 1;
}

/// The step for derivatives near these poses.
template <PoseSpace S>
double step_for(std::span<const typename S::Pose> poses) {
  return difference_step * std::clamp(extent<S>(poses), 1e-9, 1.0);
}

template <DyadType D>
Eigen::VectorXd residuals(const typename D::Design& d, std::span<const typename D::Space::Pose> poses) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(poses.size()));
  for (std::size_t j = 0; j < poses.size(); ++j) r[static_cast<Eigen::Index>(j)] = D::residual(d, poses[j]);
  return r;
}

/// d residual_j / d u_i at u = 0: poses x parameters.
template <DyadType D>
Eigen::MatrixXd design_jacobian(const typename D::Design& d, std::span<const typename D::Space::Pose> poses,
                                double step = difference_step) {
  Eigen::MatrixXd J(static_cast<Eigen::Index>(poses.size()), D::parameters);
  for (int i = 0; i < D::parameters; ++i) {
    const Vector<double, D::parameters> u = step * Vector<double, D::parameters>::Unit(i);
    J.col(i) = (residuals<D>(D::nudged(d, u), poses) - residuals<D>(D::nudged(d, -u), poses)) / (2 * step);
  }
  return J;
}

/// d residual / d pose, in the space's local coordinates.
template <DyadType D>
Vector<double, D::Space::dof> pose_gradient(const typename D::Design& d, const typename D::Space::Pose& pose,
                                            double step = difference_step) {
  using S = typename D::Space;
  Vector<double, S::dof> gradient;
  for (int i = 0; i < S::dof; ++i) {
    const Vector<double, S::dof> u = step * Vector<double, S::dof>::Unit(i);
    gradient[i] = (D::residual(d, S::nudged(pose, u)) - D::residual(d, S::nudged(pose, -u))) / (2 * step);
  }
  return gradient;
}

/// A pose whose residual is `target`, reached from `start` by damped Newton steps along the gradient. Empty
/// where they get stuck; the residual of the answer is within 1e-11 (1 + |start's residual|) of the target.
template <DyadType D>
std::optional<typename D::Space::Pose> pose_with_residual(const typename D::Design& d,
                                                          const typename D::Space::Pose& start,
                                                          double target = 0) {
  using S = typename D::Space;
  typename S::Pose pose = start;
  double off = D::residual(d, pose) - target;
  const double wanted = 1e-11 * (1 + std::abs(off));
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vector<double, S::dof> gradient = pose_gradient<D>(d, pose);
    Vector<double, S::dof> u = -off / gradient.squaredNorm() * gradient;
    if (!u.allFinite()) break;
    bool better = false;
    for (int halving = 0; halving < 30 && !better; ++halving, u /= 2) {
      const typename S::Pose next = S::nudged(pose, u);
      const double next_off = D::residual(d, next) - target;
      better = std::abs(next_off) < std::abs(off);
      if (better) pose = next, off = next_off;
    }
    if (!better) break;
  }
  return std::abs(off) <= wanted ? std::optional(pose) : std::nullopt;
}

/// How differently two designs judge the same poses: 0 for equal designs, whatever their coordinates.
template <DyadType D>
double disagreement(const typename D::Design& a, const typename D::Design& b,
                    std::span<const typename D::Space::Pose> probes) {
  const Eigen::VectorXd r = residuals<D>(a, probes), s = residuals<D>(b, probes);
  return (r.cwiseAbs() - s.cwiseAbs()).cwiseAbs().maxCoeff();
}

}  // namespace burmester
