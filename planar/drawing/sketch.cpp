#include "burmester/planar/drawing/sketch.hpp"

#include <algorithm>
#include <utility>

namespace burmester::planar {
namespace {

using Points = std::vector<Vector2>;

constexpr double arm = 0.15, overhang = 0.15, block_length = 0.06, block_width = 0.035;
constexpr double farthest = 1e3;  // links to pivots beyond are drawn as far as this

Vector2 direction_of(const Line& line) { return {line.normal[1], -line.normal[0]}; }
Vector2 foot_of(const Line& line) { return line.offset * line.normal; }
Vector2 origin_of(const Pose& pose) { return {pose.x, pose.y}; }

Points block_at(const Vector2& p, const Vector2& along) {
  const Vector2 u = block_length * along, v = block_width * Vector2(-along[1], along[0]);
  return {p - u - v, p + u - v, p + u + v, p - u + v};
}

/// The point itself, or a point on the way to it.
Vector2 towards(const Vector2& from, const Vector2& to) {
  const double distance = (to - from).norm();
  return distance <= farthest ? to : Vector2(from + (farthest / distance) * (to - from));
}

Vector2 nearest_on(const Vector2& from, const Vector2& to, const Vector2& p) {
  const double length2 = (to - from).squaredNorm();
  const double f = length2 > 0 ? std::clamp((p - from).dot(to - from) / length2, 0.0, 1.0) : 0;
  return from + f * (to - from);
}

/// The stretch of a line that holds the points, with some overhang.
template <class PointAt>
std::pair<Vector2, Vector2> stretch(const Line& line, const std::vector<Pose>& poses, PointAt point_at) {
  const Vector2 along = direction_of(line);
  double low = farthest, high = -farthest;
  for (const Pose& pose : poses) {
    const double at = std::clamp(along.dot(point_at(pose)), -farthest, farthest);
    low = std::min(low, at), high = std::max(high, at);
  }
  return {foot_of(line) + (low - overhang) * along, foot_of(line) + (high + overhang) * along};
}

}  // namespace

Sketch::Sketch(const std::array<SketchDyad, 2>& dyads, const std::vector<Pose>& everywhere) : everywhere_(everywhere) {
  for (int i = 0; i < 2; ++i)
    std::visit([&](const auto& d) { add_dyad(d, dyads[i].id, i == 0 ? "A" : "B"); }, dyads[i].design);
  add_ground();
  add_body();
}

Snapshot Sketch::at(const Pose& pose) const {
  Snapshot out;
  for (const Shape& shape : shapes_) {
    Polyline& line = out.emplace_back();
    for (const Vector2& p : shape(pose)) line.push_back({p[0], p[1]});
  }
  return out;
}

void Sketch::add(const std::string& role, const std::string& label, int dyad, Shape shape) {
  parts_.push_back({role, label, role == "block" || role == "coupler", dyad});
  shapes_.push_back(std::move(shape));
}

void Sketch::add_dyad(const RR::Design& d, int id, const std::string& letter) {
  add("link", "", id, [d](const Pose& x) {
    const Vector2 m = to_fixed(x, d.moving);
    return Points{towards(m, d.fixed), towards(origin_of(x), m)};
  });
  add("fixed_pivot", letter + "0", id, [d](const Pose&) { return Points{d.fixed}; });
  add("moving_pivot", letter, id, [d](const Pose& x) { return Points{to_fixed(x, d.moving)}; });
  bases_.push_back({d.fixed, d.fixed});
  couplings_.push_back(d.moving);
}

void Sketch::add_dyad(const PR::Design& d, int id, const std::string& letter) {
  const auto [from, to] = stretch(d.line, everywhere_, [&](const Pose& x) { return to_fixed(x, d.moving); });
  add("guide", "", id, [from = from, to = to](const Pose&) { return Points{from, to}; });
  add("block", "", id, [d](const Pose& x) { return block_at(to_fixed(x, d.moving), direction_of(d.line)); });
  add("moving_pivot", letter, id, [d](const Pose& x) { return Points{to_fixed(x, d.moving)}; });
  bases_.push_back({from, to});
  couplings_.push_back(d.moving);
}

void Sketch::add_dyad(const RP::Design& d, int id, const std::string& letter) {
  const auto [from, to] = stretch(d.line, everywhere_, [&](const Pose& x) { return to_moving(x, d.fixed); });
  add("guide", "", id, [from = from, to = to](const Pose& x) { return Points{to_fixed(x, from), to_fixed(x, to)}; });
  add("block", "", id, [d](const Pose& x) { return block_at(d.fixed, rotated(x, direction_of(d.line))); });
  add("fixed_pivot", letter + "0", id, [d](const Pose&) { return Points{d.fixed}; });
  bases_.push_back({d.fixed, d.fixed});
  couplings_.push_back(nearest_on(from, to, {0, 0}));
}

void Sketch::add_dyad(const PP::Design&, int id, const std::string&) {
  Vector2 low(farthest, farthest), high(-farthest, -farthest);
  double level = 1;  // of the fixed guide: below the body while that is in view
  for (const Pose& x : everywhere_) {
    const Vector2 p = origin_of(x);
    low = low.cwiseMin(p), high = high.cwiseMax(p);
    if (p.norm() <= 1.001) level = std::min(level, p[1] - 2 * overhang);
  }
  const Vector2 from(low[0] - overhang, level), to(high[0] + overhang, level);
  const double bottom = std::min(level, low[1] - overhang), top = high[1] + overhang;
  add("guide", "", id, [from, to](const Pose&) { return Points{from, to}; });
  add("guide", "", id, [bottom, top](const Pose& x) { return Points{{x.x, bottom}, {x.x, top}}; });
  add("block", "", id, [level](const Pose& x) { return block_at({x.x, level}, {1, 0}); });
  add("block", "", id, [](const Pose& x) { return block_at(origin_of(x), {0, 1}); });
  bases_.push_back({from, to});
}

/// The shortest line between what the dyads hold on to.
void Sketch::add_ground() {
  const auto& [a, b] = std::pair(bases_[0], bases_[1]);
  const Vector2 near_b = nearest_on(a.from, a.to, (b.from + b.to) / 2), q = nearest_on(b.from, b.to, near_b);
  const Vector2 p = nearest_on(a.from, a.to, q), end = towards(p, q), begin = towards(end, p);
  add("ground", "", 0, [begin, end](const Pose&) { return Points{begin, end}; });
}

void Sketch::add_body() {
  add("coupler", "", 0, [points = couplings_](const Pose& x) {
    Points out;
    for (const Vector2& p : points) out.push_back(towards(origin_of(x), to_fixed(x, p)));
    out.push_back(origin_of(x));
    return out;
  });
  add("frame", "", 0, [](const Pose& x) {
    return Points{to_fixed(x, {arm, 0}), origin_of(x), to_fixed(x, {0, arm})};
  });
}

}  // namespace burmester::planar
