#include "burmester/spherical/drawing/sketch.hpp"

#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <string>

#include "burmester/geometry/quadric_curve.hpp"
#include "burmester/spherical/constraint_quadric.hpp"

namespace burmester::spherical {
namespace {

constexpr double walk_step = 0.02;  // on the unit sphere of quaternions, half of the rotation in radians
constexpr double visible = 1e-6;    // radians: a miss that the eye could never see

const char* letter(std::size_t k) { return k == 0 ? "A" : "B"; }

Quadric<double> quadric_of(const SketchDyad& d) {
  return constraint_quadric(d.slider ? PR::encode({d.fixed, d.moving}) : RR::encode({d.fixed, d.moving, d.arc}));
}

double spread(const SketchDyad& a, const SketchDyad& b) {
  const Axis x = Axis::UnitX();
  const double fixed = a.slider || b.slider ? 0 : Space::distance(a.fixed, b.fixed);
  return fixed + Space::distance(a.moving, b.moving) + Space::distance(a.moving, x) + Space::distance(b.moving, x);
}

SketchDyad reversed(SketchDyad d) {
  d.fixed = -d.fixed, d.moving = -d.moving;
  return d;
}

bool passes(const Walk& walk, const Point3<double>& x) {
  const Point3<double>& p = walk.points[nearest_point(walk, x)];
  return (aligned(x, p) - p).norm() < 0.6 * walk_step;
}

}  // namespace

std::optional<SketchDyad> sketch_dyad(const DyadRecord& record) {
  if (record.fixed.size() != 3 || record.moving.size() != 3 || !record.arc) return std::nullopt;
  const auto axis = [](const std::vector<double>& v) { return Axis(v[0], v[1], v[2]).normalized(); };
  return SketchDyad{record.id, record.type == PR::name, axis(record.fixed), axis(record.moving), *record.arc};
}

std::array<SketchDyad, 2> compact(std::array<SketchDyad, 2> dyads) {
  std::array<SketchDyad, 2> best = dyads;
  double least = std::numeric_limits<double>::infinity();
  for (const SketchDyad& a : {dyads[0], reversed(dyads[0])})
    for (const SketchDyad& b : {dyads[1], reversed(dyads[1])})
      if (const double s = spread(a, b); s < least) least = s, best = {a, b};
  return best;
}

std::vector<SphereStroke> fixed_strokes(const std::array<SketchDyad, 2>& dyads) {
  std::vector<SphereStroke> out;
  if (!dyads[0].slider && !dyads[1].slider)
    out.push_back({.role = "ground", .points = great_arc(dyads[0].fixed, dyads[1].fixed)});
  for (const SketchDyad& d : dyads)
    if (d.slider)
      out.push_back(
          {.role = "guide", .dyad = d.id, .closed = true, .points = circle_about(d.fixed, std::numbers::pi / 2)});
  for (std::size_t k = 0; k < 2; ++k)
    out.push_back({.role = "fixed_axis",
                   .label = fmt::format("{}0", letter(k)),
                   .dyad = dyads[k].id,
                   .points = {coordinates(dyads[k].fixed)}});
  return out;
}

std::vector<SphereStroke> moving_strokes(const std::array<SketchDyad, 2>& dyads, const Pose& at, int pose) {
  const std::array<Axis, 3> body{carried(at, dyads[0].moving), carried(at, dyads[1].moving),
                                 carried(at, Axis::UnitX())};
  std::vector<SphereStroke> out;
  for (std::size_t k = 0; k < 3; ++k)
    out.push_back({.role = "coupler", .pose = pose, .points = great_arc(body[k], body[(k + 1) % 3])});
  for (std::size_t k = 0; k < 2; ++k)
    if (dyads[k].slider)
      out.push_back({.role = "block",
                     .dyad = dyads[k].id,
                     .pose = pose,
                     .closed = true,
                     .points = block_at(body[k], dyads[k].fixed)});
    else
      out.push_back({.role = "link", .dyad = dyads[k].id, .pose = pose, .points = great_arc(dyads[k].fixed, body[k])});
  for (std::size_t k = 0; k < 2; ++k)
    out.push_back({.role = "moving_axis",
                   .label = letter(k),
                   .dyad = dyads[k].id,
                   .pose = pose,
                   .points = {coordinates(body[k])}});
  out.push_back({.role = "body", .pose = pose, .points = attitude(at)});
  return out;
}

Motions motions_through(const std::vector<Pose>& poses, const std::array<SketchDyad, 2>& dyads) {
  const QuadricCurve curve(quadric_of(dyads[0]), quadric_of(dyads[1]));
  Motions out{poses, {}};
  std::vector<Walk> walks;
  for (Pose& pose : out.shown) {
    const Point3<double> x = Space::point<double>(pose).normalized(), on = curve.corrected(x).value_or(x);
    if ((on - x).norm() > visible) pose = Space::pose(on);
    bool seen = false;
    for (const Walk& w : walks) seen = seen || passes(w, on);
    if (seen) continue;
    Walk path = walk(curve, on, {.longest_step = walk_step, .stop = {}});
    if (path.points.size() < 2) continue;
    std::vector<Pose>& frames = out.paths.emplace_back();
    for (const Point3<double>& p : path.points) frames.push_back(Space::pose(p));
    if (path.closed) frames.push_back(frames.front());
    walks.push_back(std::move(path));
  }
  return out;
}

}  // namespace burmester::spherical
