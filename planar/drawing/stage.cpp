#include "burmester/planar/drawing/stage.hpp"

#include <algorithm>
#include <limits>

namespace burmester::planar {
namespace {

Vector2 origin_of(const Pose& p) { return {p.x, p.y}; }

Vector2 centroid(const std::vector<Pose>& poses) {
  Vector2 sum(0, 0);
  for (const Pose& p : poses) sum += origin_of(p) - origin_of(poses[0]);
  return origin_of(poses[0]) + sum / static_cast<double>(poses.size());
}

/// Distances of a design's pivots, in all poses, from the centre.
std::vector<double> pivot_distances(const Family::Design& d, const std::vector<Pose>& poses, const Vector2& centre) {
  std::vector<double> out;
  if (const Vector2* f = fixed_pivot(d)) out.push_back((*f - centre).norm());
  if (const Vector2* m = moving_pivot(d))
    for (const Pose& p : poses) out.push_back((rotated(p, *m) + (origin_of(p) - centre)).norm());
  return out;
}


double length_of(const Family::Design& design) {
  const auto* d = std::get_if<RR::Design>(&design);
  return d ? d->length : 0;
}

}  // namespace

const Vector2* fixed_pivot(const Family::Design& design) {
  if (const auto* d = std::get_if<RR::Design>(&design)) return &d->fixed;
  if (const auto* d = std::get_if<RP::Design>(&design)) return &d->fixed;
  return nullptr;
}
const Vector2* moving_pivot(const Family::Design& design) {
  if (const auto* d = std::get_if<RR::Design>(&design)) return &d->moving;
  if (const auto* d = std::get_if<PR::Design>(&design)) return &d->moving;
  return nullptr;
}

Family::Design Stage::design(const Family::Design& design) const {
  if (const auto* d = std::get_if<RR::Design>(&design))
    return RR::Design{(d->fixed - centre) / unit, d->moving / unit, d->length / unit};
  if (const auto* d = std::get_if<PR::Design>(&design)) {
    const double offset = -d->line.signed_distance(centre);
    return PR::Design{d->moving / unit, {d->line.normal, offset / unit}};
  }
  if (const auto* d = std::get_if<RP::Design>(&design))
    return RP::Design{(d->fixed - centre) / unit, {d->line.normal, d->line.offset / unit}};
  return design;
}

Stage stage_of(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b) {
  const Vector2 centre = centroid(poses);
  double task = 0, nearest = std::numeric_limits<double>::infinity();
  for (const Pose& p : poses) task = std::max(task, (origin_of(p) - centre).norm());
  std::vector<double> pivots = pivot_distances(a, poses, centre);
  for (const double r : pivot_distances(b, poses, centre)) pivots.push_back(r);
  for (const double r : pivots) nearest = std::min(nearest, r);
  const double longest = std::max(length_of(a), length_of(b));
  const double own_size = longest > 0 ? std::min(nearest, longest) : nearest;
  double radius = task;
  for (const double r : pivots)
    if (r <= too_far * std::max(2 * task, own_size)) radius = std::max(radius, r);
  return {centre, radius > 0 ? radius : 1};
}

}  // namespace burmester::planar
