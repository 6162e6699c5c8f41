#include "research/planar_limit/limit.hpp"

#include <algorithm>
#include <cmath>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/spherical/five_pose_roots.hpp"
#include "burmester/spherical/tangent_plane.hpp"

namespace burmester {
namespace {

using spherical::Axis;

std::vector<DyadPlace> on_sphere(std::span<const planar::Pose, 5> planar_poses, double curvature) {
  std::array<spherical::Pose, 5> poses;
  std::transform(planar_poses.begin(), planar_poses.end(), poses.begin(), [&](const planar::Pose& p) {
    return spherical::wrapped_pose(p.x, p.y, planar::angle_of(p), curvature);
  });
  const spherical::FivePoseRoots roots = spherical::five_pose_roots(poses);
  std::vector<DyadPlace> out;
  for (int i = 0; i < roots.count; ++i) {
    const auto d = spherical::dyad_of(roots.equations, roots.root[static_cast<std::size_t>(i)], poses);
    const Axis moving = spherical::Space::act<double>(spherical::Space::point<double>(poses[0]), d.moving);
    out.push_back({spherical::in_tangent_plane(d.fixed, curvature), spherical::in_tangent_plane(moving, curvature)});
  }
  return out;
}

/// Sine of the angle between the axes, the larger of the two: no jump where an axis passes the horizon.
double turned(const DyadPlace& a, const DyadPlace& b, double curvature) {
  const auto sine = [&](const planar::Vector2& p, const planar::Vector2& q) {
    return spherical::axis_through(p, curvature).cross(spherical::axis_through(q, curvature)).norm();
  };
  return std::max(sine(a.fixed, b.fixed), sine(a.moving, b.moving));
}

/// Gives each place to the dyad that it is next to, the closest pairs first; what is left over stays in `places`.
void extend(std::vector<FollowedDyad>& dyads, std::size_t step, std::vector<DyadPlace>& places, double curvature) {
  for (;;) {
    double least = 2;
    FollowedDyad* follower = nullptr;
    std::size_t taken = 0;
    for (FollowedDyad& d : dyads) {
      if (d.path.size() != step) continue;
      const DyadPlace& last = step == 0 ? d.planar : d.path.back();
      for (std::size_t i = 0; i < places.size(); ++i)
        if (const double by = turned(last, places[i], curvature); by < least) least = by, follower = &d, taken = i;
    }
    if (!follower) return;
    follower->path.push_back(places[taken]);
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(taken));
  }
}

}  // namespace

double apart(const DyadPlace& a, const DyadPlace& b) {
  return std::max((a.fixed - b.fixed).norm(), (a.moving - b.moving).norm());
}

PlanarLimit planar_limit(std::span<const planar::Pose, 5> poses, const std::vector<planar::RR::Design>& dyads,
                         const std::vector<double>& e) {
  PlanarLimit out{planar::task_size(poses), e, {}, {}};
  for (const auto& d : dyads) out.dyads.push_back({{d.fixed, planar::to_fixed(poses[0], d.moving)}, {}});
  for (std::size_t step = 0; step < e.size(); ++step) {
    const double curvature = e[step] / out.size;
    std::vector<DyadPlace> places = on_sphere(poses, curvature);
    extend(out.dyads, step, places, curvature);
    out.others.push_back(std::move(places));
  }
  return out;
}

std::optional<double> exponent(const PlanarLimit& limit, const FollowedDyad& dyad, std::size_t from, std::size_t to) {
  if (dyad.path.size() <= std::max(from, to)) return std::nullopt;
  return std::log(apart(dyad.path[to], dyad.planar) / apart(dyad.path[from], dyad.planar)) /
         std::log(limit.e[to] / limit.e[from]);
}

}  // namespace burmester
