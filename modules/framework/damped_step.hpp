// The step of K. Levenberg (1944) and D. Marquardt (1963): the u of least |J u + r|^2 + damping |J|^2 |u|^2, with |J|
// the Frobenius norm. Apart from search.hpp, so that Eigen's decompositions are compiled once and not for each dyad
// type.
#pragma once

#include <Eigen/Core>

namespace burmester {

/// J P = Q R once: |J u + r|^2 is |R P^T u + along|^2 + a constant, so damping extends R alone.
class DampedStep {
 public:
  /// J: residuals x parameters, at least as many rows as columns, finite; r: the residuals.
  DampedStep(const Eigen::MatrixXd& J, const Eigen::VectorXd& r);

  /// Norm of the part of r that u could still take away, to first order.
  double removable() const { return along_.norm(); }

  /// u. Precondition: damping > 0.
  Eigen::VectorXd at(double damping) const;

 private:
  double size_;
  Eigen::MatrixXd triangle_;
  Eigen::VectorXd along_;
  Eigen::VectorXi order_;
};

}  // namespace burmester
