#include "burmester/geometry/circle_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Points = std::vector<Vector<double, 2>>;
using K4 = Vector<double, 4>;

/// Difference of two vectors of one line.
double gap(const K4& a, const K4& b) {
  return std::min((a.normalized() - b.normalized()).norm(), (a.normalized() + b.normalized()).norm());
}

// ---- M. J. D. Hayes, lecture notes ME 401 / MECH 5507, unit 3: line and circle feature extraction ----

/// 42 points of the unit circle. Printed: rank 3, k = (1, 0, 0, -1), which is the singular vector over K0.
TEST(FitCircle, PublishedPointsOnACircle) {
  Points points;
  for (int i = 0; i < 42; ++i) {
    const double angle = i * std::numbers::pi / 21;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  const auto fit = fit_circle(points);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rank, 3);
  EXPECT_FALSE(fit->straight);
  EXPECT_LT(gap(fit->K, {1, 0, 0, -1}), 1e-15);
  EXPECT_LT((fit->singular_values - K4(9.16515138991168, 9.16515138991168, 9.16515138991168, 0)).norm(), 1e-13);
}

/// 25 points of Y = X. Printed: rank 3, k = (0, 0.7071, -0.7071, 0), 45 degrees.
TEST(FitCircle, PublishedPointsOnALine) {
  Points points;
  for (int i = -12; i <= 12; ++i) points.emplace_back(i / 12.0, i / 12.0);
  const auto fit = fit_circle(points);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rank, 3);
  EXPECT_TRUE(fit->straight);
  EXPECT_LT(gap(fit->K, {0, std::sqrt(0.5), -std::sqrt(0.5), 0}), 1e-15);
  EXPECT_LT((fit->singular_values - K4(8.498365855987975, 6.502600929261072, 2.4775490017369197, 0)).norm(), 1e-13);
}

/// The printed noisy points are not given; these are made to the printed condition, 225.2 (42 points, noise 0.008), and
/// their vectors computed in 60 digits. The printed radius 0.99746 is -K3: it should be sqrt(K1^2 + K2^2 - K3) =
/// 0.998729.
TEST(FitCircle, NoisyPointsNearACircle) {
  const Points points{{1.002622, -0.003299},  {0.991788, 0.142397},   {0.955853, 0.294581},   {0.902701, 0.431686},
                      {0.822126, 0.561194},   {0.738554, 0.674642},   {0.620073, 0.784257},   {0.504895, 0.874269},
                      {0.370421, 0.93027},    {0.22318, 0.977049},    {0.070505, 1.00065},    {-0.071075, 1.005308},
                      {-0.22541, 0.974006},   {-0.361819, 0.934928},  {-0.50553, 0.857841},   {-0.618714, 0.774078},
                      {-0.731405, 0.675875},  {-0.825285, 0.563577},  {-0.902702, 0.42852},   {-0.953106, 0.298415},
                      {-0.992127, 0.15701},   {-0.994346, -0.001857}, {-0.985368, -0.155371}, {-0.953752, -0.293926},
                      {-0.897591, -0.427056}, {-0.827982, -0.557704}, {-0.73105, -0.68835},   {-0.625603, -0.78843},
                      {-0.498982, -0.868219}, {-0.371258, -0.925741}, {-0.229751, -0.981929}, {-0.079852, -0.990472},
                      {0.075561, -0.997391},  {0.220429, -0.981689},  {0.364554, -0.934111},  {0.497923, -0.872402},
                      {0.631017, -0.776898},  {0.731941, -0.679067},  {0.818145, -0.555542},  {0.895216, -0.436435},
                      {0.959775, -0.291035},  {0.994443, -0.154399}};
  const auto fit = fit_circle(points);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rank, 4);
  EXPECT_FALSE(fit->straight);
  EXPECT_LT(gap(fit->K, {0.7068772054292809, -0.0008074158876196504, 5.271877423357913e-05, -0.7073358196393036}),
            1e-14);
  EXPECT_NEAR(fit->singular_values[0] / fit->singular_values[3], 224.89037324794134, 1e-10);
}

