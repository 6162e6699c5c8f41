// The certified answer beside poses with a double dyad: 1e-6 to 1e-15 from them, on both sides.
//   study_five_pose_double_roots [problems, default 10000]
// Each problem is a way between two random tasks with different numbers of real dyads. Counted against Sturm's theorem
// over rationals; true distances by a discriminant in 50 digits (tests/support/double_roots.hpp). Exit code 1 where a
// certified count is wrong, an answer is not certified though no dyad is double, the warning is missing below 10 units
// in the last place (2^-53) or given above 1000, or tells the wrong thing.
#include <fmt/format.h>

#include <cstdlib>
#include <thread>

#include "double_roots.hpp"

int main(int argc, char** argv) {
  using namespace burmester;
  using namespace burmester::planar;
  const long problems = argc > 1 ? std::atol(argv[1]) : 10000;
  constexpr long workers = 2;  // part of the seeds' names: the tasks are the same on every machine
  double_roots::Outcome part[workers];
  {
    std::vector<std::jthread> threads;
    for (long k = 0; k < workers; ++k)
      threads.emplace_back([&, k] {
        const std::string name = fmt::format("five_pose_double_roots.{}", k);
        Random random(name), coordinates(name + ".coordinates");
        for (long i = k; i < problems; i += workers) double_roots::walk(random, coordinates, part[k]);
      });
  }
  double_roots::Outcome out;
  for (const auto& p : part) out.add(p);
  fmt::print(
      "problems {}, poses {}\nnot certified though all dyads are simple: {}\nwrong certified counts: {}\n"
      "warnings missing below 10 units: {}\nwarnings above 1000 units: {}\nwarnings of the wrong kind: {}\n"
      "double roots not crossed: {}\nlargest relative error of the distance stated, below 1000 units: {:.1e}\n",
      out.problems, out.poses, out.uncertified, out.wrong_count, out.missing, out.needless, out.wrong_kind,
      out.not_bracketed, out.largest_error);
  return out.good() ? 0 : 1;
}
