#include "burmester/geometry/signs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/sign.hpp"
#include "near_degenerate.hpp"
#include "polynomials.hpp"
#include "rounding_mode.hpp"

namespace burmester {

// Shown by GoogleTest where a sign is not the expected one.
void PrintTo(const Sign& s, std::ostream* out) {
  *out << s.sign << " by "
       << std::array{"none", "doubles", "intervals", "exact"}[static_cast<std::size_t>(s.decided_by)];
}

namespace {

using Point = Vector<double, 2>;
using Point3 = Vector<double, 3>;

constexpr Sign by_doubles(int sign) { return {sign, Rung::doubles}; }
constexpr Sign by_intervals(int sign) { return {sign, Rung::intervals}; }
constexpr Sign by_exact(int sign) { return {sign, Rung::exact}; }

double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

// ---- Against rationals, for each polynomial ----

template <class F>
class EveryPolynomial : public testing::Test {
 protected:
  using Arguments = decltype(near_degenerate(F(), std::declval<Random&>()));

  std::string stream() const {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return std::string(test->test_suite_name()) + '.' + test->name();
  }
  /// Returns the rung that decided.
  Rung expect_exact(const Arguments& x, const std::string& which) {
    const Sign sign = exact_sign<F>(x);
    EXPECT_EQ(sign.sign, *known_sign(evaluate<F, Rational>(x))) << stream() << ", case " << which;
    return sign.decided_by;
  }
};
TYPED_TEST_SUITE(EveryPolynomial, Polynomials<>);

TYPED_TEST(EveryPolynomial, IsExactOnRandomArguments) {
  Random random(this->stream());
  int by_first_rung = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto x = random_arguments<std::tuple_size_v<typename TestFixture::Arguments>>(random);
    by_first_rung += this->expect_exact(x, std::to_string(i)) == Rung::doubles;
  }
  EXPECT_GE(by_first_rung, 1495);
}

TYPED_TEST(EveryPolynomial, IsExactNearDegeneracies) {
  Random random(this->stream());
  int by_last_rung = 0;
  for (int i = 0; i < 1500; ++i)
    by_last_rung +=
        this->expect_exact(near_degenerate(TypeParam(), random), std::to_string(i)) == Rung::exact;
  EXPECT_GE(by_last_rung, 750);
}

// Each argument of another size, so that products over- and underflow.
TYPED_TEST(EveryPolynomial, IsExactWhereDoublesOverflowAndUnderflow) {
  Random random(this->stream());
  for (int i = 0; i < 300; ++i) {
    auto x = random_arguments<std::tuple_size_v<typename TestFixture::Arguments>>(random);
    for (double& a : x) a = std::ldexp(a, random.below(2040) - 1050);
    this->expect_exact(x, std::to_string(i));
  }
  for (const int exponent : {-1074, -1060, -800, -540, -500, -260, 250, 500, 900, 1015})
    for (int i = 0; i < 30; ++i) {
      auto x = near_degenerate(TypeParam(), random);
      for (double& a : x) a = std::ldexp(a, exponent);
      this->expect_exact(x, std::to_string(i) + " times 2^" + std::to_string(exponent));
    }
}

TYPED_TEST(EveryPolynomial, SaysNothingOfWhatIsNotFinite) {
  Random random(this->stream());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto x = random_arguments<std::tuple_size_v<typename TestFixture::Arguments>>(random);
    x[x.size() / 2] = bad;
    EXPECT_EQ(exact_sign<TypeParam>(x), (Sign{0, Rung::none}));
  }
}

TYPED_TEST(EveryPolynomial, LeavesTheRoundingModeAlone) {
  Random random(this->stream());
  for (int i = 0; i < 100; ++i) {
    exact_sign<TypeParam>(near_degenerate(TypeParam(), random));
    ASSERT_EQ(rounding_mode(), RoundingMode::nearest) << this->stream() << ", case " << i;
  }
}

TYPED_TEST(EveryPolynomial, AgreesBetweenThreads) {
  const auto signs = [stream = this->stream()] {
    Random random(stream);
    std::vector<Sign> out;
    for (int i = 0; i < 1000; ++i) {
      const auto x = near_degenerate(TypeParam(), random);
      out.push_back(exact_sign<TypeParam>(x));
    }
    return out;
  };
  std::vector<Sign> first, second;
  std::thread one([&] { first = signs(); }), two([&] { second = signs(); });
  one.join();
  two.join();
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, signs());
}

