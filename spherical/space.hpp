// The pose space of the sphere: SO(3) as the whole of P^3, unit quaternions up to scale and sign.
//
// Image point (w, x, y, z) = (cos(angle/2), sin(angle/2) axis); features are axes through the centre, given
// by vectors; their distance is the angle between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "burmester/geometry/number.hpp"
#include "burmester/modules/framework/displacement.hpp"
#include "burmester/modules/framework/pose_space.hpp"
#include "burmester/spherical/pose.hpp"

namespace burmester::spherical {

struct Space : Displacement<std::array{0, 1, 2, 3}, std::array{1, 2, 3}> {
  static constexpr const char* name = "spherical";
  static constexpr int dof = 3;
  using Pose = spherical::Pose;

  /// The quaternion times the power of two that takes its largest coordinate to [1, 2): no answer depends on its norm.
  /// Exact (coordinates below 2^-1022 of the largest may vanish).
  template <class T>
  static Point<T> point(const Pose& p) {
    const double largest = std::max({std::abs(p.w), std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double guard = largest < 0x1p-1000 ? 0x1p100 : largest > 0x1p1000 ? 0x1p-100 : 1;  // its inverse is normal
    const double scale = unit_scale(guard * largest);
    return {T(scale * (guard * p.w)), T(scale * (guard * p.x)), T(scale * (guard * p.y)), T(scale * (guard * p.z))};
  }
  static Pose pose(const Point<double>& x) { return {x[0], x[1], x[2], x[3]}; }

  /// p followed in the moving frame by the rotation with rotation vector u (radians).
  static Pose nudged(const Pose& p, const Vector<double, dof>& u) {
    const double half = u.norm() / 2, s = half > 0 ? std::sin(half) / (2 * half) : 0.5;
    return pose(product<double>(point<double>(p), {std::cos(half), s * u[0], s * u[1], s * u[2]}));
  }

  /// Angle between directed axes in [0, pi]; accurate at both ends, where an arc cosine is not.
  static double distance(const Feature<double>& a, const Feature<double>& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  /// Uniform on the group: four normal coordinates, normalised.
  static Pose random_pose(Random& random) { return pose(direction<ambient + 1>(random)); }
  /// Uniform on the unit sphere.
  static Feature<double> random_feature(Random& random) { return direction<feature_size>(random); }

 private:
  template <int n>
  static Vector<double, n> direction(Random& random) {
    Vector<double, n> v;
    for (int i = 0; i < n; ++i) v[i] = random.normal();
    return v.normalized();
  }
};
static_assert(PoseSpace<Space>);

}  // namespace burmester::spherical
