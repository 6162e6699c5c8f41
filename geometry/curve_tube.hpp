// The tube test: proof that a plane curve follows a chord.
//
// F a form of degree three or less in homogeneous coordinates (Cubic), known to within an error of its coefficients; X,
// Y two points near the curve, M their middle, d = (Y - X) / 2, n a unit vector, |t| <= T = 1 + r / |d|,
// |s| <= r. If on the patch M + t d + s n
//     dF/dn > g > 0    and    |F| <= f <= g r  where s = 0,
// then for each t there is exactly one s with F = 0, and |s| <= f / g: on the patch the curve is a graph over the
// chord, within f / g of it. The patch reaches r beyond both ends; so the graphs over two chords with a common end
// overlap in the disc of radius r about it and are parts of the same branch. That a passage from X to Y on a closed
// branch is this part and not the rest of the branch is seen from any other point of the branch: it does not lie over
// the chord. In the plane (z = 1, n in the plane) s is a
// distance; on the sphere (X, Y unit vectors, n = X x Y normalised) at most the tangent of an angle over |M|.
//
// With D = dF/dd the restriction of F to the chord is the cubic that has the values F and D at both ends,
//     F(M + t d) = (F(Y) + F(X)) / 2 + t delta + (t^2 - 1)(alpha + beta t),
//     delta = (F(Y) - F(X)) / 2,  alpha = (D(Y) - D(X)) / 4,  beta = (D(Y) + D(X)) / 4 - delta / 2,
// and dF/dn on it is linear in t but for (t^2 - 1) n . gradient(d). So a chord costs two gradients, which its
// neighbours share. The derivation and the terms for rounding: docs/curves.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "burmester/geometry/cubic.hpp"

namespace burmester {

/// A cubic in doubles with what the test must know of it.
class TubeCurve {
 public:
  /// `coefficient_error`: how far each coefficient may be from the true one.
  explicit TubeCurve(const Cubic<double>& f, double coefficient_error = 0)
      : f_(f), bound_(f.gradient_bound() * (1 + 0x1p-40) + sum_of_ones * coefficient_error) {
    error_ = 16 * unit_roundoff * bound_ + sum_of_ones * coefficient_error;
  }
  const Cubic<double>& form() const { return f_; }
  /// |gradient(p)| <= bound |p|^2
  double bound() const { return bound_; }
  /// |gradient(p) computed - true| <= error |p|^2, and so is |F(p) computed - true| <= error |p|^3: six roundings on
  /// the way to each term of a sum, 2 u each if the processor rounds upward, and those of the dot product with p.
  double error() const { return error_; }

 private:
  static constexpr double sum_of_ones = 6.82;  // gradient_bound() of the cubic whose coefficients are all 1
  Cubic<double> f_;
  double bound_, error_;
};

/// A point near the curve, with what its two chords need.
struct TubePoint {
  Point2<double> at;
  Vector<double, 3> gradient;
  double value = 0, size = 0;
  TubePoint() = default;
  TubePoint(const Point2<double>& p, const TubeCurve& curve)
      : at(p), gradient(curve.form().gradient(p)), value(gradient.dot(p) / 3), size(p.norm()) {}
  TubePoint opposite() const {
    TubePoint out = *this;
    out.at = -at, out.value = -value;
    return out;
  }
  /// The same point as a unit vector.
  TubePoint unit() const {
    TubePoint out = *this;
    out.at /= size, out.gradient /= size * size, out.value /= size * size * size, out.size = 1;
    return out;
  }
};

/// A chord that the curve is proved to follow.
struct Tube {
  double radius;  ///< f / g: the distance between chord and curve along n is at most this
  double width;   ///< r: on the patch there is no other part of the curve
};

/// Nothing where the test fails. n: unit to a few unit roundoffs. The patch is as narrow as the test allows, but not
/// narrower than asked for.
inline std::optional<Tube> tube(const TubeCurve& curve, const TubePoint& x, const TubePoint& y,
                                const Vector<double, 3>& n, double least_width = 0) {
  constexpr double tilt =
      1.25;  // on the sphere the patches of neighbours are tilted against each other, less than this
  constexpr double safe = 1 + 0x1p-40;  // covers the roundings of this function, all of them of sums of a few terms
  const Vector<double, 3> d = (y.at - x.at) / 2;
  const double reach = std::max(x.size, y.size) * safe, half = d.norm() * safe;
  const double error = curve.error() * reach * reach;

  const double delta = (y.value - x.value) / 2, dx = x.gradient.dot(d), dy = y.gradient.dot(d);
  const double ends = std::max(std::abs(x.value), std::abs(y.value)) + error * reach;
  const double alpha = std::abs(dy - dx) / 4 + error * half,
               beta = std::abs((dy + dx) / 4 - delta / 2) + error * (half + reach);
  const double gx = x.gradient.dot(n), gy = y.gradient.dot(n);
  if (!(gx * gy > 0)) return std::nullopt;
  const double least = std::min(std::abs(gx), std::abs(gy)) - 2 * error;

  // The least possible r is f / g without the parts that depend on r; twice that leaves room for them.
  const double r = std::max(least_width, 2 * (ends + alpha + 0.385 * beta) / least + 0x1p-30 * half);
  if (!(r < half) || !(least > 0)) return std::nullopt;
  const double beyond = r / half * safe, t = 1 + beyond, over = std::max(1.0, t * t - 1);
  const double wide = reach + r + beyond * half;
  const double g = (least - beyond * (std::abs(gy - gx) / 2 + error) - over * curve.bound() * half * half -
                    curve.bound() * r * (2 * wide + r)) /
                   safe;
  const double f =
      (ends + beyond * (std::abs(delta) + error * reach) + over * alpha + std::max(0.385, t * (t * t - 1)) * beta) *
      safe;
  if (!(g > 0) || !(tilt * f <= g * r)) return std::nullopt;
  return Tube{f / g * safe, r};
}

/// Whether a point within `uncertainty` |z| of z, or of -z, may lie over the chord and within the radius of it;
/// roundings of the order of 1e-9 are allowed for.
inline bool over_chord(const TubePoint& x, const TubePoint& y, const Vector<double, 3>& n, double radius,
                       const Point2<double>& z, double uncertainty = 0) {
  // z is lambda (m + t d + s n) times the volume m . (d x n)
  const Vector<double, 3> sum = x.at + y.at, difference = y.at - x.at, across = difference.cross(n),
                          along = n.cross(sum);
  const auto bound = [](const Vector<double, 3>& v) { return v.cwiseAbs().sum(); };  // of |v|
  const double slack = 0x1p-30, size = bound(z), moved = uncertainty * size, lambda = std::abs(z.dot(across));
  if (std::abs(z.dot(along)) >
      (1 + slack) * lambda + slack * size * bound(across) + moved * (bound(along) + bound(across)))
    return false;
  const Vector<double, 3> up = sum.cross(difference) / 2;
  return std::abs(z.dot(up)) <= (radius + slack) * (lambda + moved * bound(across)) + moved * bound(up);
}

}  // namespace burmester
