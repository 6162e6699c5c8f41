#include "burmester/planar/motion_rank.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <vector>

#include "burmester/planar/family.hpp"

namespace burmester::planar {
namespace {

/// From the centroid, in units of the largest distance from it, rotations of norm 1.
std::vector<Pose> normalised(std::span<const Pose> poses) {
  Vector2 centre(0, 0);
  for (const Pose& p : poses) centre += Vector2(p.x - poses[0].x, p.y - poses[0].y) / static_cast<double>(poses.size());
  std::vector<Pose> out;
  double unit = 0;
  for (const Pose& p : poses) {
    const double n = std::hypot(p.X3, p.X4);
    out.push_back({p.x - poses[0].x - centre[0], p.y - poses[0].y - centre[1], p.X3 / n, p.X4 / n});
    unit = std::max(unit, std::hypot(out.back().x, out.back().y));
  }
  if (unit > 0)
    for (Pose& p : out) p.x /= unit, p.y /= unit;
  return out;
}

}  // namespace

MotionRank motion_rank(std::span<const Pose> poses, double errors) {
  MotionRank out;
  out.singular_values.setZero();
  if (poses.empty()) return out;
  const std::vector<Pose> near_one = normalised(poses);
  const Eigen::Index m = static_cast<Eigen::Index>(poses.size());
  Eigen::MatrixXd rows(m, 8);
  for (Eigen::Index i = 0; i < m; ++i) rows.row(i) = Family::row<double>(near_one[static_cast<std::size_t>(i)]);
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues();
  out.singular_values.head(s.size()) = s;
  // A row, |t| <= 1, moves by at most sqrt(2^2 + 2^2 + 4^2 + 2^2) < 6 times a shift and turn of its pose.
  const double size = static_cast<double>(m);
  const double zero = size * std::numeric_limits<double>::epsilon() * s[0] + 6 * errors * std::sqrt(size);
  out.rank = static_cast<int>((s.array() > zero).count());
  return out;
}

}  // namespace burmester::planar
