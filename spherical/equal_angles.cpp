#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {

int reference_of(std::span<const Pose> poses) {
  std::vector<double> sum(poses.size());
  std::size_t first = 0, second = 0;
  double least = 2;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      const double gap = Space::gap(Space::point<double>(poses[i]), Space::point<double>(poses[j]));
      sum[i] += gap, sum[j] += gap;
      if (gap < least) least = gap, first = i, second = j;
    }
  return static_cast<int>(sum[first] <= sum[second] ? first : second);
}

}  // namespace burmester::spherical
