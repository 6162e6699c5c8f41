// Poles: the points about which the body turns from one pose to another.
//
// Homogeneous coordinates (P0 : P1 : P2): the pole at (P0, P1) / P2. A translation has its pole at infinity, P2 = 0, at
// right angles to its direction; for two equal poses everything is zero. In Blaschke-Gruenwald coordinates the pole of
// a displacement is X1 : X2 : X3 (O. Bottema, B. Roth, "Theoretical Kinematics", 1979, chapter XI).
#pragma once

#include "burmester/geometry/conic.hpp"
#include "burmester/planar/space.hpp"

namespace burmester::planar {

/// Of the displacement that takes S to a pose: the point with the same coordinates in S and in E.
template <class T = double>
Point2<T> pole(const Pose& pose) {
  const Vector<T, 4> p = Space::point<T>(pose);
  return {T(-p[3]), p[2], p[1]};
}

/// P_ij, in S: the point of the body that is at one place of S in both poses.
template <class T = double>
Point2<T> relative_pole(const Pose& i, const Pose& j) {
  const Vector<T, 4> p = Space::product<T>(Space::point<T>(j), Space::conjugate<T>(Space::point<T>(i)));
  return {T(-p[3]), p[2], p[1]};
}

/// The same point in E. Carried to a third pose, to_fixed(home, ..), it is the image pole of P_ij in that pose.
template <class T = double>
Point2<T> moving_pole(const Pose& i, const Pose& j) {
  const Vector<T, 4> p = Space::product<T>(Space::conjugate<T>(Space::point<T>(i)), Space::point<T>(j));
  return {T(-p[3]), p[2], p[1]};
}

}  // namespace burmester::planar
