// Lines and conics that split off a plane curve, exactly.
//
// Coordinates in which the curve F of degree d meets the line at infinity in d complex points, none of them
// (0:1:0). phi(m) = F(1, m, 0), psi(m) the terms at z.
// - y = m x + b z is a component iff it is the asymptote in its direction, b = -psi(m) / phi'(m), and F vanishes on it:
//   polynomials in m with a common root. So all lines are found, rational or not.
// - A conic without real lines is a pair of complex conjugate ones (found like lines), or what rational lines leave of
//   a cubic, or has two asymptotes of F for its own and the same next term: a candidate for each two points
//   at infinity. If its coefficients are rational they are multiples of 1 / F(0, 1, 0) (C. F. Gauss), and
//   exact division decides. The roots stand in proved boxes; where these leave room for two multiples of
//   1 / F(0, 1, 0), which takes numerators of some 100 digits, the answer says that a conic may be missing.
// So all conics of curves of degree up to 3 are found, all pairs of lines, and of quartics to sextics the rational
// conics; not x^2 - z^2 = sqrt(2) y^2 and its conjugate.
#pragma once

#include <vector>

#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// Rational numbers as they are, irrational ones within 2^-100.
struct CurveFactors {
  std::vector<LinearForm<Rational>> lines;    ///< real
  std::vector<TernaryForm<Rational>> conics;  ///< real, irreducible over the reals
  bool proved = true;                         ///< false: a rational conic may be missing
};

/// Preconditions: square-free; coordinates as above. Needs GMP: nothing found without it.
CurveFactors lines_and_conics(const TernaryForm<Integer>& curve);

}  // namespace burmester
