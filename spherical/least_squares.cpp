#include "burmester/spherical/least_squares.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/family.hpp"

namespace burmester::spherical {
namespace {

/// Points of the half sphere, and how many directions of it are neighbours.
constexpr int grid_size = 1500;
const double grid_spacing = std::sqrt(2 * std::numbers::pi / grid_size), neighbourhood = std::cos(1.6 * grid_spacing);

/// Heaviest orientation first: elimination by rows of very different sizes then loses nothing of the small ones.
struct Task {
  std::vector<Pose> poses;
  std::vector<Eigen::Matrix3d> turns;
  std::vector<double> weights;  ///< largest 1
  double sum = 0;               ///< of these
};

/// Relative to the largest; `floor` for those that are smaller, but not zero.
std::vector<double> relative_weights(std::span<const double> weights, std::size_t count,
                                     double floor = 1 / largest_weight_ratio) {
  std::vector<double> out(count, 1);
  if (weights.empty()) return out;
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (std::size_t j = 0; j < count; ++j) out[j] = weights[j] > 0 ? std::max(weights[j] / largest, floor) : 0;
  return out;
}

Task task_of(std::span<const Pose> poses, const std::vector<double>& weights) {
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return weights[i] > weights[j]; });
  Task task;
  for (const std::size_t j : order) {
    const Eigen::Quaterniond q(poses[j].w, poses[j].x, poses[j].y, poses[j].z);
    task.poses.push_back(poses[j]);
    task.turns.push_back(q.normalized().toRotationMatrix());
    task.weights.push_back(weights[j]), task.sum += weights[j];
  }
  return task;
}

/// A moving axis with its best fixed axis, by the plane through its places.
struct Fit {
  Axis fixed, moving;
  double cosine = 0;  ///< of the arc
  double misfit = 0;  ///< mean square of the angular errors, to first order
};

template <class D>
Fit fit(const Task& task, const Axis& a) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  if constexpr (std::is_same_v<D, RR>)
    for (std::size_t j = 0; j < task.turns.size(); ++j) mean += task.weights[j] / task.sum * (task.turns[j] * a);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t j = 0; j < task.turns.size(); ++j) {
    const Eigen::Vector3d p = task.turns[j] * a - mean;
    scatter += task.weights[j] * p * p.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  const Axis b = axes.eigenvectors().col(0);
  const double cosine = b.dot(mean), sine = std::max(1 - cosine * cosine, 1e-12);
  return {b, a, cosine, std::max(axes.eigenvalues()[0], 0.0) / sine};
}

RR::Design design_of(const Fit& f, RR) { return {f.fixed, f.moving, std::acos(std::clamp(f.cosine, -1.0, 1.0))}; }
PR::Design design_of(const Fit& f, PR) { return {f.fixed, f.moving}; }

/// Local minima of the misfit on a Fibonacci grid of the half sphere.
template <class D>
void add_scanned(const Task& task, std::vector<typename D::Design>& starts) {
  std::vector<Fit> grid;
  for (int i = 0; i < grid_size; ++i) {
    const double z = (i + 0.5) / grid_size, r = std::sqrt(1 - z * z),
                 turn = 2 * std::numbers::pi * i / std::numbers::phi;
    grid.push_back(fit<D>(task, {r * std::cos(turn), r * std::sin(turn), z}));
  }
  for (const Fit& f : grid) {
    const bool least = std::all_of(grid.begin(), grid.end(), [&](const Fit& other) {
      return !(other.misfit < f.misfit) || std::abs(other.moving.dot(f.moving)) < neighbourhood;
    });
    if (least) starts.push_back(design_of(f, D{}));
  }
}

/// The dyads nearest to the singular vectors of the lifted rows.
template <class D>
void add_lifted(const Task& task, std::vector<typename D::Design>& starts) {
  constexpr int columns = std::is_same_v<D, RR> ? Family::dimension : Family::dimension - 1;  // without the arc
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(task.poses.size()), columns);
  for (Eigen::Index j = 0; j < rows.rows(); ++j) {
    const Pose& pose = task.poses[static_cast<std::size_t>(j)];
    const double norm = Space::norm<double>(Space::point<double>(pose));
    rows.row(j) = std::sqrt(task.weights[static_cast<std::size_t>(j)]) / norm *
                  Family::row<double>(pose).head<columns>().transpose();
  }
  const Eigen::MatrixXd v = Eigen::JacobiSVD<Eigen::MatrixXd>(rows, Eigen::ComputeFullV).matrixV();
  for (Eigen::Index i = 0; i < columns; ++i) {
    Vector<double, Family::dimension> k = Vector<double, Family::dimension>::Zero();
    k.head<columns>() = v.col(i);
    const auto any = Family::decode(k);
    if (!any) continue;
    Dyads::visit(*any, [&]<class E>(const typename E::Design& d) {
      if constexpr (std::is_same_v<D, E>)
        starts.push_back(d);
      else if constexpr (std::is_same_v<D, RR>)
        starts.push_back({d.fixed, d.moving, std::numbers::pi / 2});
    });
  }
}

/// Steps from one start: heavy orientations leave narrow curved valleys, and large errors slow the last steps.
constexpr int steps = 2000;

/// Largest weight over the smallest up to which the weighted rows and the scan are starts enough.
constexpr double uneven_ratio = 100;

