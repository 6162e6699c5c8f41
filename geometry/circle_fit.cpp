#include "burmester/geometry/circle_fit.hpp"

#include <Eigen/SVD>
#include <limits>

namespace burmester {

std::optional<FittedCircle> fit_circle(std::span<const Vector<double, 2>> points) {
  const Eigen::Index m = static_cast<Eigen::Index>(points.size());
  if (m < 3) return std::nullopt;
  Eigen::MatrixX4d rows(m, 4);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Vector<double, 2>& p = points[static_cast<std::size_t>(i)];
    rows.row(i) << p.squaredNorm(), 2 * p[0], 2 * p[1], 1;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  FittedCircle out;
  out.K = svd.matrixV().col(3);
  out.singular_values.setZero();
  out.singular_values.head(svd.singularValues().size()) = svd.singularValues();
  const auto& s = out.singular_values;
  const double rounding = static_cast<double>(m) * std::numeric_limits<double>::epsilon() * s[0];
  out.rank = static_cast<int>((s.array() > rounding).count());
  if (out.rank < 3) return std::nullopt;
  out.straight = std::abs(out.K[0]) <= (s[3] + rounding) / s[2];
  return out;
}

}  // namespace burmester
