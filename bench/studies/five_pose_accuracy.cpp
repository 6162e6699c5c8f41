// The direct five-pose solver against quad precision on many random tasks of every class.
//   study_five_pose_accuracy [generic tasks, default 1000000] [tasks of every other class, default 100000]
// Exit code 1 where a count is wrong or an error exceeds its limit.
#include <fmt/format.h>

#include <cstdlib>
#include <thread>

#include "five_pose_accuracy.hpp"

namespace {

using namespace burmester;
using namespace burmester::planar;

accuracy::Outcome run(const TaskClass& c, long tasks, int worker, int workers) {
  Random random(fmt::format("five_pose_accuracy.{}.{}", c.name, worker));
  accuracy::Outcome out;
  for (long i = worker; i < tasks; i += workers) accuracy::add_task(c.make(random), out);
  return out;
}

accuracy::Outcome run_parallel(const TaskClass& c, long tasks) {
  constexpr int workers = 2;  // part of the seeds' names: the tasks are the same on every machine
  accuracy::Outcome parts[workers];
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < workers; ++k) threads.emplace_back([&, k] { parts[k] = run(c, tasks, k, workers); });
  }
  accuracy::Outcome out = parts[0];
  for (int k = 1; k < workers; ++k) {
    out.tasks += parts[k].tasks, out.wrong_count += parts[k].wrong_count, out.wrong_type += parts[k].wrong_type;
    out.largest = std::max(out.largest, parts[k].largest);
    out.floor = std::max(out.floor, parts[k].floor);
    for (int n = 0; n < 5; ++n) out.with_real[n] += parts[k].with_real[n];
    out.errors.insert(out.errors.end(), parts[k].errors.begin(), parts[k].errors.end());
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const long generic = argc > 1 ? std::atol(argv[1]) : 1000000, others = argc > 2 ? std::atol(argv[2]) : 100000;
  bool good = true;
  fmt::print("{:<18}{:>9}{:>7}{:>6}{:>10}{:>10}{:>10}{:>10}   {:<20}{}\n", "class", "tasks", "count", "type", "median",
             "99.9 %", "largest", "rounding", "limits", "tasks with 0 / 2 / 4 real dyads");
  for (const TaskClass& c : random_task_classes()) {
    accuracy::Outcome out = run_parallel(c, c.name == "generic" ? generic : others);
    const accuracy::Limits limits = accuracy::limits_of(c.name);
    const double median = out.quantile(0.5), tail = out.quantile(0.999);
    const bool ok = out.wrong_count == 0 && out.wrong_type == 0 && median <= limits.median && tail <= limits.tail;
    good = good && ok;
    fmt::print("{:<18}{:>9}{:>7}{:>6}{:>10.1e}{:>10.1e}{:>10.1e}{:>10.1e}   {:.1e} {:.1e} {}  {} / {} / {}\n", c.name,
               out.tasks, out.wrong_count, out.wrong_type, median, tail, out.largest, out.floor, limits.median,
               limits.tail, ok ? "met" : "NOT MET", out.with_real[0], out.with_real[2], out.with_real[4]);
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}
