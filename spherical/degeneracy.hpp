// Orientations with more dyads than others of their number: of which kind, told within rounding by how far the
// orientations are from such.
//
// In all kinds but the first an axis takes at most two places: v, of E, is in one place in a group of the five and in
// another in the rest. Unit quaternions of one group are then p (c + s v), one line of the plane C^2 that right
// multiplication by v makes of R^4. So the least change of n of them that brings v to one place is the smaller singular
// value of a 2 x n matrix over C, whose 2 x 2 minors are of the size |s_ij x v|, s_ij the vector part of the rotation
// from i to j: its square is, with an error of the fourth order,
//     sum over i < j of |s_ij x v|^2 / n.
// The least sum of both groups over all unit v is that of the two smaller eigenvalues of sum s_ij s_ij^T / n; its root
// is the distance of the unit quaternions from such. Axes of S: the same of the inverse rotations. With all n in one
// group it is their distance from rotations about one axis.
#pragma once

#include <span>
#include <string>

#include "burmester/spherical/five_pose_equations.hpp"

namespace burmester::spherical {

enum class Degeneracy {
  none,                ///< of none of these kinds, or not proved
  equal_orientations,  ///< two orientations are equal: in effect fewer, of five four, with curves of dyads
  one_axis,            ///< all rotate about one axis: every axis with that one
  rank_deficient,      ///< the four conditions on b (x) a are dependent: four orientations rotate about one axis
  // Beside each of those below there may be other dyads.
  moving_on_circle,  ///< a moving axis takes only two places: the fixed axes with it are a great circle
  fixed_on_circle,   ///< the same seen from the body
  both_on_circles    ///< both: three orientations about one axis, the other two with that axis turned over
};

struct NearDegeneracy {
  Degeneracy kind = Degeneracy::none;  ///< of orientations within same_tolerance, from rank_deficient on
  double distance = 0;                 ///< the least change of the unit quaternions, all together, that gives one such
};
/// Closer than this to being equal, or to one of the kinds above, rounding of the data changes what is left of the
/// distance by 2^-18 or more.
inline constexpr double indistinct_tolerance = 0x1p-33;

/// Four orientations about one axis, or an axis in two places.
NearDegeneracy axis_in_two_places(FivePoses poses);

/// The least change of the unit quaternions of two to five orientations, all together, that gives rotations about one
/// axis.
double distance_from_one_axis(std::span<const Pose> poses);

/// In words. `same`: whether two of the poses count as equal. what: not none.
std::string name_degeneracy(Degeneracy what, std::span<const Pose> poses, bool (*same)(const Pose&, const Pose&));

/// Why two to four orientations are met by more dyads than others, or by another kind of family: two of them are equal
/// or, of three or four, all rotate about one axis. "..., within rounding" where the doubles given do so only to
/// same_tolerance. Empty for all others.
std::string degeneracy_of(std::span<const Pose> poses);

}  // namespace burmester::spherical
