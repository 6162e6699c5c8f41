// The angles between a fixed and a moving axis in many orientations, with their first and second derivatives, to the
// last digits however close the orientations are.
//
// Seen from one orientation, the reference, let orientation j be turned by the unit quaternion (c_j, e t_j), e the size
// of the largest turn, and let theta_0 and theta_j be the angles between the axes a and b there. Then
//     cos(theta_j) - cos(theta_0) = 2 e^2 [c_j t_j . W - (t_j x a) . (t_j x b)],   W = a x b / e,         (1)
// is linear in k = (W, S), S = (a b^T + b a^T) / 2 (five_pose_equations.hpp), and so are its derivatives in those of k.
// The cosine and the sine of theta_0 are kept with the axes, so that with (1) neither theta_j - theta_0 nor its
// derivatives lose digits to the part that all angles have in common, be theta_0 about e or about 1. The arc of an RR
// is the mean of the angles (exact variable projection); it is 90 deg for a slider. What is left are errors as
// functions of the axes: four variables, alpha moving a against b, in units of about the larger of e and sin(theta_0),
// and beta turning both. Angles are in radians.
#pragma once

#include <span>

#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// Many orientations as seen from the first.
struct TurnedTask {
  Pose reference;
  double e = 0;                                   ///< sine of half the largest turn; 0: all orientations are equal
  Eigen::VectorXd c;                              ///< of each orientation
  Eigen::Matrix3Xd t;                             ///< one column for each
  Eigen::Matrix<double, Eigen::Dynamic, 9> rows;  ///< bracket of (1) as rows . k; set where e > 0
  Eigen::VectorXd weights;
  Eigen::VectorXd shift;  ///< errors are counted from here: zero but for orientations in met_exactly
};

/// Precondition: one pose or more; weights not negative, one for each pose; the first is positive.
TurnedTask turned_task(std::span<const Pose> poses, std::span<const double> weights);

/// Two axes as seen in the reference orientation: b = frame.col(0), a = cosine frame.col(0) + sine frame.col(1). Cosine
/// and sine are both known to all digits.
struct AxesAt {
  Eigen::Matrix3d frame;
  double cosine = 0, sine = 1;  ///< not negative
};

/// Axes of any length but zero.
AxesAt axes_at(const Eigen::Vector3d& fixed, const Eigen::Vector3d& moving);
Eigen::Vector3d moving_axis(const AxesAt& x);

/// Unit of alpha: hypot(sin(theta_0), e), at most 1: about e for angles of the size of the turns.
double length_of_alpha(const TurnedTask& task, const AxesAt& x);

/// The neighbour of x at the given (alpha, beta): a moves along its tangents, then both turn.
AxesAt moved(const TurnedTask& task, const AxesAt& x, const Eigen::Vector4d& u);

/// One column for each orientation, derivatives by (alpha, beta); the weighted mean of those of an RR is zero. Not
/// finite where the axes coincide or are opposite in an orientation. Precondition: e > 0.
struct AngleErrors {
  double arc = 0;                                   ///< weighted mean of the angles; of a slider 90 deg
  Eigen::VectorXd values;                           ///< angles less the arc and the shifts
  Eigen::Matrix4Xd slopes;                          ///< gradients
  Eigen::Matrix<double, 16, Eigen::Dynamic> bends;  ///< Hessians, 4 x 4 by columns
};
template <class D>
AngleErrors angle_errors(const TurnedTask& task, const AxesAt& x);

/// As condition.hpp, as if all weights were equal, but to all digits of close orientations: the poses' local
/// coordinates move each angle by 1. Radians per radian; infinite where the angles do not fix the dyad. Precondition: e
/// > 0.
template <class D>
double condition_of(const TurnedTask& task, const AxesAt& x);

}  // namespace burmester::spherical
