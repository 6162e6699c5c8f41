#include "burmester/geometry/common_points.hpp"

#include <gtest/gtest.h>

#include "planted_conics.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using Point = Point2<double>;

CommonPoints<double> solve(const ConicPair& pair) {
  return regular_common_points(pair.a, pair.b, pencil_determinant(pair.a, pair.b));
}

Point to_double(const QuadPoint& p) { return {approximate(p[0]), approximate(p[1]), approximate(p[2])}; }

/// Sine of the angle between two homogeneous vectors.
double apart(const Point& p, const Point& q) { return p.cross(q).norm() / (p.norm() * q.norm()); }

double nearest(const Point& p, const CommonPoints<double>& points) {
  double least = 1;
  for (int i = 0; i < points.count; ++i) least = std::min(least, apart(p, points.point[i]));
  return least;
}

/// Change of a common point per change of the values of two conics of size 1.
double condition(const ConicPair& pair, const Point& at) {
  const Point p = at.normalized(), ga = pair.a.gradient(p), gb = pair.b.gradient(p);
  return (ga.norm() + gb.norm()) / std::abs(ga.dot(gb.cross(p)));
}

/// The Newton step that callers take, orthogonal to p.
Point polished(const ConicPair& pair, const Point& p) {
  const Point ga = pair.a.gradient(p), gb = pair.b.gradient(p), across = gb.cross(p);
  return p - (pair.a(p) * across + pair.b(p) * p.cross(ga)) / ga.dot(across);
}

// The rounding of the conics to double alone moves a point by sqrt(6) unit roundoffs times its condition, the
// evaluation of two conics in the Newton step by some 10 more. The worst condition of the four counts for all
// of them.
constexpr double few = 64;

double tolerance(const ConicPair& pair) {
  double worst = 1;
  for (const QuadPoint& p : pair.common) worst = std::max(worst, condition(pair, to_double(p)));
  return few * unit_roundoff * worst;
}

void expect_planted(const ConicPair& pair, const std::string& label) {
  CommonPoints<double> found = solve(pair);
  ASSERT_EQ(found.count, static_cast<int>(pair.common.size())) << label;
  for (int i = 0; i < found.count; ++i) {
    const double size = found.point[i].cwiseAbs().maxCoeff();
    EXPECT_TRUE(1 <= size && size < 2) << label;
    found.point[i] = polished(pair, found.point[i]);
  }
  for (const QuadPoint& p : pair.common)
    EXPECT_LT(nearest(to_double(p), found), tolerance(pair)) << label << ": " << to_double(p).transpose();
}

template <class Make>
void expect_planted_in_many(const std::string& stream, Make make) {
  Random random(stream);
  for (int i = 0; i < 2000; ++i) expect_planted(make(random), stream + ", case " + std::to_string(i));
}

TEST(CommonPoints, FourRealOnes) {
  expect_planted_in_many("CommonPoints.FourRealOnes", [](Random& r) {
    const QuadPoint p = random_point(r), q = random_point(r), u = random_point(r);
    return through(p, q, u, random_point(r), r);
  });
}

TEST(CommonPoints, TwoRealOnes) {
  expect_planted_in_many("CommonPoints.TwoRealOnes", [](Random& r) {
    const QuadPoint p = random_point(r), q = random_point(r), x = random_point(r);
    return through_two_real(p, q, x, random_point(r), r);
  });
}

TEST(CommonPoints, NoRealOne) {
  expect_planted_in_many("CommonPoints.NoRealOne", [](Random& r) {
    const QuadPoint x = random_point(r), y = random_point(r), v = random_point(r);
    return through_none_real(x, y, v, random_point(r), r);
  });
}

QuadPoint at_infinity(Random& random) {
  QuadPoint p = random_point(random);
  p[2] = 0;
  return p;
}

TEST(CommonPoints, RealOnesAtInfinity) {
  expect_planted_in_many("CommonPoints.RealOnesAtInfinity", [](Random& r) {
    const QuadPoint p = random_point(r), q = random_point(r), u = at_infinity(r);
    return through(p, q, u, at_infinity(r), r);
  });
}