// Sums of products that each lose up to half of the smallest double: without eta in the bound some signs are wrong.
TEST(Signs, CountsWhatProductsLoseInUnderflow) {
  const std::string stream = "Signs.CountsWhatProductsLoseInUnderflow";
  Random random(stream);
  int zeros_of_doubles = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 9> m{1, 1, 1};
    for (std::size_t k = 3; k < 9; ++k) m[k] = random.uniform(-2, 2) * 0x1p-537;
    const int exact = *known_sign(evaluate<Determinant<3>, Rational>(m));
    zeros_of_doubles += determinant3(m) == 0;
    ASSERT_EQ(exact_sign<Determinant<3>>(m).sign, exact) << stream << ", case " << i;
  }
  EXPECT_GT(zeros_of_doubles, 1000);
}

// ---- Known cases, and the rung that decides them ----

template <int n>
Matrix<double, n, n> matrix(std::initializer_list<double> rows) {
  Matrix<double, n, n> m;
  auto entry = rows.begin();
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) m(r, c) = *entry++;
  return m;
}

TEST(DeterminantSign, OfRegularMatrices) {
  EXPECT_EQ(determinant_sign(matrix<2>({1, 2, 3, 4})), by_doubles(-1));
  EXPECT_EQ(determinant_sign(matrix<3>({2, 0, 1, 0, 3, 1, 1, 1, 4})), by_doubles(1));
  EXPECT_EQ(determinant_sign(matrix<4>({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})), by_doubles(-1));
}

TEST(DeterminantSign, OfSingularIntegerMatricesScaledByPowersOfTwo) {
  for (const double scale : {1.0, 0x1p-100, 0x1p200}) {
    EXPECT_EQ(determinant_sign(scale * matrix<2>({6, 4, 9, 6})), by_intervals(0));
    EXPECT_EQ(determinant_sign(scale * matrix<3>({1, 2, 3, 4, 5, 6, 7, 8, 9})), by_intervals(0));
    EXPECT_EQ(determinant_sign(scale * matrix<4>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16})),
              by_intervals(0));
  }
}

TEST(DeterminantSign, OfSingularMatricesWhoseProductsRound) {
  const double a = 0x1p52 + 1, b = 0x1p51 + 3, c = 0x1p50 + 7;
  EXPECT_EQ(determinant_sign(matrix<2>({a, b, 2 * a, 2 * b})), by_exact(0));
  EXPECT_EQ(determinant_sign(matrix<3>({a, b, c, c, a, b, a + c, a + b, b + c})), by_exact(0));
  EXPECT_EQ(determinant_sign(matrix<4>({a, b, c, 1, c, a, b, 2, b, c, a, 3, 2 * a, 2 * b, 2 * c, 2})),
            by_exact(0));
}

// a (b +- ulp) - b a
TEST(DeterminantSign, OfSingularMatricesMovedByOneUlp) {
  EXPECT_EQ(determinant_sign(matrix<2>({3, 0.1, 3, above(0.1)})), by_exact(1));
  EXPECT_EQ(determinant_sign(matrix<2>({3, 0.1, 3, below(0.1)})), by_exact(-1));
  EXPECT_EQ(determinant_sign(matrix<3>({1, 2, 3, 4, 5, 6, 7, 8, above(9)})), by_exact(-1));
  EXPECT_EQ(determinant_sign(matrix<3>({1, 2, 3, 4, 5, 6, 7, 8, below(9)})), by_exact(1));
}

// 2^26 + 1 times 2^26 - 1 is one less than 2^52: every product is a double, but the bound cannot know.
TEST(DeterminantSign, IsDecidedByIntervalsWhereNothingIsRounded) {
  EXPECT_EQ(determinant_sign(matrix<2>({0x1p26 + 1, 0x1p26, 0x1p26, 0x1p26 - 1})), by_intervals(-1));
}

TEST(DeterminantSign, AtTheEndsOfTheDoubles) {
  const double big = std::numeric_limits<double>::max(), small = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(determinant_sign(matrix<2>({big, big, big, big})), by_exact(0));
  EXPECT_EQ(determinant_sign(matrix<2>({big, big, big, below(big)})), by_exact(-1));
  EXPECT_EQ(determinant_sign(matrix<2>({small, 2 * small, small, 3 * small})), by_exact(1));
  EXPECT_EQ(determinant_sign(matrix<2>({small, 2 * small, 2 * small, 4 * small})), by_exact(0));
  EXPECT_EQ(determinant_sign(matrix<2>({big, small, 1, 0})), by_intervals(-1));
}

