#include "burmester/spherical/drawing/views.hpp"

#include "burmester/spherical/drawing/arcs.hpp"

namespace burmester::spherical {
namespace {

/// Precondition: not along z, unless exactly.
SphereView view_from(const std::string& name, const Axis& eye) {
  const Axis vertical = eye[0] == 0 && eye[1] == 0 ? Axis::UnitY() : Axis::UnitZ();
  const Axis right = vertical.cross(eye).normalized();
  return {name, coordinates(right), coordinates(eye.cross(right)), coordinates(eye)};
}

Axis mean_of(const std::vector<SphereStroke>& strokes) {
  Axis sum = Axis::Zero();
  for (const SphereStroke& s : strokes)
    if (s.role == "task" || s.role == "fixed_axis" || s.role == "moving_axis")
      for (const auto& p : s.points) sum += Axis(p[0], p[1], p[2]);
  return sum.norm() > 1e-6 ? Axis(sum.normalized()) : Axis(Axis(3, 2, 1).normalized());
}

}  // namespace

std::vector<SphereView> views_of(const std::vector<SphereStroke>& strokes) {
  const Axis mean = mean_of(strokes);
  std::vector<SphereView> out{view_from("along the mean axis", mean)};
  for (int i = 0; i < 3; ++i) {
    const bool behind = mean[i] < 0;
    out.push_back(view_from(std::string("from ") + (behind ? "−" : "+") + "xyz"[i], (behind ? -1 : 1) * Axis::Unit(i)));
  }
  return out;
}

}  // namespace burmester::spherical
