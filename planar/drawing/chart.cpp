#include "burmester/planar/drawing/chart.hpp"

#include <algorithm>

#include "burmester/planar/constraint_quadric.hpp"
#include "burmester/planar/drawing/stage.hpp"

namespace burmester::planar {
namespace {

Vector2 half_angle(const Pose& p) { return Vector2(p.X3, p.X4).normalized(); }

/// The pose with a rotation put before it.
Pose turned(const Pose& p, const Pose& by) {
  return {p.x, p.y, p.X3 * by.X4 + p.X4 * by.X3, p.X4 * by.X4 - p.X3 * by.X3};
}
Pose back(const Pose& rotation) { return {0, 0, -rotation.X3, rotation.X4}; }

Pose middle_of(const std::vector<Pose>& poses) {
  const Vector2 first = half_angle(poses[0]);
  Vector2 sum(0, 0);
  for (const Pose& p : poses) {
    const Vector2 half = half_angle(p);
    sum += half.dot(first) < 0 ? Vector2(-half) : half;
  }
  sum.normalize();
  return {0, 0, sum[0], sum[1]};
}

/// How far off a design's pivots are that rule out large turns: those of S and of E both.
double remoteness(const Family::Design& design) {
  const Vector2 *fixed = fixed_pivot(design), *moving = moving_pivot(design);
  if (fixed && moving) return std::min(fixed->norm(), moving->norm());
  return fixed ? fixed->norm() : moving ? moving->norm() : 0;
}

}  // namespace

Point3<double> Chart::point(const Pose& pose) const {
  Point3<double> p = Space::point<double>(turned(pose, back(middle)));
  p[1] *= weight;
  return p.normalized();
}

Pose Chart::pose(const Point3<double>& x) const {
  return turned(Space::pose({x[0], x[1] / weight, x[2], x[3]}), middle);
}

Quadric<double> Chart::quadric(const Family::Design& design) const {
  const Vector<double, 4> unit(1, 0, 0, 0), h = Space::point<double>(middle);
  const Family::Design moved = Family::Types::visit(
      design, [&]<class D>(const typename D::Design& d) { return Family::Design(D::moved(d, unit, h)); });
  Quadric<double> out = constraint_quadric(moved);
  if (const auto* d = std::get_if<PP::Design>(&moved))
    out = constraint_quadric(Vector<double, 8>{{0, 0, 0, 0, 0, 0, -std::sin(d->angle), std::cos(d->angle)}});
  for (const int i : {1, 4, 7, 8}) out.q[i] /= i == 1 ? weight * weight : weight;
  return out;
}

bool Chart::beyond(double distance, const Point3<double>& x) const {
  return 4 * x.tail<2>().squaredNorm() > distance * distance * (x[0] * x[0] + x[1] * x[1] / (weight * weight));
}

Chart chart_for(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b) {
  const Pose middle = middle_of(poses);
  double shift = 0, turn = 0;
  for (const Pose& p : poses) {
    shift = std::max(shift, std::hypot(p.x, p.y));
    turn = std::max(turn, std::abs(half_angle(turned(p, back(middle)))[0]));
  }
  const double far = std::max(remoteness(a), remoteness(b));
  return {middle, std::max(1.0, far * turn < shift ? far : shift / turn)};
}

}  // namespace burmester::planar
