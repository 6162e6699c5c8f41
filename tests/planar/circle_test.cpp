// Circles and lines by their coordinates K, and the forms of points that move along them.
#include <gtest/gtest.h>

#include <numbers>

#include "burmester/geometry/grassmann.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {
namespace {

double value(const Vector<double, 4>& K, const Vector2& p) {
  return K[0] * p.squaredNorm() + 2 * K[1] * p[0] + 2 * K[2] * p[1] + K[3];
}

TEST(CircleCoordinates, GiveTheCurveBack) {
  Random random("CircleCoordinates.GiveTheCurveBack");
  for (int i = 0; i < 100; ++i) {
    const double factor = random.normal();
    const Circle circle{Space::random_feature(random), std::abs(random.normal())};
    const auto same = curve_of(factor * coordinates_of(circle));
    ASSERT_TRUE(same && std::holds_alternative<Circle>(*same)) << i;
    EXPECT_LT((std::get<Circle>(*same).centre - circle.centre).norm(), 1e-14) << i;
    EXPECT_NEAR(std::pow(std::get<Circle>(*same).radius, 2), std::pow(circle.radius, 2), 1e-14) << i;

    const double angle = random.uniform(0, std::numbers::pi);
    const Vector2 point = Space::random_feature(random);
    const Line line = Line::through(point, angle);
    const Vector<double, 4> K = coordinates_of(line);  // as printed: K = [0, -sin / 2, cos / 2, X sin - Y cos]
    const Vector<double, 4> printed(0, -std::sin(angle) / 2, std::cos(angle) / 2,
                                    point[0] * std::sin(angle) - point[1] * std::cos(angle));
    EXPECT_LT((K - printed).norm(), 1e-15 * (1 + point.norm())) << i;
    const auto again = curve_of(factor * K);
    ASSERT_TRUE(again && std::holds_alternative<Line>(*again)) << i;
    EXPECT_NEAR(std::get<Line>(*again).record().angle, angle, 1e-14) << i;
    EXPECT_NEAR(std::get<Line>(*again).signed_distance(point), 0, 1e-14) << i;
  }
}

TEST(CircleCoordinates, AreEmptyWithoutARealCurve) {
  EXPECT_FALSE(curve_of({1, 0, 0, 1}));
  EXPECT_FALSE(curve_of({-2, 0, 0, -1}));
  EXPECT_FALSE(curve_of({0, 0, 0, 1}));
  EXPECT_FALSE(curve_of({0, 0, 0, 0}));
  EXPECT_FALSE(curve_of({std::nan(""), 1, 1, 1}));
  ASSERT_TRUE(curve_of({1, 0, 0, 0}));  // a point
  EXPECT_EQ(std::get<Circle>(*curve_of({1, 0, 0, 0})).radius, 0);
}

/// Three places of a body point give its centre point: an RR dyad for three poses.
TEST(CircleCoordinates, OfThreePlacesAreADyad) {
  Random random("CircleCoordinates.OfThreePlacesAreADyad");
  for (int i = 0; i < 100; ++i) {
    std::array<Pose, 3> poses;
    for (Pose& x : poses) x = Space::random_pose(random);
    const Vector2 p = Space::random_feature(random);
    std::array<Point2<double>, 3> places;
    for (std::size_t j = 0; j < 3; ++j) places[j] = to_fixed(poses[j], p).homogeneous();
    const auto K = circle_through(places);
    ASSERT_TRUE(K) << i;
    const auto curve = curve_of(*K);
    ASSERT_TRUE(curve) << i;
    const Circle& circle = std::get<Circle>(*curve);
    const double size = 1 + circle.radius;  // the rounding of a wide circle through close points
    for (const Pose& x : poses)
      EXPECT_NEAR(RR::residual({circle.centre, p, circle.radius}, x), 0, 1e-13 * size * size) << i;
  }
}

/// norm(x) K(P) = row(x) . k, for the moving point's place P in S and for the fixed point's place in E.
TEST(LiftedForms, AreTheEquationsOfTheMovedPoint) {
  Random random("LiftedForms.AreTheEquationsOfTheMovedPoint");
  for (int i = 0; i < 100; ++i) {
    const Pose x = Space::random_pose(random);
    const Vector2 p = Space::random_feature(random);
    Vector<double, 4> K(random.normal(), random.normal(), random.normal(), random.normal());
    if (i % 3 == 0) K[0] = 0;
    const Vector<double, 8> row = Family::row<double>(x);
    const double size = 1e-14 * K.norm() * row.norm() * (1 + p.squaredNorm());
    EXPECT_NEAR(row.dot(form_of_moving_point<double>(K, p)), value(K, to_fixed(x, p)), size) << i;
    EXPECT_NEAR(row.dot(form_of_fixed_point<double>(K, p)), value(K, to_moving(x, p)), size) << i;
  }
}

/// One circle seen from both bodies is one surface.
TEST(LiftedForms, OfAnRRAreTheSameFromBothBodies) {
  Random random("LiftedForms.OfAnRRAreTheSameFromBothBodies");
  for (int i = 0; i < 100; ++i) {
    const RR::Design d = RR::random_design(random);
    const Vector<double, 8> upper = form_of_moving_point<double>(coordinates_of(Circle{d.fixed, d.length}), d.moving),
                            lower = form_of_fixed_point<double>(coordinates_of(Circle{d.moving, d.length}), d.fixed);
    EXPECT_LT((upper - lower).norm(), 1e-15 * upper.squaredNorm()) << i;
  }
}

}  // namespace
}  // namespace burmester::planar
