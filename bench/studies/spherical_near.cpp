// Dyads near random directions: four orientations of each task class, one direction each.
//   study_spherical_near [sets, default 400]
// Exit code 1 where a dyad is not certified or leaves an orientation by more than 1e-14 rad, but for nearly_coaxial.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "burmester/spherical/near_curve.hpp"
#include "burmester/spherical/tasks.hpp"
#include "thread_time.hpp"

namespace {

using namespace burmester;
using namespace burmester::spherical;

double quantile(std::vector<double>& x, double share) {
  if (x.empty()) return 0;
  std::sort(x.begin(), x.end());
  return x[std::min(x.size() - 1, static_cast<std::size_t>(share * static_cast<double>(x.size())))];
}

}  // namespace

int main(int argc, char** argv) {
  const int sets = argc > 1 ? std::atoi(argv[1]) : 400;
  bool good = true;
  fmt::print(
      "| class | dyads, certified | traced completely | residual: median, largest | radius: median, 99 %, largest | "
      "ms |\n|---|---|---|---|---|---|\n");
  for (const std::string_view name : {"generic", "small_rotations", "near_half_turns", "close_pair", "planted_four_bar",
                                      "planted_slider", "nearly_coaxial"}) {
    Random random("spherical_near");
    std::vector<double> residuals, radii, times;
    int complete = 0;
    for (int i = 0; i < sets; ++i) {
      const auto five = find_task_class(name)->make(random);
      std::array<Pose, 4> poses;
      std::copy_n(five.begin(), 4, poses.begin());
      const Axis q = Space::random_feature(random);
      const FourPoseCurves curves = four_pose_curves(poses);
      complete += curves.complete;
      const double start = thread_time();
      const NearDyads answer = dyads_near(poses, curves.pieces, {{q[0], q[1], q[2]}}, true);
      times.push_back((thread_time() - start) / 1e3);
      for (const auto& found : answer.dyads) {
        residuals.push_back(found.residual);
        if (found.certificate.certified) radii.push_back(found.certificate.radius);
      }
    }
    good = good && (name == "nearly_coaxial" || (radii.size() == residuals.size() && quantile(residuals, 1) < 1e-14));
    fmt::print("| {} | {}, {} | {} | {:.0e}, {:.0e} | {:.0e}, {:.0e}, {:.0e} | {:.2f} |\n", name, residuals.size(),
               radii.size(), complete, quantile(residuals, 0.5), quantile(residuals, 1), quantile(radii, 0.5),
               quantile(radii, 0.99), quantile(radii, 1), quantile(times, 0.5));
  }
  return good ? 0 : 1;
}
