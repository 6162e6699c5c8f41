// The angles between a fixed and a moving axis in many orientations, with their first and second derivatives, to the
// last digits however close the orientations are; and the nearest local minimum of their errors.
//
// Seen from one orientation, the reference, let orientation j be turned by the unit quaternion (c_j, e t_j), e the size
// of the largest turn, and let theta_0 and theta_j be the angles between the axes a and b there. Then
//     cos(theta_j) - cos(theta_0) = 2 e^2 [c_j t_j . W - (t_j x a) . (t_j x b)],   W = a x b / e,         (1)
// is linear in k = (W, S), S = (a b^T + b a^T) / 2 (five_pose_equations.hpp), and so are its derivatives in those of k.
// The cosine and the sine of theta_0 are kept with the axes, so that with (1) neither theta_j - theta_0 nor its
// derivatives lose digits to the part that all angles have in common, be theta_0 about e or about 1. The arc of an RR
// is the mean of the angles (exact variable projection); it is 90 deg for a slider. What is left is the weighted sum of
// squares of the errors as a function of the axes: four variables, alpha moving a against b, in units of the larger of
// e and sin(theta_0), and beta turning both. Newton steps in a trust region of these lead to a minimum; where errors do
// not vanish, those of Gauss and Newton need not. A step that leaves the floor of a curved valley (heavy orientations)
// is followed by one across the valley before it is judged.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// Many orientations as seen from the first.
struct TurnedTask {
  Pose reference;
  double e = 0;                                   ///< sine of half the largest turn; 0: all orientations are equal
  Eigen::VectorXd c;                              ///< of each orientation
  Eigen::Matrix3Xd t;                             ///< one column for each
  Eigen::Matrix<double, Eigen::Dynamic, 9> rows;  ///< bracket of (1) as rows . k
  Eigen::VectorXd weights;
  Eigen::VectorXd shift;  ///< errors are counted from here: zero but for orientations in met_exactly
};

/// Precondition: weights not negative, one for each pose; the first is positive.
TurnedTask turned_task(std::span<const Pose> poses, std::span<const double> weights);

/// Two axes as seen in the reference orientation: b = frame.col(0), a = cosine frame.col(0) + sine frame.col(1). Cosine
/// and sine are both known to all digits.
struct AxesAt {
  Eigen::Matrix3d frame;
  double cosine = 0, sine = 1;  ///< not negative
};

/// Axes of any length but zero.
AxesAt axes_at(const Eigen::Vector3d& fixed, const Eigen::Vector3d& moving);

/// Half the weighted sum of squares with its derivatives by (alpha, beta).
struct ErrorSum {
  double value = 0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
  double arc = 0;          ///< mean angle; of a slider 90 deg
  Eigen::VectorXd errors;  ///< angles less the arc and the shifts
};
template <class D>
ErrorSum error_sum(const TurnedTask& task, const AxesAt& x);

template <class D>
struct AngleFit {
  AxesAt axes;
  typename D::Design design;
  double sum = 0;  ///< of the weighted squares
  Eigen::VectorXd errors;
  bool least = false;  ///< a local minimum: the gradient is zero to rounding, the Hessian not negative
};

/// The local minimum that the steps from a start lead to.
template <class D>
AngleFit<D> nearest_fit(const TurnedTask& task, const AxesAt& start, int steps);

/// The local minimum near a fit, with the orientations of the given numbers met to rounding: multipliers (M. R.
/// Hestenes, M. J. D. Powell, 1969) in the form of shifts, each round takes back what the last left. Its sum is that of
/// the other orientations. Empty where that fails. Precondition: weights of these are large against the others.
template <class D>
std::optional<AngleFit<D>> met_exactly(TurnedTask task, const AngleFit<D>& fit, std::span<const Eigen::Index> which,
                                       int steps);

/// Whether two fits are one: axes within `same`, and a x b within as much of the unit of alpha.
template <class D>
bool same_fit(const TurnedTask& task, const AngleFit<D>& x, const AngleFit<D>& y, double same = 1e-6);

/// As condition.hpp, but to all digits of close orientations: the poses' local coordinates move each angle by 1.
template <class D>
double condition_of(const TurnedTask& task, const AxesAt& x);

}  // namespace burmester::spherical
