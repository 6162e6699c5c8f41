#include <optional>
#include <utility>

#include "burmester/geometry/conic_points.hpp"
#include "burmester/geometry/real_roots.hpp"

namespace burmester {
namespace {

using Point = Point2<Rational>;
using Line = LinearForm<Rational>;
using BoxPoint = std::array<RationalInterval, 3>;
using P = Polynomial<Rational>;

constexpr double narrow = 0x1p-50;  // of coordinates up to 1

/// Nothing where the box is too wide.
std::optional<ProjectivePointBox> scaled(const BoxPoint& p, double width) {
  ProjectivePointBox out;
  std::array<Rational, 3> size;
  for (std::size_t i = 0; i < 3; ++i) size[i] = abs(Rational(p[i].low() + p[i].high()));
  const auto unit = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  if (p[unit].low() <= 0 && p[unit].high() >= 0) return std::nullopt;  // exactly: doubles underflow
  out.unit = static_cast<int>(unit);
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalInterval x = i == unit ? RationalInterval(1) : p[i] / p[unit];
    if (x.high() - x.low() > width) return std::nullopt;
    out.at[i] = range_of(x);
  }
  return out;
}

bool is_zero(const Point& p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; }

/// Of a point that is known exactly, not zero.
ProjectivePointBox scaled(const Point& p) {
  return *scaled(BoxPoint{RationalInterval(p[0]), RationalInterval(p[1]), RationalInterval(p[2])}, 0);
}

bool exactly_proportional(const Conic<Rational>& a, const Conic<Rational>& b) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (a.q[i] * b.q[j] != a.q[j] * b.q[i]) return false;
  return true;
}

// ---- Pencils of singular conics ----

/// The point where the lines of a singular conic meet; zero for a double line.
Point vertex_of(const Conic<Rational>& c) {
  const Adjugate<Rational> adj(c);
  if (adj.xx != 0) return {adj.xx, adj.xy, adj.xz};
  if (adj.yy != 0) return {adj.xy, adj.yy, adj.yz};
  return {adj.xz, adj.yz, adj.zz};
}

int nonzero_coordinate(const Point& p) { return p[0] != 0 ? 0 : p[1] != 0 ? 1 : 2; }

