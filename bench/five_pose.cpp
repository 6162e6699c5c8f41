// Five planar poses: the direct solver beside the usual route through Eigen's dense linear algebra, in one binary with
// the same flags, on the same tasks. Counters: share of tasks with a valid answer (every dyad listed meets the poses),
// share of the true real dyads found (truth: quad precision).
//
// Routes:
//   direct           planar::five_pose_roots
//   certified        the same, proved complete, with a box for every dyad
//   quad             the oracle
//   eigen_kernels    only the two decompositions that the Eigen route cannot do without: JacobiSVD of the 4 x 7 matrix
//                    (right singular vectors) and the eigenvalues of the 4 x 4 companion matrix; no answer comes out
//   eigen            the whole route: null space by SVD, resultant quartic of the two conics, companion eigenvalues,
//                    back substitution
#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "eigen_route.hpp"
#include "burmester/planar/five_pose_certificate.hpp"
#include "five_pose_accuracy.hpp"

namespace {

using namespace burmester;
using namespace burmester::planar;

constexpr int pool_size = 4096;  // larger than the branch predictor's memory

std::vector<FivePoseTask> pool(const std::string& name) {
  Random random("bench.five_pose." + name);
  const TaskClass* c = find_task_class(name);
  std::vector<FivePoseTask> tasks;
  for (int i = 0; i < pool_size; ++i) tasks.push_back(c->make(random));
  return tasks;
}

/// Largest |row . w| relative to |w|: the poses are met.
bool meets_poses(const Anchored<double>& w, const FivePoseTask& task, const Anchor& anchor) {
  return (anchored_rows<double>(task, anchor) * w).norm() < 1e-9 * w.norm();
}

void count_truth(benchmark::State& state, const std::vector<FivePoseTask>& tasks, auto solve) {
  long found = 0, truth = 0, valid = 0;
  for (const FivePoseTask& task : tasks) {
    const FivePoseRoots<Quad> oracle = five_pose_roots_quad(task);
    const FivePoseRoots<double> got = solve(task);
    bool all_meet = got.count % 2 == 0;
    for (int i = 0; i < got.count; ++i) all_meet = all_meet && meets_poses(got.w[i], task, got.anchor);
    valid += all_meet;
    truth += oracle.count;
    for (int i = 0; i < oracle.count; ++i)
      for (int j = 0; j < got.count; ++j) {
        const Anchored<double> w = oracle.w[i].cast<double>();
        if (std::abs(w.dot(got.w[j])) > (1 - 1e-12) * w.norm() * got.w[j].norm()) {
          ++found;
          break;
        }
      }
  }
  state.counters["valid"] = static_cast<double>(valid) / pool_size;
  state.counters["truth_found"] = truth > 0 ? static_cast<double>(found) / static_cast<double>(truth) : 1;
}

template <class Solve>
void run(benchmark::State& state, const std::string& name, Solve solve) {
  const std::vector<FivePoseTask> tasks = pool(name);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(tasks[i]));
    i = (i + 1) % tasks.size();
  }
  if constexpr (std::is_same_v<decltype(solve(tasks[0])), FivePoseRoots<double>>) count_truth(state, tasks, solve);
}

FivePoseRoots<double> direct(const FivePoseTask& task) { return five_pose_roots(task); }
FivePoseRoots<double> certified(const FivePoseTask& task) { return certified_five_pose_roots(task).roots; }

const bool registered = [] {
  for (const TaskClass& c : random_task_classes()) {
    const std::string name(c.name);
    const auto add = [&](const char* route, auto solve) {
      benchmark::RegisterBenchmark((std::string(route) + "/" + name).c_str(),
                                   [=](benchmark::State& state) { run(state, name, solve); });
    };
    add("direct", direct);
    add("certified", certified);
    add("eigen", eigen_route::solve);
    if (name != "generic") continue;
    add("eigen_kernels", eigen_route::kernels);
    add("quad", [](const FivePoseTask& task) { return five_pose_roots_quad(task); });
  }
  return true;
}();

}  // namespace