TEST(DeterminantSign, TurnsWithARowExchanged) {
  const std::string stream = "DeterminantSign.TurnsWithARowExchanged";
  Random random(stream);
  for (int i = 0; i < 500; ++i) {
    const auto x = i % 2 ? near_singular<4>(random) : random_arguments<16>(random);
    Matrix<double, 4, 4> m = Eigen::Map<const Eigen::Matrix4d>(x.data());
    const int sign = determinant_sign(m).sign;
    EXPECT_EQ(determinant_sign(m.transpose()).sign, sign) << stream << ", case " << i;
    m.row(i % 3).swap(m.row(3));
    EXPECT_EQ(determinant_sign(m).sign, -sign) << stream << ", case " << i;
    m.row(1) = m.row(2);
    EXPECT_EQ(determinant_sign(m).sign, 0) << stream << ", case " << i;
  }
}

TEST(Orientation, OfThePlane) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), by_doubles(1));
  EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), by_doubles(-1));
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, 24}), by_intervals(0));
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, above(24)}), by_exact(1));
}

// The classical trap of plain doubles (Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of
// robustness problems in geometric computations", Comput. Geom. 40 (2008)): points an ulp apart beside the
// line through two others.
TEST(Orientation, OfTheClassroomExample) {
  const double ulp = 0x1p-53;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const int truth = j > i ? 1 : j < i ? -1 : 0;
      EXPECT_EQ(orientation({0.5 + i * ulp, 0.5 + j * ulp}, {12, 12}, {24, 24}).sign, truth) << i << ' ' << j;
    }
}

TEST(Orientation, FarFromTheOriginIsDecidedAsNearIt) {
  const Point far(0x1p50, -0x1p50);
  EXPECT_EQ(orientation(far, far + Point(3, 1), far + Point(6, 3)), by_doubles(1));
  EXPECT_EQ(orientation(far, far + Point(3, 1), far + Point(6, 2)), by_intervals(0));
  EXPECT_EQ(orientation(far, far + Point(3, 1), far + Point(9, 2)), by_doubles(-1));
}

