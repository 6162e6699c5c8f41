#include "burmester/geometry/error_free.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {
namespace {

/// A double with a random sign, 53 random bits and an exponent in [-range, range].
double random_double(Random& random, int range) {
  return std::ldexp(random.uniform(-2, 2), random.below(2 * range + 1) - range);
}

TEST(TwoProduct, IsExact) {
  Random random("TwoProduct.IsExact");
  for (int i = 0; i < 100000; ++i) {
    const double a = random_double(random, 200), b = random_double(random, 200);
    const TwoProduct p = two_product(a, b);
    EXPECT_EQ(p.high, a * b);
    EXPECT_EQ(Rational(p.high) + Rational(p.low), Rational(a) * Rational(b))
        << "case " << i << ": " << a << ' ' << b;
  }
}

TEST(TwoProduct, IsExactWithFullMantissas) {
  Random random("TwoProduct.IsExactWithFullMantissas");
  for (int i = 0; i < 1000; ++i) {
    const double a = 1 + (1 - 0x1p-52 * (1 + random.below(4))), b = random_double(random, 3);
    const TwoProduct p = two_product(a, b), q = two_product(a, a);
    EXPECT_EQ(Rational(p.high) + Rational(p.low), Rational(a) * Rational(b)) << a << ' ' << b;
    EXPECT_EQ(Rational(q.high) + Rational(q.low), Rational(a) * Rational(a)) << a;
  }
}

/// Error of difference_of_products in unit roundoffs of the result.
double error(double a, double b, double c, double d) {
  const Rational exact = Rational(a) * Rational(b) - Rational(c) * Rational(d);
  const double got = difference_of_products(a, b, c, d);
  if (exact == 0) return got == 0 ? 0 : std::numeric_limits<double>::infinity();
  return static_cast<double>(Rational(abs(Rational((Rational(got) - exact) / exact)))) / unit_roundoff;
}

// Without cancellation the result suffers the rounding of both products, of their tails and of three
// additions. With cancellation, high parts within a factor of two, the leading difference is exact.
constexpr double few = 4;

TEST(DifferenceOfProducts, IsAccurateForAnyNumbers) {
  Random random("DifferenceOfProducts.IsAccurateForAnyNumbers");
  for (int i = 0; i < 50000; ++i) {
    const double a = random_double(random, 100), b = random_double(random, 100);
    const double c = random_double(random, 100), d = random_double(random, 100);
    EXPECT_LE(error(a, b, c, d), few) << "case " << i << ": " << a << ' ' << b << ' ' << c << ' ' << d;
  }
}

TEST(DifferenceOfProducts, IsAccurateHoweverMuchCancels) {
  Random random("DifferenceOfProducts.IsAccurateHoweverMuchCancels");
  for (int i = 0; i < 50000; ++i) {
    const double a = random_double(random, 10), b = random_double(random, 10), c = random_double(random, 10);
    const double closeness = std::ldexp(random.normal(), -random.below(60));
    const double d = a * b / c * (1 + closeness);
    EXPECT_LE(error(a, b, c, d), few) << "case " << i << ": " << a << ' ' << b << ' ' << c << ' ' << d;
    EXPECT_LE(error(a, c, b, c), few);
  }
}

TEST(DifferenceOfProducts, IsZeroForProportionalPairs) {
  Random random("DifferenceOfProducts.IsZeroForProportionalPairs");
  for (int i = 0; i < 1000; ++i) {
    const double a = random_double(random, 20), b = random_double(random, 20);
    EXPECT_EQ(difference_of_products(a, b, b, a), 0);
    EXPECT_EQ(difference_of_products(a, 8 * b, 8 * a, b), 0);
  }
}

TEST(DifferenceOfProducts, IsTheFormulaOverExactNumbers) {
  const Rational a(1, 3), b(2, 5), c(-1, 7), d(3, 2);
  EXPECT_EQ(difference_of_products(a, b, c, d), a * b - c * d);
}

}  // namespace
}  // namespace burmester
