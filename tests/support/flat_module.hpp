// A module for tests of reading, writing and the program: poses are two numbers, answers are fixed.
#pragma once

#include <memory>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/module.hpp"
#include "burmester/modules/framework/registry.hpp"

namespace burmester::testing {

class FlatModule final : public Module {
 public:
  FlatModule() {
    info_.name = "flat";
    info_.origin = "tests";
    info_.dyad_types = {"RR", "PR"};
    info_.type_aliases = {{"RP", "PR"}};
    info_.solvers = {{"none", "nothing"}};
    info_.csv_headers = {{"a", "angle_deg"}, {"a", "angle_rad"}};
    info_.linkage_classes = {"even", "odd"};
  }
  const ModuleInfo& info() const override { return info_; }
  PoseData read_pose(const InputNode& node, const Units&) const override {
    if (node.is_array()) return node.numbers(2);
    node.expect_keys({"a", "angle"});
    return {node.at("a").number(), node.at("angle").number()};
  }
  PoseData read_csv_pose(std::size_t, const std::vector<double>& row) const override {
    if (row[0] < 0) throw InputError("expected a that is not negative");
    return row;
  }
  std::vector<std::pair<std::string, double>> show_pose(const PoseData& pose, const Units&) const override {
    return {{"a", pose[0]}, {"pair", pose[0]}, {"pair", pose[1]}};
  }
  double task_size(const Problem&) const override { return 1; }
  Synthesis synthesize(const Problem& problem) const override {
    if (problem.poses.size() > 5) throw NotAvailable("more than five flat poses");
    if (problem.name == "fail") throw std::runtime_error("asked to fail");
    return answer;
  }
  Drawing draw(const Problem&, const Synthesis&) const override { return {}; }

  Synthesis answer;

 private:
  ModuleInfo info_;
};

inline Registry flat_registry(Synthesis answer = {}) {
  Registry registry;
  auto module = std::make_unique<FlatModule>();
  module->answer = std::move(answer);
  registry.add(std::move(module));
  return registry;
}

}  // namespace burmester::testing
