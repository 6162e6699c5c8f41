// How far degenerate five-pose tasks are from all others, in the quotient that noise_factor cuts: pivot (or size of the
// pencil's cubic) times the pivot before, over what rounding the data once does to the rows.
//   study_degeneracy_margin [tasks of every class, default 100000]
// Exit code 1 where a class lies on both sides of noise_factor within a factor of 4.
#include <fmt/format.h>

#include <cstdlib>
#include <limits>

#include "burmester/geometry/null_space.hpp"
#include "burmester/planar/five_pose_roots.hpp"
#include "burmester/planar/tasks.hpp"

namespace {

using namespace burmester;
using namespace burmester::planar;

/// The smallest quotient of the task: of its rank, and where that is full of its pencil.
double quotient(const FivePoseTask& task) {
  const AnchorChoice choice = choose_anchor(task);
  const NullSpace<double, 4, 7> null = null_space(anchored_rows<double>(task, choice.anchor));
  const double rank = null.pivot[3] * null.pivot[2] / choice.noise;
  const FivePoseRoots<double> roots = five_pose_roots(task);
  if (!(rank > noise_factor)) return rank;
  return std::min(rank, roots.pencil_size * roots.smallest_pivot / choice.noise);
}

}  // namespace

int main(int argc, char** argv) {
  const long tasks = argc > 1 ? std::atol(argv[1]) : 100000;
  bool good = true;
  const auto run = [&](const TaskClass& c, bool degenerate) {
    Random random(fmt::format("degeneracy_margin.{}", c.name));
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (long i = 0; i < tasks; ++i) {
      const double q = quotient(c.make(random));
      least = std::min(least, q), most = std::max(most, q);
    }
    good = good && (degenerate ? most < noise_factor / 4 : least > noise_factor * 4);
    fmt::print("{:<22}{:>12.2g}{:>12.2g}   {}\n", c.name, least, most, degenerate ? "degenerate" : "");
  };
  fmt::print("{:<22}{:>12}{:>12}\n", "class", "smallest", "largest");
  // The other degenerate classes are told by equal orientations or equal poses, not by size.
  for (const char* name : {"rotation_about_point", "cardan_motion", "oldham_motion"}) run(*find_task_class(name), true);
  for (const TaskClass& c : random_task_classes()) run(c, false);
  return good ? 0 : 1;
}
