// Nearest points of cubics whose nearest points are known: a circle and a line, a circular cone and a plane.
#include "burmester/geometry/nearest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

/// (x^2 + y^2 - r^2 z^2) times the linear form l.
Cubic<Rational> circle_and(const LinearForm<Rational>& l, const Rational& square) {
  Conic<Rational> circle;
  circle.q = {1, 1, Rational(-square), 0, 0, 0};
  Cubic<Rational> f;
  f.add_product(l, circle);
  return f;
}

/// A polygon in the circle, its corners at these shares of a turn; on the sphere at the height z of |c| = 1.
CurvePiece polygon(const std::vector<double>& shares, double radius, double z, double max_error) {
  CurvePiece out;
  out.closed = true, out.max_error = max_error;
  for (const double share : shares) {
    const double angle = 2 * std::numbers::pi * share;
    out.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return out;
}
std::vector<double> equal_shares(int n) {
  std::vector<double> out;
  for (int k = 0; k < n; ++k) out.push_back(static_cast<double>(k) / n);
  return out;
}

const LinearForm<Rational> far_line(1, 0, -5);

TEST(NearestPoint, OfACircleIsOnTheRay) {
  Random random("NearestPoint.OfACircleIsOnTheRay");
  const auto f = circle_and(far_line, Rational(1));
  const std::vector<CurvePiece> pieces{polygon(equal_shares(40), 1, 1, 0.0031)};
  for (int i = 0; i < 200; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), away = random.uniform(0.2, 3);
    const Point2<double> ray(std::cos(angle), std::sin(angle), 1), q(away * ray[0], away * ray[1], 1);
    const auto nearest = nearest_point(Surface::plane, f, pieces, q);
    ASSERT_TRUE(nearest);
    EXPECT_FALSE(nearest->end);
    EXPECT_LT((nearest->at - ray).norm(), 1e-14) << i;
  }
}

/// The longest chord is the nearest one, but not the nearest arc.
TEST(NearestPoint, IsNotThatOfTheNearestChordWhereErrorsHideIt) {
  std::vector<double> shares = equal_shares(60);
  shares.erase(shares.begin() + 30);  // one chord twice as long, opposite to the nearest point
  const std::vector<CurvePiece> pieces{polygon(shares, 1, 1, 0.0056)};
  for (const double x : {1e-3, 2e-4}) {
    const auto nearest = nearest_point(Surface::plane, circle_and(far_line, Rational(1)), pieces, {x, 0, 1});
    ASSERT_TRUE(nearest);
    EXPECT_LT((nearest->at - Point2<double>(1, 0, 1)).norm(), 1e-12) << x;
  }
}

TEST(NearestPoint, OfAConeIsOnTheMeridianOnTheSideOfTheDirection) {
  Random random("NearestPoint.OfAConeIsOnTheMeridianOnTheSideOfTheDirection");
  for (const double polar : {0.3, 1.0, 1.5}) {  // half the opening of the cone
    const double tangent = std::tan(polar);
    const auto f =
        circle_and(LinearForm<Rational>(0, 0, 1), Rational(tangent * tangent));  // and the equator, not in the pieces
    const std::vector<CurvePiece> pieces{polygon(equal_shares(80), std::sin(polar), std::cos(polar), 1e-3)};
    for (int i = 0; i < 100; ++i) {
      const double l = random.uniform(0, 2 * std::numbers::pi), off = random.uniform(-0.25, 0.06);
      const int side = i % 2 ? 1 : -1;
      const auto at = [&](double t) -> Point2<double> {
        return side * Point2<double>(std::sin(t) * std::cos(l), std::sin(t) * std::sin(l), std::cos(t));
      };
      const auto nearest = nearest_point(Surface::sphere, f, pieces, at(polar + off));
      ASSERT_TRUE(nearest);
      EXPECT_LT((nearest->at - at(polar)).norm(), 1e-13) << polar << " " << i;
    }
  }
}

TEST(NearestPoint, AtTheEndOfAnOpenPieceIsTold) {
  const auto f = circle_and(far_line, Rational(1));
  CurvePiece half = polygon(equal_shares(40), 1, 1, 0.0031);
  half.points.resize(21), half.closed = false;
  EXPECT_FALSE(nearest_point(Surface::plane, f, {half}, {0, 2, 1})->end);
  EXPECT_TRUE(nearest_point(Surface::plane, f, {half}, {0.5, -3, 1})->end);
  EXPECT_FALSE(nearest_point(Surface::plane, f, {}, {0, 2, 1}));
}

TEST(NearestPoint, ACrossingHoldsAPointOfTheCurve) {
  Random random("NearestPoint.ACrossingHoldsAPointOfTheCurve");
  for (const Surface surface : {Surface::plane, Surface::sphere}) {
    const auto f = circle_and(far_line, Rational(1));
    for (int i = 0; i < 50; ++i) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      Point2<double> c(std::cos(angle), std::sin(angle), 1);
      if (surface == Surface::sphere) c.normalize();
      const auto box = crossing(surface, f, c);
      ASSERT_TRUE(box) << i;
      const auto [x, y, z] = std::tuple{(*box)[0], (*box)[1], (*box)[2]};
      const RationalInterval square = x * x + y * y - z * z;
      EXPECT_TRUE(square.low() <= 0 && square.high() >= 0) << i;
      for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE((*box)[k].low() <= Rational(c[k]) && (*box)[k].high() >= Rational(c[k])) << i;
        EXPECT_LT(upper((*box)[k]) - lower((*box)[k]), 1e-14) << i;
      }
    }
    // a line that counts twice has no side
    Cubic<Rational> twice;
    twice.add_product({0, 1, 0}, {0, 1, 0}, {1, 0, -5}, 1);
    EXPECT_FALSE(crossing(surface, twice, {0, 0x1p-60, 1}));
  }
}

}  // namespace
}  // namespace burmester
