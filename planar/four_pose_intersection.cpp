#include "burmester/planar/four_pose_intersection.hpp"

#include "burmester/geometry/real_roots.hpp"
#include "burmester/planar/equidistance.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

using P = Polynomial<Rational>;
using Point = Point2<Rational>;
using Correlations = std::array<Correlation<Rational>, 3>;

/// The coefficients of y^0 .. y^3, polynomials in x.
std::array<P, 4> by_powers_of_y(const Cubic<Rational>& f) {
  const auto& c = f.c;
  return {P({c[9], c[5], c[2], c[0]}), P({c[8], c[4], c[1]}), P({c[7], c[3]}), P({c[6]})};
}

/// Symmetric; B (1, y, y^2) = 0 at a common zero.
struct Bezout {
  P b00, b01, b02, b11, b12, b22;
  Bezout(const Cubic<Rational>& first, const Cubic<Rational>& second) {
    const auto f = by_powers_of_y(first), g = by_powers_of_y(second);
    const auto m = [&](std::size_t i, std::size_t j) { return f[i] * g[j] - f[j] * g[i]; };
    b00 = m(1, 0), b01 = m(2, 0), b02 = m(3, 0), b11 = m(3, 0) + m(2, 1), b12 = m(3, 1), b22 = m(3, 2);
  }
  P determinant() const {
    return b00 * (b11 * b22 - b12 * b12) - b01 * (b01 * b22 - b12 * b02) + b02 * (b01 * b12 - b11 * b02);
  }
  /// y, from the first two rows.
  Rational kernel(const Rational& x) const {
    const Rational r0 = b00(x), r1 = b01(x), r2 = b02(x), s1 = b11(x), s2 = b12(x);
    return (r2 * r1 - r0 * s2) / (r1 * s2 - r2 * s1);
  }
};

/// p over z x - point, exactly. Precondition: p vanishes there, or the point is at infinity.
P without_root(const P& p, const Point& point) {
  if (point[2] == 0) return p;
  const Rational root = point[0] / point[2];
  std::vector<Rational> quotient(static_cast<std::size_t>(p.degree()));
  Rational carry(0);
  for (int k = p.degree(); k > 0; --k) quotient[static_cast<std::size_t>(k - 1)] = carry = carry * root + p[k];
  return P(std::move(quotient));
}

/// Where the pole of poses 2 and 3 lies on the body, as p is given: seen from pose 1.
Point pole_23(FivePoses poses, double per_length) {
  const Point pole = moving_pole<Rational>(poses[1], poses[2]);
  const Rational s(poses[0].X3), c(poses[0].X4), unit(per_length);
  const Rational cosine = unit * (c * c - s * s), sine = unit * 2 * s * c;
  return {cosine * pole[0] - sine * pole[1], sine * pole[0] + cosine * pole[1], (c * c + s * s) * pole[2]};
}

Vector2 shown(const Point& p) { return {approximate(Rational(p[0] / p[2])), approximate(Rational(p[1] / p[2]))}; }

}  // namespace

CommonDyads intersected_four_pose_curves(FivePoses poses) {
  const double length = power_of_two_below(task_size(poses));
  std::array<Correlation<Rational>, 4> n;
  for (std::size_t j = 0; j < 4; ++j) n[j] = equidistance<Rational>(poses[0], poses[j + 1], 1 / length);
  const Correlations first{n[0], n[1], n[2]}, second{n[0], n[1], n[3]};
  const Bezout bezout(points_with_partner(first), points_with_partner(second));

  CommonDyads out;
  P quartic = bezout.determinant();
  if (quartic.is_zero()) {
    out.reason = "the two circle-point curves have a part in common";
    return out;
  }
  for (const Point& pole : {vertex(n[0]), vertex(n[1]), pole_23(poses, 1 / length)})
    quartic = without_root(quartic, pole);
  for (RealRoot& root : real_roots(quartic)) {
    if (root.multiplicity() > 1) {
      out.reason = "the two circle-point curves touch";
      return out;
    }
    root.refine(Rational(0x1p-160));
    const Rational x = (root.bounds().low() + root.bounds().high()) / 2;
    const Point p{x, bezout.kernel(x), Rational(1)}, c = partner(first, p);
    const Vector2 moving = length * shown(p), fixed = length * shown(c);
    out.dyads.push_back({to_moving({0, 0, poses[0].X3, poses[0].X4}, moving), fixed + Vector2(poses[0].x, poses[0].y),
                         (shown(partner(second, p)) - shown(c)).norm()});
  }
  return out;
}

}  // namespace burmester::planar
