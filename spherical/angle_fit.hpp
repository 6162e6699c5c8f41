// The nearest local minimum of the weighted sum of squares of the angular errors (angle_errors.hpp).
//
// With the weighted errors E as functions of the four variables, J = E' and the Hessians H_j of the errors, a step
// solves (J^T J + sum_j w_j e_j H_j) u = -J^T E in a trust region, downwards along all modes: where errors do not
// vanish, steps of Gauss and Newton need not converge. Instead of E, the sum has its part across the columns of J: at a
// minimum both are the same, away from it that is the second derivative of the surface E(u) itself (D. M. Bates, D. G.
// Watts, 1980), and it has fewer rounding errors. Orientations about nearly one axis, or in clusters, leave valleys
// that are steeper across than along by the square of how near they are. So the matrix is formed in the singular
// vectors of J, where its entries are accurate to the size of their row and column, and diagonalised by Jacobi's
// rotations, which keep that where it is positive definite, as at a minimum (J. Demmel, K. Veselic, 1992). A step that
// leaves the floor of a curved valley (heavy orientations) is followed by one across the valley before it is judged.
#pragma once

#include <optional>
#include <span>

#include "burmester/spherical/angle_errors.hpp"

namespace burmester::spherical {

template <class D>
struct AngleFit {
  AxesAt axes;
  typename D::Design design;
  double sum = 0;          ///< of the weighted squares
  Eigen::VectorXd errors;  ///< angles less the arc and the shifts
  bool least = false;      ///< a local minimum, as far as rounding tells: no step takes away more, no mode bends down
  bool sure = false;       ///< all modes bend up by more than rounding, and the place is known to a thousandth
  bool met = false;        ///< all errors are rounding
  double known = 0;        ///< length of the last Newton step: to that the axes are known
};

/// The local minimum that at most so many steps from a start lead to; `least` is false where they do not. Axes, sum and
/// errors may be infinite or NaN where angles are at a start, as they are where the axes coincide. Precondition: e > 0.
template <class D>
AngleFit<D> nearest_fit(const TurnedTask& task, const AxesAt& start, int steps);

/// The local minimum near a fit, with the orientations of the given numbers met to rounding: multipliers (M. R.
/// Hestenes, M. J. D. Powell, 1969) in the form of shifts, each round takes back what the last left. Its sum is that of
/// the other orientations, its errors are those of the shifted task. Empty where that fails. Precondition: weights of
/// these are large against the others.
template <class D>
std::optional<AngleFit<D>> met_exactly(TurnedTask task, const AngleFit<D>& fit, std::span<const Eigen::Index> which,
                                       int steps);

/// Whether two fits are one: axes within `same`, and a x b within as much of the unit of alpha; more where less is
/// known of them.
template <class D>
bool same_fit(const TurnedTask& task, const AngleFit<D>& x, const AngleFit<D>& y, double same = 1e-6);

}  // namespace burmester::spherical
