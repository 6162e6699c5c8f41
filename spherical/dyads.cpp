#include "burmester/spherical/dyads.hpp"

#include <cmath>
#include <numbers>

#include "burmester/spherical/family.hpp"

namespace burmester::spherical {
namespace {

using ImagePoint = Space::Point<double>;
constexpr double right_angle = std::numbers::pi / 2;

Axis placed(const ImagePoint& x, const Axis& a) { return Space::act<double>(x, a).normalized(); }

Axis nudged_axis(const Axis& a, double u, double v) {
  const Axis first = a.unitOrthogonal(), second = a.cross(first);
  return (a + u * first + v * second).normalized();
}

bool points_down(const Axis& a, double zero) {
  for (int i = 2; i >= 0; --i)
    if (std::abs(a[i]) > zero) return a[i] < 0;
  return false;
}

std::vector<double> shown(const Axis& a, bool reversed) {
  const double sign = reversed ? -1 : 1;
  return {sign * a[0] + 0.0, sign * a[1] + 0.0, sign * a[2] + 0.0};
}

DyadRecord shown(const char* type, const Axis& fixed, bool fixed_reversed, const Axis& moving,
                 bool moving_reversed, double arc) {
  DyadRecord out;
  out.type = type;
  out.fixed = shown(fixed, fixed_reversed);
  out.moving = shown(moving, moving_reversed);
  out.arc = arc;
  return out;
}

Vector<double, 10> lifted(const Axis& b, const Axis& a, double cosine) {
  Vector<double, 10> k;
  k << b[0] * a, b[1] * a, b[2] * a, -cosine;
  return k;
}

}  // namespace

double RR::residual(const Design& d, const Pose& pose) {
  return Space::distance(d.fixed, Space::act<double>(Space::point<double>(pose), d.moving)) - d.arc;
}

RR::Design RR::moved(const Design& d, const ImagePoint& g, const ImagePoint& h) {
  return {placed(g, d.fixed), placed(h, d.moving), d.arc};
}

RR::Design RR::nudged(const Design& d, const Vector<double, parameters>& u) {
  return {nudged_axis(d.fixed, u[0], u[1]), nudged_axis(d.moving, u[2], u[3]), d.arc + u[4]};
}

RR::Design RR::random_design(Random& random) {
  const Axis fixed = Space::random_feature(random), moving = Space::random_feature(random);
  return {fixed, moving, random.uniform(0, std::numbers::pi)};
}

DyadRecord RR::record(const Design& d, double zero) {
  const bool reversed = points_down(d.moving, zero);
  const double arc = reversed ? std::numbers::pi - d.arc : d.arc;
  const bool wide = arc > right_angle;
  return shown(name, d.fixed, wide, d.moving, reversed, wide ? std::numbers::pi - arc : arc);
}

Vector<double, 10> RR::encode(const Design& d) {
  return lifted(d.fixed, d.moving, std::sin(right_angle - d.arc));  // the sine keeps its accuracy near 90 deg
}

double PR::residual(const Design& d, const Pose& pose) {
  const Axis a = Space::act<double>(Space::point<double>(pose), d.moving);
  return -std::atan2(d.fixed.dot(a), d.fixed.cross(a).norm());
}

PR::Design PR::moved(const Design& d, const ImagePoint& g, const ImagePoint& h) {
  return {placed(g, d.fixed), placed(h, d.moving)};
}

PR::Design PR::nudged(const Design& d, const Vector<double, parameters>& u) {
  return {nudged_axis(d.fixed, u[0], u[1]), nudged_axis(d.moving, u[2], u[3])};
}

PR::Design PR::random_design(Random& random) {
  const Axis fixed = Space::random_feature(random), moving = Space::random_feature(random);
  return {fixed, moving};
}

DyadRecord PR::record(const Design& d, double zero) {
  return shown(name, d.fixed, points_down(d.fixed, zero), d.moving, points_down(d.moving, zero), right_angle);
}

Vector<double, 10> PR::encode(const Design& d) { return lifted(d.fixed, d.moving, 0); }

static_assert(LiftedDyadType<RR> && LiftedDyadType<PR>);

}  // namespace burmester::spherical
