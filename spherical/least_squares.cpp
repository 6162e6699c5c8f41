#include "burmester/spherical/least_squares.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "burmester/modules/framework/counted.hpp"
#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/spherical/angle_fit.hpp"
#include "burmester/spherical/fit_starts.hpp"

namespace burmester::spherical {
namespace {

/// Of orientations that are met exactly, the others' largest is 1: multipliers do the rest.
constexpr double exact_weight = 1000;

/// Relative to the largest that is finite; `floor` for those that are smaller, but not zero.
std::vector<double> relative_weights(std::span<const double> weights, std::size_t count,
                                     double floor = 1 / largest_weight_ratio) {
  std::vector<double> out(count, 1);
  double largest = 0;
  for (const double w : weights) largest = std::isinf(w) ? largest : std::max(largest, w);
  for (std::size_t j = 0; j < weights.size(); ++j)
    out[j] = std::isinf(weights[j]) ? exact_weight : weights[j] > 0 ? std::max(weights[j] / largest, floor) : 0;
  return out;
}

/// Steps from one start: heavy orientations leave narrow curved valleys.
constexpr int steps = 500;

/// Largest weight over the smallest up to which the weighted rows and the scan are starts enough.
constexpr double uneven_ratio = 100;

/// Adds what is not there yet.
template <class D>
void add_fit(const TurnedTask& task, std::vector<AngleFit<D>>& fits, const AngleFit<D>& found) {
  if (std::none_of(fits.begin(), fits.end(), [&](const auto& f) { return same_fit(task, f, found); }))
    fits.push_back(found);
}

/// By so much of itself the sum of another place must be less than those of all minima, to be listed though it is not
/// surely one: where steps end beside a minimum is not.
constexpr double less_by = 1e-6;

/// Surely a minimum, or the orientations are met to rounding.
template <class D>
bool isolated(const AngleFit<D>& f) {
  return f.least && (f.sure || f.met);
}

/// Once each: the isolated places; and the lowest of all, where that is not, or was not reached.
template <class D>
std::vector<AngleFit<D>> fits_from(std::vector<AxesAt> starts, const TurnedTask& task) {
  for (const AxesAt& start : fit_starts<D>(task)) starts.push_back(start);
  std::vector<AngleFit<D>> out;
  std::optional<AngleFit<D>> lowest;
  double least = std::numeric_limits<double>::infinity();
  for (const AxesAt& start : starts) {
    const AngleFit<D> found = nearest_fit<D>(task, start, steps);
    if (!found.axes.frame.allFinite() || !std::isfinite(found.sum)) continue;
    if (isolated(found))
      add_fit(task, out, found), least = std::min(least, found.sum);
    else if (!lowest || found.sum < lowest->sum)
      lowest = found;
  }
  if (lowest && lowest->sum < (1 - less_by) * least) out.push_back(*lowest);
  return out;
}

/// Of the fits those that can meet the orientations of exact_weight, once each.
template <class D>
std::vector<AngleFit<D>> with_exact(const TurnedTask& task, std::vector<AngleFit<D>> fits) {
  std::vector<Eigen::Index> exact;
  for (Eigen::Index j = 0; j < task.weights.size(); ++j)
    if (task.weights[j] == exact_weight) exact.push_back(j);
  if (exact.empty()) return fits;
  std::vector<AngleFit<D>> out;
  for (const auto& fit : fits)
    if (const auto met = met_exactly(task, fit, exact, steps)) add_fit(task, out, *met);
  return out;
}

/// Condition of what is not isolated to rounding, or not reached.
constexpr double not_isolated = std::numeric_limits<double>::infinity();

/// Those with a weight, from the heaviest.
TurnedTask seen_from_heaviest(std::span<const Pose> poses, std::span<const double> weights) {
  std::vector<double> relative;
  std::vector<Pose> seen;
  const std::vector<double> all = relative_weights(weights, poses.size());
  for (std::size_t j = 0; j < poses.size(); ++j)
    if (all[j] > 0) relative.push_back(all[j]), seen.push_back(poses[j]);
  const auto heaviest = std::max_element(relative.begin(), relative.end()) - relative.begin();
  std::swap(seen[0], seen[static_cast<std::size_t>(heaviest)]);
  std::swap(relative[0], relative[static_cast<std::size_t>(heaviest)]);
  return turned_task(seen, relative);
}

/// With uneven weights the fits with equal ones are starts: what all orientations meet is found there.
template <class D>
std::vector<AxesAt> further_starts(TurnedTask task) {
  std::vector<AxesAt> out;
  if (!(task.weights.minCoeff() * uneven_ratio < task.weights.maxCoeff())) return out;
  task.weights.setOnes();
  for (const auto& f : fits_from<D>({}, task)) out.push_back(f.axes);
  return out;
}

/// Least sum of squares first.
template <class D>
std::vector<Found<typename D::Design>> best(std::span<const Pose> poses, std::span<const double> weights) {
  const TurnedTask task = seen_from_heaviest(poses, weights);
  std::vector<AngleFit<D>> fits = with_exact(task, fits_from<D>(further_starts<D>(task), task));
  std::sort(fits.begin(), fits.end(), [](const auto& a, const auto& b) { return a.sum < b.sum; });
  std::vector<Found<typename D::Design>> out;
  for (const AngleFit<D>& f : fits) {
    const double condition = isolated(f) ? condition_of<D>(task, f.axes) : not_isolated;
    out.push_back({f.design, largest_residual<D>(f.design, poses), condition, {}, {}, {}});
  }
  return out;
}

/// With the condition that is good for close orientations.
template <class Design>
Found<Dyads::Design> listed(const Found<Design>& fit, std::span<const Pose> poses) {
  Found<Dyads::Design> out;
  if constexpr (std::is_same_v<Design, RR::Design>)
    out = found_dyad(fit.design, poses);
  else
    out = found_slider<PR, Dyads>(fit.design, poses);
  out.condition = fit.condition;
  return out;
}

/// Singular values of the quaternions below this, relative to the largest, are zero but for rounding.
constexpr double rank_rounding = 0x1p-40;

/// Of those with a weight. 1: all are equal, 2: all rotations from one to another have one axis.
Eigen::Index rank_of(std::span<const Pose> poses, const std::vector<double>& weights) {
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(poses.size()), 4);
  for (std::size_t j = 0; j < poses.size(); ++j)
    if (weights[j] > 0) q.row(static_cast<Eigen::Index>(j)) = Space::point<double>(poses[j]).normalized().transpose();
  const Eigen::VectorXd size = Eigen::JacobiSVD<Eigen::MatrixXd>(q).singularValues();
  return (size.array() > rank_rounding * size[0]).count();
}

}  // namespace

