// The rungs one by one, and a predicate of one's own.
#include "burmester/geometry/predicate.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "burmester/geometry/rational.hpp"
#include "near_degenerate.hpp"
#include "polynomials.hpp"
#include "rounding_mode.hpp"

namespace burmester {

/// Six points of the plane lie on a conic where this vanishes: the invariant of brackets (H. S. White, "Seven
/// points on a twisted cubic curve", 1915; J. Richter-Gebert, "Perspectives on Projective Geometry", 2011,
/// section 10.2).
struct SixOnAConic {
  template <class T>
  constexpr T operator()(const std::array<T, 12>& p) const {
    const auto bracket = [&](std::size_t a, std::size_t b, std::size_t c) {
      return Orientation2()(
          std::array<T, 6>{p[2 * a], p[2 * a + 1], p[2 * b], p[2 * b + 1], p[2 * c], p[2 * c + 1]});
    };
    return bracket(0, 1, 2) * bracket(0, 3, 4) * bracket(1, 3, 5) * bracket(2, 4, 5) -
           bracket(0, 1, 3) * bracket(0, 2, 4) * bracket(1, 2, 5) * bracket(3, 4, 5);
  }
};

#include "signed_area.hpp"  // the example of docs/exact.md

namespace {

// ---- One's own predicate ----

TEST(OwnPredicate, TheExampleOfTheGuide) {
  const double e = 0x1p-52;
  EXPECT_EQ(exact_sign<SignedArea>(std::array<double, 6>{0, 0, 1, 0, 0, 1}), (Sign{1, Rung::doubles}));
  EXPECT_EQ(exact_sign<SignedArea>(std::array<double, 6>{1, 1, 1 + e, 1 + e, 1 - e, 1 - e}),
            (Sign{0, Rung::intervals}));
  EXPECT_EQ(exact_sign<SignedArea>(std::array<double, 6>{1, 1, 3.1, 3.1, 0.7, 0.7}), (Sign{0, Rung::exact}));
  EXPECT_EQ(exact_sign<SignedArea>(std::array<double, 6>{1, 1, 3.1, 3.1, 0.7, std::nextafter(0.7, 0)}),
            (Sign{-1, Rung::intervals}));
}

TEST(OwnPredicate, SixPointsOnAConic) {
  std::array<double, 12> parabola, far;
  for (int i = 0; i < 6; ++i) {
    const double t = 3 * i - 7;
    parabola[2 * i] = t, parabola[2 * i + 1] = t * t;
    far[2 * i] = t + 0x1p44, far[2 * i + 1] = t * t - 0x1p45;
  }
  EXPECT_EQ(exact_sign<SixOnAConic>(parabola), (Sign{0, Rung::intervals}));
  EXPECT_EQ(exact_sign<SixOnAConic>(far), (Sign{0, Rung::intervals}));

  far[11] += 1;
  const Sign beside = exact_sign<SixOnAConic>(far);
  EXPECT_EQ(beside.decided_by, Rung::doubles);
  far[11] -= 2;
  EXPECT_EQ(exact_sign<SixOnAConic>(far), (Sign{-beside.sign, Rung::doubles}));

  auto moved = parabola;
  moved[11] = std::nextafter(moved[11], 100);
  EXPECT_EQ(exact_sign<SixOnAConic>(moved), (Sign{beside.sign, Rung::exact}));

  // The ellipse through (+-a, +-b), (0, +-b sqrt 2)... in integers: (x / s)^2 + (y / t)^2 = 65, long s and t.
  const double s = 0x1p40 + 1, t = 0x1p39 + 3;
  const std::array<double, 12> ellipse{8 * s, t,      -4 * s, 7 * t, -s,     -8 * t,
                                       7 * s, -4 * t, s,      8 * t, -7 * s, 4 * t};
  EXPECT_EQ(exact_sign<SixOnAConic>(ellipse), (Sign{0, Rung::exact}));
}

TEST(OwnPredicate, AgreesWithRationals) {
  const std::string stream = "OwnPredicate.AgreesWithRationals";
  Random random(stream);
  for (int i = 0; i < 1000; ++i) {
    auto x = random_arguments<12>(random);
    if (i % 2)
      for (std::size_t k = 0; k < 12; k += 2) x[k + 1] = x[k] * x[k] / 3;
    EXPECT_EQ(exact_sign<SixOnAConic>(x).sign, *known_sign(evaluate<SixOnAConic, Rational>(x)))
        << stream << ", case " << i;
  }
}

// ---- Depth and bound of doubles ----

constexpr int depth(auto f, auto arguments) { return f(arguments).value(); }

TEST(Depth, CountsWhatTheBoundNeeds) {
  constexpr auto sum = [](const auto& x) { return x[0] + x[1] - x[2]; };
  constexpr auto power = [](const auto& x) { return x[0] * x[0] * x[0] * x[0]; };
  constexpr auto constant = [](const auto& x) { return 2 * x[0] + 1; };
  static_assert(depth(sum, std::array<Depth, 3>{}) == 2);
  static_assert(depth(power, std::array<Depth, 1>{}) == 3);
  static_assert(depth(constant, std::array<Depth, 1>{}) == 2);
  static_assert(depth(Determinant<3>(), std::array<Depth, 9>{}) == 5);
  static_assert(depth(Orientation2(), std::array<Depth, 6>{}) == 4);
}

template <class F>
class Bound : public testing::Test {};
TYPED_TEST_SUITE(Bound, Polynomials<SixOnAConic>);

inline auto near_degenerate(SixOnAConic, Random& random) { return random_arguments<12>(random); }

// |v - exact| <= k 2^-52 m to nearest and upward, at all sizes at which m is finite.
TYPED_TEST(Bound, HoldsInBothRoundingModes) {
  const std::string stream =
      std::string("Bound.") + testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
  Random random(stream);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    auto x = near_degenerate(TypeParam(), random);
    const int scale = random.below(4) ? 0 : random.below(1000) - 600;
    for (double& a : x) a = std::ldexp(a, scale);
    std::array<Depth, std::tuple_size_v<decltype(x)>> depths;
    const Rational unit = Rational(0x1p-52) * (1 + Rational(0x1p-40)) * TypeParam()(depths).value();
    const Rational exact = evaluate<TypeParam, Rational>(x);
    const auto expect_bounded = [&](const Bounded& v) {
      if (!std::isfinite(v.magnitude())) return;
      EXPECT_LE(abs(Rational(Rational(v.value()) - exact)), unit * Rational(v.magnitude()))
          << stream << ", case " << i;
      ++compared;
    };
    const auto upward = [&] {
      const UpwardRounding live;
      return evaluate<TypeParam, Bounded>(x);
    };
    expect_bounded(evaluate<TypeParam, Bounded>(x));
    expect_bounded(upward());
  }
  EXPECT_GT(compared, 1500);
}

/// |v - exact| / (k 2^-52 m), rounding upward
template <class F, std::size_t N>
double share_of_bound(const F& f, const std::array<double, N>& x) {
  const UpwardRounding upward;
  const Bounded v = evaluate<F, Bounded>(x);
  const Rational error = abs(Rational(Rational(v.value()) - evaluate<F, Rational>(x)));
  return approximate(Rational(error / (Rational(v.magnitude()) * f(std::array<Depth, N>{}).value()))) *
         0x1p52;
}

// Every step rounds by nearly an ulp in the same direction: a smaller depth or unit would be wrong.
TEST(Bound, IsAttained) {
  constexpr auto power = [](const auto& x) { return x[0] * x[0] * x[0] * x[0] * x[0]; };
  constexpr auto sum = [](const auto& x) { return x[0] + x[1] + x[1] + x[1] + x[1]; };
  constexpr auto gap = [](const auto& x) { return difference(x[0], x[1]); };
  EXPECT_GT(share_of_bound(power, std::array{1 + 0x1p-52}), 0.999);
  EXPECT_GT(share_of_bound(sum, std::array{1.0, 0x1p-80}), 0.999);
  EXPECT_GT(share_of_bound(gap, std::array{1.0, -0x1p-80}), 0.999);
}

// ---- The rungs alone ----

const std::array<double, 4> regular{1, 2, 3, 4}, singular{6, 4, 9, 6}, rounded{3, 0.1, 6, 0.2};

TEST(Rungs, DoublesNeverProveAZero) {
  EXPECT_EQ(sign_by_doubles<Determinant<2>>(regular), -1);
  EXPECT_EQ(sign_by_doubles<Determinant<2>>(singular), std::nullopt);
  EXPECT_EQ(sign_by_doubles<Determinant<2>>(std::array<double, 4>{}), std::nullopt);
}

TEST(Rungs, IntervalsProveAZeroWhereNothingIsRounded) {
  EXPECT_EQ(sign_by_intervals<Determinant<2>>(regular), -1);
  EXPECT_EQ(sign_by_intervals<Determinant<2>>(singular), 0);
  EXPECT_EQ(sign_by_intervals<Determinant<2>>(rounded), std::nullopt);
}

TEST(Rungs, ExactProvesEverything) {
  EXPECT_EQ(sign_by_exact<Determinant<2>>(regular), -1);
  EXPECT_EQ(sign_by_exact<Determinant<2>>(singular), 0);
  EXPECT_EQ(sign_by_exact<Determinant<2>>(rounded), 0);
}

TEST(Rungs, AgreeAlsoWhereTheCallerRoundsUpward) {
  const std::string stream = "Rungs.AgreeAlsoWhereTheCallerRoundsUpward";
  Random random(stream);
  for (int i = 0; i < 500; ++i) {
    const auto x = i % 2 ? near_singular<3>(random) : random_arguments<9>(random);
    const int exact = sign_by_exact<Determinant<3>>(x);
    const UpwardRounding upward;
    const auto first = sign_by_doubles<Determinant<3>>(x),
               second = sign_by_intervals<Determinant<3>>(x, upward);
    EXPECT_TRUE(!first || *first == exact) << stream << ", case " << i;
    EXPECT_TRUE(!second || *second == exact) << stream << ", case " << i;
    EXPECT_EQ(exact_sign<Determinant<3>>(x).sign, exact) << stream << ", case " << i;
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
  }
  EXPECT_EQ(rounding_mode(), RoundingMode::nearest);
}

TEST(Rungs, RestoreTheRoundingMode) {
  sign_by_intervals<Determinant<2>>(rounded);
  EXPECT_EQ(rounding_mode(), RoundingMode::nearest);
  exact_sign<Determinant<2>>(rounded);
  EXPECT_EQ(rounding_mode(), RoundingMode::nearest);
}

}  // namespace
}  // namespace burmester
