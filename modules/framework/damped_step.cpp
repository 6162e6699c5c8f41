#include "burmester/modules/framework/damped_step.hpp"

#include <Eigen/QR>
#include <cmath>

namespace burmester {

DampedStep::DampedStep(const Eigen::MatrixXd& J, const Eigen::VectorXd& r) : size_(J.norm()) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J);
  triangle_ = qr.matrixQR().topRows(J.cols()).triangularView<Eigen::Upper>();
  along_ = (qr.householderQ().adjoint() * r).head(J.cols());
  order_ = qr.colsPermutation().indices();
}

Eigen::VectorXd DampedStep::at(double damping) const {
  const Eigen::Index p = along_.size();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * p, p);
  system.topRows(p) = triangle_;
  system.bottomRows(p).diagonal().setConstant(std::sqrt(damping) * size_);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(2 * p);
  wanted.head(p) = -along_;
  return Eigen::PermutationMatrix<Eigen::Dynamic>(order_) * system.colPivHouseholderQr().solve(wanted);
}

}  // namespace burmester
