// Polynomials with integer coefficients and their real roots, by CGAL's univariate algebraic kernel: what the
// exact curve analysis shares. Only for .cpp files of geometry/ (CGAL is linked to no other room); empty without GMP.
#pragma once

#ifndef BURMESTER_WITHOUT_GMP

#ifndef CGAL_USE_MPFI
#define CGAL_USE_MPFI 1
#endif
#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/GMP_arithmetic_kernel.h>
#include <CGAL/Gmpz.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "burmester/geometry/integer_polynomial.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester::exact_curve {

using RootKernel = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using CgalPolynomial = RootKernel::Polynomial_1;
using Root = RootKernel::Algebraic_real_1;

constexpr int approximation_bits = 100;  ///< of irrational numbers on their way to doubles

inline Integer from_cgal(const CGAL::Gmpz& x) { return Integer(x.mpz()); }
inline Rational from_cgal(const CGAL::Gmpq& x) { return Rational(x.mpq()); }
inline CGAL::Gmpz to_cgal(const Integer& x) { return CGAL::Gmpz(x.backend().data()); }

/// The multiple whose coefficients are integers without a common factor. Precondition: not zero.
inline TernaryForm<Integer> integer_form(const TernaryForm<Rational>& f) {
  TernaryForm<Integer> out(f.degree);
  const IntegerPolynomial multiple =
      integer_multiple(Polynomial<Rational>(std::vector<Rational>(f.coefficients.begin(), f.coefficients.end())));
  std::copy(multiple.coefficients().begin(), multiple.coefficients().end(), out.coefficients.begin());
  return out;
}

/// The polynomial in m that stands at s^a z^b in F(1, m + s, z): derivatives of F at infinity, divided by factorials.
inline CgalPolynomial at_infinity(const TernaryForm<Integer>& f, int a, int b) {
  std::vector<CGAL::Gmpz> c{0};
  Integer binomial = 1;  // j over a
  for (int j = a; j + b <= f.degree; ++j) {
    c.resize(static_cast<std::size_t>(j - a + 1));
    c.back() = to_cgal(binomial * f(f.degree - b - j, j));
    binomial = binomial * (j + 1) / (j + 1 - a);
  }
  return CgalPolynomial(c.begin(), c.end());
}

/// Distinct real roots, ascending.
inline std::vector<Root> cgal_roots(const CgalPolynomial& p) {
  std::vector<Root> out;
  if (p.degree() > 0) RootKernel().solve_1_object()(p, false, std::back_inserter(out));
  return out;
}

inline Integer nearest_integer(const Rational& x) {
  const Rational up = x + Rational(1, 2);
  const Integer truncated = numerator(up) / denominator(up);
  return up < truncated ? Integer(truncated - 1) : truncated;
}

/// The root itself where it is rational (a multiple of 1 / leading coefficient then), else within
/// 2^-approximation_bits.
inline Rational rational_value(const Root& root) {
  const Integer leading = abs(from_cgal(RootKernel().compute_polynomial_1_object()(root).lcoeff()));
  const int bits = approximation_bits + static_cast<int>(boost::multiprecision::msb(leading));
  const auto [low, high] = RootKernel().approximate_absolute_1_object()(root, bits);
  const Rational middle = (from_cgal(low) + from_cgal(high)) / 2;
  const CGAL::Gmpq candidate(to_cgal(nearest_integer(middle * leading)), to_cgal(leading));
  return RootKernel().compare_1_object()(root, candidate) == CGAL::EQUAL ? from_cgal(candidate) : middle;
}

inline Rational value(const CgalPolynomial& p, const Rational& x) {
  Rational out = 0;
  for (int i = p.degree(); i >= 0; --i) out = out * x + from_cgal(p[i]);
  return out;
}

}  // namespace burmester::exact_curve

#endif
