#include "burmester/planar/constraint_quadric.hpp"

#include <gtest/gtest.h>

namespace burmester::planar {
namespace {

Vector<double, 8> random_form(Random& r) {
  Vector<double, 8> k;
  for (int i = 0; i < 8; ++i) k[i] = r.normal();
  return k;
}

TEST(ConstraintQuadric, IsTheFamilysRow) {
  Random random("ConstraintQuadric.IsTheFamilysRow");
  for (int i = 0; i < 100; ++i) {
    Pose x = Space::random_pose(random);
    const double scale = random.normal();
    x.X3 *= scale, x.X4 *= scale;
    const Vector<double, 8> k = random_form(random), row = Family::row<double>(x);
    const Point3<double> p = Space::point<double>(x);
    EXPECT_NEAR(constraint_quadric(k)(p), row.dot(k), 1e-13 * row.norm() * k.norm());
  }
}

/// The printed equation, term by term, for a point (x, y) of E on K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3 = 0.
TEST(ConstraintQuadric, IsTheConstraintManifoldEquation) {
  Random random("ConstraintQuadric.IsTheConstraintManifoldEquation");
  for (int i = 0; i < 100; ++i) {
    const Vector<double, 4> K(random.normal(), random.normal(), random.normal(), random.normal());
    const double x = random.normal(), y = random.normal();
    const Vector<double, 4> X = image_point(Space::random_pose(random));  // X1, X2, X3, X4
    const double K3 = K[0] * (x * x + y * y) + K[3], dot = K[1] * x + K[2] * y, cross = K[1] * y - K[2] * x;
    const double printed = K[0] * (X[0] * X[0] + X[1] * X[1]) + (K3 - 2 * dot) / 4 * X[2] * X[2] +
                           (K[1] - K[0] * x) * X[0] * X[2] + (K[2] - K[0] * y) * X[1] * X[2] -
                           (K[0] * y + K[2]) * X[0] * X[3] + (K[0] * x + K[1]) * X[1] * X[3] - cross * X[2] * X[3] +
                           (K3 + 2 * dot) / 4 * X[3] * X[3];
    const Vector<double, 8> k{{K[0], K[1], K[2], K[0] * x, K[0] * y, K3, dot, -cross}};
    const double value = constraint_quadric(k)({X[3], X[2], X[1], -X[0]});
    EXPECT_NEAR(value, printed, 1e-13 * (1 + X.squaredNorm()) * (1 + k.norm()));
  }
}

double squared(const RR::Design& d, double residual) { return residual * (residual + 2 * d.length); }
double squared(const PR::Design&, double residual) { return residual; }
double squared(const RP::Design&, double residual) { return residual; }
double squared(const PP::Design&, double residual) { return 2 * (1 - std::cos(residual)); }

TEST(ConstraintQuadric, IsTheNormTimesAFunctionOfTheResidual) {
  Random random("ConstraintQuadric.IsTheNormTimesAFunctionOfTheResidual");
  Dyads::for_each([&]<class D>() {
    for (int i = 0; i < 20; ++i) {
      const auto d = D::random_design(random);
      Pose x = Space::random_pose(random);
      x.X3 *= 3, x.X4 *= 3;
      const double value = constraint_quadric(Family::Design(d))(Space::point<double>(x));
      EXPECT_NEAR(std::abs(value), 9 * std::abs(squared(d, D::residual(d, x))), 1e-11) << D::name;
    }
  });
}

TEST(DesignOf, ReadsWhatTheRecordShows) {
  Random random("DesignOf.ReadsWhatTheRecordShows");
  Dyads::for_each([&]<class D>() {
    for (int i = 0; i < 20; ++i) {
      const auto d = D::random_design(random);
      const Pose x = Space::random_pose(random);
      const auto back = design_of(D::record(d));
      ASSERT_TRUE(back) << D::name;
      ASSERT_TRUE(std::holds_alternative<typename D::Design>(*back)) << D::name;
      const double residual = D::residual(std::get<typename D::Design>(*back), x);
      EXPECT_NEAR(std::abs(residual), std::abs(D::residual(d, x)), 1e-13) << D::name;
    }
  });
}

TEST(DesignOf, IsEmptyForOtherRecords) {
  DyadRecord record;
  record.type = "RR";
  EXPECT_FALSE(design_of(record));
  record.fixed = record.moving = {0, 0, 1}, record.arc = 1;
  EXPECT_FALSE(design_of(record));
  record.type = "SS";
  EXPECT_FALSE(design_of(record));
}

}  // namespace
}  // namespace burmester::planar
