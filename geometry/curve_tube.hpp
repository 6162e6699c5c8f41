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
#include <concepts>
#include <optional>

#include "burmester/geometry/cubic.hpp"
#include "burmester/geometry/lanes.hpp"

namespace burmester {

/// A cubic with what the test must know of it; in doubles, or two curves side by side.
template <class T>
class TubeCurveOf {
 public:
  /// `coefficient_error`: how far each coefficient may be from the true one.
  explicit TubeCurveOf(const Cubic<double>& f, double coefficient_error = 0) requires std::same_as<T, double>
      : f_(f), bound_(f.gradient_bound() * (1 + 0x1p-40) + sum_of_ones * coefficient_error) {
    error_ = 16 * unit_roundoff * bound_ + sum_of_ones * coefficient_error;
  }
  TubeCurveOf(const TubeCurveOf<double>& a, const TubeCurveOf<double>& b) requires std::same_as<T, Lanes>
      : bound_(a.bound(), b.bound()), error_(a.error(), b.error()) {
    for (std::size_t k = 0; k < f_.c.size(); ++k) f_.c[k] = Lanes(a.form().c[k], b.form().c[k]);
  }
  const Cubic<T>& form() const { return f_; }
  /// |gradient(p)| <= bound |p|^2
  const T& bound() const { return bound_; }
  /// |gradient(p) computed - true| <= error |p|^2, and so is |F(p) computed - true| <= error |p|^3: six roundings on
  /// the way to each term of a sum, 2 u each if the processor rounds upward, and those of the dot product with p / 3.
  const T& error() const { return error_; }

 private:
  static constexpr double sum_of_ones = 6.82;  // gradient_bound() of the cubic whose coefficients are all 1
  Cubic<T> f_;
  T bound_, error_;
};
using TubeCurve = TubeCurveOf<double>;

/// A point near the curve, with what its two chords need.
template <class T>
struct TubePointOf {
  Point2<T> at;
  Vector<T, 3> gradient;
  T value = 0, size = 0;
  TubePointOf() = default;
  TubePointOf(const Point2<T>& p, const TubeCurveOf<T>& curve)
      : at(p), gradient(curve.form().gradient(p)), value(dot(gradient, p) * (1.0 / 3)), size(length_of(p)) {}
  TubePointOf opposite() const { return times(-1); }
  /// Precondition: the factor is 1 or -1.
  TubePointOf times(const T& sign) const {
    TubePointOf out = *this;
    out.at *= sign, out.value *= sign;
    return out;
  }
  /// The same point as a unit vector.
  TubePointOf unit() const {
    TubePointOf out = *this;
    out.at /= size, out.gradient /= size * size, out.value /= size * size * size, out.size = 1;
    return out;
  }

  static T dot(const Vector<T, 3>& a, const Vector<T, 3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static T length_of(const Vector<T, 3>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
  }
};
using TubePoint = TubePointOf<double>;

/// From the middle of X and Y to Y: d, its length, and a unit vector n across (to a few unit roundoffs).
template <class T>
struct HalfChordOf {
  Vector<T, 3> d, n;
  T length, per_length;  ///< and its reciprocal