TEST(CommonPoints, OfTwoCircles) {  // the circular points (1, +-i, 0) are the other two
  expect_planted_in_many("CommonPoints.OfTwoCircles", [](Random& r) {
    const QuadPoint p = random_point(r), q = random_point(r);
    return through_two_real(p, q, {Quad(1), Quad(0), Quad(0)}, {Quad(0), Quad(1), Quad(0)}, r);
  });
}

TEST(CommonPoints, OfTheTextbookCircles) {
  // radius 5 about (0, 0) and (6, 0)
  ConicPair pair{Conic<double>({1, 1, -25, 0, 0, 0}), Conic<double>({1, 1, 11, 0, -12, 0}), {}};
  pair.common = {{Quad(3), Quad(4), Quad(1)}, {Quad(3), Quad(-4), Quad(1)}};
  expect_planted(pair, "circles");
}

Matrix<double, 3, 3> random_map(Random& random) {
  Matrix<double, 3, 3> m;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m(r, c) = random.normal();
  return m;
}
Conic<double> mapped(const Conic<double>& c,
                     const Matrix<double, 3, 3>& m) {  // x is on the result where m x is on c
  Matrix<double, 3, 3> doubled;
  doubled << 2 * c.q[0], c.q[5], c.q[4], c.q[5], 2 * c.q[1], c.q[3], c.q[4], c.q[3], 2 * c.q[2];
  const Matrix<double, 3, 3> d = m.transpose() * doubled * m;
  Conic<double> out({d(0, 0) / 2, d(1, 1) / 2, d(2, 2) / 2, d(1, 2), d(0, 2), d(0, 1)});
  const double scale = unit_scale(size_of(out));
  for (double& q : out.q) q *= scale;
  return out;
}

TEST(CommonPoints, AreInvariantUnderProjectiveMaps) {
  Random random("CommonPoints.AreInvariantUnderProjectiveMaps");
  for (int i = 0; i < 500; ++i) {
    const QuadPoint p = random_point(random), q = random_point(random), u = random_point(random);
    const ConicPair pair = i % 2 ? through(p, q, u, random_point(random), random)
                                 : through_two_real(p, q, u, random_point(random), random);
    const Matrix<double, 3, 3> m = random_map(random), inverse = m.inverse();
    const ConicPair image{mapped(pair.a, m), mapped(pair.b, m), {}};
    CommonPoints<double> found = solve(pair), there = solve(image);
    ASSERT_EQ(found.count, there.count) << "case " << i;
    for (int k = 0; k < found.count; ++k) {
      found.point[k] = polished(pair, found.point[k]);
      there.point[k] = polished(image, there.point[k]);
    }
    const double stretch = m.norm() * inverse.norm();
    for (int k = 0; k < found.count; ++k) {
      const Point expected = inverse * found.point[k];
      const double there_too = few * unit_roundoff * condition(image, expected);
      EXPECT_LT(nearest(expected, there), stretch * stretch * (tolerance(pair) + there_too)) << "case " << i;
    }
  }
}

// Members through u and v that touch the line l at p: a double point may be seen as none, one or two.
TEST(CommonPoints, TangencyLeavesTheSimplePoints) {
  Random random("CommonPoints.TangencyLeavesTheSimplePoints");
  for (int i = 0; i < 1000; ++i) {
    const QuadPoint p = random_point(random), u = random_point(random), v = random_point(random);
    const QuadPoint l = p.cross(random_point(random));
    const ConicPair pair =
        random_members(line_pair(l, u.cross(v)), line_pair(p.cross(u), p.cross(v)), {u, v}, random);
    const CommonPoints<double> found = solve(pair);
    const double root_of_rounding = std::sqrt(few * tolerance(pair));
    for (const QuadPoint& simple : pair.common)
      EXPECT_LT(nearest(to_double(simple), found), root_of_rounding) << "case " << i;
    for (int k = 0; k < found.count; ++k) {
      const double away = std::min({apart(found.point[k], to_double(p)), apart(found.point[k], to_double(u)),
                                    apart(found.point[k], to_double(v))});
      EXPECT_LT(away, std::sqrt(root_of_rounding)) << "case " << i;
    }
  }
}

