#include "burmester/geometry/quadric.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/quad.hpp"

namespace burmester {
namespace {

using Integers = Quadric<long long>;
constexpr Integers integers{{2, -3, 5, 7, -11, 13, 17, -19, 23, 29}};

TEST(Quadric, ValueIsTheSumOfItsTerms) {
  const Point3<long long> x(2, -3, 5, 7);
  const long long expected = 2 * 4 - 3 * 9 + 5 * 25 + 7 * 49 - 11 * 2 * -3 + 13 * 2 * 5 + 17 * 2 * 7 - 19 * -3 * 5 +
                             23 * -3 * 7 + 29 * 5 * 7;
  EXPECT_EQ(integers(x), expected);
}

TEST(Quadric, PolarFormPolarises) {
  const Point3<long long> u(2, -3, 5, 7), v(1, 4, -6, 3);
  EXPECT_EQ(integers.polar(u, u), 2 * integers(u));
  EXPECT_EQ(integers.polar(u, v), integers.polar(v, u));
  EXPECT_EQ(integers(u + v), integers(u) + integers(v) + integers.polar(u, v));
}

TEST(Quadric, AddProductAddsAPairOfPlanes) {
  const Point3<long long> l(1, -2, 3, 5), m(-4, 7, 2, 1), x(2, -3, 5, 7);
  Integers s = integers;
  s.add_product(l, m, 6);
  EXPECT_EQ(s(x), integers(x) + 6 * l.dot(x) * m.dot(x));
}

TEST(Quadric, SizeIsThatOfTheLargestCoefficient) {
  EXPECT_EQ(size_of(integers), 29);
  EXPECT_EQ(size_of(Quadric<double>{{0, 0, -0.5, 0, 0.25}}), 0.5);
  EXPECT_EQ(size_of(Quadric<Quad>{}), 0);
}

}  // namespace
}  // namespace burmester
