#include "burmester/spherical/equal_angles.hpp"

#include <array>
#include <cassert>

namespace burmester::spherical {
namespace {

using ImagePoint = Space::Point<double>;

/// 2 sin(angle/4), angle up to half a turn. Of unit quaternions.
double distance(const ImagePoint& p, const ImagePoint& q) {
  return std::sqrt(std::min((p + q).squaredNorm(), (p - q).squaredNorm()));
}

}  // namespace

int reference_of(std::span<const Pose> poses) {
  assert(poses.size() >= 2 && poses.size() <= 5);
  std::array<ImagePoint, 5> unit;
  for (std::size_t i = 0; i < poses.size(); ++i) unit[i] = Space::point<double>(poses[i]).normalized();
  std::array<double, 5> sum{};
  std::size_t first = 0, second = 1;
  double least = 3;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      const double off = distance(unit[i], unit[j]);
      sum[i] += off, sum[j] += off;
      if (off < least) least = off, first = i, second = j;
    }
  return static_cast<int>(sum[first] <= sum[second] ? first : second);
}

}  // namespace burmester::spherical