TEST(Orientation, OfSpace) {
  EXPECT_EQ(orientation(Point3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), by_doubles(1));
  EXPECT_EQ(orientation(Point3(0, 0, 0), {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), by_doubles(-1));
  const Point3 far(0x1p40, 0x1p41, -0x1p40);
  const Point3 a = far + Point3(1, 2, 3), b = far + Point3(4, -5, 6), c = far + Point3(7, 8, -9);
  EXPECT_EQ(orientation(far, a, b, a + b - far), by_intervals(0));
  EXPECT_EQ(orientation(far, a, b, c), by_doubles(1));
  EXPECT_EQ(orientation(Point3(0.1, 0.1, 0.1), {1, 1, 1}, {2, 2, 2}, {1, 2, 3}), by_exact(0));
}

TEST(Orientation, IsAlternating) {
  const std::string stream = "Orientation.IsAlternating";
  Random random(stream);
  for (int i = 0; i < 500; ++i) {
    const auto x = near_degenerate(Orientation2(), random);
    const Point a(x[0], x[1]), b(x[2], x[3]), c(x[4], x[5]);
    const int sign = orientation(a, b, c).sign;
    EXPECT_EQ(orientation(b, c, a).sign, sign) << stream << ", case " << i;
    EXPECT_EQ(orientation(b, a, c).sign, -sign) << stream << ", case " << i;
    const auto y = near_degenerate(Orientation3(), random);
    std::array<Point3, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = Point3(y[3 * k], y[3 * k + 1], y[3 * k + 2]);
    const int volume = orientation(p[0], p[1], p[2], p[3]).sign;
    EXPECT_EQ(orientation(p[1], p[0], p[2], p[3]).sign, -volume) << stream << ", case " << i;
    EXPECT_EQ(orientation(p[0], p[3], p[2], p[1]).sign, -volume) << stream << ", case " << i;
  }
}

// Eight integer points of the circle x^2 + y^2 = 65.
TEST(InCircleSign, OfIntegerPointsFarFromTheOrigin) {
  const Point centre(0x1p45, 0x1p44);
  const Point a = centre + Point(8, 1), b = centre + Point(-4, 7), c = centre + Point(-1, -8);
  EXPECT_EQ(in_circle(a, b, c, centre + Point(7, -4)), by_intervals(0));
  EXPECT_EQ(in_circle(a, b, c, centre + Point(7, -3)), by_doubles(1));
  EXPECT_EQ(in_circle(a, b, c, centre + Point(7, -5)), by_doubles(-1));
  EXPECT_EQ(in_circle(a, c, b, centre + Point(7, -3)), by_doubles(-1));
}

TEST(InCircleSign, OfPointsMovedByOneUlp) {
  const Point a(8, 1), b(-4, 7), c(-1, -8);
  EXPECT_EQ(in_circle(a, b, c, {7, below(-4)}), by_exact(-1));
  EXPECT_EQ(in_circle(a, b, c, {7, above(-4)}), by_exact(1));
}

TEST(InCircleSign, IsAlternating) {
  const std::string stream = "InCircleSign.IsAlternating";
  Random random(stream);
  for (int i = 0; i < 500; ++i) {
    const auto x = near_degenerate(InCircle(), random);
    const Point a(x[0], x[1]), b(x[2], x[3]), c(x[4], x[5]), d(x[6], x[7]);
    const int sign = in_circle(a, b, c, d).sign;
    EXPECT_EQ(in_circle(b, a, c, d).sign, -sign) << stream << ", case " << i;
    EXPECT_EQ(in_circle(a, b, d, c).sign, -sign) << stream << ", case " << i;
    EXPECT_EQ(in_circle(d, b, c, a).sign, -sign) << stream << ", case " << i;
  }
}

// Links of 5 and 10: they reach from 5 to 15.
TEST(DyadClosureSign, AtAndBesideTheDeadCentres) {
  const Point a(0, 0), b(3, 4), c(9, 12);
  EXPECT_EQ(dyad_closure(a, b, c, a), by_intervals(0));  // stretched as it stands
  EXPECT_EQ(dyad_closure(a, b, c, c + Point(0, 15)), by_intervals(0));
  EXPECT_EQ(dyad_closure(a, b, c, c + Point(-5, 0)), by_intervals(0));  // folded
  EXPECT_EQ(dyad_closure(a, b, c, c + Point(0, 10)), by_doubles(1));
  EXPECT_EQ(dyad_closure(a, b, c, c + Point(0, 16)), by_doubles(-1));
  EXPECT_EQ(dyad_closure(a, b, c, c + Point(4, 0)), by_doubles(-1));
  EXPECT_EQ(dyad_closure(a, b, Point(3, 14), Point(3, above(29))), by_intervals(-1));
  EXPECT_EQ(dyad_closure(a, b, Point(3, 14), Point(3, below(29))), by_intervals(1));
  const double s = 0x1p45 + 1;  // squares that doubles do not hold
  EXPECT_EQ(dyad_closure(s * a, s * b, s * c, s * (c + Point(0, 15))), by_exact(0));
  EXPECT_EQ(dyad_closure(s * a, s * b, s * c, Point(9 * s, above(27 * s))), by_exact(-1));
}

TEST(DyadClosureSign, FarFromTheOriginIsDecidedAsNearIt) {
  const Point far(-0x1p46, 0x1p47);
  EXPECT_EQ(dyad_closure(far, far + Point(3, 4), far + Point(9, 12), far), by_intervals(0));
  EXPECT_EQ(dyad_closure(far, far + Point(3, 4), far + Point(9, 12), far + Point(1, 0)), by_doubles(1));
  EXPECT_EQ(dyad_closure(far, far + Point(3, 4), far + Point(9, 12), far + Point(-1, 0)), by_doubles(-1));
}

// In its own position a dyad closes: the sign is never negative, and zero only if a, b, c lie on a line.
TEST(DyadClosureSign, IsThatOfTheTriangleWhereNothingMoved) {
  const std::string stream = "DyadClosureSign.IsThatOfTheTriangleWhereNothingMoved";
  Random random(stream);
  for (int i = 0; i < 500; ++i) {
    const auto x = near_degenerate(Orientation2(), random);
    const Point a(x[0], x[1]), b(x[2], x[3]), c(x[4], x[5]);
    EXPECT_EQ(dyad_closure(a, b, c, a).sign, std::abs(orientation(a, b, c).sign)) << stream << ", case " << i;
    const auto y = near_degenerate(DyadClosure(), random);
    const Point d(y[6], y[7]);
    const auto flipped = [](const Point& p) { return Point(-p[1], p[0]); };
    const Point p(y[0], y[1]), q(y[2], y[3]), r(y[4], y[5]);
    EXPECT_EQ(dyad_closure(flipped(p), flipped(q), flipped(r), flipped(d)).sign,
              dyad_closure(p, q, r, d).sign)
        << stream << ", case " << i;
  }
}

}  // namespace
}  // namespace burmester
