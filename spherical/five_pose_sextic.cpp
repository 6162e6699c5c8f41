#include "burmester/spherical/five_pose_sextic.hpp"

namespace burmester::spherical {

int reference_of(FivePoses poses) {
  int reference = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i)
    for (int j = i + 1; j < 5; ++j) {
      const Quaternion<double> p =
          relative_rotation<double>(poses[static_cast<std::size_t>(i)], poses[static_cast<std::size_t>(j)]);
      const double gap = p.tail<3>().norm() / p.norm();
      if (gap < least) least = gap, reference = i;
    }
  return reference;
}

}  // namespace burmester::spherical
