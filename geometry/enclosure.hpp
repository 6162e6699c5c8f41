// Exact numbers as intervals of doubles. Only for targets that compile intervals.
#pragma once

#include "burmester/geometry/cubic.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/rational_interval.hpp"

namespace burmester {

/// The narrowest interval of doubles that holds x, or one step wider.
inline Interval enclosure(const RationalInterval& x) { return {lower(x), upper(x)}; }
inline Interval enclosure(const Rational& x) { return enclosure(RationalInterval(x)); }

inline Cubic<Interval> enclosure(const Cubic<Rational>& f) {
  Cubic<Interval> out;
  for (std::size_t k = 0; k < 10; ++k) out.c[k] = enclosure(f.c[k]);
  return out;
}

}  // namespace burmester
