// How the processor rounds, seen from sums: CGAL sets the mode of the vector unit, which std::fegetround does not read.
#pragma once

namespace burmester {

enum class RoundingMode { nearest, upward, other };

inline RoundingMode rounding_mode() {
  volatile double one = 1, tiny = 0x1p-60;
  const double above = one + tiny, below = -one - tiny;
  if (above == 1 && below == -1) return RoundingMode::nearest;
  return above > 1 && below == -1 ? RoundingMode::upward : RoundingMode::other;
}

}  // namespace burmester
