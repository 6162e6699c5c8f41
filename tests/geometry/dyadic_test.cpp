#include "burmester/geometry/dyadic.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {
namespace {

Rational rational(const Dyadic& x) {
  const Rational m{Integer(x.mantissa())}, power(Integer(Integer(1) << std::abs(x.exponent())));
  return x.exponent() < 0 ? m / power : m * power;
}

/// Any finite double, subnormal ones too; every fourth a small integer.
double any_double(Random& random) {
  if (random.below(4) == 0) return random.below(9) - 4;
  return std::ldexp(random.normal(), random.below(2090) - 1072);
}

TEST(Dyadic, ReadsDoublesExactly) {
  const std::string stream = "Dyadic.ReadsDoublesExactly";
  Random random(stream);
  for (int i = 0; i < 2000; ++i) {
    const double x = any_double(random);
    EXPECT_EQ(rational(Dyadic(x)), Rational(x)) << stream << ", case " << i;
    EXPECT_EQ(static_cast<double>(Dyadic(x)), x) << stream << ", case " << i;
  }
  using Limits = std::numeric_limits<double>;
  for (const double x :
       {0.0, -0.0, Limits::denorm_min(), -Limits::min(), Limits::max(), Limits::lowest(), 0x1p1023})
    EXPECT_EQ(rational(Dyadic(x)), Rational(x)) << x;
  EXPECT_EQ(Dyadic(6.0).mantissa(), 3);
  EXPECT_EQ(Dyadic(6.0).exponent(), 1);
}

TEST(Dyadic, IsTheRingOfRationalsOnDoubles) {
  const std::string stream = "Dyadic.IsTheRingOfRationalsOnDoubles";
  Random random(stream);
  for (int i = 0; i < 1000; ++i) {
    const double a = any_double(random), b = any_double(random), c = any_double(random);
    const Dyadic x(a), y(b), z(c);
    const Rational p(a), q(b), r(c);
    EXPECT_EQ(rational(x + y), p + q) << stream << ", case " << i;
    EXPECT_EQ(rational(x - y), p - q) << stream << ", case " << i;
    EXPECT_EQ(rational(-x), -p) << stream << ", case " << i;
    EXPECT_EQ(rational(2 * x * y - z * z), 2 * p * q - r * r) << stream << ", case " << i;
    Dyadic w = x;
    w *= y, w -= z, w += x;
    EXPECT_EQ(rational(w), p * q - r + p) << stream << ", case " << i;
    EXPECT_TRUE(x * (y + z) == x * y + x * z) << stream << ", case " << i;
    EXPECT_TRUE(x - x == 0) << stream << ", case " << i;
    EXPECT_EQ(x == y, p == q) << stream << ", case " << i;
    EXPECT_EQ(known_sign(x * y - z), known_sign(Rational(p * q - r))) << stream << ", case " << i;
  }
}

TEST(Dyadic, ApproximatesItsValue) {
  const std::string stream = "Dyadic.ApproximatesItsValue";
  Random random(stream);
  for (int i = 0; i < 1000; ++i) {
    const double a = std::ldexp(random.normal(), random.below(600) - 300),
                 b = std::ldexp(random.normal(), -40);
    const Dyadic x = Dyadic(a) * Dyadic(b) * Dyadic(b) + Dyadic(b);
    const Rational exact = rational(x), error = abs(Rational(Rational(approximate(x)) - exact));
    EXPECT_LE(error, abs(exact) * Rational(0x1p-51)) << stream << ", case " << i;
  }
  const Dyadic huge(0x1p1000), tiny(0x1p-1000);
  EXPECT_EQ(approximate(huge * huge), std::numeric_limits<double>::infinity());
  EXPECT_EQ(approximate(-huge * huge), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(approximate(tiny * tiny), 0);
  EXPECT_EQ(approximate(huge * huge * tiny),
            0x1p1000);  // the mantissa alone would do, the exponent overflows first
}

}  // namespace
}  // namespace burmester
