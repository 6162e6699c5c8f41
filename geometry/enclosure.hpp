// Exact numbers as intervals of doubles. Only for targets that compile intervals.
#pragma once

#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/rational_interval.hpp"

namespace burmester {

/// The narrowest interval of doubles that holds x, or one step wider.
inline Interval enclosure(const Rational& x) {
  const RationalInterval point(x);
  return {lower(point), upper(point)};
}

}  // namespace burmester