template <class D>
std::vector<Found<typename D::Design>> best_from(std::vector<typename D::Design> starts, const Task& task) {
  add_lifted<D>(task, starts);
  add_scanned<D>(task, starts);
  return search_from<D>(starts, task.poses,
                        {.iterations = steps, .tolerance = exact_residual, .weights = task.weights});
}

/// With uneven weights the fits with equal ones are starts too: what all orientations meet is found there.
template <class D>
std::vector<Found<typename D::Design>> best(std::span<const Pose> poses, std::span<const double> weights) {
  const std::vector<double> relative = relative_weights(weights, poses.size());
  if (relative == relative_weights(weights, poses.size(), 1 / uneven_ratio))
    return best_from<D>({}, task_of(poses, relative));
  std::vector<typename D::Design> starts;
  for (const auto& f : best_from<D>({}, task_of(poses, relative_weights(weights, poses.size(), 1))))
    starts.push_back(f.design);
  return best_from<D>(std::move(starts), task_of(poses, relative));
}

double sum_of_squares(const PR::Design& d, std::span<const Pose> poses, std::span<const double> weights) {
  const Eigen::VectorXd r = residuals<PR>(d, poses);
  double sum = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) sum += weights[j] * std::pow(r[static_cast<Eigen::Index>(j)], 2);
  return sum;
}

/// Singular values of the quaternions below this, relative to the largest, are zero but for rounding.
constexpr double rank_rounding = 0x1p-40;

/// 1: all are equal, 2: all rotations from one to another have one axis.
Eigen::Index rank_of(std::span<const Pose> poses) {
  Eigen::MatrixXd q(static_cast<Eigen::Index>(poses.size()), 4);
  for (std::size_t j = 0; j < poses.size(); ++j)
    q.row(static_cast<Eigen::Index>(j)) = Space::point<double>(poses[j]).normalized().transpose();
  const Eigen::VectorXd size = Eigen::JacobiSVD<Eigen::MatrixXd>(q).singularValues();
  return (size.array() > rank_rounding * size[0]).count();
}

}  // namespace

std::vector<Found<RR::Design>> best_dyads(std::span<const Pose> poses, std::span<const double> weights) {
  return best<RR>(poses, weights);
}

std::vector<Found<PR::Design>> best_sliders(std::span<const Pose> poses, std::span<const double> weights) {
  return best<PR>(poses, weights);
}

std::optional<Found<PR::Design>> best_slider(std::span<const Pose> poses, std::span<const double> weights) {
  const auto all = best_sliders(poses, weights);
  if (all.empty()) return std::nullopt;
  const std::vector<double> relative = relative_weights(weights, poses.size());
  return *std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return sum_of_squares(a.design, poses, relative) < sum_of_squares(b.design, poses, relative);
  });
}

void add_best_slider(std::span<const Pose> poses, std::span<const double> weights, SphericalReport& report) {
  const auto is_slider = [](const auto& found) { return std::holds_alternative<PR::Design>(found.design); };
  if (report.status == Status::degenerate || std::any_of(report.dyads.begin(), report.dyads.end(), is_slider)) return;
  const auto slider = best_slider(poses, weights);
  if (!slider) return;
  report.status = Status::approximate;
  report.message = fmt::format("no slider meets all {} orientations: the best one by least squares; {}", poses.size(),
                               report.message);
  report.dyads.push_back(found_slider<PR, Dyads>(slider->design, poses));
}

SphericalReport LeastSquaresSolver::solve(std::span<const Pose> poses) const {
  SphericalReport report;
  if (relative_weights(weights, poses.size()) != relative_weights(weights, poses.size(), 0))
    report.warnings.push_back(
        fmt::format("weights below {:g} of the largest count as that much: fits that depend on "
                    "smaller ones cannot be told",
                    1 / largest_weight_ratio));
  if (const Eigen::Index rank = rank_of(poses); rank <= 2) {
    report.status = Status::degenerate;
    report.message = rank == 1
                         ? "all orientations are equal: every dyad meets them"
                         : "all rotations have one axis: every moving axis with that one as fixed axis meets them";
    return report;
  }
  const auto dyads = best_dyads(poses, weights);
  report.counts.dimension = 0;
  for (const auto& f : dyads)
    if (f.residual <= exact_residual) report.dyads.push_back(found_dyad(f.design, poses));
  const bool isolated = std::all_of(report.dyads.begin(), report.dyads.end(),
                                    [](const auto& f) { return f.condition && std::isfinite(*f.condition); });
  if (!isolated) {
    report = {};
    report.status = Status::degenerate;
    report.message =
        "infinitely many dyads meet these orientations: fewer than five of them are different, or they follow a "
        "linkage that moves";
    return report;
  }
  if (!report.dyads.empty()) {
    report.status = Status::exact;
    report.message =
        fmt::format("{} real dyad{} met by all {} orientations to rounding; found by least squares, there may be more",
                    report.dyads.size(), report.dyads.size() == 1 ? "" : "s", poses.size());
    return report;
  }
  report.status = Status::approximate;
  for (const auto& f : dyads) report.dyads.push_back(found_dyad(f.design, poses));
  if (const auto slider = best_slider(poses, weights))
    report.dyads.push_back(found_slider<PR, Dyads>(slider->design, poses));
  report.message = fmt::format("no dyad meets all {} orientations: {} local best fit{} and the best slider",
                               poses.size(), dyads.size(), dyads.size() == 1 ? "" : "s");
  return report;
}

static_assert(Solver<LeastSquaresSolver>);

}  // namespace burmester::spherical
