// Cones and sliders of four random orientations: cost, size, completeness, and how well the pairs keep their arc.
//   study_spherical_curves [sets, default 1000]
// Exit code 1 where a cone is not traced completely, an arc changes by more than 1e-12 rad, or a slider is not proved.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>

#include "burmester/spherical/four_pose_curves.hpp"

namespace {

using namespace burmester;
using namespace burmester::spherical;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double change_of_arc(const std::array<Pose, 4>& poses, const PointRecord& moving, const PointRecord& fixed) {
  const Axis a(moving[0], moving[1], moving[2]), b(fixed[0], fixed[1], fixed[2]);
  double least = 4, largest = 0;
  for (const Pose& pose : poses) {
    const double arc = Space::distance(Space::act<double>(Space::point<double>(pose), a).normalized(), b);
    least = std::min(least, arc), largest = std::max(largest, arc);
  }
  return largest - least;
}

}  // namespace

int main(int argc, char** argv) {
  const int sets = argc > 1 ? std::atoi(argv[1]) : 1000;
  Random random("spherical_curves");
  double tracing = 0, eliminating = 0, worst = 0, radius = 0;
  long pairs = 0;
  int complete = 0, two_components = 0, unproved = 0;
  std::array<int, 7> with_sliders{};
  for (int i = 0; i < sets; ++i) {
    std::array<Pose, 4> poses;
    for (Pose& p : poses) p = Space::random_pose(random);
    const double start = seconds();
    const FourPoseCurves curves = four_pose_curves(poses);
    const double traced = seconds();
    const auto found = sliders(poses);
    tracing += traced - start, eliminating += seconds() - traced;
    complete += curves.complete, two_components += curves.topology.components == 2;
    for (const CurveRecord& piece : curves.pieces)
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++pairs)
        worst = std::max(worst, change_of_arc(poses, piece.moving[k], piece.fixed[k]));
    unproved += !found;
    if (!found) continue;
    ++with_sliders[found->size()];
    for (const FoundSlider& f : *found) {
      unproved += !f.slider.certificate.certified;
      radius = std::max(radius, f.slider.certificate.radius);
    }
  }
  fmt::print(
      "{} sets: {:.3f} ms and {:.0f} pairs each, {} complete, {} with two components; largest change of an arc "
      "{:.1e}\n",
      sets, tracing * 1e3 / sets, static_cast<double>(pairs) / sets, complete, two_components, worst);
  fmt::print("sliders: {:.3f} ms, {} not proved, largest radius {:.1e}; sets with 0, 2, 4, 6: {} {} {} {}\n",
             eliminating * 1e3 / sets, unproved, radius, with_sliders[0], with_sliders[2], with_sliders[4],
             with_sliders[6]);
  return complete == sets && unproved == 0 && worst < 1e-12 ? 0 : 1;
}
