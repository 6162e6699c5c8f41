// The constraint manifold of a dyad: the poses that meet it, as a quadric of the image space P^3.
//
// With image coordinates X1 : X2 : X3 : X4 (space.hpp) and the family's lifted form k (family.hpp) it is
//   K0 (X1^2 + X2^2) + (K1 - K0 x) X1 X3 + (K2 - K0 y) X2 X3 - (K2 + K0 y) X1 X4 + (K1 + K0 x) X2 X4
//   + 1/4 (k5 - 2 k6) X3^2 + k7 X3 X4 + 1/4 (k5 + 2 k6) X4^2 = 0,   k5 = K0 (x^2 + y^2) + K3
// (Hayes, Luu, Chang, ARK 2004, the sign of K0 x in X1 X3 put right), here as a form on Space::point, in the
// coordinates (X4, X3, X2, -X1). RR: a hyperboloid of one sheet, PR and RP: hyperbolic paraboloids through the line
// X3 = X4 = 0, PP: a double plane.
#pragma once

#include <optional>

#include "burmester/geometry/quadric.hpp"
#include "burmester/planar/family.hpp"

namespace burmester::planar {

/// constraint_quadric(k)(Space::point(pose)) = Family::row(pose) . k, as polynomials in the pose.
template <class T>
Quadric<T> constraint_quadric(const Vector<T, 8>& k) {
  const T quarter = T(1) / T(4);
  return {{T(quarter * (k[5] + 2 * k[6])), T(quarter * (k[5] - 2 * k[6])), k[0], k[0], k[7], T(k[1] + k[3]),
           T(k[2] + k[4]), T(k[2] - k[4]), T(k[3] - k[1]), T(0)}};
}

/// The same for a design; for far pivots too, whose k loses the length of the link to rounding.
Quadric<double> constraint_quadric(const Family::Design& design);

/// The design that a record shows; empty where its type or its entries are not those of a planar dyad.
std::optional<Family::Design> design_of(const DyadRecord& record);

}  // namespace burmester::planar
