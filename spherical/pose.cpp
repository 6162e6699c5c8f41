#include "burmester/spherical/pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/spherical/space.hpp"

namespace burmester::spherical {
namespace {

using Axis = std::array<double, 3>;
constexpr Axis x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

struct Half {
  double sine, cosine;
};

// Sine and cosine of half an angle, in long double, rounded once to double.
Half half_of_radians(double angle) {
  const long double half = static_cast<long double>(angle) / 2;
  return {static_cast<double>(std::sin(half)), static_cast<double>(std::cos(half))};
}

Half half_of_degrees(double angle) {
  // Quarter turns of the half angle are taken off in degrees, where they are exact.
  const double half = std::fmod(angle, 720.0) / 2;
  const double quarters = std::nearbyint(half / 90);
  const long double rest = (half - 90 * quarters) * (std::numbers::pi_v<long double> / 180);
  const double s = static_cast<double>(std::sin(rest)), c = static_cast<double>(std::cos(rest));
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, 0 - s};
    case 2:
      return {0 - s, -c};
    default:
      return {-c, s};
  }
}

Pose about(const Axis& axis, Half half) {
  const double largest = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
  const Vector<double, 3> a{axis[0] / largest, axis[1] / largest, axis[2] / largest};
  const Vector<double, 3> v = half.sine / a.norm() * a;
  return {half.cosine, v[0], v[1], v[2]};
}

Pose globe(Half longitude, Half latitude, Half roll) {
  const auto point = [](const Axis& axis, Half half) { return Space::point<double>(about(axis, half)); };
  const auto tilted =
      Space::product<double>(point(z_axis, longitude), point(y_axis, {-latitude.sine, latitude.cosine}));
  return Space::pose(Space::product<double>(tilted, point(x_axis, roll)));
}

}  // namespace

Pose pose_from_axis_radians(const Axis& axis, double angle) { return about(axis, half_of_radians(angle)); }
Pose pose_from_axis_degrees(const Axis& axis, double angle) { return about(axis, half_of_degrees(angle)); }

Pose pose_from_globe_radians(double longitude, double latitude, double roll) {
  return globe(half_of_radians(longitude), half_of_radians(latitude), half_of_radians(roll));
}
Pose pose_from_globe_degrees(double longitude, double latitude, double roll) {
  return globe(half_of_degrees(longitude), half_of_degrees(latitude), half_of_degrees(roll));
}

// q q^T is linear in Q (I. Bar-Itzhack, "New Method for Extracting the Quaternion from a Rotation Matrix",
// 2000); its longest column is q up to scale, free of cancellation.
Pose pose_from_matrix(const std::array<std::array<double, 3>, 3>& m) {
  const double t = m[0][0] + m[1][1] + m[2][2];
  Eigen::Matrix4d outer;
  outer << 1 + t, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1],           //
      m[2][1] - m[1][2], 1 + 2 * m[0][0] - t, m[0][1] + m[1][0], m[0][2] + m[2][0],  //
      m[0][2] - m[2][0], m[0][1] + m[1][0], 1 + 2 * m[1][1] - t, m[1][2] + m[2][1],  //
      m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 + 2 * m[2][2] - t;
  int longest = 0;
  outer.diagonal().maxCoeff(&longest);
  const Vector<double, 4> q = outer.col(longest).normalized();
  return Space::pose(q[0] < 0 ? Vector<double, 4>(-q) : q);
}

AxisAngle axis_angle_of(const Pose& pose) {
  const Vector<double, 4> q = Space::point<double>(pose);
  const double sine = std::hypot(q[1], q[2], q[3]);
  if (sine == 0) return {z_axis, 0};
  const double sign = q[0] < 0 ? -1 : 1;
  const auto along = [&](double c) { return sign * c / sine + 0.0; };
  return {{along(q[1]), along(q[2]), along(q[3])}, 2 * std::atan2(sine, std::abs(q[0]))};
}

}  // namespace burmester::spherical
