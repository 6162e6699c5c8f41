// Where curves are traced: the plane within a window, and the sphere. Not for inclusion by users: curve_trace.hpp is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "burmester/geometry/curve_tube.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester::detail {

using Point = Point2<double>;
using Box = Point2<Interval>;
inline constexpr double margin = 1.02;  ///< how far outside the window the last point of a piece may be

inline Point2<Lanes> side_by_side(const Point& a, const Point& b) {
  return {Lanes(a[0], b[0]), Lanes(a[1], b[1]), Lanes(a[2], b[2])};
}

/// A point of the curve and its partner, as each chart shows them, side by side; the point twice if it has none.
struct Sample {
  TubePointOf<Lanes> both;
  bool valid = true;                  ///< not so where a point has no single partner
  bool inside = false, near = false;  ///< of the window; of the window with its margin
  int end = -1;                       ///< number of the end of first chords that it is

  Point at(std::size_t k) const { return {both.at[0][k], both.at[1][k], both.at[2][k]}; }
  TubePoint track(std::size_t k) const {
    TubePoint out;
    out.at = at(k), out.gradient = {both.gradient[0][k], both.gradient[1][k], both.gradient[2][k]};
    out.value = both.value[k], out.size = both.size[k];
    return out;
  }
};

/// Not a number where one is none.
inline double largest(const Lanes& of) { return of[0] > of[1] || std::isnan(of[0]) ? of[0] : of[1]; }
inline Lanes squared_distances(const Sample& x, const Sample& y) {
  const Point2<Lanes> way = y.both.at - x.both.at;
  return TubePointOf<Lanes>::dot(way, way);
}

/// Largest angle between an axis of the box and two unit vectors, where it is below about 0.9 rad; infinite where the
/// box does not tell.
inline double patch_of_box(const Box& box, const Point& x, const Point& y) {
  // Scaled to the height of x along its largest coordinate, the box is a patch near the sphere.
  int k = 0;
  for (int n = 1; n < 3; ++n)
    if (std::abs(x[n]) > std::abs(x[k])) k = n;
  if (contains_zero(box[k])) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int n = 0; n < 3; ++n) {
    const Interval at = box[n] / box[k] * x[k];
    const double across = std::max({upper(at), x[n], y[n]}) - std::min({lower(at), x[n], y[n]});
    sum += across * across;
  }
  return 2 * std::sqrt(sum);  // an angle is at most 1.5 times its chord, and radial scaling at most 1 over |x| - across
}
/// The same from one unit vector.
inline double distance_from_box(const Box& box, const Point& x) { return patch_of_box(box, x, x); }

/// Of two unit vectors; across their plane. Not a number where they are the same.
template <class T>
HalfChordOf<T> chord_between_axes(const Point2<T>& x, const Point2<T>& y) {
  const Vector<T, 3> across = x.cross(y);
  return HalfChordOf<T>::between(x, y, across * (T(1) / TubePointOf<T>::length_of(across)));
}

/// The affine plane z = 1, seen through a square window.
class Plane {
 public:
  static constexpr bool has_opposites = false;
  explicit Plane(double window) : window_(window) {}
  /// (x, y, 1) near the window, a unit vector elsewhere.
  Point place(const Point& x) const {
    const double reach = margin * window_ * std::abs(x[2]);
    if (!(std::abs(x[0]) <= reach && std::abs(x[1]) <= reach) || x[2] == 0) return x.normalized();
    const double scale = 1 / x[2];
    return std::isfinite(scale) ? Point(x[0] * scale, x[1] * scale, 1) : Point(x.normalized());
  }
  bool inside(const Point& x, double factor) const {
    const double reach = factor * window_ * std::abs(x[2]);
    return std::abs(x[0]) <= reach && std::abs(x[1]) <= reach;
  }
  /// Not a number where the points are the same. Precondition: their third coordinates are 1.
  template <class T>
  static std::optional<HalfChordOf<T>> chord(const Point2<T>& x, const Point2<T>& y) {
    const Vector<T, 3> d = (y - x) * T(0.5);
    const T length = TubePointOf<T>::length_of(d), scale = T(1) / length;
    return HalfChordOf<T>{d, {-d[1] * scale, d[0] * scale, T(0)}, length, scale};
  }
  template <class T>
  static T error(const T& radius, const Point2<T>&, const Point2<T>&) {
    return radius;
  }
  /// Whether the tube test proves that the curve between two points, without those within
  /// `off` of z, passes the window on one side. box():
  /// holds the point of the branch at the first of them, so that it is this branch which the tube follows.
  template <class BoxOf>
  bool outside(const TubeCurve& curve, const TubePoint& from, const TubePoint& to, const Point& z, double off,
               const BoxOf& box) const {
    const TubePoint x = from.unit(), y = from.at.dot(to.at) < 0 ? to.unit().opposite() : to.unit();
    for (int k = 0; k < 2; ++k) {
      const double sign = x.at[k] < 0 ? -1 : 1, gap = std::min(sign * x.at[k] - window_ * std::abs(x.at[2]),
                                                               sign * y.at[k] - window_ * std::abs(y.at[2]));
      if (!(gap > 0)) continue;
      const HalfChord chord = chord_between_axes(x.at, y.at);
      const double extent = distance_from_box(box(), x.at);
      const auto proved = std::isfinite(extent) ? tube(curve, x, y, chord, extent) : std::nullopt;
      if (proved && proved->radius * (1 + window_) < gap && !over_chord(x, y, chord, proved->radius, z, off))
        return true;
    }
    return false;
  }
  bool outside(const Box& box) const {
    const double height = window_ * magnitude(box[2]);
    return lower(box[0]) > height || upper(box[0]) < -height || lower(box[1]) > height || upper(box[1]) < -height;
  }
  /// Largest distance from a point of the box to another point or to the samples; infinite where it reaches infinity.
  static double extent(const Box& box, const Point& x, const Point& y) {
    if (contains_zero(box[2])) return std::numeric_limits<double>::infinity();
    const auto along = [&](int k) {
      const Interval at = box[k] / box[2];
      return std::max({upper(at), x[k], y[k]}) - std::min({lower(at), x[k], y[k]});
    };
    return std::hypot(along(0), along(1)) * (1 + 0x1p-40);
  }

 private:
  double window_;
};

/// The unit sphere.
class Sphere {
 public:
  static constexpr bool has_opposites = true;
  static Point place(const Point& x) { return x.normalized(); }
  static bool inside(const Point&, double) { return true; }
  template <class T>
  static std::optional<HalfChordOf<T>> chord(const Point2<T>& x, const Point2<T>& y) {
    if (!all_positive(TubePointOf<T>::dot(x, y) - T(0.5))) return std::nullopt;
    return chord_between_axes(x, y);
  }
  template <class T>
  static T error(const T& radius, const Point2<T>& x, const Point2<T>& y) {
    return 2 * radius / TubePointOf<T>::length_of(x + y) * (1 + 0x1p-40);
  }
  template <class BoxOf>
  static bool outside(const TubeCurve&, const TubePoint&, const TubePoint&, const Point&, double, const BoxOf&) {
    return false;
  }
  static bool outside(const Box&) { return false; }
  static double extent(const Box& box, const Point& x, const Point& y) { return patch_of_box(box, x, y); }
};

}  // namespace burmester::detail
