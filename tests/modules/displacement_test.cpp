#include "burmester/modules/framework/displacement.hpp"

#include <gtest/gtest.h>

#include "rational.hpp"

namespace burmester {
namespace {

using SE2 = Displacement<std::array{0, 3, 5, 6}, std::array{1, 2}>;
using SO3 = Displacement<std::array{0, 1, 2, 3}, std::array{1, 2, 3}>;
using SE3 = Displacement<std::array{0, 1, 2, 3, 4, 5, 6, 7}, std::array{1, 2, 3}>;

template <class S>
using Exact = typename S::template Point<Rational>;

/// A rational displacement; of SE(3), one on the Study quadric: the last coordinate is solved for.
template <class S>
Exact<S> random_displacement(Random& random) {
  for (;;) {
    Exact<S> x = random_rationals<S::ambient + 1>(random);
    if constexpr (S::ambient == 7) {
      if (x[3] == 0) continue;
      x[7] = -(x[0] * x[4] + x[1] * x[5] + x[2] * x[6]) / x[3];
    }
    if (S::template norm<Rational>(x) != 0) return x;
  }
}

template <class S>
class ExactLaws : public testing::Test {};
using AllThree = testing::Types<SE2, SO3, SE3>;
TYPED_TEST_SUITE(ExactLaws, AllThree);

TYPED_TEST(ExactLaws, HoldWithoutAnyRounding) {
  using S = TypeParam;
  Random random("ExactLaws." + std::to_string(S::ambient));
  const auto product = [](const Exact<S>& x, const Exact<S>& y) {
    return S::template product<Rational>(x, y);
  };
  const auto norm = [](const Exact<S>& x) { return S::template norm<Rational>(x); };
  for (int i = 0; i < 30; ++i) {
    const Exact<S> x = random_displacement<S>(random), y = random_displacement<S>(random);
    const Exact<S> z = random_displacement<S>(random);
    EXPECT_EQ(norm(product(x, y)), norm(x) * norm(y));
    EXPECT_TRUE(product(product(x, y), z) == product(x, product(y, z)));
    Exact<S> unit = Exact<S>::Zero();
    unit[0] = norm(x);
    EXPECT_TRUE(product(x, S::template conjugate<Rational>(x)) == unit);

    using Feature = typename S::template Feature<Rational>;
    const Feature a = random_rationals<S::feature_size>(random);
    const Feature y_of_a = S::template act<Rational>(y, a) / norm(y);
    const Feature xy_of_a = S::template act<Rational>(x, y_of_a) * norm(y);
    EXPECT_TRUE(S::template act<Rational>(product(x, y), a) == xy_of_a);
  }
}

// Conventions, which no law can see.
TEST(Displacement, PointsMoveByTwiceTheDualPart) {
  // 1 + e (1 i + 2 j + 3 k): a shift by (2, 4, 6)
  const SE3::Point<double> shift{1, 0, 0, 0, 0, 1, 2, 3};
  EXPECT_TRUE((SE3::act<double>(shift, {10, 20, 30}).isApprox(Vector<double, 3>(12, 24, 36))));
}

TEST(Displacement, QuarterTurnAboutZTakesXToY) {
  const double r = std::sqrt(0.5);
  EXPECT_TRUE((SO3::act<double>({r, 0, 0, r}, {1, 0, 0}).isApprox(Vector<double, 3>(0, 1, 0))));
  EXPECT_TRUE((SE2::act<double>({r, r, 0, 0}, {1, 0}).isApprox(Vector<double, 2>(0, 1))));
}

TEST(Displacement, GapIsTheSineOfTheAngleAtEveryScale) {
  for (const double angle : {1e-12, 1e-6, 9e-4, 1.1e-3, 0.3, 1.5}) {
    const SO3::Point<double> x{1, 0, 0, 0}, y{std::cos(angle), std::sin(angle), 0, 0};
    EXPECT_NEAR(SO3::gap(x, -3 * y) / std::sin(angle), 1, 1e-6) << angle;
  }
}

}  // namespace
}  // namespace burmester
