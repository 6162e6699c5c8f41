// The certified five-pose answer on many random tasks of every class: what decides, how sharp, at what cost.
//   study_five_pose_certificate [generic tasks, default 1000000] [tasks of every other class, default 100000]
// Columns: answers not certified; count decided by intervals and exactly, boxes by intervals and exactly (percent of
// the tasks; the latter with those computed again because a radius was above 1e-9 of the task size); percentiles of the
// largest radius over the task size; CPU time of solving and of solving with proof.
// Exit code 1 where an answer is not certified, a radius of a generic task is above 1e-9 of the task size for more than
// 0.1 %, or the median of the certified answer costs ten times the bare roots or more.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "burmester/planar/five_pose_certificate.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"
#include "thread_time.hpp"

namespace {

using namespace burmester;
using namespace burmester::planar;

struct Outcome {
  long tasks = 0, uncertified = 0, count_exact = 0, boxes_exact = 0;
  std::vector<float> radius, bare, roots, proof;  ///< radius over task size; microseconds

  void add(const Outcome& o) {
    tasks += o.tasks, uncertified += o.uncertified, count_exact += o.count_exact, boxes_exact += o.boxes_exact;
    for (const auto member : {&Outcome::radius, &Outcome::bare, &Outcome::roots, &Outcome::proof})
      (this->*member).insert((this->*member).end(), (o.*member).begin(), (o.*member).end());
  }
};

void solve(const FivePoseTask& task, Outcome& out) {
  const double start = thread_time();
  const int bare = five_pose_roots(task).count;
  const double after_bare = thread_time();
  const CertifiedRoots certified = certified_five_pose_roots(task);
  const double after_roots = thread_time();
  const PlanarReport report = FivePoseSolver().solve(task);
  const double end = thread_time();
  ++out.tasks;
  out.uncertified += !report.counts.certified || bare < 0;
  out.count_exact += certified.count_rung == Rung::exact;
  double radius = 0;
  bool exact_boxes = false;
  for (const auto& found : report.dyads) {
    radius = std::max(radius, found.certificate.radius);
    exact_boxes = exact_boxes || found.certificate.rung == Rung::exact;
  }
  out.boxes_exact += exact_boxes;
  out.radius.push_back(static_cast<float>(radius / task_size(task)));
  out.bare.push_back(static_cast<float>(after_bare - start));
  out.roots.push_back(static_cast<float>(after_roots - after_bare));
  out.proof.push_back(static_cast<float>(end - after_roots));
}

Outcome run(const TaskClass& c, long tasks) {
  constexpr long workers = 2;  // part of the seeds' names: the tasks are the same on every machine
  Outcome part[workers];
  {
    std::vector<std::jthread> threads;
    for (long k = 0; k < workers; ++k)
      threads.emplace_back([&, k] {
        Random random(fmt::format("five_pose_certificate.{}.{}", c.name, k));
        for (long i = k; i < tasks; i += workers) solve(c.make(random), part[k]);
      });
  }
  Outcome out;
  for (const Outcome& p : part) out.add(p);
  return out;
}

double quantile(std::vector<float>& x, double p) {
  const auto at = static_cast<long>(p * static_cast<double>(x.size() - 1));
  std::nth_element(x.begin(), x.begin() + at, x.end());
  return static_cast<double>(x[static_cast<std::size_t>(at)]);
}
double mean(const std::vector<float>& x) {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v);
  return sum / static_cast<double>(x.size());
}

}  // namespace

int main(int argc, char** argv) {
  const long generic = argc > 1 ? std::atol(argv[1]) : 1000000, others = argc > 2 ? std::atol(argv[2]) : 100000;
  bool good = true;
  fmt::print(
      "| class | tasks | not certified | count: intervals / exact | boxes: intervals / exact | radius: median | 99.9 % "
      "| "
      "largest | roots alone, us: median | proved: median, mean | whole report: median, mean |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const TaskClass& c : random_task_classes()) {
    const bool is_generic = c.name == "generic";
    Outcome out = run(c, is_generic ? generic : others);
    const double tail = quantile(out.radius, 0.999), ratio = quantile(out.roots, 0.5) / quantile(out.bare, 0.5);
    good = good && out.uncertified == 0 && ratio < 10 && (!is_generic || tail <= 1e-9);
    const auto percent = [&](long n) { return 100 * static_cast<double>(n) / static_cast<double>(out.tasks); };
    fmt::print(
        "| {} | {} | {} | {:.3f} / {:.3f} % | {:.3f} / {:.3f} % | {:.0e} | {:.0e} | {:.0e} | {:.2f} | {:.1f}, {:.1f} | "
        "{:.0f}, {:.0f} |\n",
        c.name, out.tasks, out.uncertified, 100 - percent(out.count_exact), percent(out.count_exact),
        100 - percent(out.boxes_exact), percent(out.boxes_exact), quantile(out.radius, 0.5), tail,
        *std::max_element(out.radius.begin(), out.radius.end()), quantile(out.bare, 0.5), quantile(out.roots, 0.5),
        mean(out.roots), quantile(out.proof, 0.5), mean(out.proof));
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}
