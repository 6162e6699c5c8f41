// More orientations than a dyad can meet: the dyads, and the slider, that come nearest to them.
//
// Sought are the local minima of the sum of squares of the angular errors arc - angle(b, Q_j a), each times the weight
// of its orientation. Starts come from linear algebra (fit_starts.hpp), each is refined by Newton steps
// (angle_fit.hpp); listed are places that surely are minima, and a lower one that is not isolated to rounding or was
// not reached, with an infinite condition. Weights over 100 to 1 make starts of the fits with equal ones, too. Only the
// ratios of weights matter, up to largest_weight_ratio; orientations of infinite weight are met exactly. The slider by
// the smallest singular vectors alone is what J. Angeles, S. Bai, "A robust solution of the spherical Burmester
// problem", print for their example 2.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "burmester/spherical/five_pose_solver.hpp"

namespace burmester::spherical {

/// Largest finite weight over the smallest that is not zero up to which all is well. Smaller weights are raised to
/// that, and a report says so: in doubles what heavier orientations leave of the errors would hide their effect.
inline constexpr double largest_weight_ratio = 1e9;

/// Weight of an orientation that is met exactly: the errors of the others are least among the dyads that do so. Up to
/// four such orientations leave something to fit (three for sliders).
inline constexpr double met_exactly_weight = std::numeric_limits<double>::infinity();

/// The local minima that the starts lead to, those of smallest largest residual first. `weights`: one for each
/// orientation, not negative, or none. Preconditions: five orientations or more, those of positive weight among them,
/// and not all of these equal.
std::vector<Found<RR::Design>> best_dyads(std::span<const Pose> poses, std::span<const double> weights = {});

/// The slider whose weighted sum of squares is least of the local minima. Preconditions as above, four orientations.
std::optional<Found<PR::Design>> best_slider(std::span<const Pose> poses, std::span<const double> weights = {});

/// Where sliders are asked for and none of the report meets the orientations: adds the best one and says so. The counts
/// stay, they are those of all dyads.
void add_best_slider(std::span<const Pose> poses, std::span<const double> weights, SphericalReport& report);

/// Residuals up to this, radians, are rounding of the data.
inline constexpr double exact_residual = 1e-12;

struct LeastSquaresSolver {
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* name = "six and more orientations, least squares";
  static constexpr const char* answers =
      "every RR dyad that is a local best fit of the angular errors, and the best slider; exact ones where there are";
  std::vector<double> weights{};
  SphericalReport solve(std::span<const Pose> poses) const;
};

}  // namespace burmester::spherical
