#include "burmester/spherical/spherical.hpp"

#include <algorithm>

#include "burmester/spherical/drawing.hpp"
#include "burmester/spherical/family.hpp"
#include "burmester/spherical/five_pose_solver.hpp"
#include "burmester/spherical/four_pose_curves.hpp"
#include "burmester/spherical/least_squares.hpp"
#include "burmester/spherical/linkage.hpp"
#include "burmester/spherical/near_curve.hpp"
#include "burmester/spherical/pivots.hpp"
#include "burmester/spherical/pose_format.hpp"

namespace burmester::spherical {
namespace {

ModuleInfo describe() {
  ModuleInfo info = built_in<Space, Dyads, FourPoseSolver, FivePoseSolver, LeastSquaresSolver>();
  info.solvers.insert(info.solvers.begin(),
                      SolverInfo{"two and three orientations, linear",
                                 "the family of dyads with its axes of rotation; the dyad, or the best fits to more "
                                 "orientations, for given fixed and moving axes"});
  info.type_aliases = {{"RP", "PR"}};  // a slider is its own inverse
  info.csv_headers = {{"qw", "qx", "qy", "qz"}};
  return info;
}

std::vector<double> weights_of(const Problem& problem) {
  std::vector<double> out;
  for (const std::optional<double>& weight : problem.weights) out.push_back(weight.value_or(met_exactly_weight));
  if (std::count(out.begin(), out.end(), 0.0) + 5 >= static_cast<std::ptrdiff_t>(problem.poses.size()) && !out.empty())
    throw NotAvailable("spherical synthesis with weights that leave fewer than six orientations");
  if (std::count(out.begin(), out.end(), met_exactly_weight) > 4)
    throw NotAvailable("more than four orientations met exactly among others: those alone leave finitely many dyads");
  return out;
}

bool only_sliders(const Problem& problem) {
  return !problem.types.empty() && std::all_of(problem.types.begin(), problem.types.end(),
                                               [](const std::string& type) { return type == PR::name; });
}

SphericalReport solve(const Problem& problem, std::span<const Pose> poses) {
  expect_pivots<Pivots>("near", problem.near);
  SphericalReport report;
  if (poses.size() < 4 || !problem.fixed.empty() || !problem.moving.empty()) {
    report = solve_linear(problem, poses);
  } else if (poses.size() > 5) {
    const std::vector<double> weights = weights_of(problem);
    report = LeastSquaresSolver{weights}.solve(poses);
    if (only_sliders(problem)) add_best_slider(poses, weights, report);
  } else if (poses.size() == 5) {
    report = FivePoseSolver{.certify = problem.certify}.solve(poses);
    if (only_sliders(problem)) add_best_slider(poses, {}, report);
  } else {
    report = FourPoseSolver().solve(poses);
    add_near<Pivots>(dyads_near(poses.first<4>(), report.curves, problem.near, problem.certify), "directions", poses,
                     report);
  }
  for (std::string& warning : ignored_requests<Pivots>(problem)) report.warnings.push_back(std::move(warning));
  return report;
}

class SphericalModule final : public Module {
 public:
  const ModuleInfo& info() const override { return info_; }

  PoseData read_pose(const InputNode& node, const Units& units) const override {
    return spherical::read_pose(node, units);
  }
  PoseData read_csv_pose(std::size_t, const std::vector<double>& row) const override {
    return spherical::read_csv_pose(row);
  }
  std::vector<std::pair<std::string, double>> show_pose(const PoseData& data, const Units&) const override {
    // one name: files show the four as an array
    const std::string name = "quaternion_wxyz";
    return {{name, data[0]}, {name, data[1]}, {name, data[2]}, {name, data[3]}};
  }
  double task_size(const Problem&) const override { return 1; }

  Synthesis synthesize(const Problem& problem) const override {
    const SphericalReport report = solve(problem, poses_of(problem));
    return {report.status,   report.message, report.counts, records_of(report), linkages_of(report.dyads),
            report.warnings, report.curves,  report.family};
  }
  Drawing draw(const Problem& problem, const Synthesis& answer) const override {
    return draw_synthesis(problem, answer);
  }

 private:
  ModuleInfo info_ = describe();
};

}  // namespace

std::unique_ptr<Module> make_module() { return std::make_unique<SphericalModule>(); }

}  // namespace burmester::spherical
