// Error-free transformations: products whose rounding error is not lost.
//
// Sources: T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18
// (1971); Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm", Math. Comp. 82 (2013).
// Precondition: compiled without contraction of a*b+c and without value-changing optimisation; the
// package's targets carry the flag. No product may over- or underflow.
#pragma once

#include "burmester/geometry/number.hpp"

namespace burmester {

struct TwoProduct {
  double high, low;  ///< high = fl(a b), high + low = a b exactly
};

inline TwoProduct two_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1: halves of 26 bits, whose products are exact
  const double sa = splitter * a, sb = splitter * b;
  const double ah = sa - (sa - a), bh = sb - (sb - b);
  const double al = a - ah, bl = b - bh;
  const double p = a * b;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

/// a b - c d. Over double with relative error at most a few units in the last place of the result, however
/// much cancels (the leading difference is exact by Sterbenz where it cancels); over other types as written.
template <class T>
T difference_of_products(const T& a, const T& b, const T& c, const T& d) {
  return a * b - c * d;
}
template <>
inline double difference_of_products(const double& a, const double& b, const double& c, const double& d) {
  const TwoProduct p = two_product(a, b), q = two_product(c, d);
  return (p.high - q.high) + (p.low - q.low);
}

}  // namespace burmester
