// How far the direct five-orientation solver is from exact elimination, class by class: used by the seeded test and by the
// long study, with the same limits. Error of a dyad: the largest of the distances of its axes, as lines, and of its arc
// from the exact one's (radians); counted where the number of dyads is right.
#pragma once

#include <string_view>
#include <vector>

#include "burmester/spherical/five_pose_oracle.hpp"
#include "five_orientations.hpp"

namespace burmester::spherical::accuracy {

struct Limits {
  double wrong_share;   ///< of the tasks: counts that differ from the exact one's
  double median, tail;  ///< of the errors: median, and 99.9 %
};

inline Limits limits_of(std::string_view name) {
  if (name == "small_rotations") return {0, 1e-15, 5e-12};
  if (name == "nearly_coaxial") return {0.02, 1e-15, 1e-7};
  if (name == "planted_four_bar" || name == "planted_slider") return {0, 1e-14, 1e-8};
  return {0, 1e-15, 5e-12};
}

struct Outcome {
  long tasks = 0, wrong_count = 0, by_action = 0;
  long with_real[4] = {};  ///< 0, 2, 4, 6 real dyads
  std::vector<double> errors;

  void add(const Outcome& o) {
    tasks += o.tasks, wrong_count += o.wrong_count, by_action += o.by_action;
    for (int k = 0; k < 4; ++k) with_real[k] += o.with_real[k];
    errors.insert(errors.end(), o.errors.begin(), o.errors.end());
  }
  double quantile(double p) {
    if (errors.empty()) return 0;
    const auto at = errors.begin() + static_cast<std::ptrdiff_t>(p * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), at, errors.end());
    return *at;
  }
};

inline void add_task(FivePoses task, Outcome& out) {
  const FivePoseRoots roots = five_pose_roots(task);
  const ExactFivePoses exact = exact_by_elimination(task);
  ++out.tasks;
  ++out.with_real[exact.real.size() / 2];
  out.by_action += roots.path == FivePosePath::action;
  if (roots.count != static_cast<int>(exact.real.size())) {
    ++out.wrong_count;
    return;
  }
  const std::vector<RR::Design> found = support::dyads_of(roots, task);
  for (const ExactDyad& truth : exact.real) {
    double least = 4;
    for (const RR::Design& dyad : found) least = std::min(least, support::distance(truth.rounded(), dyad));
    out.errors.push_back(least);
  }
}

}  // namespace burmester::spherical::accuracy
