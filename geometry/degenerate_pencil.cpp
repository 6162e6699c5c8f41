#include "burmester/geometry/degenerate_pencil.hpp"

#include <vector>

namespace burmester {
namespace {

using Point = Point2<Rational>;
using Line = LinearForm<Rational>;

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

/// The line that two conics singular at p share, zero if none.
Line shared_line_through(const Point& p, const Conic<Rational>& a, const Conic<Rational>& b) {
  const int k = nonzero_coordinate(p);
  const Point u = Point::Unit((k + 1) % 3), v = Point::Unit((k + 2) % 3);
  const Rational a0 = a(u), a1 = a.polar(u, v), a2 = a(v), b0 = b(u), b1 = b.polar(u, v), b2 = b(v);
  const Rational c01 = a0 * b1 - a1 * b0, c02 = a0 * b2 - a2 * b0, c12 = a1 * b2 - a2 * b1;
  if (c02 * c02 != c01 * c12) return Line::Zero();  // common root (s : t): s^2 : s t : t^2 = c12 : -c02 : c01
  return p.cross(c01 != 0 ? Point(u * Rational(-c02) + v * c01) : u);
}

}  // namespace

bool exactly_proportional(const Conic<Rational>& a, const Conic<Rational>& b) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (a.q[i] * b.q[j] != a.q[j] * b.q[i]) return false;
  return true;
}

Point vertex_of(const Conic<Rational>& c) {
  const Adjugate<Rational> adj(c);
  if (adj.xx != 0) return {adj.xx, adj.xy, adj.xz};
  if (adj.yy != 0) return {adj.xy, adj.yy, adj.yz};
  return {adj.xz, adj.yz, adj.zz};
}

std::optional<CommonPoints<Rational>> degenerate_common_points_exactly(const Conic<Rational>& a,
                                                                       const Conic<Rational>& b) {
  for (const Rational& coefficient : pencil_determinant(a, b))
    if (coefficient != 0) return std::nullopt;
  CommonPoints<Rational> out;
  out.kind = PencilKind::same_conic;
  if (exactly_proportional(a, b)) return out;
  std::vector<Point> vertices;
  for (const int k : {0, 1, 2, 3}) {
    const Point vertex = vertex_of(pencil_member(a, Rational(1), b, Rational(k)));
    if (!vertex.isZero(0)) vertices.push_back(vertex);
  }
  const Line through_both = vertices[0].cross(vertices[1]);
  out.line = through_both.isZero(0) ? shared_line_through(vertices[0], a, b) : through_both;
  if (out.line.isZero(0)) {
    out.kind = PencilKind::common_vertex;
    out.point[out.count++] = vertices[0];
    return out;
  }
  out.kind = PencilKind::common_line;
  const Point apart = other_line(a, out.line).cross(other_line(b, out.line));
  if (out.line.dot(apart) != 0) out.point[out.count++] = apart;
  return out;
}

}  // namespace burmester
