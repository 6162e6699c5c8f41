// A general solver: any dyad type whose residual can be evaluated, no lifted form needed.
//
// Damped Gauss-Newton (K. Levenberg 1944, D. Marquardt 1963) on the residuals in the design's local
// coordinates, from many random designs. As many poses as D::parameters: designs that meet them; more: local
// minima of the sum of squares. It is slow and NOT complete: a design that no start leads to is missing, and
// the count of what was found proves nothing. For checks of direct solvers, and for dyad types that have
// none. A slider may appear as the very long crank that it is a limit of.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burmester/modules/framework/damped_step.hpp"
#include "burmester/modules/framework/local.hpp"
#include "burmester/modules/framework/report.hpp"

namespace burmester {

struct SearchOptions {
  std::string seed = "search";
  int starts = 200;
  int iterations = 100;           ///< for each start
  double tolerance = 1e-9;        ///< as many poses as parameters: largest residual of an answer, per task size
  double same = 1e-6;             ///< answers that differ by less on other poses are one, per task size
  std::vector<double> weights{};  ///< of the poses; none: all 1
};

template <DyadType D>
struct Refined {
  typename D::Design design;
  bool converged = false;  ///< at a stationary point of the sum of squares, up to the accuracy of differences
};

/// Converged: of the residuals' norm no larger part is along what the design can change. Differences are good to 1e-10.
inline constexpr double stationary = 1e-7;

/// The nearest local minimum of the sum of squared residuals, each times the weight of its pose (none: 1).
/// Preconditions: at least D::parameters poses; where weights are very different the heaviest first, the largest about
/// 1 (elimination with sorted rows and pivots by columns is stable row by row: A. J. Cox, N. J. Higham, 1998).
template <DyadType D>
Refined<D> refine(const typename D::Design& start, std::span<const typename D::Space::Pose> poses, int iterations = 100,
                  std::span<const double> weights = {}) {
  const Eigen::Index n = static_cast<Eigen::Index>(poses.size());
  const double step = step_for<typename D::Space>(poses);
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(n);
  for (std::size_t j = 0; j < weights.size(); ++j) factor[static_cast<Eigen::Index>(j)] = std::sqrt(weights[j]);
  const auto weighted = [&](const typename D::Design& d) -> Eigen::VectorXd {
    return factor.cwiseProduct(residuals<D>(d, poses));
  };
  Refined<D> out{start};
  Eigen::VectorXd r = weighted(out.design);
  double damping = 1e-3;
  for (int i = 0; i < iterations && r.allFinite(); ++i) {
    const Eigen::MatrixXd J = factor.asDiagonal() * design_jacobian<D>(out.design, poses, step);
    if (!J.allFinite()) break;
    const DampedStep steps(J, r);
    out.converged = steps.removable() <= stationary * r.norm();
    bool better = false;
    for (; !better && damping < 1e8; damping *= 8) {
      const Vector<double, D::parameters> u = steps.at(damping);
      const typename D::Design next = D::nudged(out.design, u);
      const Eigen::VectorXd next_r = weighted(next);
      better = next_r.norm() < r.norm();
      if (better) out.design = next, r = next_r;
    }
    if (!better) break;
    damping = std::max(damping / 64, 1e-18);
  }
  return out;
}

namespace detail {

/// A random design near the poses, as far out as they spread.
template <DyadType D>
typename D::Design random_start(Random& random, std::span<const typename D::Space::Pose> poses, double size) {
  using S = typename D::Space;
  const auto& near = poses[static_cast<std::size_t>(random.below(static_cast<int>(poses.size())))];
  const typename D::Design d = D::random_design(random);
  Vector<double, D::parameters> spread;
  for (int i = 0; i < D::parameters; ++i) spread[i] = std::max(0.0, size - 1) * random.normal();
  return D::nudged(D::moved(d, S::template point<double>(near), S::template point<double>(typename S::Pose{})), spread);
}

/// Poses other than the given ones, on which designs can be told apart.
template <DyadType D>
std::vector<typename D::Space::Pose> probes(Random& random, std::span<const typename D::Space::Pose> poses,
                                            double size) {
  using S = typename D::Space;
  std::vector<typename S::Pose> out;
  for (int i = 0; i < 2 * D::parameters; ++i) {
    Vector<double, S::dof> u;
    for (int j = 0; j < S::dof; ++j) u[j] = std::max(1.0, size) * random.normal();
    out.push_back(S::nudged(poses[static_cast<std::size_t>(i) % poses.size()], u));
  }
  return out;
}

}  // namespace detail

/// The different designs that the starts lead to, best first. Precondition: at least D::parameters poses, lengths not
/// far below 1.
template <DyadType D>
std::vector<Found<typename D::Design>> search_from(std::span<const typename D::Design> starts,
                                                   std::span<const typename D::Space::Pose> poses,
                                                   const SearchOptions& options = {}) {
  Random random(options.seed);
  const double size = extent<typename D::Space>(poses);
  const bool exact = poses.size() == D::parameters;
  const auto probes = detail::probes<D>(random, poses, size);
  std::vector<Found<typename D::Design>> out;
  for (const auto& start : starts) {
    const auto found = refine<D>(start, poses, options.iterations, options.weights);
    const double residual = largest_residual<D>(found.design, poses);
    if (!(residual <= options.tolerance * size || (found.converged && !exact))) continue;
    const bool known = std::any_of(out.begin(), out.end(), [&](const auto& other) {
      return disagreement<D>(other.design, found.design, probes) <= options.same * std::max(1.0, size);
    });
    if (!known) out.push_back({found.design, residual, {}, {}, {}, {}});
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.residual < b.residual; });
  return out;
}

/// The same from random starts.
template <DyadType D>
std::vector<Found<typename D::Design>> search(std::span<const typename D::Space::Pose> poses,
                                              const SearchOptions& options = {}) {
  Random random(options.seed + ", starts");
  const double size = extent<typename D::Space>(poses);
  std::vector<typename D::Design> starts;
  for (int i = 0; i < options.starts; ++i) starts.push_back(detail::random_start<D>(random, poses, size));
  return search_from<D>(starts, poses, options);
}

}  // namespace burmester
