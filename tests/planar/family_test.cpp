#include "burmester/planar/family.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rational.hpp"

namespace burmester::planar {
namespace {

TEST(PlanarFamily, LiftedFormIsTheCircleExactlyOverTheRationals) {
  // K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3 at P = R p + t, times norm, is row . k for any K, p and pose.
  Random random("PlanarFamily.LiftedFormIsTheCircleExactlyOverTheRationals");
  for (int i = 0; i < 50; ++i) {
    const Pose pose{random.normal(), random.normal(), random.normal(), random.normal()};
    const Vector<Rational, 4> K = random_rationals<4>(random);
    const Vector<Rational, 2> p = random_rationals<2>(random);
    Vector<Rational, 8> k;
    k << K[0], K[1], K[2], K[0] * p[0], K[0] * p[1], K[0] * (p[0] * p[0] + p[1] * p[1]) + K[3],
        K[1] * p[0] + K[2] * p[1], K[2] * p[0] - K[1] * p[1];

    const Vector<Rational, 4> x = Space::point<Rational>(pose);
    const Vector<Rational, 2> P = Space::act<Rational>(x, p) / Space::norm<Rational>(x);
    const Rational n = Rational(pose.X3) * Rational(pose.X3) + Rational(pose.X4) * Rational(pose.X4);
    const Rational circle = K[0] * (P[0] * P[0] + P[1] * P[1]) + 2 * K[1] * P[0] + 2 * K[2] * P[1] + K[3];
    EXPECT_EQ(Rational(Family::row<Rational>(pose).dot(k)), n * circle);
    const Vector<Rational, 2> relations = Family::relations<Rational>(k);
    EXPECT_EQ(relations[0], 0);
    EXPECT_EQ(relations[1], 0);
  }
}

TEST(PlanarFamily, DecodesEveryTypeUpToScale) {
  Random random("PlanarFamily.DecodesEveryTypeUpToScale");
  Dyads::for_each([&]<class D>() {
    for (int i = 0; i < 100; ++i) {
      const auto design = D::random_design(random);
      const auto back = Family::decode(random.normal() * D::encode(design));
      ASSERT_TRUE(back && std::holds_alternative<typename D::Design>(*back)) << D::name << ", case " << i;
      const Pose probe = Space::random_pose(random);
      const double residual = D::residual(std::get<typename D::Design>(*back), probe);
      EXPECT_NEAR(std::abs(residual), std::abs(D::residual(design, probe)), 1e-12) << D::name << ", case " << i;
    }
  });
}

TEST(PlanarFamily, OtherFormsAreNoDyads) {
  const auto none = [](std::initializer_list<double> k) {
    Vector<double, 8> v;
    std::copy(k.begin(), k.end(), v.begin());
    return !Family::decode(v);
  };
  EXPECT_TRUE(none({0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(none({1, 0, 0, 0, 0, 1, 0, 0}));  // X^2 + Y^2 = -1
  EXPECT_TRUE(none({0, 1, 0, 1, 0, 0, 0, 0}));  // neither line
  EXPECT_TRUE(none({0, 0, 0, 0, 0, 1, 1, 0}));  // a pair of orientations
  EXPECT_TRUE(none({0, 0, 0, 0, 0, 0, 1, 0}));
  EXPECT_FALSE(none({0, 0, 0, 0, 0, 2, 1, 0}));
}

}  // namespace
}  // namespace burmester::planar