/// m with c = l m. Precondition: l divides c.
Line other_line(const Conic<Rational>& c, const Line& l) {
  constexpr int mixed[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  const int k = nonzero_coordinate(l);
  const auto coefficient = [&](int i, int j) { return c.q[static_cast<std::size_t>(mixed[i][j])]; };
  Line m;
  m[k] = coefficient(k, k) / l[k];
  for (const int i : {(k + 1) % 3, (k + 2) % 3}) m[i] = (coefficient(i, k) - l[i] * m[k]) / l[k];
  return m;
}

/// The line that two conics singular at p share, zero if none: the common root of two quadratic forms on a line that
/// misses p.
Line shared_line_through(const Point& p, const Conic<Rational>& a, const Conic<Rational>& b) {
  const int k = nonzero_coordinate(p);
  const Point u = Point::Unit((k + 1) % 3), v = Point::Unit((k + 2) % 3);
  const Rational a0 = a(u), a1 = a.polar(u, v), a2 = a(v), b0 = b(u), b1 = b.polar(u, v), b2 = b(v);
  const Rational c01 = a0 * b1 - a1 * b0, c02 = a0 * b2 - a2 * b0, c12 = a1 * b2 - a2 * b1;
  if (c02 * c02 != c01 * c12) return Line::Zero();  // common root (s : t): s^2 : s t : t^2 = c12 : -c02 : c01
  return p.cross(c01 != 0 ? Point(u * Rational(-c02) + v * c01) : u);
}

/// All members are singular, not all proportional: they share a line or a vertex. At most two members are double lines.
CertifiedCommonPoints singular_pencil(const Conic<Rational>& a, const Conic<Rational>& b) {
  CertifiedCommonPoints out;
  out.rung = Rung::exact;
  std::vector<Point> vertices;
  for (const int k : {0, 1, 2, 3}) {
    const Point vertex = vertex_of(pencil_member(a, Rational(1), b, Rational(k)));
    if (!is_zero(vertex)) vertices.push_back(vertex);
  }
  const Line through_both = vertices[0].cross(vertices[1]);
  const Line line = is_zero(through_both) ? shared_line_through(vertices[0], a, b) : through_both;
  if (is_zero(line)) {
    out.kind = PencilKind::common_vertex;
    out.points.push_back({scaled(vertices[0]), 4});
    return out;
  }
  out.kind = PencilKind::common_line;
  out.line = scaled(line);
  const Point point = other_line(a, line).cross(other_line(b, line));
  if (line.dot(point) != 0) out.points.push_back({scaled(point), 1});
  return out;
}

// ---- All other pencils ----

/// A conic seen from the point c: coefficients of z^2, z, 1, polynomials of the line through c and x e + f.
struct Seen {
  Rational a;
  P a1, a2;
  Seen(const Conic<Rational>& q, const Point& e, const Point& f, const Point& c)
      : a(q(c)), a1({q.polar(c, f), q.polar(c, e)}), a2({q(f), q.polar(e, f), q(e)}) {}
};

/// The point on the line number x, e (x s1) + f s1 - c s0.
std::optional<CertifiedCommonPoint> lifted(RealRoot root, const P& s0, const P& s1, const Matrix<Rational, 3, 3>& efc) {
  if (sign_at(s1, root) == 0) return std::nullopt;
  for (;;) {
    const RationalInterval x = root.bounds(), t = s1(x), z = -s0(x);
    BoxPoint p;
    for (int i = 0; i < 3; ++i)
      p[static_cast<std::size_t>(i)] =
          (RationalInterval(efc(i, 0)) * x + RationalInterval(efc(i, 1))) * t + RationalInterval(efc(i, 2)) * z;
    if (const auto box = scaled(p, narrow)) return CertifiedCommonPoint{*box, root.multiplicity()};
    root.refine();
  }
}

/// Nothing where the centre (1, k, k^2) is badly placed, which can be so for 24 values of k at most.
std::optional<CertifiedCommonPoints> seen_from(int k, const Conic<Rational>& a, const Conic<Rational>& b) {
  Matrix<Rational, 3, 3> efc;  // the line through c and e may not meet a common point either
  efc << 1, 0, 1, k + 1, 0, k, (k + 1) * (k + 1), 1, k * k;
  const Seen s(a, efc.col(0), efc.col(1), efc.col(2)), t(b, efc.col(0), efc.col(1), efc.col(2));
  const P s1 = t.a1 * s.a - s.a1 * t.a, s0 = t.a2 * s.a - s.a2 * t.a;
  const P resultant = s0 * s0 - s1 * (s.a1 * t.a2 - t.a1 * s.a2);
  if (resultant.degree() < 4) return std::nullopt;
  CertifiedCommonPoints out;
  out.rung = Rung::exact;
  for (RealRoot& root : real_roots(resultant)) {
    const auto point = lifted(std::move(root), s0, s1, efc);
    if (!point) return std::nullopt;
    out.points.push_back(*point);
  }
  return out;
}

}  // namespace

CertifiedCommonPoints certified_common_points_exactly(const Conic<Rational>& a, const Conic<Rational>& b) {
  if (exactly_proportional(a, b)) return {PencilKind::same_conic, Rung::exact, {}, {}};
  const std::array<Rational, 4> determinant = pencil_determinant(a, b);
  if (std::all_of(determinant.begin(), determinant.end(), [](const Rational& x) { return x == 0; }))
    return singular_pencil(a, b);
  for (int k = 0;; ++k)
    if (auto out = seen_from(k, a, b)) return std::move(*out);
}

}  // namespace burmester
