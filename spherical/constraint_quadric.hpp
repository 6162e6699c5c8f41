// The constraint manifold of a spherical dyad: the poses that meet it, as a quadric of the image space P^3.
//
// With the lifted form k (family.hpp) and the image point (w, x, y, z): Family::row . k, ordered by monomials.
#pragma once

#include "burmester/geometry/quadric.hpp"
#include "burmester/spherical/family.hpp"

namespace burmester::spherical {

/// constraint_quadric(k)(Space::point(pose)) = Family::row(pose) . k, as polynomials in the pose.
template <class T>
Quadric<T> constraint_quadric(const Vector<T, 10>& k) {
  return {{T(k[0] + k[4] + k[8] + k[9]), T(k[0] - k[4] - k[8] + k[9]), T(k[4] - k[0] - k[8] + k[9]),
           T(k[8] - k[0] - k[4] + k[9]), T(2 * (k[7] - k[5])), T(2 * (k[2] - k[6])), T(2 * (k[3] - k[1])),
           T(2 * (k[1] + k[3])), T(2 * (k[2] + k[6])), T(2 * (k[5] + k[7]))}};
}

}  // namespace burmester::spherical