/// Made to the printed condition, 5448.6 (25 points, noise 0.0003). The printed k is not of norm 1 (0.99506).
TEST(FitCircle, NoisyPointsNearALine) {
  const Points points{{-0.999925, -1.000015}, {-0.91652, -0.916634},  {-0.833374, -0.833295}, {-0.750166, -0.749909},
                      {-0.666579, -0.6665},   {-0.5831, -0.583486},   {-0.500278, -0.499802}, {-0.416543, -0.416787},
                      {-0.333215, -0.333598}, {-0.250119, -0.249794}, {-0.166507, -0.166635}, {-0.083439, -0.083352},
                      {7.2e-05, -0.000296},   {0.083409, 0.083468},   {0.166754, 0.166678},   {0.249782, 0.24993},
                      {0.333132, 0.333082},   {0.416817, 0.416397},   {0.500071, 0.500256},   {0.583078, 0.583093},
                      {0.666729, 0.666675},   {0.749935, 0.749913},   {0.833539, 0.833223},   {0.916777, 0.916699},
                      {1.000123, 0.999803}};
  const auto fit = fit_circle(points);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rank, 4);
  EXPECT_TRUE(fit->straight);  // its circle would have a radius of 17604
  EXPECT_LT(gap(fit->K, {-5.6804295756127495e-05, 0.7070779590897428, -0.7071355989744905, -3.4723831982402364e-05}),
            1e-13);
  EXPECT_NEAR(fit->singular_values[0] / fit->singular_values[3], 5365.5921242805825, 1e-8);
  EXPECT_NEAR(std::atan(-fit->K[1] / fit->K[2]) * 180 / std::numbers::pi, 44.99766476420269, 1e-10);
}

// ---- Laws ----

/// Any circle and any line; the vector is good to the rounding of the rows over the third singular value.
TEST(FitCircle, FindsExactCurves) {
  Random random("FitCircle.FindsExactCurves");
  for (int i = 0; i < 100; ++i) {
    const double a = random.normal(), b = random.normal(), r = 0.1 + std::abs(random.normal());
    const double angle = random.uniform(0, 3);
    Points circle, line;
    for (int k = 0; k < 12; ++k) {
      const double u = random.uniform(-3, 3);
      circle.emplace_back(a + r * std::cos(u), b + r * std::sin(u));
      line.emplace_back(a + u * std::cos(angle), b + u * std::sin(angle));
    }
    const auto round = fit_circle(circle), flat = fit_circle(line);
    ASSERT_TRUE(round && flat) << i;
    const auto tolerance = [](const FittedCircle& f) { return 1e-14 * f.singular_values[0] / f.singular_values[2]; };
    EXPECT_LT(gap(round->K, {1, -a, -b, a * a + b * b - r * r}), tolerance(*round)) << i;
    EXPECT_FALSE(round->straight) << i;
    const double s = std::sin(angle), c = std::cos(angle);
    EXPECT_LT(gap(flat->K, {0, -s / 2, c / 2, a * s - b * c}), tolerance(*flat)) << i;
    EXPECT_TRUE(flat->straight) << i;
  }
}

/// A shallow arc is a circle as long as its bow stands out of the noise.
TEST(FitCircle, TellsAnArcFromALineByTheNoise) {
  Random random("FitCircle.TellsAnArcFromALineByTheNoise");
  for (int i = 0; i < 100; ++i) {
    const auto arc = [&random](double curvature, double noise) {
      Points points;
      for (int k = -20; k <= 20; ++k) {
        const double x = k / 20.0;
        points.emplace_back(x + noise * random.normal(), curvature * x * x / 2 + noise * random.normal());
      }
      return fit_circle(points)->straight;
    };
    EXPECT_FALSE(arc(0.02, 1e-4)) << i;  // bow 0.01
    EXPECT_TRUE(arc(0, 1e-3)) << i;
    EXPECT_TRUE(arc(1e-5, 1e-3)) << i;
  }
}

TEST(FitCircle, IsEmptyWhereThePointsDoNotSay) {
  const Vector<double, 2> a(1, 2), b(3, -1), c(0, 5);
  EXPECT_FALSE(fit_circle(Points{}));
  EXPECT_FALSE(fit_circle(Points{a, b}));
  EXPECT_FALSE(fit_circle(Points{a, b, a, b, b}));
  EXPECT_FALSE(fit_circle(Points{a, a, a, a}));
  EXPECT_TRUE(fit_circle(Points{a, b, c}));
  EXPECT_TRUE(fit_circle(Points{a, b, c, a}));
}

}  // namespace
}  // namespace burmester
