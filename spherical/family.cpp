#include "burmester/spherical/family.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <numbers>

namespace burmester::spherical {

std::optional<Family::Design> Family::decode(const Vector<double, dimension>& k) {
  const Eigen::Matrix3d m{{k[0], k[1], k[2]}, {k[3], k[4], k[5]}, {k[6], k[7], k[8]}};
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double scale = svd.singularValues()[0], cosine = -k[9];
  if (!(scale > 0 && std::abs(cosine) <= scale)) return std::nullopt;
  const Axis b = svd.matrixU().col(0), a = svd.matrixV().col(0);
  const double sine = std::sqrt((scale - cosine) * (scale + cosine)), beyond = std::atan2(-cosine, sine);
  if (std::abs(beyond) <= slider_arc_tolerance) return PR::Design{b, a};
  return RR::Design{b, a, std::numbers::pi / 2 + beyond};
}

}  // namespace burmester::spherical
