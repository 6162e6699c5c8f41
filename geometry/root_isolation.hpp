// Exact isolation and refinement of the roots of square-free integer polynomials, for real_roots.cpp.
#pragma once

#include <vector>

#include "burmester/geometry/real_roots.hpp"

namespace burmester::detail {

/// The real roots, ascending, each alone in its open interval and with values at the ends that are not 0, or a point.
/// Precondition: square-free, degree at least 1.
std::vector<DyadicInterval> isolate_roots(const IntegerPolynomial& p);

/// The one simple root of p in an interval, and how to come closer.
class Refinement {
 public:
  Refinement(const IntegerPolynomial& p, DyadicInterval box);
  const DyadicInterval& box() const { return box_; }
  /// At least halves the interval, or makes it a point. Precondition: it is not a point.
  void step();

 private:
  bool try_secant();

  const IntegerPolynomial& p_;
  DyadicInterval box_;
  Integer value_low_, value_high_;  // at the ends, scaled_value
  int bits_ = 1;                    // the next step divides by 2^bits
};

}  // namespace burmester::detail
