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
  double task = 0, own = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Pose& p : poses) task = std::max(task, (origin_of(p) - centre).norm());
  std::vector<double> pivots;
  for (const Family::Design* design : {&a, &b}) {
    const std::vector<double> distances = pivot_distances(*design, poses, centre);
    if (distances.empty()) continue;
    own = std::min(own, *std::max_element(distances.begin(), distances.end()));
    longest = std::max(longest, length_of(*design));
    pivots.insert(pivots.end(), distances.begin(), distances.end());
  }
  if (longest > 0) own = std::min(own, longest);
  double radius = task;
  for (const double r : pivots)
    if (r <= too_far * std::max(2 * task, own)) radius = std::max(radius, r);
  return {centre, radius > 0 ? radius : 1};
}

}  // namespace burmester::planar
