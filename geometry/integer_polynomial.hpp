// Polynomials with integer coefficients: what exact root finding needs of them.
#pragma once

#include <span>
#include <vector>

#include "burmester/geometry/polynomial.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

using IntegerPolynomial = Polynomial<Integer>;

/// The positive multiple whose coefficients have no common factor.
IntegerPolynomial primitive_part(const IntegerPolynomial& p);
/// A positive multiple of p, primitive.
IntegerPolynomial integer_multiple(const Polynomial<Rational>& p);
/// A positive multiple (by a power of two) of the polynomial with these coefficients, constant term first, all finite.
IntegerPolynomial integer_multiple(std::span<const double> coefficients);

/// Primitive, leading coefficient positive; of degree 0 where the two have no common factor. Precondition: neither is
/// zero. First modulo a prime, which settles almost all pairs without a common factor; then by primitive remainders
/// (W. S. Brown, "The subresultant PRS algorithm", 1978).
IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// The square-free factors w[0], w[1], ..: w[m] vanishes exactly, and only simply, where p has a root of multiplicity
/// above m (D. R. Musser, "Algorithms for polynomial factorization", 1971). Precondition: degree at least 1.
std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& p);

/// 2^(n scale) p(at / 2^scale), n the degree.
Integer scaled_value(const IntegerPolynomial& p, const Integer& at, int scale);

}  // namespace burmester
