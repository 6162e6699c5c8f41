// Random fractions, for laws that hold without any rounding.
#pragma once

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

/// A fraction with a numerator up to 50 and a denominator up to 9.
inline Rational random_rational(Random& random) {
  const int numerator = random.below(101) - 50;
  return Rational(numerator, 1 + random.below(9));
}

template <int n>
Vector<Rational, n> random_rationals(Random& random) {
  Vector<Rational, n> out;
  for (int i = 0; i < n; ++i) out[i] = random_rational(random);
  return out;
}

}  // namespace burmester
