#include "burmester/geometry/rational.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/random.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

TEST(Rational, ReadsDoublesExactly) {
  Random random("Rational.ReadsDoublesExactly");
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(random.normal(), random.below(1800) - 900);
    const Rational q(x);
    EXPECT_EQ(static_cast<double>(q), x);
    EXPECT_EQ(approximate(q), x);
    EXPECT_EQ(Integer(denominator(q)) & (Integer(denominator(q)) - 1), 0) << x;  // a power of two
  }
}

TEST(Rational, HasNoExpressionTemplates) {
  const Rational a(1, 3), b(1, 6);
  static_assert(std::is_same_v<decltype(a + b), Rational>);
  static_assert(std::is_same_v<decltype(Integer(1) * Integer(2)), Integer>);
  EXPECT_EQ(a + b, Rational(1, 2));
}

TEST(Rational, RunsInEigen) {
  const Vector<Rational, 3> u{Rational(1, 3), Rational(2), Rational(-1)},
      v{Rational(3), Rational(1, 4), Rational(3, 2)};
  EXPECT_EQ(u.dot(v), 0);
  EXPECT_EQ(u.cross(v).dot(u), 0);
}

}  // namespace burmester
