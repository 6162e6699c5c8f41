// Five orientations: the direct solver beside Eigen's dense eigenvalue solver, in one binary with the same flags, on the same
// tasks, and the share of tasks in which it takes its slower path.
//
// Routes:
//   direct         spherical::five_pose_roots: equations, sextic, real roots, polish
//   action         the slower path for every task
//   eigen_6x6      only Eigen's EigenSolver on the 6 x 6 action matrices of these tasks: no equations, no answer
//   report         the whole report with residuals and conditions
#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>

#include "burmester/spherical/five_pose_roots.hpp"
#include "burmester/spherical/five_pose_solver.hpp"
#include "burmester/spherical/tasks.hpp"

namespace {

using namespace burmester;
using namespace burmester::spherical;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int pool_size = 4096;  // larger than the branch predictor's memory

std::vector<FivePoseTask> pool(const TaskClass& c) {
  Random random("bench.spherical_five_pose." + std::string(c.name));
  std::vector<FivePoseTask> tasks;
  for (int i = 0; i < pool_size; ++i) tasks.push_back(c.make(random));
  return tasks;
}

template <class Data, class Solve>
void run(benchmark::State& state, const std::vector<Data>& data, Solve solve) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(data[i]));
    i = (i + 1) % data.size();
  }
}

const bool registered = [] {
  for (const TaskClass& c : random_task_classes()) {
    const auto add = [&](const char* route, auto measure) {
      benchmark::RegisterBenchmark((std::string(route) + "/" + std::string(c.name)).c_str(), measure);
    };
    add("direct", [&c](benchmark::State& state) {
      const std::vector<FivePoseTask> tasks = pool(c);
      run(state, tasks, [](const FivePoseTask& task) { return five_pose_roots(task); });
      int by_action = 0;
      for (const FivePoseTask& task : tasks) by_action += five_pose_roots(task).path == FivePosePath::action;
      state.counters["by_action"] = static_cast<double>(by_action) / pool_size;
    });
    add("action", [&c](benchmark::State& state) {
      run(state, pool(c), [](const FivePoseTask& task) { return five_pose_roots(task, FivePosePath::action); });
    });
    if (c.name != "generic") continue;
    add("eigen_6x6", [&c](benchmark::State& state) {
      std::vector<Matrix6> matrices;
      for (const FivePoseTask& task : pool(c))
        if (const auto action = detail::action_of(five_pose_equations(task))) matrices.push_back(action->matrix);
      run(state, matrices, [](const Matrix6& m) { return Eigen::EigenSolver<Matrix6>(m).eigenvectors().eval(); });
    });
    add("report", [&c](benchmark::State& state) {
      run(state, pool(c), [](const FivePoseTask& task) { return FivePoseSolver().solve(task); });
    });
  }
  return true;
}();

}  // namespace
