// Four orientations in two pairs that differ by one and the same rotation.
//
// R_j R_i^-1 = R_l R_k^-1, and then R_i^-1 R_k = R_j^-1 R_l. The axis of the first in S is the partner of a great
// circle of moving axes, that of the second in E has a great circle of partners, and the rest of the cone is a quadric
// (docs/curves.md). Quaternions in doubles meet the equation to rounding only.
#pragma once

#include <array>
#include <optional>

#include "burmester/spherical/sliders.hpp"

namespace burmester::spherical {

struct SharedRotation {
  std::array<std::size_t, 4> poses;  ///< i, j, k, l, from 0
  double off = 0;                    ///< the angle by which the two rotations differ, radians

  /// The poses of the same equation that begins with another of them.
  std::array<std::size_t, 4> from(std::size_t pose) const;
};

/// Nothing where the two rotations differ by more than rounding the four does, 2^-48 rad, or where two orientations are
/// within 2^-20 rad of each other: rounding means something there.
std::optional<SharedRotation> shared_rotation(FourPoses poses);

}  // namespace burmester::spherical
