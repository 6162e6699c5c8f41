#include "burmester/spherical/spherical.hpp"

#include "burmester/spherical/pivots.hpp"
#include "burmester/spherical/pose_format.hpp"

namespace burmester::spherical {
namespace {

ModuleInfo describe() {
  ModuleInfo info;
  info.name = Space::name;
  info.origin = "built in";
  Dyads::for_each([&]<class D>() { info.dyad_types.push_back(D::name); });
  info.type_aliases = {{"RP", "PR"}};  // a slider is its own inverse
  info.csv_headers = {{"qw", "qx", "qy", "qz"}};
  info.solvers = {{"two and three orientations, linear",
                   "the family of dyads with its axes of rotation; the dyad, or the best fits to more orientations, for "
                   "given fixed and moving axes"}};
  info.point_size = Space::feature_size;
  return info;
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
    std::vector<Pose> poses;
    for (const PoseData& data : problem.poses) poses.push_back(pose_of(data));
    Report<Dyads> report;
    if (poses.size() < 4 || !problem.fixed.empty() || !problem.moving.empty())
      report = solve_linear(problem, poses);
    else
      throw NotAvailable("spherical synthesis for four or more poses without given axes");
    return {report.status, report.message, report.counts, records_of(report), {}, report.warnings, report.curves,
            report.family};
  }
  Drawing draw(const Problem&, const Synthesis&) const override { return {}; }

 private:
  ModuleInfo info_ = describe();
};

}  // namespace

std::unique_ptr<Module> make_module() { return std::make_unique<SphericalModule>(); }

}  // namespace burmester::spherical
