#include "burmester/planar/constraint_manifold.hpp"

#include <limits>

namespace burmester::planar {
namespace {

constexpr double zero = 1e-12;  // as Family::decode

Vector2 direction_of(const Line& line) { return {line.normal[1], -line.normal[0]}; }

/// Of a PR (sign = 1: the point and the line as seen from S) or an RP (-1: as seen from E); 2 (K1, K2) = normal.
Line line_section(const Vector2& p, const Line& line, double sign, double t, double w) {
  const Vector2& n = line.normal;
  const double h = std::hypot(t, w), dot = n.dot(p), cross = n[0] * p[1] - n[1] * p[0];
  const double c = (-(line.offset + dot) * t * t + (dot - line.offset) * w * w) / 2 - sign * cross * t * w;
  return {Vector2(n[0] * t - sign * n[1] * w, n[1] * t + sign * n[0] * w) / h, -c / h};
}

std::optional<CircleOrLine> section_of(const RR::Design& d, double t, double w) {
  const Vector2 sum = d.moving + d.fixed, step = d.moving - d.fixed;
  return Circle{Vector2(sum[0] * t + step[1] * w, sum[1] * t - step[0] * w) / 2, d.length * std::hypot(t, w) / 2};
}
std::optional<CircleOrLine> section_of(const PR::Design& d, double t, double w) {
  return line_section(d.moving, d.line, 1, t, w);
}
std::optional<CircleOrLine> section_of(const RP::Design& d, double t, double w) {
  return line_section(d.fixed, d.line, -1, t, w);
}
std::optional<CircleOrLine> section_of(const PP::Design&, double, double) { return std::nullopt; }

std::vector<ImageLine> generators_of(const RR::Design& d, const Pose& pose) {
  return {poses_taking(d.moving, to_fixed(pose, d.moving)), poses_taking(to_moving(pose, d.fixed), d.fixed)};
}
std::vector<ImageLine> generators_of(const PR::Design& d, const Pose& pose) {
  return {poses_taking(d.moving, to_fixed(pose, d.moving)), translations_of(pose, direction_of(d.line))};
}
std::vector<ImageLine> generators_of(const RP::Design& d, const Pose& pose) {
  return {poses_taking(to_moving(pose, d.fixed), d.fixed), translations_of(pose, rotated(pose, direction_of(d.line)))};
}
std::vector<ImageLine> generators_of(const PP::Design&, const Pose&) { return {}; }

}  // namespace

ImageLine poses_taking(const Vector2& p, const Vector2& P) {
  const Vector2 unturned = P - p, turned = P + p;
  return {Space::point<double>({unturned[0], unturned[1], 0, 1}), Space::point<double>({turned[0], turned[1], 1, 0})};
}

ImageLine translations_of(const Pose& pose, const Vector2& u) {
  return {Space::point<double>(pose), {0, 0, u[0] * pose.X4 + u[1] * pose.X3, u[1] * pose.X4 - u[0] * pose.X3}};
}

std::optional<Vector<double, 8>> lifted_form(const Quadric<double>& surface) {
  const auto& q = surface.q;
  const double tolerance = zero * size_of(surface);
  if (!(std::abs(q[2] - q[3]) <= tolerance && std::abs(q[9]) <= tolerance)) return std::nullopt;
  return Vector<double, 8>{{(q[2] + q[3]) / 2, (q[5] - q[8]) / 2, (q[6] + q[7]) / 2, (q[5] + q[8]) / 2,
                            (q[6] - q[7]) / 2, 2 * (q[0] + q[1]), q[0] - q[1], q[4]}};
}

std::optional<Family::Design> design_of(const Quadric<double>& surface) {
  const auto k = lifted_form(surface);
  if (!k || !(Family::relations(*k).norm() <= zero * k->squaredNorm())) return std::nullopt;
  return Family::decode(*k);
}

ConstraintManifold::ConstraintManifold(Family::Design design)
    : design_(std::move(design)), quadric_(constraint_quadric(design_)) {}

QuadricType ConstraintManifold::type() const {
  if (const auto* d = std::get_if<RR::Design>(&design_))
    return d->length > 0 ? QuadricType::hyperboloid_of_one_sheet : QuadricType::line;
  return std::holds_alternative<PP::Design>(design_) ? QuadricType::coincident_planes
                                                     : QuadricType::hyperbolic_paraboloid;
}

std::optional<CircleOrLine> ConstraintManifold::section(double t, double w) const {
  return std::visit([&](const auto& d) { return section_of(d, t, w); }, design_);
}

std::optional<Point3<double>> ConstraintManifold::point(double t, double w, double at) const {
  const auto curve = section(t, w);
  if (!curve) return std::nullopt;
  Vector2 X;
  if (const auto* circle = std::get_if<Circle>(&*curve)) {
    X = circle->centre + circle->radius * Vector2(std::cos(at), std::sin(at));
  } else {
    const auto& [n, offset] = std::get<Line>(*curve);
    X = offset * n + at * std::hypot(t, w) / 2 * Vector2(-n[1], n[0]);  // a^2 + b^2 = (t^2 + w^2) / 4
  }
  return point_of_image({X[0], X[1], t, w});
}

std::vector<ImageLine> ConstraintManifold::generators(const Pose& pose) const {
  return std::visit([&](const auto& d) { return generators_of(d, pose); }, design_);
}

double ConstraintManifold::distance(const Pose& pose) const {
  return Family::Types::visit(design_,
                              [&]<class D>(const typename D::Design& d) { return std::abs(D::residual(d, pose)); });
}

std::optional<double> ConstraintManifold::spacing(const Pose& pose) const {
  if (std::holds_alternative<PP::Design>(design_)) return std::nullopt;
  if (pose.X4 == 0) return std::numeric_limits<double>::infinity();
  return distance(pose) * std::hypot(pose.X3, pose.X4) / (2 * std::abs(pose.X4));
}

}  // namespace burmester::planar