constexpr double tiny = 1e-12;  // what counts as zero in conics of size 1

/// Six coefficients below 2, each rounded once, enter with cofactors up to 32: 2 * 6 * 32 unit roundoffs, and
/// the rounding of the evaluation.
void expect_zero_pencil(const ConicPair& pair, const std::string& label) {
  for (const double c : pencil_determinant(pair.a, pair.b))
    EXPECT_LT(std::abs(c), 512 * unit_roundoff) << label;
}

TEST(DegeneratePencil, SharedLine) {
  Random random("DegeneratePencil.SharedLine");
  for (int i = 0; i < 1000; ++i) {
    const std::string label = "case " + std::to_string(i);
    const QuadPoint shared = random_point(random), l = random_point(random), m = random_point(random);
    const ConicPair pair = random_members(line_pair(shared, l), line_pair(shared, m), {l.cross(m)}, random);
    expect_zero_pencil(pair, label);
    const CommonPoints<double> found = degenerate_common_points(pair.a, pair.b, tiny);
    ASSERT_EQ(found.kind, PencilKind::common_line) << label;
    EXPECT_LT(apart(found.line, to_double(shared)), 1e-10) << label;
    ASSERT_EQ(found.count, 1) << label;
    EXPECT_LT(apart(found.point[0], to_double(pair.common[0])), 1e-9) << label;
  }
}

TEST(DegeneratePencil, SharedLineThroughTheCommonPointOfTheOthers) {
  const QuadPoint shared{Quad(1), Quad(2), Quad(-3)}, l{Quad(1), Quad(-1), Quad(0)},
      m{Quad(2), Quad(1), Quad(-3)};
  ASSERT_EQ(shared.dot(l.cross(m)), 0);
  const auto found =
      degenerate_common_points(rounded(line_pair(shared, l)), rounded(line_pair(shared, m)), tiny);
  EXPECT_EQ(found.kind, PencilKind::common_line);
  EXPECT_EQ(found.count, 0);
}

TEST(DegeneratePencil, SharedLineThatOneMemberHoldsTwice) {
  Random random("DegeneratePencil.SharedLineThatOneMemberHoldsTwice");
  for (int i = 0; i < 100; ++i) {
    const QuadPoint shared = random_point(random), m = random_point(random);
    const auto twice = rounded(line_pair(shared, shared)), once = rounded(line_pair(shared, m));
    for (const auto& found :
         {degenerate_common_points(twice, once, tiny), degenerate_common_points(once, twice, tiny)}) {
      ASSERT_EQ(found.kind, PencilKind::common_line) << "case " << i;
      EXPECT_LT(apart(found.line, to_double(shared)), 1e-10) << "case " << i;
      EXPECT_EQ(found.count, 0) << "case " << i;
    }
  }
}

TEST(DegeneratePencil, CommonVertexOfTwoDoubleLines) {
  Random random("DegeneratePencil.CommonVertexOfTwoDoubleLines");
  for (int i = 0; i < 100; ++i) {
    const QuadPoint l = random_point(random), m = random_point(random);
    const auto found = degenerate_common_points(rounded(line_pair(l, l)), rounded(line_pair(m, m)), tiny);
    ASSERT_EQ(found.kind, PencilKind::common_vertex) << "case " << i;
    EXPECT_LT(apart(found.point[0], to_double(l.cross(m))), 1e-10) << "case " << i;
  }
}

