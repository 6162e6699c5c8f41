#include "burmester/planar/near_curve.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "burmester/planar/enclosed_pair.hpp"
#include "burmester/planar/equidistance.hpp"

namespace burmester::planar {
namespace {

/// Seen from pose 1's origin, in units of `length`, centre points first: c^T N^T p = 0.
struct Centres {
  FourPoses poses;
  double length;

  template <class T>
  std::array<Correlation<T>, 3> correlations() const {
    std::array<Correlation<T>, 3> n;
    for (std::size_t j = 0; j < 3; ++j) n[j] = equidistance<T>(poses[0], poses[j + 1], 1 / length).transpose();
    return n;
  }
  Vector2 seen(std::span<const double> c) const { return Vector2(c[0] - poses[0].x, c[1] - poses[0].y) / length; }
};

Point2<double> affine(const Vector2& c) { return {c[0], c[1], 1}; }

struct Shown {
  Vector2 at;
  bool end;  ///< of a piece: the curve goes on where nothing is traced
};

std::optional<Shown> nearest_shown(const Vector2& q, const std::vector<CurveRecord>& curves, const Centres& centres) {
  std::optional<Shown> best;
  for (const CurveRecord& curve : curves) {
    const std::size_t n = curve.fixed.size();
    for (std::size_t k = curve.closed ? 0 : 1; k < n; ++k) {
      const Vector2 a = centres.seen(curve.fixed[(k + n - 1) % n]), d = centres.seen(curve.fixed[k]) - a;
      const double t = d.isZero(0) ? 0 : std::clamp(d.dot(q - a) / d.squaredNorm(), 0.0, 1.0);
      const Vector2 p = a + t * d;
      if (best && !((p - q).norm() < (best->at - q).norm())) continue;
      best = {p, !curve.closed && ((k == 1 && t == 0) || (k + 1 == n && t == 1))};
    }
  }
  return best;
}

/// One step towards the curve along the gradient, if it leads nearer; at double points it may not.
Vector2 projected(const Cubic<double>& f, const Vector2& c) {
  const Vector2 slope = f.gradient(affine(c)).head<2>();
  const Vector2 next = c - f(affine(c)) / slope.squaredNorm() * slope;
  return std::abs(f(affine(next))) < std::abs(f(affine(c))) ? next : c;
}

/// The centre point nearest to q that Newton's method leads to; the start, put on the curve, where it leads away.
Vector2 nearest(const Cubic<double>& f, const Vector2& q, const Vector2& start) {
  Vector2 c = start, slope = f.gradient(affine(c)).head<2>();
  double lambda = (q - c).dot(slope) / slope.squaredNorm();
  for (int i = 0; i < 20; ++i) {
    const Point2<double> p = affine(c);
    slope = f.gradient(p).head<2>();
    Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 2; ++k) system.col(k).head<2>() = lambda * f.polar(p, Point2<double>::Unit(k)).head<2>();
    system.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity();
    system.col(2).head<2>() = slope, system.row(2).head<2>() = slope;
    Eigen::Vector3d off;
    off << c - q + lambda * slope, f(p);
    const Eigen::Vector3d step = system.partialPivLu().solve(off);
    c -= step.head<2>(), lambda -= step[2];
    if (!c.allFinite() || (c - start).norm() > 0.25) break;  // a chord of the traced curve is no longer
  }
  if (!c.allFinite() || (c - start).norm() > 0.25) c = start;
  for (int i = 0; i < 4; ++i) c = projected(f, c);
  return c;
}

/// Around c and across the curve, as short as exact signs allow: a segment that the curve of centre points crosses.
std::optional<Point2<RationalInterval>> crossing(const Centres& centres, const Vector2& c, const Vector2& slope) {
  const Cubic<Rational> f = points_with_partner(centres.correlations<Rational>());
  const Vector2 normal = slope.normalized();
  for (double reach = unit_roundoff * (1 + c.norm()); reach < 1e-6; reach *= 4) {
    const Vector2 a = c - reach * normal, b = c + reach * normal;
    const Rational below = f(affine(a).cast<Rational>()), above = f(affine(b).cast<Rational>());
    if (below * above > 0) continue;
    const auto hull = [](double x, double y) { return RationalInterval(std::min(x, y), std::max(x, y)); };
    return Point2<RationalInterval>{hull(a[0], b[0]), hull(a[1], b[1]), RationalInterval(1)};
  }
  return std::nullopt;
}

template <class T>
PivotPair<T> pair_of(const Point2<T>& c, const Point2<T>& p, double length) {
  const T unit(length);
  return {{T(unit * p[0] / p[2]), T(unit * p[1] / p[2])}, {T(unit * c[0] / c[2]), T(unit * c[1] / c[2])}};
}

/// Whether a computed partner tells nothing: c, within rounding, is the pole of two displacements, and a line of
/// partners is left. Each line of partners is known to a few unit roundoffs of |N| |c|.
bool undetermined(const Point2<double>& p, const std::array<Correlation<double>, 3>& n, const Vector2& c) {
  double size = 0;
  for (const Correlation<double>& form : n) size = std::max(size, form.norm() * affine(c).norm());
  return !(p.norm() > 64 * unit_roundoff * size * size);
}

Found<Dyads::Design> dyad_at(const Centres& centres, const Vector2& c, const Point2<double>& p, const Vector2& slope,
                             bool certify) {
  const Pose& first = centres.poses[0];
  const Vector2 at = centres.length * c + Vector2(first.x, first.y);
  const bool far = !(std::abs(p[2]) > 256 * unit_roundoff * p.norm());
  if (far) return judged({}, Body::fixed, at, true, centres.poses, false);
  if (certify)
    if (const auto segment = crossing(centres, c, slope)) {
      const Point2<RationalInterval> enclosed_partner = partner(centres.correlations<RationalInterval>(), *segment);
      if (!contains_zero(enclosed_partner[2]))
        return judged(enclosed(pair_of(*segment, enclosed_partner, centres.length), first), Body::fixed, at, false,
                      centres.poses, true);
    }
  const Point2<Rational> exact_c = affine(c).cast<Rational>(), exact_p = p.cast<Rational>();
  return judged(enclosed(pair_of(exact_c, exact_p, centres.length), first), Body::fixed, at, false, centres.poses,
                false);
}

}  // namespace

NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify) {
  const Centres centres{poses, power_of_two_below(curve_scale(poses))};
  const auto n = centres.correlations<double>();
  const Cubic<double> f = points_with_partner(n);
  NearDyads out;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const auto warn = [&](const char* words) { out.warnings.push_back(fmt::format("near[{}]: {}", k, words)); };
    const Vector2 q = centres.seen(near[k]);
    const auto start = nearest_shown(q, curves, centres);
    if (!start) {
      warn("no curve is listed; no dyad");
      continue;
    }
    const Vector2 c = nearest(f, q, start->at);
    const Point2<double> p = partner(n, affine(c));
    if (undetermined(p, n, c)) {
      warn("the nearest centre point is a common pole, every point of a line is its partner; no dyad");
      continue;
    }
    auto found = dyad_at(centres, c, p, f.gradient(affine(c)).head<2>(), certify);
    if (!std::holds_alternative<RR::Design>(found.design)) {
      warn("the nearest centre point is the pivot of a slider; no RR dyad");
      continue;
    }
    if (start->end) warn("the curve is traced no farther than to this dyad; farther out it may be nearer");
    out.dyads.push_back(std::move(found));
  }
  return out;
}

}  // namespace burmester::planar
