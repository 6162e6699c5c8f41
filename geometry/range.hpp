// Ranges of doubles read off intervals of any type (those with lower() and upper()).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace burmester {

/// low <= x <= high; the ends may be infinite.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

template <class Interval>
Range range_of(const Interval& x) {
  return {lower(x), upper(x)};
}

/// Also where an end is not a number.
template <class Interval>
bool contains_zero(const Interval& x) {
  return !(lower(x) > 0) && !(upper(x) < 0);
}

/// Upper bound of |x|; infinite where an end is not a number.
template <class Interval>
double magnitude(const Interval& x) {
  const double a = std::abs(lower(x)), b = std::abs(upper(x));
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

/// Square roots of a range of squares, the ends moved outward by one step.
inline Range root_of(const Range& square) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double low = std::sqrt(std::max(0.0, square.low)), high = std::sqrt(square.high);
  return {std::max(0.0, std::nextafter(low, -infinity)), std::nextafter(high, infinity)};
}

}  // namespace burmester
