#include "burmester/spherical/least_squares.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "burmester/modules/framework/counted.hpp"
#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/modules/framework/local.hpp"
#include "burmester/spherical/angle_fit.hpp"
#include "burmester/spherical/five_pose_equations.hpp"

namespace burmester::spherical {
namespace {

/// Points of the half sphere, and how many directions of it are neighbours.
constexpr int grid_size = 1500;
const double grid_spacing = std::sqrt(2 * std::numbers::pi / grid_size), neighbourhood = std::cos(1.6 * grid_spacing);

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

/// A moving axis with its best fixed axis and the next, by planes through its places.
struct Planes {
  Eigen::Vector3d moving;
  std::array<Eigen::Vector3d, 2> fixed;
  std::array<double, 2> misfit;  ///< weighted squares of the angular errors, in units of e, to first order
};

/// Seen along a, the places R_j a are a + e s (d_j + e s q_j a), with d_j across a and s the length of the longest.
/// A plane b . x = cos(arc) leaves b . R_j a - cos(arc) = e k . (d_j, q_j, 1), where k = (s b1, s b2, s^2 e b3, (b3 -
/// cos(arc)) / e), and (s sin(arc))^2 is k^T N k: the least ratio of the two squares is an eigenvalue (V. Pratt, 1987,
/// for circles of the plane, which are the limit e = 0).
template <class D>
Planes planes(const TurnedTask& task, const Eigen::Vector3d& a) {
  constexpr int size = std::is_same_v<D, RR> ? 4 : 3;
  using Square = Eigen::Matrix<double, size, size>;
  const Eigen::Index n = task.t.cols();
  const Eigen::Vector3d p = a.unitOrthogonal(), q = a.cross(p);
  Eigen::Matrix3Xd places(3, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d t = task.t.col(j), across = t.cross(a),
                          d = 2 * (task.c[j] * across + task.e * t.cross(across));
    places.col(j) << d.dot(p), d.dot(q), -2 * across.squaredNorm();
  }
  const double s = std::sqrt(places.topRows<2>().colwise().squaredNorm().maxCoeff()), e = task.e * s;
  Square M = Square::Zero(), N = Square::Identity();
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d x = places.col(j) / s;
    Eigen::Matrix<double, size, 1> z;
    if constexpr (size == 4)
      z << x[0], x[1], x[2] / s, 1;
    else
      z << x[0], x[1], 1 + e * task.e * x[2];
    M.template selfadjointView<Eigen::Lower>().rankUpdate(z, task.weights[j]);
  }
  M = M.template selfadjointView<Eigen::Lower>();
  if constexpr (size == 4)
    N.template bottomRightCorner<2, 2>() << 0, 1, 1, -e * e;
  else
    N(2, 2) = e * e;
  M.diagonal().array() += 0x1p-48 * M.trace();  // exact fits make it singular
  const Eigen::GeneralizedSelfAdjointEigenSolver<Square> ratios(N, M);
  Planes out{a, {}, {}};
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix<double, size, 1> k = ratios.eigenvectors().col(size - 1 - i);
    out.fixed[static_cast<std::size_t>(i)] = k[0] * p + k[1] * q + (size == 4 ? k[2] / e : k[2] * e) * a;
    out.misfit[static_cast<std::size_t>(i)] = s * s / ratios.eigenvalues()[size - 1 - i];
  }
  return out;
}

/// Every so many points of the grid one is a start whatever its misfit.
constexpr std::size_t stride = 15;

/// Local minima of the misfits on a Fibonacci grid of the half sphere, its points mapped by `chart`, and some points of
/// it.
template <class D>
void add_scanned(const TurnedTask& task, const Eigen::Matrix3d& chart, std::vector<AxesAt>& starts) {
  std::vector<Eigen::Vector3d> at;
  std::vector<Planes> grid;
  for (int i = 0; i < grid_size; ++i) {
    const double z = (i + 0.5) / grid_size, r = std::sqrt(1 - z * z),
                 turn = 2 * std::numbers::pi * i / std::numbers::phi;
    at.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    grid.push_back(planes<D>(task, (chart * at.back()).normalized()));
  }
  const auto is_least = [&](std::size_t j, std::size_t i) {
    for (std::size_t k = 0; k < grid.size(); ++k)
      if (grid[k].misfit[i] < grid[j].misfit[i] && std::abs(at[k].dot(at[j])) >= neighbourhood) return false;
    return true;
  };
  for (std::size_t j = 0; j < grid.size(); ++j)
    for (std::size_t i = 0; i < 2; ++i)
      if ((j % stride == 0 && j / stride % 2 == i) || is_least(j, i))
        starts.push_back(axes_at(grid[j].fixed[i], grid[j].moving));
}

