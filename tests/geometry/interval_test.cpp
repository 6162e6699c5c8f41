#include "burmester/geometry/interval.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/vector.hpp"
#include "rounding_mode.hpp"

namespace burmester {
namespace {

bool contains(const Interval& box, const Rational& x) {
  return Rational(box.inf()) <= x && x <= Rational(box.sup());
}

// Fails where the compiler folded the division or nothing switched the rounding mode.
TEST(Interval, OneThirdHasPositiveWidth) {
  const UpwardRounding upward;
  const Interval third = Interval(1) / Interval(3);
  EXPECT_LT(third.inf(), third.sup());
  EXPECT_EQ(third.sup(), std::nextafter(third.inf(), 1));
  EXPECT_TRUE(contains(third, Rational(1, 3)));
}

TEST(Interval, RoundingModeIsRestored) {
  ASSERT_EQ(rounding_mode(), RoundingMode::nearest);
  {
    const UpwardRounding upward;
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
    { const UpwardRounding inner; }
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
  }
  EXPECT_EQ(rounding_mode(), RoundingMode::nearest);
  EXPECT_THROW(
      {
        const UpwardRounding upward;
        throw 1;
      },
      int);
  EXPECT_EQ(rounding_mode(), RoundingMode::nearest);
}

TEST(Interval, DoublesArePoints) {
  Random random("Interval.DoublesArePoints");
  for (int i = 0; i < 100; ++i) {
    const double x = std::ldexp(random.normal(), random.below(1800) - 900);
    const UpwardRounding upward;
    EXPECT_EQ(Interval(x).inf(), x);
    EXPECT_EQ(Interval(x).sup(), x);
    EXPECT_EQ(approximate(Interval(x)), x);
  }
}

TEST(Interval, ApproximationIsAPointOfTheBox) {
  Random random("Interval.ApproximationIsAPointOfTheBox");
  for (int i = 0; i < 100; ++i) {
    const double x = random.normal(), width = std::ldexp(random.uniform(), -random.below(60));
    const UpwardRounding upward;
    const Interval box(x, x + width);
    EXPECT_GE(approximate(box), box.inf());
    EXPECT_LE(approximate(box), box.sup());
  }
}

TEST(Interval, ContainsTheExactValue) {
  Random random("Interval.ContainsTheExactValue");
  for (int i = 0; i < 1000; ++i) {
    const double a = random.normal(), b = random.normal(), c = a * (1 + 1e-14 * random.normal()),
                 d = random.normal();
    const Rational exact =
        (Rational(a) * Rational(b) - Rational(c) * Rational(b)) / Rational(d) + Rational(c);
    const UpwardRounding upward;
    const Interval box = (Interval(a) * Interval(b) - Interval(c) * Interval(b)) / Interval(d) + Interval(c);
    EXPECT_TRUE(contains(box, exact)) << "case " << i << ": " << a << ' ' << b << ' ' << c << ' ' << d;
  }
}

TEST(Interval, UndecidedComparisonsThrow) {
  const UpwardRounding upward;
  const Interval x(-1, 1);
  EXPECT_THROW((void)static_cast<bool>(x > 0), CGAL::Uncertain_conversion_exception);
  EXPECT_TRUE(static_cast<bool>(Interval(1, 2) > 0));
}

TEST(Interval, RunsInEigen) {
  const UpwardRounding upward;
  const Vector<Interval, 3> u{Interval(0.1), Interval(0.2), Interval(0.3)},
      v{Interval(3), Interval(-2), Interval(0.7)};
  const Rational exact = Rational(0.1) * 3 - Rational(0.2) * 2 + Rational(0.3) * Rational(0.7);
  EXPECT_TRUE(contains(u.dot(v), exact));
}

}  // namespace
}  // namespace burmester
