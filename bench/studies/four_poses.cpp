// Curves and sliders of four random poses against the size of the turns.
//   study_four_poses [sets of each size, default 200]
// Origins and turns are normally distributed, standard deviation 1 and that of the row (rad). Exit code 1 where turns
// of 1 rad leave a curve incomplete, or turns of 1e-3 rad and more a slider unlisted.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "burmester/geometry/random.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "burmester/planar/tasks.hpp"

int main(int argc, char** argv) {
  using namespace burmester;
  using namespace burmester::planar;
  const int sets = argc > 1 ? std::atoi(argv[1]) : 200;
  bool good = true;
  fmt::print(
      "| turns, rad | curve scale in task sizes, geometric mean | pairs listed, mean | sets traced completely | "
      "sliders listed, of {} |\n|---|---|---|---|---|\n",
      2 * sets);
  Random random("four_poses");
  for (const double turns : {1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5}) {
    double scale = 0;
    std::size_t pairs = 0, sliders = 0;
    int complete = 0;
    for (int i = 0; i < sets; ++i) {
      std::array<Pose, 4> poses;
      for (Pose& p : poses) {
        const double x = random.normal(), y = random.normal();
        p = pose_from_radians(x, y, turns * random.normal());
      }
      scale += std::log(curve_scale(poses) / task_size(poses));
      const FourPoseCurves curves = four_pose_curves(poses);
      complete += curves.complete;
      for (const CurveRecord& piece : curves.pieces) pairs += piece.moving.size();
      sliders += FourPoseSolver().solve(poses).dyads.size();
    }
    good = good && (turns < 1 || complete == sets) && (turns < 1e-3 || sliders == 2 * static_cast<std::size_t>(sets));
    fmt::print("| {:.0e} | {:.3g} | {:.0f} | {} | {} |\n", turns, std::exp(scale / sets),
               static_cast<double>(pairs) / sets, complete, sliders);
  }
  return good ? 0 : 1;
}
