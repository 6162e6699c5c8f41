// The certified answer for five orientations on many random tasks of every class: what decides,
// how sharp, at what cost.
//   study_spherical_certificate [generic tasks, default 100000] [of every other class, 10000] [checked, 300]
// Columns: answers not certified; certified counts that the elimination of five_pose_oracle.hpp finds wrong, among the
// first `checked` tasks; tasks that intervals decided alone, the others being decided exactly; the largest radius of a
// task, radians; microseconds of CPU for the roots alone, their proof, and the whole report with both.
// Exit code 1 where a count is wrong, a generic answer is not certified, or more than a fifth of a class.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "burmester/spherical/five_pose_certificate.hpp"
#include "burmester/spherical/five_pose_oracle.hpp"
#include "burmester/spherical/five_pose_roots.hpp"
#include "burmester/spherical/five_pose_solver.hpp"
#include "burmester/spherical/tasks.hpp"
#include "thread_time.hpp"

namespace {

using namespace burmester;
using namespace burmester::spherical;

struct Outcome {
  long tasks = 0, uncertified = 0, wrong = 0, by_intervals = 0;
  std::vector<double> radius, bare, proof, report;
};

void solve(const FivePoseTask& task, bool check, Outcome& out) {
  const double start = thread_time();
  const FivePoseRoots roots = five_pose_roots(task);
  const double after_roots = thread_time();
  std::vector<AxisPair> found;
  for (int i = 0; i < roots.count; ++i) {
    const RR::Design d = dyad_of(roots.equations, roots.root[static_cast<std::size_t>(i)], task);
    found.push_back({d.moving, d.fixed});
  }
  const double before_proof = thread_time();
  const CertifiedAxes proved = certified_axes(task, found);
  const double after_proof = thread_time();
  const SphericalReport report = FivePoseSolver().solve(task);
  const double end = thread_time();

  ++out.tasks;
  out.uncertified += !report.counts.certified;
  if (check && report.counts.certified && report.counts.real) out.wrong += *report.counts.real != exact_count(task);
  double radius = 0;
  bool by_intervals = proved.complete && proved.count_rung == Rung::intervals;
  for (const auto& dyad : report.dyads) {
    radius = std::max(radius, dyad.certificate.radius);
    by_intervals = by_intervals && dyad.certificate.rung == Rung::intervals;
  }
  out.by_intervals += by_intervals;
  out.radius.push_back(radius);
  out.bare.push_back(after_roots - start);
  out.proof.push_back(after_proof - before_proof);
  out.report.push_back(end - after_proof);
}

double quantile(std::vector<double>& x, double p) {
  const auto at = static_cast<long>(p * static_cast<double>(x.size() - 1));
  std::nth_element(x.begin(), x.begin() + at, x.end());
  return x[static_cast<std::size_t>(at)];
}
double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v;
  return sum / static_cast<double>(x.size());
}

}  // namespace

int main(int argc, char** argv) {
  const long generic = argc > 1 ? std::atol(argv[1]) : 100000, others = argc > 2 ? std::atol(argv[2]) : 10000,
             checked = argc > 3 ? std::atol(argv[3]) : 300;
  bool good = true;
  fmt::print(
      "| class | tasks | not certified | wrong of {} | by intervals | radius: median | 99.9 "
      "% | "
      "largest | roots alone, us: median, mean | proof: median, mean | whole report: median, mean |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n",
      checked);
  for (const TaskClass& c : random_task_classes()) {
    const bool is_generic = c.name == "generic";
    Random random(fmt::format("spherical_certificate.{}", c.name));
    Outcome out;
    for (long i = 0; i < (is_generic ? generic : others); ++i) solve(c.make(random), i < checked, out);
    good = good && out.wrong == 0 && out.uncertified * 5 <= out.tasks && (!is_generic || out.uncertified == 0);
    const auto percent = [&](long n) { return 100 * static_cast<double>(n) / static_cast<double>(out.tasks); };
    const double radius = quantile(out.radius, 0.5), tail = quantile(out.radius, 0.999);
    fmt::print(
        "| {} | {} | {} | {} | {:.3f} % | {:.0e} | {:.0e} | {:.0e} | {:.1f}, {:.1f} | {:.1f}, {:.0f} | "
        "{:.0f}, "
        "{:.0f} |\n",
        c.name, out.tasks, out.uncertified, out.wrong, percent(out.by_intervals), radius, tail,
        *std::max_element(out.radius.begin(), out.radius.end()), quantile(out.bare, 0.5), mean(out.bare),
        quantile(out.proof, 0.5), mean(out.proof), quantile(out.report, 0.5), mean(out.report));
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}
