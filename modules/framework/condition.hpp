// The condition of a design: how far small errors of the poses move it.
//
// The residuals r_j(u, x_j) vanish (or their squares' sum is least) at u = 0. To first order a change of pose
// j by local coordinates v_j (lengths and radians, at its own origin) changes r_j by c_j |v_j| at most, with
// c_j = |dr_j / dv_j|, and the design by u = -J^+ dr, J = dr / du. So the largest |u| for pose errors with
// |v| = 1 in all is
//   condition = || J^+ diag(c_1, .., c_n) ||_2.
// |u| and |v| mix lengths and radians as they come, so the number depends on the unit of length. It is not
// certified, and for more poses than parameters it leaves out the part that grows with the residuals.
#pragma once

#include <limits>

#include "burmester/modules/framework/local.hpp"

namespace burmester {

namespace detail {

/// || J^+ diag(c) ||_2, infinite where the columns of J are dependent. J: poses x parameters, finite; c: how much each
/// residual changes with its pose, c_j >= 0.
double largest_change(const Eigen::MatrixXd& J, const Eigen::VectorXd& c);

}  // namespace detail

/// Change of the design's local coordinates per change of the poses; infinite where the poses do not
/// determine it. Precondition: at least D::parameters poses.
template <DyadType D>
double condition(const typename D::Design& design, std::span<const typename D::Space::Pose> poses) {
  const double step = step_for<typename D::Space>(poses);
  const Eigen::MatrixXd J = design_jacobian<D>(design, poses, step);
  if (!J.allFinite()) return std::numeric_limits<double>::infinity();
  Eigen::VectorXd c(J.rows());
  for (Eigen::Index j = 0; j < c.size(); ++j)
    c[j] = pose_gradient<D>(design, poses[static_cast<std::size_t>(j)], step).norm();
  return detail::largest_change(J, c);
}

}  // namespace burmester