  static HalfChordOf between(const Point2<T>& x, const Point2<T>& y, const Vector<T, 3>& n) {
    const Vector<T, 3> d = (y - x) * T(0.5);
    const T length = TubePointOf<T>::length_of(d);
    return {d, n, length, T(1) / length};
  }
};
using HalfChord = HalfChordOf<double>;

/// A chord that the curve is proved to follow.
template <class T>
struct TubeOf {
  T radius;  ///< f / g: the distance between chord and curve along n is at most this
  T width;   ///< r: on the patch there is no other part of the curve
};
using Tube = TubeOf<double>;

/// Nothing where the test fails (in one lane). The patch is as narrow as the test allows, but not narrower than asked
/// for.
template <class T>
std::optional<TubeOf<T>> tube(const TubeCurveOf<T>& curve, const TubePointOf<T>& x, const TubePointOf<T>& y,
                              const HalfChordOf<T>& chord, double least_width = 0) {
  using std::abs, std::max, std::min;
  const auto dot = TubePointOf<T>::dot;
  constexpr double tilt =
      1.25;  // on the sphere the patches of neighbours are tilted against each other, less than this
  constexpr double safe = 1 + 0x1p-40;  // covers the roundings of this function, all of them of sums of a few terms
  const T reach = max(x.size, y.size) * safe, half = chord.length * safe;
  const T error = curve.error() * reach * reach;

  const T delta = (y.value - x.value) * 0.5, dx = dot(x.gradient, chord.d), dy = dot(y.gradient, chord.d);
  const T ends = max(abs(x.value), abs(y.value)) + error * reach;
  const T alpha = abs(dy - dx) * 0.25 + error * half,
          beta = abs((dy + dx) * 0.25 - delta * 0.5) + error * (half + reach);
  const T gx = dot(x.gradient, chord.n), gy = dot(y.gradient, chord.n);
  const T least = min(abs(gx), abs(gy)) - 2 * error;

  // The least possible r is f / g without the parts that depend on r; twice that leaves room for them.
  const T r = max(T(least_width), 2 * (ends + alpha + 0.385 * beta) / least + 0x1p-30 * half);
  const T beyond = r * chord.per_length * safe, t = 1 + beyond, over = max(T(1), t * t - 1);
  const T wide = reach + r + beyond * half;
  const T g = (least - beyond * (abs(gy - gx) * 0.5 + error) - over * curve.bound() * half * half -
               curve.bound() * r * (2 * wide + r)) *
              (1 - 0x1p-40);
  const T f =
      (ends + beyond * (abs(delta) + error * reach) + over * alpha + max(T(0.385), t * (t * t - 1)) * beta) * safe;
  const bool proved = all_positive(gx * gy) && all_positive(least) && all_positive(half - r) && all_positive(g) &&
                      all_positive(g * r - tilt * f);
  if (!proved) return std::nullopt;
  return TubeOf<T>{f / g * safe, r};
}

/// Whether (in every lane) it is plain that `over_chord` is not so.
template <class T>
bool beside_chord(const TubePointOf<T>& x, const TubePointOf<T>& y, const HalfChordOf<T>& chord, const T& radius,
                  const Point2<T>& z, const T& uncertainty) {
  using std::max;
  const auto dot = TubePointOf<T>::dot;
  // Such a point is a multiple of m + v, |v| <= h: the sine of its angle with m is at most h / (|m| - h).
  const Vector<T, 3> m((x.at[0] + y.at[0]) * 0.5, (x.at[1] + y.at[1]) * 0.5, (x.at[2] + y.at[2]) * 0.5);
  const T h = (chord.length + radius) * (1 + 0x1p-30), least = max(x.size, y.size) - chord.length - h,
          sine = (1 + uncertainty) * h + uncertainty * least, along = dot(z, m) * least;
  return all_positive(least - sine) &&
         all_positive(dot(m, m) * ((1 - 0x1p-30) * least * least - sine * sine) - along * along);
}

/// Whether a point within `uncertainty` |z| of z, or of -z, may lie over the chord and within the radius of it;
/// roundings of the order of 1e-9 are allowed for. z: unit.
inline bool over_chord(const TubePoint& x, const TubePoint& y, const HalfChord& chord, double radius,
                       const Point2<double>& z, double uncertainty = 0) {
  if (beside_chord(x, y, chord, radius, z, uncertainty)) return false;
  // z is lambda (m + t d + s n) times the volume m . (d x n)
  const Vector<double, 3> m = (x.at + y.at) / 2, across = chord.d.cross(chord.n), along = chord.n.cross(m);
  const auto bound = [](const Vector<double, 3>& v) { return v.cwiseAbs().sum(); };  // of |v|
  const double slack = 0x1p-30, moved = uncertainty, lambda = std::abs(z.dot(across));
  if (std::abs(z.dot(along)) > (1 + slack) * lambda + slack * bound(across) + moved * (bound(along) + bound(across)))
    return false;
  const Vector<double, 3> up = m.cross(chord.d);
  return std::abs(z.dot(up)) <= (radius + slack) * (lambda + moved * bound(across)) + moved * bound(up);
}

}  // namespace burmester
