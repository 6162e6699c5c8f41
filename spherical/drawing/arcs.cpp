#include "burmester/spherical/drawing/arcs.hpp"

#include <cmath>
#include <numbers>

namespace burmester::spherical {
namespace {

constexpr double block_length = 0.06, block_width = 0.035;  // half sides, radians

Axis turned(const Axis& u, const Axis& v, double angle) { return std::cos(angle) * u + std::sin(angle) * v; }

}  // namespace

Axis towards(const Axis& p, const Axis& q, double angle) {
  const Axis across = p.cross(q);
  const Axis pole = across.norm() > 0 ? across.normalized() : p.unitOrthogonal();
  return turned(p, pole.cross(p), angle).normalized();
}

SpherePoints great_arc(const Axis& p, const Axis& q) {
  const double length = Space::distance(p, q);
  const int count = std::max(1, static_cast<int>(std::ceil(length / arc_step)));
  SpherePoints out;
  for (int i = 0; i < count; ++i) out.push_back(coordinates(towards(p, q, length * i / count)));
  out.push_back(coordinates(q));
  return out;
}

SpherePoints circle_about(const Axis& pole, double arc) {
  const int count = static_cast<int>(std::ceil(2 * std::numbers::pi / arc_step));
  const Axis u = pole.unitOrthogonal(), v = pole.cross(u);
  SpherePoints out;
  for (int i = 0; i < count; ++i)
    out.push_back(coordinates(turned(pole, turned(u, v, 2 * std::numbers::pi * i / count), arc).normalized()));
  return out;
}

SpherePoints block_at(const Axis& p, const Axis& pole) {
  const Axis along = towards(p, pole.cross(p).normalized(), std::numbers::pi / 2), across = p.cross(along);
  SpherePoints out;
  for (const auto& [u, v] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    out.push_back(coordinates((p + u * block_length * along + v * block_width * across).normalized()));
  return out;
}

SpherePoints attitude(const Pose& pose) {
  const Axis x = carried(pose, Axis::UnitX());
  return {coordinates(towards(x, carried(pose, Axis::UnitY()), attitude_arm)), coordinates(x),
          coordinates(towards(x, carried(pose, Axis::UnitZ()), attitude_arm))};
}

Axis carried(const Pose& pose, const Axis& p) { return Space::act<double>(Space::point<double>(pose), p).normalized(); }

std::array<double, 3> coordinates(const Axis& p) { return {p[0], p[1], p[2]}; }

}  // namespace burmester::spherical
