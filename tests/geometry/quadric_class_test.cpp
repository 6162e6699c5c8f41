#include "burmester/geometry/quadric_class.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "moved_forms.hpp"

namespace burmester {
namespace {

using Q = Quadric<double>;
using enum QuadricType;

struct Normal {
  Q quadric;
  QuadricType type;
};
/// Every class, in coordinates (x, y, z, w), w = 0 at infinity.
std::vector<Normal> normal_forms() {
  return {{{{1, 2, 3, -4}}, ellipsoid},
          {{{1, 2, 3, 4}}, imaginary_ellipsoid},
          {{{1, 2, -3, -4}}, hyperboloid_of_one_sheet},
          {{{1, 2, -3, 4}}, hyperboloid_of_two_sheets},
          {{{1, 2, 0, 0, 0, 0, 0, 0, 0, -1}}, elliptic_paraboloid},
          {{{1, -2, 0, 0, 0, 0, 0, 0, 0, -1}}, hyperbolic_paraboloid},
          {{{1, 2, -3, 0}}, cone},
          {{{1, 2, 3, 0}}, point},
          {{{1, 2, 0, -4}}, elliptic_cylinder},
          {{{1, 2, 0, 4}}, imaginary_cylinder},
          {{{1, -2, 0, 4}}, hyperbolic_cylinder},
          {{{1, 0, 0, 0, 0, 0, 0, 0, 1, 0}}, parabolic_cylinder},
          {{{1, -2, 0, 0}}, crossing_planes},
          {{{1, 2, 0, 0}}, line},
          {{{1, 0, 0, -4}}, parallel_planes},
          {{{1, 0, 0, 4}}, complex_parallel_planes},
          {{{1, 0, 0, 0}}, coincident_planes},
          {{{0, 0, 0, 0, 0, 0, 1, 0, 0, 0}}, plane_and_infinity},
          {{{0, 0, 0, 1}}, infinity_twice},
          {{}, everything}};
}

TEST(QuadricClass, IsInvariantUnderAffineMapsScalingAndSign) {
  Random random("QuadricClass.IsInvariantUnderAffineMapsScalingAndSign");
  for (const Normal& normal : normal_forms())
    for (int i = 0; i < 40; ++i) {
      const Q moved = substituted(normal.quadric, random_unimodular<4>(random, true));
      for (const double factor : {1.0, -1.0, 0x1p-700, -0x1.8p300}) {
        const QuadricClass found = classify(scaled(moved, factor));
        ASSERT_EQ(found.type, normal.type) << name_of(found.type) << ", case " << i << ", factor " << factor;
        EXPECT_NE(found.rung, Rung::none);
      }
      const QuadricClass exactly = classify(in_rationals(moved));
      EXPECT_EQ(exactly.type, normal.type);
      EXPECT_EQ(exactly.rung, Rung::exact);
    }
}

/// A projective map moves the quadric and the plane at infinity together.
TEST(QuadricClass, GoesWithThePlaneAtInfinity) {
  Random random("QuadricClass.GoesWithThePlaneAtInfinity");
  for (const Normal& normal : normal_forms())
    for (int i = 0; i < 40; ++i) {
      const Matrix<double, 4, 4> H = random_unimodular<4>(random, false);
      const Q moved = substituted(normal.quadric, H);
      const Point3<double> infinity = H.row(3);
      EXPECT_EQ(classify(moved, infinity).type, normal.type) << "case " << i;
      EXPECT_EQ(classify(moved, Point3<double>(-0x1.8p-30 * infinity)).type, normal.type) << "case " << i;
    }
}

TEST(QuadricClass, DependsOnThePlaneAtInfinity) {
  const Q sphere{{1, 1, 1, -1}}, saddle{{1, 1, -1, -1}};
  EXPECT_EQ(classify(sphere, {1, 0, 0, 0}).type, hyperboloid_of_two_sheets);
  EXPECT_EQ(classify(sphere, {1, 0, 0, 1}).type, elliptic_paraboloid);
  EXPECT_EQ(classify(sphere, {1, 0, 0, std::nextafter(1, 2)}).type, ellipsoid);
  EXPECT_EQ(classify(sphere, {1, 0, 0, std::nextafter(1, 0)}).type, hyperboloid_of_two_sheets);
  EXPECT_EQ(classify(saddle).type, hyperboloid_of_one_sheet);
  EXPECT_EQ(classify(saddle, {1, 0, 1, 0}).type, hyperbolic_paraboloid);
  EXPECT_EQ(classify(saddle, {1, 0, std::nextafter(1, 0), 0}).type, hyperboloid_of_one_sheet);
}

/// A step of one unit in the last place (of 0 too) in the coefficient of w^2.
TEST(QuadricClass, IsDecidedByTheLastBit) {
  Random random("QuadricClass.IsDecidedByTheLastBit");
  for (int i = 0; i < 100; ++i) {
    const Matrix<double, 4, 4> H = random_unimodular<4>(random, true);
    const auto type = [&H](const Q& form, double toward) {
      Q s = substituted(form, H);
      s.q[3] = std::nextafter(s.q[3], toward * INFINITY);
      return classify(s).type;
    };
    EXPECT_EQ(type({{1, 2, -3, 0}}, 1), hyperboloid_of_two_sheets) << i;
    EXPECT_EQ(type({{1, 2, -3, 0}}, -1), hyperboloid_of_one_sheet) << i;
    EXPECT_EQ(type({{1, 2, 3, 0}}, 1), imaginary_ellipsoid) << i;
    EXPECT_EQ(type({{1, 2, 3, 0}}, -1), ellipsoid) << i;
    EXPECT_EQ(type({{1, -2, 0, 0}}, 1), hyperbolic_cylinder) << i;
    EXPECT_EQ(type({{1, 2, 0, 0}}, -1), elliptic_cylinder) << i;
    EXPECT_EQ(type({{1, 0, 0, 0}}, -1), parallel_planes) << i;
    EXPECT_EQ(type({{1, 0, 0, 0}}, 1), complex_parallel_planes) << i;
  }
}

TEST(QuadricClass, GenericQuadricsNeedNoExactArithmetic) {
  Random random("QuadricClass.GenericQuadricsNeedNoExactArithmetic");
  for (int i = 0; i < 500; ++i) {
    Q s;
    for (double& q : s.q) q = random.normal();
    const QuadricClass found = classify(s);
    EXPECT_EQ(found.rung, Rung::intervals) << i;
    EXPECT_EQ(found.type, classify(in_rationals(s)).type) << i;
  }
}

TEST(CentreOf, HasThePlaneAtInfinityForItsPolar) {
  Random random("CentreOf.HasThePlaneAtInfinityForItsPolar");
  for (const Normal& normal : normal_forms()) {
    if (normal.type > hyperbolic_paraboloid) continue;  // singular
    for (int i = 0; i < 40; ++i) {
      const Matrix<double, 4, 4> H = random_unimodular<4>(random, false);
      const Point3<double> infinity = H.row(3), centre = centre_of(substituted(normal.quadric, H), infinity);
      const Point3<double> there =
          H * centre;  // (0, 0, 0, 1) or the direction of the paraboloid's axis, (0, 0, 1, 0)
      const bool central = normal.quadric.q[9] == 0;
      for (int k = 0; k < 4; ++k)
        if (k != (central ? 3 : 2)) {
          EXPECT_LT(std::abs(there[k]), 1e-11 * H.norm()) << i;
        }
    }
  }
}

/// Eigenvalues and vectors are those of a matrix a few roundoffs away, and X sums four terms of size |corner|.
TEST(Rulings, LieOnTheQuadric) {
  Random random("Rulings.LieOnTheQuadric");
  int ruled = 0;
  for (int i = 0; i < 1000; ++i) {
    Q s;
    for (double& q : s.q) q = random.normal();
    if (i % 2) s = substituted({{1, -2, 0, 0, 0, 0, 0, 0, 0, -1}}, random_unimodular<4>(random, true));
    const QuadricType type = classify(s).type;
    if (type != hyperboloid_of_one_sheet && type != hyperbolic_paraboloid) continue;
    ++ruled;
    const Rulings X = rulings_of(s);
    double corner = 0;
    for (const auto& pair : X.corner)
      for (const auto& p : pair) corner += p.norm();
    const double bound = 256 * unit_roundoff * size_of(s) * corner * corner;
    Matrix<double, 4, 4> frame;
    for (int k = 0; k < 4; ++k)
      frame.col(k) = X.corner[static_cast<std::size_t>(k / 2)][static_cast<std::size_t>(k % 2)].normalized();
    EXPECT_GT(std::abs(frame.determinant()), 1e-9) << i;
    for (int k = 0; k < 10; ++k) {
      const Vector<double, 2> u(std::cos(k), std::sin(k)), v(std::cos(2 * k + 1), std::sin(2 * k + 1)),
          w(-v[1], v[0]);
      EXPECT_LE(std::abs(s(X(u, v))), bound) << i;
      EXPECT_LE(std::abs(s.polar(X(u, v), X(u, w))), 2 * bound) << i;  // a line of the first family
      EXPECT_LE(std::abs(s.polar(X(v, u), X(w, u))), 2 * bound) << i;  // and of the second
    }
  }
  EXPECT_GT(ruled, 600);
}

}  // namespace
}  // namespace burmester
