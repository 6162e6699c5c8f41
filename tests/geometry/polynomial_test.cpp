#include "burmester/geometry/polynomial.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/integer_polynomial.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using P = Polynomial<Rational>;

P random_polynomial(Random& random) {
  std::vector<Rational> c;
  for (int k = random.below(7); k > 0; --k) c.push_back(random_rational(random));
  return P(c);
}

TEST(Polynomial, IsARingOfFunctions) {
  Random random("Polynomial.IsARingOfFunctions");
  for (int n = 0; n < 500; ++n) {
    const P p = random_polynomial(random), q = random_polynomial(random);
    const Rational x = random_rational(random), h = random_rational(random);
    EXPECT_EQ((p + q)(x), p(x) + q(x));
    EXPECT_EQ((p - q)(x), p(x) - q(x));
    EXPECT_EQ((p * q)(x), p(x) * q(x));
    EXPECT_EQ((p * h)(x), p(x) * h);
    EXPECT_EQ(p.shifted(h)(x), p(x + h));
    EXPECT_TRUE((p - p).is_zero());
    EXPECT_EQ((p * q).derivative(), p.derivative() * q + p * q.derivative());
    EXPECT_EQ((p * q).degree(), p.is_zero() || q.is_zero() ? -1 : p.degree() + q.degree());
  }
}

TEST(Polynomial, IsTrimmed) {
  EXPECT_EQ(Polynomial<double>({1, 2, 0, 0}).degree(), 1);
  EXPECT_EQ(Polynomial<double>({0, 0}).degree(), -1);
  EXPECT_EQ(Polynomial<double>({0, 1, 2}).reversed(), Polynomial<double>({2, 1}));
  EXPECT_EQ((Polynomial<double>({3, 1}) * 0.0).degree(), -1);
}

TEST(IntegerPolynomial, MultiplesArePositive) {
  Random random("IntegerPolynomial.MultiplesArePositive");
  for (int n = 0; n < 200; ++n) {
    const P p = random_polynomial(random);
    if (p.is_zero()) continue;
    const IntegerPolynomial i = integer_multiple(p);
    const Rational factor = Rational(i.leading()) / p.leading();
    EXPECT_GT(factor, 0);
    for (int k = 0; k <= p.degree(); ++k) EXPECT_EQ(p[k] * factor, Rational(i[k]));
    EXPECT_EQ(primitive_part(i * Integer(30)), i);
  }
}

TEST(IntegerPolynomial, ReadsDoublesExactly) {
  Random random("IntegerPolynomial.ReadsDoublesExactly");
  for (int n = 0; n < 200; ++n) {
    std::vector<double> c{std::ldexp(1.0, -1074), 0};
    for (int k = 0; k < 4; ++k) c.push_back(std::ldexp(random.normal(), random.below(2000) - 1000));
    const IntegerPolynomial i = integer_multiple(c);
    const Rational factor = Rational(i[0]) / Rational(c[0]);
    EXPECT_GT(factor, 0);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(Rational(c[static_cast<std::size_t>(k)]) * factor, Rational(i[k])) << n;
  }
}

TEST(IntegerPolynomial, CommonDivisorIsThePlantedOne) {
  Random random("IntegerPolynomial.CommonDivisorIsThePlantedOne");
  int planted = 0;
  for (int n = 0; n < 300; ++n) {
    const P a = random_polynomial(random), b = random_polynomial(random), g = random_polynomial(random);
    if (a.is_zero() || b.is_zero() || g.is_zero()) continue;
    const IntegerPolynomial found = common_divisor(integer_multiple(a * g), integer_multiple(b * g));
    // random factors may share more, which is then seen in a and b alone
    const IntegerPolynomial more = common_divisor(integer_multiple(a), integer_multiple(b));
    ASSERT_EQ(found.degree(), g.degree() + more.degree()) << n;
    EXPECT_EQ(common_divisor(found, integer_multiple(g)).degree(), g.degree()) << n;
    planted += g.degree() > 0;
  }
  EXPECT_GT(planted, 100);
}

TEST(IntegerPolynomial, ModularShortcutIsNotFooledByMultiplesOfItsPrime) {
  const Integer prime = 0x7fffffff;
  const IntegerPolynomial root({Integer(1), prime});  // 1 + prime x: a constant modulo the prime
  EXPECT_EQ(common_divisor(root * IntegerPolynomial({2, 1}), root * IntegerPolynomial({3, 1})), root);
}

TEST(IntegerPolynomial, SquareFreeFactorsCountMultiplicities) {
  const IntegerPolynomial a({-1, 1}), b({-2, 0, 1}), c({3, 5});
  const auto factors = square_free_factors(a * a * a * b * b * c * Integer(6));
  ASSERT_EQ(factors.size(), 3u);
  EXPECT_EQ(factors[0], a * b * c);
  EXPECT_EQ(factors[1], a * b);
  EXPECT_EQ(factors[2], a);
}

}  // namespace
}  // namespace burmester
