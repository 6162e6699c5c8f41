#include "burmester/geometry/conic.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/rational.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using Point = Point2<Rational>;

Conic<Rational> random_conic(Random& random) {
  Conic<Rational> c;
  for (Rational& q : c.q) q = random_rational(random);
  return c;
}

/// 2 M
Matrix<Rational, 3, 3> matrix(const Conic<Rational>& c) {
  Matrix<Rational, 3, 3> m;
  m << 2 * c.q[0], c.q[5], c.q[4], c.q[5], 2 * c.q[1], c.q[3], c.q[4], c.q[3], 2 * c.q[2];
  return m;
}
Matrix<Rational, 3, 3> matrix(const Adjugate<Rational>& a) {
  Matrix<Rational, 3, 3> m;
  m << a.xx, a.xy, a.xz, a.xy, a.yy, a.yz, a.xz, a.yz, a.zz;
  return m;
}
Rational determinant(const Matrix<Rational, 3, 3>& m) { return m.col(0).cross(m.col(1)).dot(m.col(2)); }

TEST(Conic, ValueAndPolarFormAreTheMatrix) {
  Random random("Conic.ValueAndPolarFormAreTheMatrix");
  for (int i = 0; i < 100; ++i) {
    const Conic<Rational> c = random_conic(random);
    const Point u = random_rationals<3>(random), v = random_rationals<3>(random);
    EXPECT_EQ(2 * c(u), Rational(u.dot(matrix(c) * u)));
    EXPECT_EQ(c.polar(u, v), Rational(u.dot(matrix(c) * v)));
    EXPECT_EQ(c.gradient(u), matrix(c) * u);
  }
}

TEST(Conic, AddProductAddsAPairOfLines) {
  Random random("Conic.AddProductAddsAPairOfLines");
  for (int i = 0; i < 100; ++i) {
    const Conic<Rational> c = random_conic(random);
    const Point l = random_rationals<3>(random), m = random_rationals<3>(random),
                x = random_rationals<3>(random);
    Conic<Rational> d = c;
    d.add_product(l, m, -3);
    EXPECT_EQ(d(x), c(x) - 3 * Rational(l.dot(x)) * Rational(m.dot(x)));
  }
}

TEST(Conic, PencilMembersAreCombinations) {
  Random random("Conic.PencilMembersAreCombinations");
  const Conic<Rational> a = random_conic(random), b = random_conic(random);
  const Point x = random_rationals<3>(random);
  EXPECT_EQ(pencil_member(a, Rational(3), b, Rational(-2, 7))(x), 3 * a(x) - Rational(2, 7) * b(x));
  EXPECT_EQ(size_of(Conic<double>({1, -3, 2, 0.5, 0, 0})), 3);
}

TEST(Adjugate, TimesTheMatrixIsTheDeterminant) {
  Random random("Adjugate.TimesTheMatrixIsTheDeterminant");
  for (int i = 0; i < 100; ++i) {
    const Conic<Rational> c = random_conic(random), n = random_conic(random);
    const Adjugate<Rational> adj(c);
    const Rational det = determinant(matrix(c));
    EXPECT_EQ(matrix(adj) * matrix(c), (Matrix<Rational, 3, 3>(det * Matrix<Rational, 3, 3>::Identity())));
    EXPECT_EQ(adj.determinant(c), det);
    EXPECT_EQ(adj.trace(), matrix(adj).trace());
    EXPECT_EQ(adj.trace_with(n), (matrix(adj) * matrix(n)).trace());
  }
}

TEST(Adjugate, OfAPairOfLinesIsTheirCommonPoint) {
  Random random("Adjugate.OfAPairOfLinesIsTheirCommonPoint");
  for (int i = 0; i < 100; ++i) {
    const Point l = random_rationals<3>(random), m = random_rationals<3>(random), p = l.cross(m);
    Conic<Rational> c;
    c.add_product(l, m, 1);
    EXPECT_EQ(matrix(Adjugate<Rational>(c)), -p * p.transpose());
  }
}

TEST(PencilDeterminant, IsTheDeterminantOfEveryMember) {
  Random random("PencilDeterminant.IsTheDeterminantOfEveryMember");
  for (int i = 0; i < 100; ++i) {
    const Conic<Rational> a = random_conic(random), b = random_conic(random);
    const Rational s = random_rational(random), t = random_rational(random);
    const auto c = pencil_determinant(a, b);
    EXPECT_EQ(c[0] * s * s * s + c[1] * s * s * t + c[2] * s * t * t + c[3] * t * t * t,
              determinant(matrix(pencil_member(a, s, b, t))));
  }
}

}  // namespace
}  // namespace burmester
