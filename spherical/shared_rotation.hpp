// Four orientations in two pairs that differ by one and the same rotation.
//
// R_j R_i^-1 = R_l R_k^-1, and then R_i^-1 R_k = R_j^-1 R_l. The axis of the first in S is the partner of a great
// circle of moving axes, that of the second in E has a great circle of partners, and the rest of the cone is a quadric
// (docs/curves.md). Most quaternions in doubles meet the equation to rounding only, small integers exactly.
#pragma once

#include <array>
#include <optional>

#include "burmester/spherical/pose.hpp"

namespace burmester::spherical {

struct SharedRotation {
  std::array<std::size_t, 4> poses;  ///< i, j, k, l, from 0
  double off = 0;                    ///< the angle by which the two rotations differ, as doubles tell it, radians
  bool exact = false;                ///< told over rationals: they are one, and off is 0

  /// The poses of the same equation that begins with another of them.
  std::array<std::size_t, 4> from(std::size_t pose) const;
};

/// One that is exact, or else the one with the least `off`. Nothing where the two rotations differ by more than
/// rounding the four does, 2^-48 rad, or where two orientations are within 2^-20 rad of each other: rounding means
/// something there.
std::optional<SharedRotation> shared_rotation(FourPoses poses);

}  // namespace burmester::spherical
