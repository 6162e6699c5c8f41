#include "burmester/modules/framework/condition.hpp"

#include <Eigen/SVD>

namespace burmester::detail {

double largest_change(const Eigen::MatrixXd& J, const Eigen::VectorXd& c) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  // Differences are good to about 1e-10: a smaller singular value may be 0.
  const Eigen::VectorXd stretch = svd.singularValues();
  if (!(stretch[J.cols() - 1] > 1e-10 * stretch[0])) return std::numeric_limits<double>::infinity();
  // |V x| = |x|: V can stay away
  const Eigen::MatrixXd spread = stretch.cwiseInverse().asDiagonal() * svd.matrixU().transpose() * c.asDiagonal();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(spread).singularValues()[0];
}

}  // namespace burmester::detail
