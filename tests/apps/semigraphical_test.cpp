// burmester-semigraphical in this process, beside an algebraic answer of the test's own.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "burmester/spherical/spherical.hpp"
#include "research/semigraphical/command.hpp"
#include "spherical_examples.hpp"

namespace burmester {
namespace {

class Answering final : public Module {
 public:
  explicit Answering(Synthesis answer) : answer_(std::move(answer)) {}
  const ModuleInfo& info() const override { return sphere_->info(); }
  PoseData read_pose(const InputNode& node, const Units& units) const override {
    return sphere_->read_pose(node, units);
  }
  PoseData read_csv_pose(std::size_t header, const std::vector<double>& row) const override {
    return sphere_->read_csv_pose(header, row);
  }
  std::vector<std::pair<std::string, double>> show_pose(const PoseData& pose, const Units& units) const override {
    return sphere_->show_pose(pose, units);
  }
  double task_size(const Problem& problem) const override { return sphere_->task_size(problem); }
  Synthesis synthesize(const Problem&) const override { return answer_; }
  Drawing draw(const Problem&, const Synthesis&) const override { return {}; }

 private:
  std::unique_ptr<Module> sphere_ = spherical::make_module();
  Synthesis answer_;
};

TEST(SemigraphicalProgram, AxesThatDifferAreNotTheSameDyad) {
  const testing::SphericalExample example = testing::angeles_bai_1();
  Synthesis answer = example.answer();
  answer.dyads[2].moving = {0, 0.6, 0.8};  // not in the plots
  Registry registry;
  registry.add(std::make_unique<Answering>(answer));
  nlohmann::json problem = {{"geometry", "spherical"}};
  for (const spherical::Pose& p : example.poses)
    problem["poses"].push_back({{"quaternion_wxyz", {p.w, p.x, p.y, p.z}}});
  std::istringstream in(problem.dump());
  std::ostringstream out, err;
  Console console{in, out, err};
  ASSERT_EQ(run_semigraphical({"-", "--json"}, registry, console), answered) << err.str();
  const auto document = nlohmann::json::parse(out.str());
  int alone = 0;
  for (const auto& dyad : document["dyads"]) {
    alone += dyad["algebraic"].is_null();
    EXPECT_EQ(dyad["algebraic"].is_null(), dyad["apart"].is_null());
  }
  EXPECT_EQ(document["dyads"].size(), 4u);
  EXPECT_EQ(alone, 1);
  EXPECT_EQ(document["missed"].size(), 1u);
}

}  // namespace
}  // namespace burmester
