// The lifted family of the spherical dyads: both types in one projective space, the constraint manifold.
//
// With x the image point and N = norm(x), the constraint is a quadric of P^3 that is linear in
//   k = [b (x) a row by row, -cos(arc)]:   row(x) . k = N (b . Q a) - N cos(arc).
// k is a dyad where its 3 x 3 part has rank one; |a| = |b| = 1 fixes the scale, and |cos(arc)| <= 1 makes it
// real. Slider: the last entry is 0.
#pragma once

#include <optional>

#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// An arc this close to 90 deg makes a slider (radians).
inline constexpr double slider_arc_tolerance = 1e-9;

struct Family {
  using Space = spherical::Space;
  using Design = Dyads::Design;
  static constexpr int dimension = 10, relation_count = 9;

  template <class T>
  static Vector<T, dimension> row(const Pose& pose) {
    const Space::Point<T> q = Space::point<T>(pose);
    const T &w = q[0], &x = q[1], &y = q[2], &z = q[3];
    const T ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    const T wx = T(2) * w * x, wy = T(2) * w * y, wz = T(2) * w * z;
    const T xy = T(2) * x * y, yz = T(2) * y * z, zx = T(2) * z * x;
    Vector<T, dimension> out;
    out << ww + xx - yy - zz, xy - wz, zx + wy,  //
        xy + wz, ww - xx + yy - zz, yz - wx,     //
        zx - wy, yz + wx, ww - xx - yy + zz,     //
        ww + xx + yy + zz;
    return out;
  }

  /// The nine 2 x 2 minors of the 3 x 3 part; minor i, j leaves out row i and column j.
  template <class T>
  static Vector<T, relation_count> relations(const Vector<T, dimension>& k) {
    const auto m = [&](int i, int j) -> const T& { return k[3 * (i % 3) + j % 3]; };
    Vector<T, relation_count> out;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        out[3 * i + j] = m(i + 1, j + 1) * m(i + 2, j + 2) - m(i + 1, j + 2) * m(i + 2, j + 1);
    return out;
  }

  /// The dyad of k, or of the rank-one matrix nearest to its 3 x 3 part. Empty where that part is zero or the
  /// arc is not real. A slider where the arc is within slider_arc_tolerance of 90 deg.
  static std::optional<Design> decode(const Vector<double, dimension>& k);
};

}  // namespace burmester::spherical
