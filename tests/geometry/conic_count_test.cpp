// The counting theorem and what it stands on, over rationals: inertia, planted common points, boxes.
#include <gtest/gtest.h>

#include "burmester/geometry/conic_count.hpp"
#include "burmester/geometry/krawczyk.hpp"
#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational_interval.hpp"

namespace burmester {
namespace {

using Matrix3 = Matrix<Rational, 3, 3>;

Rational small(Random& random) { return Rational(random.below(19) - 9); }

Matrix3 random_matrix(Random& random) {
  for (;;) {
    Matrix3 m;
    for (int i = 0; i < 9; ++i) m(i) = small(random);
    const Rational det = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                         m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
    if (det != 0) return m;
  }
}

/// m^T diag m
Matrix3 congruent(const Matrix3& m, const std::array<Rational, 3>& diagonal) {
  Matrix3 out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      out(i, j) = 0;
      for (int k = 0; k < 3; ++k) out(i, j) += m(k, i) * diagonal[static_cast<std::size_t>(k)] * m(k, j);
    }
  return out;
}

int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

TEST(Inertia, IsThatOfEveryCongruentDiagonal) {
  Random random("Inertia.IsThatOfEveryCongruentDiagonal");
  for (int n = 0; n < 500; ++n) {
    const std::array<Rational, 3> d{small(random), small(random), n % 3 == 0 ? Rational(0) : small(random)};
    const auto got = inertia(congruent(random_matrix(random), d));
    ASSERT_TRUE(got);
    EXPECT_EQ(got->signature, sign(d[0]) + sign(d[1]) + sign(d[2])) << n;
    EXPECT_EQ(got->rank, (d[0] != 0) + (d[1] != 0) + (d[2] != 0)) << n;
  }
  Matrix3 zero_diagonal;
  zero_diagonal << 0, 1, 0, 1, 0, 0, 0, 0, 0;
  EXPECT_EQ(inertia(zero_diagonal)->rank, 2);
  EXPECT_EQ(inertia(zero_diagonal)->signature, 0);
}

Conic<Rational> conic_of(const Matrix3& m) {
  return Conic<Rational>(
      {m(0, 0), m(1, 1), m(2, 2), Rational(2 * m(1, 2)), Rational(2 * m(0, 2)), Rational(2 * m(0, 1))});
}

// A and B diagonal in the coordinates m: common points have squares (X, Y, Z) = a x b.
TEST(ConicCount, FourOrNoneByTheSignsOfTheSquares) {
  Random random("ConicCount.FourOrNoneByTheSignsOfTheSquares");
  int four = 0, none = 0;
  for (int n = 0; n < 1000; ++n) {
    std::array<Rational, 3> a, b;
    for (std::size_t i = 0; i < 3; ++i) a[i] = small(random), b[i] = small(random);
    const Rational x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    if (x == 0 || y == 0 || z == 0) continue;
    const int expected = sign(x) == sign(y) && sign(y) == sign(z) ? 4 : 0;
    const Matrix3 m = random_matrix(random);
    const auto count = count_common_points(conic_of(congruent(m, a)), conic_of(congruent(m, b)));
    if (!count) continue;  // the leading coefficient of the pencil's cubic happens to vanish
    EXPECT_EQ(*count, expected) << n;
    (expected == 4 ? four : none) += 1;
  }
  EXPECT_GT(four, 100);
  EXPECT_GT(none, 100);
}

TEST(ConicCount, TwoWhereACircleMeetsALinePairOnce) {
  // x^2 + y^2 = z^2 and (x - t z)(x - u z) = 0 with |t| < 1 < |u|
  const Conic<Rational> circle({Rational(1), Rational(1), Rational(-1), Rational(0), Rational(0), Rational(0)});
  for (int k = 1; k < 9; ++k) {
    const Rational t(k, 10), u(10 + k, 10);
    const Conic<Rational> lines(
        {Rational(1), Rational(0), Rational(t * u), Rational(0), Rational(-t - u), Rational(0)});
    EXPECT_EQ(count_common_points(circle, lines), 2) << k;
  }
}

TEST(ConicCount, NothingIsClaimedOfTangentOrEqualConics) {
  const Conic<Rational> circle({Rational(1), Rational(1), Rational(-1), Rational(0), Rational(0), Rational(0)});
  const Conic<Rational> tangent({Rational(1), Rational(2), Rational(-1), Rational(0), Rational(0), Rational(0)});
  EXPECT_EQ(count_common_points(circle, circle), std::nullopt);
  EXPECT_EQ(count_common_points(circle, tangent), std::nullopt);  // touch at (1, 0) and (-1, 0)
}

/// x^2 = 2, y = x^2 x / 2 over any interval type.
template <class I>
struct RootOfTwo {
  static constexpr int size = 2;
  Vector<I, 2> value(const Vector<I, 2>& x) const {
    return {I(x[0] * x[0] - I(2)), I(x[1] - x[0] * x[0] * x[0] / I(2))};
  }
  Matrix<I, 2, 2> jacobian(const Vector<I, 2>& x) const {
    Matrix<I, 2, 2> J;
    J(0, 0) = I(2) * x[0], J(0, 1) = I(0);
    J(1, 0) = -(I(3) * x[0] * x[0] / I(2)), J(1, 1) = I(1);
    return J;
  }
};

TEST(Krawczyk, EnclosesARootAndOnlyWhereThereIsOne) {
  const auto box = krawczyk<RationalInterval>(RootOfTwo<RationalInterval>{}, {1.41421356, 1.41421356});
  ASSERT_TRUE(box);
  const Rational low(box->centre[0] - box->radius[0]), high(box->centre[0] + box->radius[0]);
  EXPECT_LT(low * low, 2);
  EXPECT_GT(high * high, 2);
  EXPECT_LT(box->radius[0], 1e-8);
  EXPECT_FALSE(krawczyk<RationalInterval>(RootOfTwo<RationalInterval>{}, {0.1, 0.1}));
  EXPECT_FALSE(krawczyk<RationalInterval>(RootOfTwo<RationalInterval>{}, {0, 0}));
}

TEST(RationalInterval, ContainsWhatItsEndsDo) {
  Random random("RationalInterval.ContainsWhatItsEndsDo");
  for (int n = 0; n < 500; ++n) {
    const double a = random.normal(), b = a + random.uniform(), c = random.normal(), d = c + random.uniform();
    const RationalInterval x(a, b), y(c, d);
    for (const auto& [p, q] : {std::pair{a, c}, {a, d}, {b, c}, {b, d}}) {
      const Rational product = Rational(p) * Rational(q), difference = Rational(p) - Rational(q);
      EXPECT_TRUE((x * y).low() <= product && product <= (x * y).high());
      EXPECT_TRUE((x - y).low() <= difference && difference <= (x - y).high());
    }
    const RationalInterval third = RationalInterval(1) / RationalInterval(3);
    EXPECT_LT(Rational(lower(third)), Rational(1, 3));
    EXPECT_GT(Rational(upper(third)), Rational(1, 3));
  }
  const RationalInterval huge = RationalInterval(1e300) * RationalInterval(1e300);
  EXPECT_EQ(upper(huge), std::numeric_limits<double>::infinity());
  EXPECT_LT(lower(huge), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace burmester