std::vector<Found<RR::Design>> best_dyads(std::span<const Pose> poses, std::span<const double> weights) {
  auto out = best<RR>(poses, weights);
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.residual < b.residual; });
  return out;
}

std::optional<Found<PR::Design>> best_slider(std::span<const Pose> poses, std::span<const double> weights) {
  const auto all = best<PR>(poses, weights);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

void add_best_slider(std::span<const Pose> poses, std::span<const double> weights, SphericalReport& report) {
  const auto is_slider = [](const auto& found) { return std::holds_alternative<PR::Design>(found.design); };
  if (report.status == Status::degenerate || std::any_of(report.dyads.begin(), report.dyads.end(), is_slider)) return;
  const auto slider = best_slider(poses, weights);
  if (!slider) return;
  report.status = Status::approximate;
  report.message = fmt::format("no slider meets all {} orientations: the best one by least squares; {}", poses.size(),
                               report.message);
  report.dyads.push_back(listed(*slider, poses));
}

SphericalReport LeastSquaresSolver::solve(std::span<const Pose> poses) const {
  SphericalReport report;
  const std::vector<double> relative = relative_weights(weights, poses.size());
  if (relative != relative_weights(weights, poses.size(), 0))
    report.warnings.push_back(
        fmt::format("weights below {:g} of the largest count as that much: fits that depend on "
                    "smaller ones cannot be told",
                    1 / largest_weight_ratio));
  if (const Eigen::Index rank = rank_of(poses, relative); rank <= 2) {
    report.status = Status::degenerate;
    report.message = rank == 1
                         ? "all orientations are equal: every dyad meets them"
                         : "all rotations have one axis: every moving axis with that one as fixed axis meets them";
    return report;
  }
  const auto dyads = best_dyads(poses, weights);
  report.counts.dimension = 0;
  for (const auto& f : dyads)
    if (f.residual <= exact_residual) report.dyads.push_back(listed(f, poses));
  const bool isolated = std::all_of(report.dyads.begin(), report.dyads.end(),
                                    [](const auto& f) { return f.condition && std::isfinite(*f.condition); });
  if (!isolated) {
    report = {};
    report.status = Status::degenerate;
    report.message =
        "infinitely many dyads meet these orientations to rounding: fewer than five of them are different, their turns "
        "are about one axis, or small and about axes of one plane, or they follow a linkage that moves";
    return report;
  }
  if (!report.dyads.empty()) {
    report.status = Status::exact;
    report.message = fmt::format("{} met by all {} orientations to rounding; found by least squares, there may be more",
                                 counted(report.dyads.size(), "real dyad"), poses.size());
    return report;
  }
  report.status = Status::approximate;
  for (const auto& f : dyads) report.dyads.push_back(listed(f, poses));
  const auto slider = best_slider(poses, weights);
  if (slider) report.dyads.push_back(listed(*slider, poses));
  const auto exact = std::count(weights.begin(), weights.end(), met_exactly_weight);
  report.message = fmt::format("no dyad meets all {} orientations: {}{}{}", poses.size(),
                               dyads.empty() ? "no isolated best fit" : counted(dyads.size(), "local best fit"),
                               slider ? " and the best slider" : ", no slider",
                               exact > 0 ? fmt::format(", of those that meet the {} exact", exact) : "");
  return report;
}

static_assert(Solver<LeastSquaresSolver>);

}  // namespace burmester::spherical