/// Turns nearer than this to one axis: dyads are sought near that, too.
constexpr double nearly_one_axis = 0.1;

/// Charts of the moving axis: all directions alike; where the turns are about nearly one axis z, those as near to z as
/// they are, too: the limit of their dyads are those of the plane ((4) of five_pose_equations.hpp).
std::vector<Eigen::Matrix3d> charts(const TurnedTask& task) {
  std::vector<Eigen::Matrix3d> out{Eigen::Matrix3d::Identity()};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(task.t * task.t.transpose());
  const Eigen::Vector3d z = spread.eigenvectors().col(2);
  double away = 0;
  for (Eigen::Index j = 0; j < task.t.cols(); ++j) away = std::max(away, z.cross(task.t.col(j)).norm());
  if (away > 0 && away < nearly_one_axis)
    out.push_back(spread.eigenvectors() * Eigen::Vector3d(away, away, 1).asDiagonal());
  return out;
}

/// The dyads nearest to the singular vectors of the lifted rows, in scaled coordinates.
template <class D>
void add_lifted(const TurnedTask& task, std::vector<AxesAt>& starts) {
  Eigen::MatrixXd rows(task.rows.rows(), 10);
  const double e = task.e;
  rows << task.rows, Eigen::VectorXd::Ones(task.rows.rows());
  rows = task.weights.cwiseSqrt().asDiagonal() * rows;
  const Eigen::MatrixXd v = Eigen::JacobiSVD<Eigen::MatrixXd>(rows, Eigen::ComputeFullV).matrixV();
  for (Eigen::Index i = 0; i < 10; ++i) {
    const Lifted k = v.col(i).head<9>();
    const ScaledDyad x = scaled_dyad(k, e);
    const AxesAt axes = axes_at(x.m - e * x.h, x.m + e * x.h);
    if (axes.frame.allFinite()) starts.push_back(axes);
  }
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

/// How much less than the sums of all minima another place must have, to be listed though it is not surely one.
constexpr double less_by = 1e-6;

/// Once each: the places that surely are minima or meet the orientations; and the lowest of all, where that is neither.
template <class D>
std::vector<AngleFit<D>> fits_from(std::vector<AxesAt> starts, const TurnedTask& task) {
  add_lifted<D>(task, starts);
  for (const Eigen::Matrix3d& chart : charts(task)) add_scanned<D>(task, chart, starts);
  std::vector<AngleFit<D>> out;
  std::optional<AngleFit<D>> lowest;
  double least = std::numeric_limits<double>::infinity();
  for (const AxesAt& start : starts) {
    const AngleFit<D> found = nearest_fit<D>(task, start, steps);
    if (!found.axes.frame.allFinite() || !std::isfinite(found.sum)) continue;
    if (found.least && (found.sure || found.met))
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

/// Condition of what is not isolated to rounding.
constexpr double not_isolated = std::numeric_limits<double>::infinity();

/// Least sum of squares first.
template <class D>
std::vector<Found<typename D::Design>> best(std::span<const Pose> poses, std::span<const double> weights) {
  std::vector<double> relative;
  std::vector<Pose> seen;  // those with a weight, from the heaviest
  const std::vector<double> all = relative_weights(weights, poses.size());
  for (std::size_t j = 0; j < poses.size(); ++j)
    if (all[j] > 0) relative.push_back(all[j]), seen.push_back(poses[j]);
  const auto heaviest = std::max_element(relative.begin(), relative.end()) - relative.begin();
  std::swap(seen[0], seen[static_cast<std::size_t>(heaviest)]);
  std::swap(relative[0], relative[static_cast<std::size_t>(heaviest)]);
  const TurnedTask task = turned_task(seen, relative);
  std::vector<AxesAt> starts;
  // with uneven weights the fits with equal ones are starts too: what all orientations meet is found there
  const std::vector<double> equal = relative_weights(relative, seen.size(), 1);
  if (relative != relative_weights(relative, seen.size(), 1 / uneven_ratio))
    for (const auto& f : fits_from<D>({}, turned_task(seen, equal))) starts.push_back(f.axes);
  std::vector<AngleFit<D>> fits = with_exact(task, fits_from<D>(std::move(starts), task));
  std::sort(fits.begin(), fits.end(), [](const auto& a, const auto& b) { return a.sum < b.sum; });
  std::vector<Found<typename D::Design>> out;
  for (const AngleFit<D>& f : fits) {
    const double condition = f.sure || f.met ? condition_of<D>(task, f.axes) : not_isolated;
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
                               counted(dyads.size(), "local best fit"), slider ? " and the best slider" : ", no slider",
                               exact > 0 ? fmt::format(", of those that meet the {} exact", exact) : "");
  return report;
}

static_assert(Solver<LeastSquaresSolver>);

}  // namespace burmester::spherical
