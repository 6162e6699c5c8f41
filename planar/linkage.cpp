#include "burmester/planar/linkage.hpp"

#include <algorithm>
#include <array>

#include "burmester/geometry/number.hpp"
#include "burmester/modules/framework/pairing.hpp"

namespace burmester::planar {
namespace {

using AnyDyad = Found<Dyads::Design>;

const RR::Design* as_RR(const AnyDyad& d) { return std::get_if<RR::Design>(&d.design); }
const PR::Design* as_PR(const AnyDyad& d) { return std::get_if<PR::Design>(&d.design); }
const RP::Design* as_RP(const AnyDyad& d) { return std::get_if<RP::Design>(&d.design); }

std::optional<Vector2> fixed_pivot(const AnyDyad& d) {
  if (const auto* rr = as_RR(d)) return rr->fixed;
  if (const auto* rp = as_RP(d)) return rp->fixed;
  return std::nullopt;
}
std::optional<Vector2> moving_pivot(const AnyDyad& d) {
  if (const auto* rr = as_RR(d)) return rr->moving;
  if (const auto* pr = as_PR(d)) return pr->moving;
  return std::nullopt;
}
std::optional<double> length_of(const AnyDyad& d) {
  if (const auto* rr = as_RR(d)) return rr->length;
  return std::nullopt;
}
std::optional<double> between(const std::optional<Vector2>& a, const std::optional<Vector2>& b) {
  if (a && b) return (*a - *b).norm();
  return std::nullopt;
}

/// Distance of the pivot of one dyad from the guide of the other, where both lie on the ground (on the coupler).
std::optional<double> ground_offset(const AnyDyad& a, const AnyDyad& b) {
  if (const auto* pr = as_PR(a); pr && fixed_pivot(b)) return std::abs(pr->line.signed_distance(*fixed_pivot(b)));
  if (const auto* pr = as_PR(b); pr && fixed_pivot(a)) return std::abs(pr->line.signed_distance(*fixed_pivot(a)));
  return std::nullopt;
}
std::optional<double> coupler_offset(const AnyDyad& a, const AnyDyad& b) {
  if (const auto* rp = as_RP(a); rp && moving_pivot(b)) return std::abs(rp->line.signed_distance(*moving_pivot(b)));
  if (const auto* rp = as_RP(b); rp && moving_pivot(a)) return std::abs(rp->line.signed_distance(*moving_pivot(a)));
  return std::nullopt;
}

/// Sliding block on the ground: the crank turns fully when the coupler reaches the guide from everywhere on its circle.
std::string slider_crank_class(double crank, double coupler, double offset, double tolerance) {
  return coupler + tolerance >= crank + offset ? "slider-crank" : "rocker-slider";
}

/// The coupler slides through a block that turns about the second fixed pivot (inverted slider-crank): the crank
/// turns fully when its end never comes nearer to that pivot than the offset; the block turns fully too (Whitworth's
/// quick return) when the crank is longer than the ground.
std::string inverted_class(double crank, double ground, double offset, double tolerance) {
  if (std::abs(ground - crank) + tolerance < offset) return "inverted rocker-slider";
  return crank > ground ? "inverted slider-crank, turning block" : "inverted slider-crank, swinging block";
}

std::string class_of(const LinkageRecord& l, double tolerance) {
  if (l.type == "RRRR") return four_bar_class(*l.ground, *l.input, *l.coupler, *l.output, tolerance);
  if (l.type == "RRRP") return slider_crank_class(*l.input, *l.coupler, *l.offset, tolerance);
  if (l.type == "RRPR") return inverted_class(*l.input, *l.ground, *l.offset, tolerance);
  if (l.type == "RRPP") return "Scotch yoke";
  if (l.type == "PRRP") return "double slider";
  if (l.type == "RPPR") return "double block (Oldham)";
  if (l.type == "PRPR") return "sliding block pair";
  return "translating coupler";
}

/// How far shortest + longest - the others can be off: twice the proved error of each dyad's pivots and length (a link
/// has two ends), or, where nothing is proved, unit roundoffs of the task times the conditions (docs/concepts.md).
double length_tolerance(const LinkageRecord& l, const AnyDyad& a, const AnyDyad& b, double task_size) {
  double lengths = 0;
  for (const auto& x : {l.ground, l.input, l.coupler, l.output}) lengths += x.value_or(0);
  double error = 16 * unit_roundoff * lengths;
  for (const AnyDyad* d : {&a, &b})
    error += d->certificate.certified && d->certificate.radius < task_size
                 ? 5 * d->certificate.radius
                 : 16 * unit_roundoff * d->condition.value_or(0) * task_size;
  return error;
}

std::optional<LinkageRecord> link(const AnyDyad& a, const AnyDyad& b, std::string type, double task_size) {
  LinkageRecord l;
  l.type = std::move(type);
  l.ground = between(fixed_pivot(a), fixed_pivot(b));
  l.input = length_of(a);
  l.coupler = between(moving_pivot(a), moving_pivot(b));
  // a given pivot stands in its dyads as it was given
  if (may_be_one(l.ground, a, b) || may_be_one(l.coupler, a, b)) return std::nullopt;
  l.output = length_of(b);
  const auto on_ground = ground_offset(a, b), on_coupler = coupler_offset(a, b);
  l.offset = on_ground ? on_ground : on_coupler;
  if (on_ground && on_coupler) l.coupler_offset = on_coupler;
  l.motion_class = class_of(l, length_tolerance(l, a, b, task_size));
  return l;
}

}  // namespace

std::string four_bar_class(double ground, double input, double coupler, double output, double tolerance) {
  const std::array<double, 4> links{ground, input, coupler, output};
  const auto [shortest, longest] = std::minmax_element(links.begin(), links.end());
  const double excess = 2 * (*shortest + *longest) - (ground + input + coupler + output);
  if (std::abs(excess) <= 2 * tolerance) return "change-point";
  if (excess > 0) return "triple-rocker";
  switch (shortest - links.begin()) {
    case 0: return "double-crank";
    case 1: return "crank-rocker";
    case 2: return "double-rocker";
    default: return "rocker-crank";
  }
}

std::vector<LinkageRecord> linkages_of(const std::vector<AnyDyad>& dyads, double task_size) {
  return paired_linkages<Dyads>(dyads, [&](const AnyDyad& a, const AnyDyad& b, std::string type) {
    return link(a, b, std::move(type), task_size);
  });
}

}  // namespace burmester::planar
