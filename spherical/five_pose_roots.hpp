// Five orientations: all real dyads in one solve, in the scaled unknowns of five_pose_equations.hpp. Two paths:
//
// Sextic, for rotations of ordinary size. With a = (x, u) split into one coordinate and a point u of the projective
// line, elimination of x b from the four bilinear equations leaves x b = P(u) b and c(u) . b = 0, linear in u. So b is
// an eigenvector of P that c does not see: c, c P and c P P are orthogonal to b, and their determinant, of degrees 1 +
// 2 + 3, is a binary form whose real roots (geometry/binary_roots.hpp) are the dyads: b = c x cP, x = b . P b / b . b.
//
// Action, where rotations are so small that this elimination has small pivots, or two of its roots are close: the null
// space of the four equations on k = (W, S) carries the six dyads as the common points of nine quadrics of P^4; a basis
// of the cubic forms modulo the ideal (Macaulay's matrix in degree three, 45 x 35 of rank 29) gives multiplication by a
// linear form as a 6 x 6 matrix, whose real eigenvectors are the dyads. D. Cox, J. Little, D. O'Shea, "Using Algebraic
// Geometry", 2nd ed. 2005, chapters 2 and 3.
//
// Both end with Newton steps in the scaled unknowns. No allocation on the first path.
#pragma once

#include <optional>

#include "burmester/spherical/degeneracy.hpp"

namespace burmester::spherical {

enum class FivePosePath { sextic, action };

struct FivePoseRoots {
  Degeneracy what = Degeneracy::none;  ///< within rounding; nothing is listed with any other
  FivePosePath path = FivePosePath::sextic;
  bool indistinct = false;  ///< orientations or axes of rotations agree almost to within rounding of the data
  bool decided = true;      ///< false where the numbers do not tell the dyads: nothing is listed
  bool merging = false;     ///< two dyads merge within rounding: the count may be off by two
  bool close = false;       ///< two roots of the sextic are near each other, real or not
  double pivot = 0;         ///< smallest pivot of the elimination of the path taken, relative to its largest
  FivePoseEquations equations;
  int count = 0;
  std::array<ScaledDyad, 6> root;
};

/// Where the sextic's smallest pivot, relative, is below this, the action path is taken (docs/spherical.md has the
/// measurements behind the number).
inline constexpr double least_sextic_pivot = 0x1p-12;

/// Where infinitely many dyads have one moving axis this may list others and not say so; FivePoseSolver does.
FivePoseRoots five_pose_roots(FivePoses poses);

/// One path whatever the pivots say, for tests and measurements. Nothing is listed for degenerate poses.
FivePoseRoots five_pose_roots(FivePoses poses, FivePosePath path);

namespace detail {
/// What the action path works with: k = basis z; values of the six linear functions on the cubic monomials of z that
/// vanish on the ideal; multiplication by a quotient of two linear forms, whose eigenvectors name those of the six
/// points.
struct Action {
  Matrix<double, 9, 5> basis;
  Matrix<double, 35, 6> dual;
  Matrix<double, 6, 6> matrix;
};
/// Nothing where there are infinitely many dyads.
std::optional<Action> action_of(const FivePoseEquations& equations);

/// Appends the real dyads of equations of full rank; false where the path cannot tell them.
bool add_sextic_roots(double least_pivot, FivePoseRoots& out);
bool add_action_roots(FivePoseRoots& out);
}  // namespace detail

}  // namespace burmester::spherical
