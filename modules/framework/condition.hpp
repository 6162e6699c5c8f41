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

#include <Eigen/SVD>
#include <limits>

#include "burmester/modules/framework/local.hpp"

namespace burmester {

/// Change of the design's local coordinates per change of the poses; infinite where the poses do not
/// determine it. Precondition: at least D::parameters poses.
template <DyadType D>
double condition(const typename D::Design& design, std::span<const typename D::Space::Pose> poses) {
  const double step = step_for<typename D::Space>(poses);
  const Eigen::MatrixXd J = design_jacobian<D>(design, poses, step);
  if (!J.allFinite()) return std::numeric_limits<double>::infinity();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  // Differences are good to about 1e-10: a smaller singular value may be 0.
  const Eigen::VectorXd stretch = svd.singularValues();
  if (!(stretch[D::parameters - 1] > 1e-10 * stretch[0])) return std::numeric_limits<double>::infinity();
  Eigen::MatrixXd spread = svd.matrixU().transpose();  // parameters x poses
  for (Eigen::Index j = 0; j < spread.cols(); ++j)
    spread.col(j) *= pose_gradient<D>(design, poses[static_cast<std::size_t>(j)], step).norm();
  spread = stretch.cwiseInverse().asDiagonal() * spread;  // |V x| = |x|: V can stay away
  return Eigen::JacobiSVD<Eigen::MatrixXd>(spread).singularValues()[0];
}

}  // namespace burmester
