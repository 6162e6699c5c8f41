// The planar pose space: SE(2) as points of P^3 in Blaschke-Gruenwald coordinates.
//
// A point is (X4, X3, X2, -X1), the basis elements {1, k, ei, ej} of the dual quaternions, with
//   X1 = x sin(angle/2) - y cos(angle/2),  X2 = x cos(angle/2) + y sin(angle/2),
//   X3 = 2 sin(angle/2),                   X4 = 2 cos(angle/2)
// (O. Bottema, B. Roth, "Theoretical Kinematics", 1979, chapter XI; Hayes and Zsombor-Murray). Points with
// X3 = X4 = 0 are no displacements.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "burmester/geometry/random.hpp"
#include "burmester/modules/framework/displacement.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

using Vector2 = Vector<double, 2>;

struct Space : Displacement<std::array{0, 3, 5, 6}, std::array{1, 2}> {
  static constexpr const char* name = "planar";
  static constexpr int dof = 3;
  using Pose = planar::Pose;

  template <class T>
  static Point<T> point(const Pose& p) {
    const T x(p.x), y(p.y), s(p.X3), c(p.X4);
    return {T(2 * c), T(2 * s), T(x * c + y * s), T(y * c - x * s)};
  }
  static Pose pose(const Point<double>& p) {
    const double n = norm<double>(p), size = std::sqrt(n);
    return {2 * (p[2] * p[0] - p[3] * p[1]) / n, 2 * (p[2] * p[1] + p[3] * p[0]) / n, p[1] / size, p[0] / size};
  }
  /// p shifted by (u0, u1) in S and turned by u2 about its origin: length units and radians.
  static Pose nudged(const Pose& p, const Vector<double, dof>& u) {
    const double s = std::sin(u[2] / 2), c = std::cos(u[2] / 2);
    return {p.x + u[0], p.y + u[1], p.X3 * c + p.X4 * s, p.X4 * c - p.X3 * s};
  }
  static double distance(const Vector2& a, const Vector2& b) { return (a - b).norm(); }
  static Pose random_pose(Random& random) {
    const double x = random.normal(), y = random.normal();
    return pose_from_radians(x, y, random.uniform(-std::numbers::pi, std::numbers::pi));
  }
  static Vector2 random_feature(Random& random) {
    const double x = random.normal();
    return {x, random.normal()};
  }
};

/// Blaschke-Gruenwald coordinates (X1, X2, X3, X4) of a point of P^3, and back.
inline Vector<double, 4> image_coordinates(const Space::Point<double>& p) { return {-p[3], p[2], p[1], p[0]}; }
/// Blaschke-Gruenwald coordinates of a pose, up to scale.
inline Vector<double, 4> image_point(const Pose& pose) {
  return image_coordinates(Space::point<double>(pose));
}
inline Space::Point<double> point_of_image(const Vector<double, 4>& X) { return {X[3], X[2], X[1], -X[0]}; }
/// The pose with these image coordinates, of any scale; X4 = 0 is a half turn. Empty for X3 = X4 = 0, the points of P^3
/// that are no displacement.
inline std::optional<Pose> pose_of_image(const Vector<double, 4>& X) {
  if (X[2] == 0 && X[3] == 0) return std::nullopt;
  return Space::pose(point_of_image(X));
}

/// Rotation by a pose's angle: p in E -> direction in S.
inline Vector2 rotated(const Pose& pose, const Vector2& p) {
  const double n = pose.X4 * pose.X4 + pose.X3 * pose.X3;
  const double c = (pose.X4 - pose.X3) * (pose.X4 + pose.X3) / n, s = 2 * pose.X3 * pose.X4 / n;
  return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}
/// A point of E in S.
inline Vector2 to_fixed(const Pose& pose, const Vector2& p) { return rotated(pose, p) + Vector2(pose.x, pose.y); }
/// A point of S in E.
inline Vector2 to_moving(const Pose& pose, const Vector2& p) {
  return rotated({0, 0, -pose.X3, pose.X4}, p - Vector2(pose.x, pose.y));
}

}  // namespace burmester::planar
