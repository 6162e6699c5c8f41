// Common points of conics: pencils of every kind with planted points, moved by projective maps with integer entries.
#include "burmester/geometry/conic_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "burmester/geometry/conic_count.hpp"
#include "burmester/geometry/degenerate_pencil.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "planted_conics.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using Point = Point2<Rational>;
using Matrix3 = Matrix<Rational, 3, 3>;
using ConicQ = Conic<Rational>;

struct PlantedPoint {
  std::array<int, 3> at;
  int multiplicity;
};

struct PlantedPencil {
  std::string name;
  std::array<int, 6> a, b;  // x^2 y^2 z^2 yz xz xy
  std::vector<PlantedPoint> points;
  PencilKind kind = PencilKind::regular;
  std::array<int, 3> line = {0, 0, 0};
};

const std::vector<PlantedPencil>& pencils() {
  constexpr std::array<int, 3> o{0, 0, 1};
  static const std::vector<PlantedPencil> all{
      {"four points",
       {1, 0, -1, 0, 0, 0},
       {0, 1, -1, 0, 0, 0},
       {{{1, 1, 1}, 1}, {{1, -1, 1}, 1}, {{-1, 1, 1}, 1}, {{-1, -1, 1}, 1}}},
      {"two points", {1, 1, -1, 0, 0, 0}, {0, 1, 0, -3, 0, 0}, {{{1, 0, 1}, 1}, {{-1, 0, 1}, 1}}},
      {"none", {1, 0, 1, 0, 0, 0}, {0, 1, 1, 0, 0, 0}, {}},
      {"none, one conic without points", {1, 1, 1, 0, 0, 0}, {1, 2, -1, 1, 0, 0}, {}},
      {"tangent, two more", {-1, 0, 0, 1, 0, 0}, {0, 1, 0, -1, 0, 0}, {{o, 2}, {{1, 1, 1}, 1}, {{-1, 1, 1}, 1}}},
      {"tangent, two more complex", {-1, 0, 0, 1, 0, 0}, {0, 1, 0, 1, 0, 0}, {{o, 2}}},
      {"isolated point", {1, 1, 0, 0, 0, 0}, {-1, 0, 0, 1, 0, 0}, {{o, 2}}},
      {"osculating", {-1, 0, 0, 1, 0, 0}, {0, -1, 0, 0, 0, 1}, {{o, 3}, {{1, 1, 1}, 1}}},
      {"fourfold", {-1, 0, 0, 1, 0, 0}, {0, 1, 0, 0, 0, 0}, {{o, 4}}},
      {"double contact", {1, 1, -1, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {{{1, 0, 1}, 2}, {{-1, 0, 1}, 2}}},
      {"complex double contact", {1, 1, -1, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {}},
      {"line pairs through a vertex",
       {0, 0, 0, 0, 0, 1},
       {1, -1, 0, 1, -1, 0},
       {{o, 2}, {{0, 1, 1}, 1}, {{1, 0, 1}, 1}}},
      {"tangent to a line at the vertex", {0, 0, 0, 0, 0, 1}, {0, -1, 0, 0, 1, 0}, {{o, 3}, {{1, 0, 0}, 1}}},
      {"double line", {1, 0, 0, 0, 0, 0}, {0, 1, -1, 0, 0, 1}, {{{0, 1, 1}, 2}, {{0, -1, 1}, 2}}},
      {"tangent double line", {1, 0, 0, 0, 0, 0}, {0, -1, 0, 0, 1, 0}, {{o, 4}}},
      {"vertex", {0, 0, 0, 0, 0, 1}, {1, -1, 0, 0, 0, 0}, {{o, 4}}, PencilKind::common_vertex},
      {"vertex of complex lines", {1, 1, 0, 0, 0, 0}, {1, 3, 0, 0, 0, 1}, {{o, 4}}, PencilKind::common_vertex},
      {"two double lines", {1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {{o, 4}}, PencilKind::common_vertex},
      {"line and point", {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}, {{{1, 0, 0}, 1}}, PencilKind::common_line, {1, 0, 0}},
      {"concurrent lines", {0, 0, 0, 0, 0, 1}, {1, 0, 0, 0, 0, 2}, {}, PencilKind::common_line, {1, 0, 0}},
      {"line and double line", {1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 1}, {}, PencilKind::common_line, {1, 0, 0}},
      {"proportional", {1, 2, 3, 4, 5, 6}, {-2, -4, -6, -8, -10, -12}, {}, PencilKind::same_conic},
      {"a conic that is zero", {1, 2, 3, 4, 5, 6}, {0, 0, 0, 0, 0, 0}, {}, PencilKind::same_conic},
  };
  return all;
}

ConicQ conic(const std::array<int, 6>& q) {
  ConicQ out;
  std::copy(q.begin(), q.end(), out.q.begin());
  return out;
}

/// Q(M x)
ConicQ pulled_back(const ConicQ& c, const Matrix3& m) {
  const Point u = m.col(0), v = m.col(1), w = m.col(2);
  return ConicQ({c(u), c(v), c(w), c.polar(v, w), c.polar(u, w), c.polar(u, v)});
}

Matrix3 adjugate(const Matrix3& m) {
  const Point u = m.col(0), v = m.col(1), w = m.col(2);
  Matrix3 out;
  out << v.cross(w).transpose(), w.cross(u).transpose(), u.cross(v).transpose();
  return out;
}

Rational determinant(const Matrix3& m) { return Point(m.col(0)).dot(Point(m.col(1)).cross(Point(m.col(2)))); }

Matrix3 random_map(Random& random, int size) {
  for (;;) {
    Matrix3 m;
    for (int i = 0; i < 9; ++i) m(i) = random.below(2 * size + 1) - size;
    if (determinant(m) != 0) return m;
  }
}

bool contains(const ProjectivePointBox& box, const Point& p) {
  if (p[box.unit] == 0) return false;
  for (int i = 0; i < 3; ++i) {
    const Rational x = p[i] / p[box.unit];
    const Range& at = box.at[static_cast<std::size_t>(i)];
    if (!(Rational(at.low) <= x && x <= Rational(at.high))) return false;
  }
  return true;
}

double width(const ProjectivePointBox& box) {
  double out = 0;
  for (const Range& x : box.at) out = std::max(out, x.high - x.low);
  return out;
}

void expect_planted(const PlantedPencil& planted, const CertifiedCommonPoints& found, const Matrix3& m,
                    const std::string& label) {
  ASSERT_EQ(found.kind, planted.kind) << label;
  ASSERT_EQ(found.points.size(), planted.points.size()) << label;
  EXPECT_NE(found.rung, Rung::none) << label;
  const Matrix3 inverse = adjugate(m);
  for (const auto& [at, multiplicity] : planted.points) {
    const Point p = inverse * Point(Rational(at[0]), Rational(at[1]), Rational(at[2]));
    int hits = 0;
    for (const CertifiedCommonPoint& point : found.points) {
      if (!contains(point.box, p)) continue;
      ++hits;
      EXPECT_EQ(point.multiplicity, multiplicity) << label;
      EXPECT_LT(width(point.box), 1e-10) << label;
      EXPECT_EQ(point.box.at[static_cast<std::size_t>(point.box.unit)].low, 1) << label;
    }
    EXPECT_EQ(hits, 1) << label;
  }
  if (planted.kind == PencilKind::common_line) {
    const Point line =
        m.transpose() * Point(Rational(planted.line[0]), Rational(planted.line[1]), Rational(planted.line[2]));
    EXPECT_TRUE(contains(found.line, line)) << label;
  }
}

/// Small enough for doubles to be exact.
Conic<double> in_doubles(const ConicQ& c) {
  Conic<double> out;
  for (std::size_t i = 0; i < 6; ++i) out.q[i] = static_cast<double>(c.q[i]);
  return out;
}

TEST(CertifiedCommonPoints, ArePlantedOnesInEveryPositionOfEveryPencil) {
  Random random("CertifiedCommonPoints.ArePlantedOnesInEveryPositionOfEveryPencil");
  const std::array<int, 4> mixes[] = {{1, 0, 0, 1}, {0, 1, 1, 0}, {1, 2, 1, -1}, {3, -1, 2, 5}};
  for (const PlantedPencil& planted : pencils())
    for (int n = 0; n < 40; ++n) {
      const Matrix3 m = n == 0 ? Matrix3(Matrix3::Identity()) : random_map(random, n < 20 ? 1 : 9);
      const auto& [s, t, u, v] = mixes[n % 4];
      const ConicQ a = pulled_back(conic(planted.a), m), b = pulled_back(conic(planted.b), m);
      const ConicQ c = pencil_member(a, Rational(s), b, Rational(t)), d = pencil_member(a, Rational(u), b, Rational(v));
      const std::string label = planted.name + " " + std::to_string(n);
      expect_planted(planted, certified_common_points(in_doubles(c), in_doubles(d)), m, label + ", doubles");
      expect_planted(planted, certified_common_points_exactly(c, d), m, label + ", exactly");
      if (n % 10 != 0) continue;
      const ConicQ third = pencil_member(c, Rational(1, 3), d, Rational(0));
      const ConicQ huge = pencil_member(c, Rational(0), d, Rational(Integer(1) << 2000));
      expect_planted(planted, certified_common_points(third, huge), m, label + ", fractions");
      expect_planted(planted, certified_common_points_exactly(third, huge), m, label + ", fractions exactly");
      const ConicQ tiny = pencil_member(c, Rational(1) / Rational(Integer(1) << 2000), d, Rational(0));
      expect_planted(planted, certified_common_points_exactly(tiny, d), m, label + ", tiny fractions");
    }
}

TEST(CertifiedCommonPoints, OfRandomConicsAreAsManyAsCounted) {
  Random random("CertifiedCommonPoints.OfRandomConicsAreAsManyAsCounted");
  std::array<int, 5> seen{};
  for (int n = 0; n < 1000; ++n) {
    ConicQ a, b;
    for (Rational& q : a.q) q = random.below(11) - 5;
    for (Rational& q : b.q) q = random.below(11) - 5;
    const CertifiedCommonPoints found = certified_common_points_exactly(a, b);
    const auto count = count_common_points(a, b);
    if (count) {
      EXPECT_EQ(static_cast<int>(found.points.size()), *count) << n;
      ++seen[static_cast<std::size_t>(*count)];
    }
    int counted = 0;
    for (const CertifiedCommonPoint& point : found.points) {
      counted += point.multiplicity;
      Point2<RationalInterval> p;
      for (int i = 0; i < 3; ++i) {
        const Range& x = point.box.at[static_cast<std::size_t>(i)];
        p[i] = RationalInterval(x.low, x.high);
      }
      for (const ConicQ& c : {a, b}) {
        Conic<RationalInterval> wide;
        for (std::size_t i = 0; i < 6; ++i) wide.q[i] = RationalInterval(c.q[i]);
        EXPECT_TRUE(contains_zero(wide(p))) << n;
      }
    }
    if (found.kind == PencilKind::regular) {
      EXPECT_EQ(counted % 2, 0) << n;  // complex ones come in pairs
    }
  }
  EXPECT_GT(seen[0], 50);
  EXPECT_GT(seen[2], 300);
  EXPECT_GT(seen[4], 50);
}

/// A change of one coefficient that doubles do not see makes members regular, or conics different.
TEST(DegeneratePencil, IsToldExactly) {
  const Rational tiny = Rational(1) / Rational(Integer(1) << 2000);
  for (const PlantedPencil& planted : pencils()) {
    const auto degenerate = degenerate_common_points_exactly(conic(planted.a), conic(planted.b));
    const bool shared = planted.kind == PencilKind::common_line || planted.kind == PencilKind::common_vertex;
    ASSERT_EQ(degenerate.has_value(), shared) << planted.name;  // those of one conic only: a regular one
    if (shared) {
      EXPECT_EQ(degenerate->kind, planted.kind) << planted.name;
    }
  }
  const ConicQ a = conic({0, 0, 0, 0, 0, 1}), b = conic({1, -1, 0, 0, 0, 0});
  ConicQ c = a;
  c.q[2] = tiny;
  EXPECT_EQ(degenerate_common_points_exactly(a, b)->kind, PencilKind::common_vertex);
  EXPECT_FALSE(degenerate_common_points_exactly(c, b));
  EXPECT_FALSE(exactly_proportional(a, c));
  EXPECT_EQ(degenerate_common_points_exactly(a, a)->kind, PencilKind::same_conic);
}

bool overlap(const ProjectivePointBox& p, const ProjectivePointBox& q) {
  if (p.unit != q.unit) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(p.at[i].low <= q.at[i].high && q.at[i].low <= p.at[i].high)) return false;
  return true;
}

TEST(CertifiedCommonPoints, BothRoutesSayTheSame) {
  Random random("CertifiedCommonPoints.BothRoutesSayTheSame");
  int by_intervals = 0;
  for (int n = 0; n < 1000; ++n) {
    const QuadPoint p = random_point(random), q = random_point(random), r = random_point(random),
                    s = random_point(random);
    const ConicPair pair = n % 3 == 0   ? through(p, q, r, s, random)
                           : n % 3 == 1 ? through_two_real(p, q, r, s, random)
                                        : through_none_real(p, q, r, s, random);
    const CertifiedCommonPoints fast = certified_common_points(pair.a, pair.b);
    ConicQ a, b;
    std::copy(pair.a.q.begin(), pair.a.q.end(), a.q.begin());
    std::copy(pair.b.q.begin(), pair.b.q.end(), b.q.begin());
    const CertifiedCommonPoints exact = certified_common_points_exactly(a, b);
    EXPECT_EQ(exact.rung, Rung::exact);
    ASSERT_EQ(fast.points.size(), exact.points.size()) << n;
    by_intervals += fast.rung == Rung::intervals;
    for (const CertifiedCommonPoint& point : fast.points)
      EXPECT_EQ(std::count_if(exact.points.begin(), exact.points.end(),
                              [&](const CertifiedCommonPoint& other) { return overlap(point.box, other.box); }),
                1)
          << n;
  }
  EXPECT_GT(by_intervals, 950);
}

TEST(CertifiedCommonPoints, WhereDoublesCannotTell) {
  // parabola y = x^2 and the lines y = e: two points 2e-30 apart, one of multiplicity two, none
  const ConicQ parabola = conic({-1, 0, 0, 1, 0, 0});
  for (const auto& [sign, exponent] : {std::pair{1, 200}, {0, 0}, {-1, 200}, {1, 3000}, {-1, 3000}}) {
    const Rational e = Rational(sign) / Rational(Integer(1) << exponent);
    const ConicQ lines(
        {Rational(0), Rational(1), Rational(-e), Rational(1 - e), Rational(0), Rational(0)});  // (y - e)(y + 1)
    const CertifiedCommonPoints found = certified_common_points(parabola, lines);
    ASSERT_EQ(found.points.size(), static_cast<std::size_t>(1 + sign)) << sign;
    EXPECT_EQ(found.rung, Rung::exact);
    for (const CertifiedCommonPoint& point : found.points) EXPECT_EQ(point.multiplicity, sign == 0 ? 2 : 1);
  }
}

TEST(CertifiedCommonPoints, OfSizesThatDoublesHardlyHold) {
  const Conic<double> a({1e308, 0, -1e308, 0, 0, 0}), b({0, 5e-324, -5e-324, 0, 0, 0});
  const CertifiedCommonPoints found = certified_common_points(a, b);
  EXPECT_EQ(found.kind, PencilKind::regular);
  EXPECT_EQ(found.points.size(), 4u);
  Conic<double> c = a;
  c.q[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(certified_common_points(a, c), std::invalid_argument);
}

}  // namespace
}  // namespace burmester
