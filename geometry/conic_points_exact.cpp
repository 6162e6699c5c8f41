#include <optional>
#include <utility>

#include "burmester/geometry/conic_points.hpp"
#include "burmester/geometry/degenerate_pencil.hpp"
#include "burmester/geometry/real_roots.hpp"

namespace burmester {
namespace {

using Point = Point2<Rational>;
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

/// Of a point that is known exactly, not zero.
ProjectivePointBox scaled(const Point& p) {
  return *scaled(BoxPoint{RationalInterval(p[0]), RationalInterval(p[1]), RationalInterval(p[2])}, 0);
}

/// Pencils whose members are all singular.
CertifiedCommonPoints certified(const CommonPoints<Rational>& found) {
  CertifiedCommonPoints out{found.kind, Rung::exact, {}, {}};
  if (found.count > 0) out.points.push_back({scaled(found.point[0]), found.kind == PencilKind::common_vertex ? 4 : 1});
  if (found.kind == PencilKind::common_line) out.line = scaled(found.line);
  return out;
}

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
  if (const auto degenerate = degenerate_common_points_exactly(a, b)) return certified(*degenerate);
  for (int k = 0;; ++k)
    if (auto out = seen_from(k, a, b)) return std::move(*out);
}

}  // namespace burmester