// Their cubic is a third power, not zero: the caller must ask.
TEST(Proportional, SeesMultiplesAndZeroOnly) {
  Random random("Proportional.SeesMultiplesAndZeroOnly");
  for (int i = 0; i < 100; ++i) {
    Conic<double> a, b, c;
    for (int k = 0; k < 6; ++k) a.q[k] = random.normal(), b.q[k] = -0.7 * a.q[k], c.q[k] = random.normal();
    EXPECT_TRUE(proportional(a, b, tiny) && proportional(a, Conic<double>(), tiny));
    EXPECT_FALSE(proportional(a, c, tiny));
    EXPECT_LT(std::abs(relative_discriminant(pencil_determinant(a, b))), 512 * unit_roundoff) << "case " << i;
  }
}

TEST(DegeneratePencil, ProportionalConics) {
  Random random("DegeneratePencil.ProportionalConics");
  for (int i = 0; i < 100; ++i) {
    Conic<double> a, b, zero;
    for (int k = 0; k < 6; ++k) a.q[k] = random.normal(), b.q[k] = -0.7 * a.q[k];
    EXPECT_EQ(degenerate_common_points(a, b, tiny).kind, PencilKind::same_conic);
    EXPECT_EQ(degenerate_common_points(a, zero, tiny).kind, PencilKind::same_conic);
    EXPECT_EQ(degenerate_common_points(zero, zero, tiny).kind, PencilKind::same_conic);
    EXPECT_EQ(degenerate_common_points(a, b, tiny).count, 0);
  }
}

TEST(DegeneratePencil, CommonVertex) {
  Random random("DegeneratePencil.CommonVertex");
  for (int i = 0; i < 1000; ++i) {
    const std::string label = "case " + std::to_string(i);
    const QuadPoint vertex = random_point(random);
    const auto line = [&] { return QuadPoint(vertex.cross(random_point(random))); };
    const QuadPoint k = line(), l = line(), m = line();
    const ConicPair pair = random_members(line_pair(k, l), line_pair(m, line()), {vertex}, random);
    expect_zero_pencil(pair, label);
    const CommonPoints<double> found = degenerate_common_points(pair.a, pair.b, tiny);
    ASSERT_EQ(found.kind, PencilKind::common_vertex) << label;
    ASSERT_EQ(found.count, 1) << label;
    EXPECT_LT(apart(found.point[0], to_double(vertex)), 1e-9) << label;
  }
}

TEST(PencilSeparation, IsThatOfTheLines) {
  Random random("PencilSeparation.IsThatOfTheLines");
  for (int i = 0; i < 100; ++i) {
    const Point2<Rational> l = random_rationals<3>(random), m = random_rationals<3>(random);
    Conic<Rational> a, b;  // a + 3 b = l m
    for (Rational& q : b.q) q = random_rational(random);
    a.add_product(l, m, 1);
    if (size_of(a) == 0) continue;
    Rational size2 = 0;
    for (const Rational& q : a.q) size2 += q * q;
    a = pencil_member(a, Rational(1), b, Rational(-3));
    EXPECT_EQ(PencilSeparation<Rational>(a, b)(1, 3) * size2, Rational(l.cross(m).squaredNorm()))
        << "case " << i;
  }
}

TEST(Split, GivesTheTwoLines) {
  Random random("Split.GivesTheTwoLines");
  for (int i = 0; i < 1000; ++i) {
    const QuadPoint l = random_point(random), m = random_point(random);
    const LinePair<double> pair = detail::split(rounded(line_pair(l, m)));
    ASSERT_GT(pair.separation, 0) << "case " << i;
    const double limit = few * unit_roundoff / std::pow(apart(to_double(l), to_double(m)), 2);
    const bool exchanged = apart(pair.first, to_double(m)) < apart(pair.first, to_double(l));
    EXPECT_LT(apart(exchanged ? pair.second : pair.first, to_double(l)), limit) << "case " << i;
    EXPECT_LT(apart(exchanged ? pair.first : pair.second, to_double(m)), limit) << "case " << i;
  }
  EXPECT_FALSE(detail::split(Conic<double>({1, 1, 0, 0, 0, 0})).separation > 0);  // complex lines
  EXPECT_EQ(detail::split(Conic<double>({1, 0, 0, 0, 0, 0})).separation, 0);      // a double line
}

}  // namespace
}  // namespace burmester
