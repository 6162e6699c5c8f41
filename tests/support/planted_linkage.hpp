// Linkages with known poses: an oracle that turns the coupler by a given angle and finds where it can be.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "burmester/planar/family.hpp"

namespace burmester::planar {

using Design = Family::Design;

/// The places t of E's origin where a dyad is met at an orientation: |t - centre| = radius, or normal . t = offset.
struct Locus {
  Vector2 centre, normal;
  double radius = 0, offset = 0;
  bool circle = false;
};
inline Locus locus(const Design& design, const Pose& turned) {
  Locus out;
  if (const auto* d = std::get_if<RR::Design>(&design)) {
    out.centre = d->fixed - rotated(turned, d->moving), out.radius = d->length, out.circle = true;
  } else if (const auto* e = std::get_if<PR::Design>(&design)) {
    out.normal = e->line.normal, out.offset = e->line.offset - e->line.normal.dot(rotated(turned, e->moving));
  } else if (const auto* f = std::get_if<RP::Design>(&design)) {
    out.normal = rotated(turned, f->line.normal), out.offset = out.normal.dot(f->fixed) - f->line.offset;
  }
  return out;
}
inline std::vector<Vector2> meet_line(const Locus& line, const Locus& circle) {
  const double distance = line.offset - line.normal.dot(circle.centre);
  const double h2 = circle.radius * circle.radius - distance * distance;
  if (h2 < 0) return {};
  const Vector2 foot = circle.centre + distance * line.normal, along(line.normal[1], -line.normal[0]);
  return {foot + std::sqrt(h2) * along, foot - std::sqrt(h2) * along};
}
inline std::vector<Vector2> meet(const Locus& a, const Locus& b) {
  if (a.circle && !b.circle) return meet_line(b, a);
  if (!a.circle && b.circle) return meet_line(a, b);
  if (!a.circle) {
    Eigen::Matrix2d m;
    m << a.normal.transpose(), b.normal.transpose();
    return {m.inverse() * Eigen::Vector2d(a.offset, b.offset)};
  }
  const Vector2 d = b.centre - a.centre;  // the radical line
  const double g = d.norm();
  Locus line;
  line.normal = d / g;
  line.offset = line.normal.dot(a.centre) + (g * g + a.radius * a.radius - b.radius * b.radius) / (2 * g);
  return meet_line(line, a);
}
/// Poses of the linkage with the coupler turned by `angle`: two circles have two, on either side.
inline std::vector<Pose> poses_at(const Design& a, const Design& b, double angle) {
  std::vector<Pose> out;
  for (const Vector2& t : meet(locus(a, pose_from_radians(0, 0, angle)), locus(b, pose_from_radians(0, 0, angle))))
    out.push_back(pose_from_radians(t[0], t[1], angle));
  return out;
}

struct Planted {
  Design a, b;
  std::vector<Pose> poses;
};
/// All five poses on random designs of two types; orientations uniform.
template <class A, class B>
Planted plant(Random& random) {
  for (;;) {
    Planted out{A::random_design(random), B::random_design(random), {}};
    for (int tries = 0; tries < 40 && out.poses.size() < 5; ++tries) {
      const auto found = poses_at(out.a, out.b, random.uniform(-std::numbers::pi, std::numbers::pi));
      if (!found.empty() && std::hypot(found[0].x, found[0].y) < 5) out.poses.push_back(found[0]);
    }
    if (out.poses.size() == 5) return out;
  }
}

}  // namespace burmester::planar
