#include "burmester/planar/planar.hpp"

#include <fmt/format.h>

#include <numbers>

#include "burmester/planar/drawing.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/linkage.hpp"
#include "burmester/planar/pose_format.hpp"

namespace burmester::planar {
namespace {

template <class... S>
std::vector<SolverInfo> describe_solvers() {
  return {{S::name, S::answers}...};
}

ModuleInfo describe() {
  ModuleInfo info;
  info.name = Space::name;
  info.origin = "built in";
  Dyads::for_each([&]<class D>() { info.dyad_types.push_back(D::name); });
  info.solvers = describe_solvers<FivePoseSolver, FivePoseOracle>();
  info.csv_headers = {{"x", "y", "angle_deg"}, {"x", "y", "angle_rad"}};
  info.point_size = 2;
  return info;
}

void require_five_poses(const Problem& problem) {
  if (!problem.fixed.empty() || !problem.moving.empty())
    throw NotAvailable("planar synthesis for given fixed or moving pivots");
  if (problem.poses.size() != 5)
    throw NotAvailable(fmt::format("planar synthesis for {} poses (this version solves five)", problem.poses.size()));
}

class PlanarModule final : public Module {
 public:
  const ModuleInfo& info() const override { return info_; }

  PoseData read_pose(const InputNode& node, const Units& units) const override {
    return planar::read_pose(node, units);
  }
  PoseData read_csv_pose(std::size_t header, const std::vector<double>& row) const override {
    return planar::read_csv_pose(header == 0, row);
  }
  std::vector<std::pair<std::string, double>> show_pose(const PoseData& data, const Units& units) const override {
    const double angle = angle_of(pose_of(data));
    return {{"x", data[0]}, {"y", data[1]}, {"angle", units.degrees ? angle * 180 / std::numbers::pi : angle}};
  }
  double task_size(const Problem& problem) const override { return planar::task_size(poses_of(problem)); }

  Synthesis synthesize(const Problem& problem) const override {
    require_five_poses(problem);
    const std::vector<Pose> poses = poses_of(problem);
    const PlanarReport report = FivePoseSolver().solve(poses);
    return {report.status,       report.message, report.counts, records_of(report),
            linkages_of(report.dyads, planar::task_size(poses)), report.warnings};
  }
  Drawing draw(const Problem& problem, const Synthesis& answer) const override {
    return draw_synthesis(problem, answer);
  }

 private:
  ModuleInfo info_ = describe();
};

}  // namespace

std::unique_ptr<Module> make_module() { return std::make_unique<PlanarModule>(); }

}  // namespace burmester::planar
