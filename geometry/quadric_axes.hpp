// Principal axes of a real quadric of space: centre and semi-axes, or vertex and parameters.
//
// Chart x3 = 1, where (x0, x1, x2) are Cartesian coordinates x: Q = x^T A x + 2 b^T x + c. The axes are the
// eigenvectors of A, its eigenvalues l the roots of the discriminating cubic (G. Salmon, "A treatise on the analytic
// geometry of three dimensions", 1882). With a centre m = -A^-1 b the quadric is sum l_i u_i^2 + Q(m) = 0, u_i =
// axis[i] . (x - m). A paraboloid has one eigenvalue 0, the direction of its axis. Rounded, not proved: for the class
// see quadric_class.hpp, for conics conic_class.hpp.
#pragma once

#include <array>

#include "burmester/geometry/quadric.hpp"

namespace burmester {

/// sum u_i^2 / square[i] = 1, square[0] >= square[1] >= square[2]: squared semi-axes where positive; an ellipsoid has
/// three of them, hyperboloids of one and two sheets two and one, an imaginary ellipsoid none.
/// The axes are orthonormal, right-handed.
struct QuadricAxes {
  Vector<double, 3> centre;
  std::array<Vector<double, 3>, 3> axis;
  std::array<double, 3> square;
};
/// Precondition: an ellipsoid (imaginary too) or a hyperboloid.
QuadricAxes axes_of(const Quadric<double>& quadric);

/// u_0^2 / parameter[0] + u_1^2 / parameter[1] = 2 w, w = axis . (x - vertex), u_i = principal[i] . (x - vertex).
/// Elliptic: parameter[0] >= parameter[1] > 0, and the axis points into the paraboloid. Hyperbolic: parameter[1] < 0 <
/// parameter[0], the latter at least as large. (principal[0], principal[1], axis) is orthonormal, right-handed.
struct ParaboloidFrame {
  Vector<double, 3> vertex, axis;
  std::array<Vector<double, 3>, 2> principal;
  std::array<double, 2> parameter;
};
/// Precondition: an elliptic or hyperbolic paraboloid.
ParaboloidFrame paraboloid_frame(const Quadric<double>& quadric);

}  // namespace burmester
