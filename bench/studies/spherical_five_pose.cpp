// The direct five-orientation solver against exact elimination on many random tasks of every class.
//   study_spherical_five_pose [generic tasks, default 300000] [other classes, default 30000] [nearly coaxial, default 3000]
// Exit code 1 where more counts are wrong than allowed (one of the generic tasks), or an error exceeds its limit.
#include <fmt/format.h>

#include <cstdlib>
#include <thread>

#include "burmester/spherical/tasks.hpp"
#include "spherical_accuracy.hpp"

namespace {

using namespace burmester;
using namespace burmester::spherical;

accuracy::Outcome run(const TaskClass& c, long tasks) {
  constexpr long workers = 2;  // part of the seeds' names: the tasks are the same on every machine
  accuracy::Outcome parts[workers];
  {
    std::vector<std::jthread> threads;
    for (long k = 0; k < workers; ++k)
      threads.emplace_back([&, k] {
        Random random(fmt::format("spherical_five_pose.{}.{}", c.name, k));
        for (long i = k; i < tasks; i += workers) accuracy::add_task(c.make(random), parts[k]);
      });
  }
  accuracy::Outcome out;
  for (const accuracy::Outcome& part : parts) out.add(part);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
  const long generic = argument(1, 300000), others = argument(2, 30000), coaxial = argument(3, 3000);
  bool good = true;
  fmt::print(
      "| class | tasks | wrong counts | by the action path | error: median | 99.9 % | largest | tasks with 0 / 2 / 4 / "
      "6 "
      "real dyads |\n|---|---|---|---|---|---|---|---|\n");
  for (const TaskClass& c : random_task_classes()) {
    const bool is_generic = c.name == "generic";
    accuracy::Outcome out = run(c, is_generic ? generic : c.name == "nearly_coaxial" ? coaxial : others);
    const accuracy::Limits limits = accuracy::limits_of(c.name);
    const double allowed = is_generic ? 1 : limits.wrong_share * static_cast<double>(out.tasks);
    good = good && static_cast<double>(out.wrong_count) <= allowed && out.quantile(0.5) <= limits.median &&
           out.quantile(0.999) <= limits.tail;
    fmt::print("| {} | {} | {} | {:.1f} % | {:.1e} | {:.1e} | {:.1e} | {} / {} / {} / {} |\n", c.name, out.tasks,
               out.wrong_count, 100 * static_cast<double>(out.by_action) / static_cast<double>(out.tasks),
               out.quantile(0.5), out.quantile(0.999), out.quantile(1), out.with_real[0], out.with_real[1],
               out.with_real[2], out.with_real[3]);
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}
