// Dyads of five-orientation reports compared as what they are: pairs of axes without direction.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "burmester/spherical/five_pose_roots.hpp"
#include "burmester/spherical/five_pose_solver.hpp"

namespace burmester::spherical::support {

/// A slider as an RR of 90 deg.
inline RR::Design as_RR(const Dyads::Design& any) {
  if (const auto* rr = std::get_if<RR::Design>(&any)) return *rr;
  const auto& slider = std::get<PR::Design>(any);
  return {slider.fixed, slider.moving, std::numbers::pi / 2};
}

/// Distance of (fixed, moving) as pairs of lines through the centre (radians where small), and of the arcs.
inline double distance(const RR::Design& a, RR::Design b) {
  if (a.fixed.dot(b.fixed) < 0) b.fixed = -b.fixed, b.arc = std::numbers::pi - b.arc;
  if (a.moving.dot(b.moving) < 0) b.moving = -b.moving, b.arc = std::numbers::pi - b.arc;
  return std::max({(a.fixed - b.fixed).norm(), (a.moving - b.moving).norm(), std::abs(a.arc - b.arc)});
}

struct Nearest {
  const Found<Dyads::Design>* dyad = nullptr;
  double distance = 4;
};
/// The dyad of the report that is nearest to this one. Precondition: the report has one.
inline Nearest nearest(const RR::Design& wanted, const SphericalReport& report) {
  Nearest out;
  for (const auto& found : report.dyads)
    if (const double d = distance(wanted, as_RR(found.design)); d < out.distance) out = {&found, d};
  return out;
}

inline std::vector<RR::Design> dyads_of(const FivePoseRoots& roots, FivePoses poses) {
  std::vector<RR::Design> out;
  for (int i = 0; i < roots.count; ++i)
    out.push_back(dyad_of(roots.equations, roots.root[static_cast<std::size_t>(i)], poses));
  return out;
}

}  // namespace burmester::spherical::support
