// The real roots of a polynomial in one variable, each proved: how many, which multiplicities,
// boxes as narrow as asked.
//
// First in intervals of doubles (simple_roots.hpp), which settles polynomials whose roots are simple and not too close;
// else exactly: square-free factors of a primitive integer polynomial, isolation by Descartes' rule on dyadic intervals
// (G. E. Collins and A. G. Akritas, "Polynomial real root isolation using Descartes' rule of signs", SYMSAC 1976),
// refinement by the secant with steps that grow quadratically (J. Abbott, "Quadratic interval refinement for real
// roots", ACM Comm. Computer Algebra 48 (2014)).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "burmester/geometry/integer_polynomial.hpp"
#include "burmester/geometry/polynomial.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

/// low / 2^scale <= x <= (low + width) / 2^scale, scale >= 0. A point where width = 0.
struct DyadicInterval {
  Integer low, width;
  int scale = 0;
};

/// A real algebraic number. A value: copies share only what never changes, so threads may work on copies.
class RealRoot {
 public:
  /// The one root of `factor` in the closed box; it must be simple (not so for a root known as a point).
  RealRoot(std::shared_ptr<const IntegerPolynomial> factor, const Range& box);
  RealRoot(std::shared_ptr<const IntegerPolynomial> factor, DyadicInterval box, int multiplicity);

  int multiplicity() const { return multiplicity_; }
  /// What proved existence and multiplicity: intervals or exact.
  Rung rung() const { return rung_; }
  /// The box in doubles, ends rounded outward. About 1e-15 wide, relative to the root, unless the coefficients are such
  /// that intervals of doubles cannot do better.
  Range enclosure() const { return enclosure_; }
  /// A finite double in the enclosure; the root itself where that is a double and is_point().
  double approximate() const;
  /// The box itself: no other root is in it, and those of different roots have at most end points in common.
  RationalInterval bounds() const;
  /// Whether the root is known to be a rational number, both ends of the box.
  bool is_point() const;
  /// Narrows the box to this width at most, absolute. Throws std::invalid_argument unless width > 0 and finite.
  void refine(const Rational& width);
  void refine(double width);
  /// Narrows the box to the square of its width, and to a sixteenth of it at least: for loops that end once it is
  /// narrow enough. Precondition: not is_point().
  void refine();

 private:
  friend int sign_at(const Polynomial<Rational>& p, RealRoot& root);
  template <class Done>
  void narrow(Done done);
  bool is_root_of(const IntegerPolynomial& p) const;

  std::shared_ptr<const IntegerPolynomial> factor_;
  std::optional<DyadicInterval> box_;  ///< without it the enclosure is the box
  Range enclosure_;
  int multiplicity_ = 1;
  Rung rung_ = Rung::none;
};

/// The different real roots, ascending. Coefficients constant term first; trailing zeros are allowed. Throws
/// std::invalid_argument for the zero polynomial and for coefficients that are not finite.
std::vector<RealRoot> real_roots(std::span<const double> coefficients);
std::vector<RealRoot> real_roots(const Polynomial<Rational>& p);
/// Without the attempt in doubles.
std::vector<RealRoot> real_roots_exactly(const Polynomial<Rational>& p);

/// Sign of p at the root: by its box, narrowed as far as needed; zero by a common divisor.
int sign_at(const Polynomial<Rational>& p, RealRoot& root);

}  // namespace burmester
