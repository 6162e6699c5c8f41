// The five-orientation synthesis equations of the sphere, in unknowns that stay regular for small and for nearly
// coaxial rotations.
//
// Let one pose be the reference, (c_j, s_j) the quaternion of the rotation from it to pose j, a the moving axis in the
// reference pose and b the fixed axis, both in S. The angle between them is kept when
//     c_j s_j . (a x b) - (s_j x a) . (s_j x b) = 0,   j = 1..4,                                     (1)
// which is linear in a x b and in the symmetric part of a b^T, and homogeneous in the quaternion. Where all rotations
// are small (|s_j| about e) the first part dominates, and a and b agree to order e: so the unknowns are
//     W = a x b / e,   S = (a b^T + b a^T) / 2,                                                      (2)
// and four equations on k = (W, S) in P^8 meet the variety (scaled Segre variety, degree 6)
//     S W = 0,   adj S + (e^2 / 4) W W^T = 0,   parametrised by   W = -2 m x h,  S = m m^T - e^2 h h^T,   (3)
// a = m + e h, b = m - e h. Where all axes s_j agree to an angle d, the finite solutions lie within d of that axis z
// (their limit is the planar problem in the tangent plane): with D = diag(d, d, 1), a = D a', b = D b', s_j = e D t_j
// equation (1) becomes, divided by e^2 d^2,
//     c_j t_j . W' - (t_j x a')^T diag(1, 1, d^2) (t_j x b') = 0,                                    (4)
// regular as d -> 0 too; (2) and (3) hold for a', b'. With d = 1 it is (1).
//
// Equation (1) is equation (6) of J. Angeles and S. Bai, "A robust solution of the spherical Burmester problem" (there
// with matrices); the scalings (2) to (4) are ours.
#pragma once

#include <array>

#include "burmester/geometry/vector.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

using Vector3 = Vector<double, 3>;

/// k = (W1, W2, W3, S11, S22, S33, S12, S13, S23).
using Lifted = Vector<double, 9>;

/// A dyad in scaled unknowns: (3), up to the lengths of a and b.
struct ScaledDyad {
  Vector3 m, h;
};

struct FivePoseEquations {
  int reference = 0;    ///< a pose of the closest pair: small rotations are then formed once, without cancellation
  double e = 1, d = 1;  ///< powers of two; d = 1 unless the axes nearly agree
  Matrix<double, 3, 3> frame;  ///< of the scaled coordinates, by rows, in S; the identity where d = 1
  Matrix<double, 4, 9> rows;   ///< rows . k = 0 is (4), each row of order 1
  Vector<double, 4> sine;      ///< of half the angle from the reference pose, for each row
  double closest = 0;          ///< sine of half the smallest angle between two poses
  double spread = 0;           ///< largest |s_j x z|: 0 when all rotations have one axis
};

/// Two equal orientations, or axes, may differ by this much: the coordinates of unit quaternions rounded twice.
inline constexpr double same_tolerance = 0x1p-50;
/// Axis times the sine of half the angle of the rotation from one pose to the other, in S; small ones lose nothing.
Vector3 half_angle_sine(const Pose& from, const Pose& to);
/// Whether two poses have the same orientation, up to rounding the data.
bool same_orientation(const Pose& a, const Pose& b);

/// Left side of (4) as row . k, dd = d^2.
Vector<double, 9> kept_angle(double c, const Vector3& t, double dd);

/// The equations of five poses. `rows` is only set where closest > 0 and spread > 0.
FivePoseEquations five_pose_equations(FivePoses poses);

/// (W, S) of a dyad.
Lifted lifted(const ScaledDyad& x, double e);
/// The nine relations (3) as a function of any k, quadratic.
Lifted scaled_relations(const Lifted& k, double e);
/// The dyad of a k that meets the relations, or comes near to it.
ScaledDyad scaled_dyad(const Lifted& k, double e);
/// The dyad of two axes in scaled coordinates.
ScaledDyad scaled_dyad(const Vector3& a, const Vector3& b, double e);

/// One Newton step on (4) in m and h. Near a double root, where rounding makes the step, only as far as it helps.
/// Returns the length of the step that was taken, in units of m and h.
double improve(const FivePoseEquations& equations, ScaledDyad& x);

/// The dyad as an RR whose moving axis is in E. The arc is accurate near 90 deg and near 0.
RR::Design dyad_of(const FivePoseEquations& equations, const ScaledDyad& x, FivePoses poses);

}  // namespace burmester::spherical
