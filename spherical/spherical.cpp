#include "burmester/spherical/spherical.hpp"

#include "burmester/spherical/drawing.hpp"
#include "burmester/spherical/family.hpp"
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

  Synthesis synthesize(const Problem&) const override { throw NotAvailable("spherical synthesis"); }
  Drawing draw(const Problem& problem, const Synthesis& answer) const override {
    return draw_synthesis(problem, answer);
  }

 private:
  ModuleInfo info_ = describe();
};

}  // namespace

std::unique_ptr<Module> make_module() { return std::make_unique<SphericalModule>(); }

}  // namespace burmester::spherical
