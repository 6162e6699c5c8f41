#include "burmester/spherical/linkage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "burmester/geometry/number.hpp"
#include "burmester/modules/framework/pairing.hpp"

namespace burmester::spherical {
namespace {

using AnyDyad = Found<Dyads::Design>;

constexpr double right_angle = std::numbers::pi / 2;
/// Of the arc between two given axes: each was normalised, and their cross product takes more roundings.
constexpr double axis_rounding = 8 * unit_roundoff;

std::array<double, 4> excesses(double g, double a, double h, double b) {
  return {g - a + h - b, g - a - h + b, h + b - g - a, 4 * right_angle - g - a - h - b};
}

/// Where one of the four is 0 to within the tolerance the input still turns, through a change point.
bool input_turns(const std::array<double, 4>& t, double tolerance = 0) {
  const auto alike = [&](double x, double y) { return std::min(x, y) >= -tolerance || std::max(x, y) <= tolerance; };
  return alike(t[0], t[1]) && alike(t[2], t[3]);
}

/// The dyad as it is shown.
struct Shown {
  Axis fixed, moving;
  double arc;
  bool slider;
};
Shown shown(const AnyDyad& d) {
  const DyadRecord r = shown_record<Dyads>(d);
  return {Axis(r.fixed[0], r.fixed[1], r.fixed[2]), Axis(r.moving[0], r.moving[1], r.moving[2]), *r.arc,
          r.type == PR::name};
}

/// How far T1 .. T4 can be off: twice the proved error of each dyad's axes and arc (a link has two ends), or, where
/// nothing is proved, unit roundoffs times the conditions (docs/concepts.md).
double arc_tolerance(const AnyDyad& a, const AnyDyad& b) {
  double error = 16 * unit_roundoff * 4 * right_angle;
  for (const AnyDyad* d : {&a, &b})
    error += d->certificate.certified ? 5 * d->certificate.radius : 16 * unit_roundoff * d->condition.value_or(0);
  return error;
}

std::optional<LinkageRecord> link(const AnyDyad& a, const AnyDyad& b, std::string type) {
  const Shown first = shown(a), second = shown(b);
  const double ground = Space::distance(first.fixed, second.fixed), tolerance = arc_tolerance(a, b);
  LinkageRecord l;
  l.type = std::move(type);
  l.coupler = Space::distance(first.moving, second.moving);
  for (const double arc : {ground, *l.coupler})
    if (may_be_one(std::min(arc, 2 * right_angle - arc), a, b, axis_rounding)) return std::nullopt;
  if (first.slider) {
    l.motion_class = "double slider";
    return l;
  }
  l.input = first.arc;
  if (second.slider) {
    l.offset = std::abs(right_angle - ground);
    l.motion_class =
        input_turns(excesses(ground, first.arc, *l.coupler, right_angle), tolerance) ? "slider-crank" : "rocker-slider";
    return l;
  }
  l.ground = ground, l.output = second.arc;
  l.motion_class = four_bar_class(ground, first.arc, *l.coupler, second.arc, tolerance);
  return l;
}

}  // namespace

std::string four_bar_class(double ground, double input, double coupler, double output, double tolerance) {
  const std::array<double, 4> t = excesses(ground, input, coupler, output);
  if (std::any_of(t.begin(), t.end(), [&](double x) { return std::abs(x) <= tolerance; })) return "change-point";
  const bool in = input_turns(t), out = input_turns(excesses(ground, output, coupler, input));
  if (in && out) return "double-crank";
  if (in) return "crank-rocker";
  if (out) return "rocker-crank";
  return t[0] * t[1] * t[2] * t[3] > 0 ? "double-rocker" : "triple-rocker";
}

std::vector<LinkageRecord> linkages_of(const std::vector<AnyDyad>& dyads) {
  return paired_linkages<Dyads>(dyads, link);
}

}  // namespace burmester::spherical
