// The PP dyad of poses of one orientation: the body only translates.
#pragma once

#include <algorithm>
#include <optional>

#include "burmester/geometry/rational.hpp"
#include "burmester/modules/framework/report.hpp"
#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

/// The orientation of the double slider is twice an arc tangent, each within a few units in the last place of pi.
inline constexpr double rounding_of_angle = 0x1p-47;

/// Nothing for poses of more than one orientation, up to rounding the data once; certified, on request, where the
/// doubles have one. Precondition: at least one pose.
inline std::optional<Found<Dyads::Design>> double_slider(std::span<const Pose> poses, bool certify) {
  const Pose& first = poses[0];
  const auto parallel = [&](const Pose& p) { return same_orientation(first, p); };
  if (!std::all_of(poses.begin(), poses.end(), parallel)) return std::nullopt;
  const PP::Design design{angle_of(first)};
  Found<Dyads::Design> found;
  found.design = design, found.residual = largest_residual<PP>(design, poses), found.condition = 1;
  const bool proved = std::all_of(poses.begin(), poses.end(), [&](const Pose& p) {
    return Rational(first.X3) * Rational(p.X4) == Rational(first.X4) * Rational(p.X3);
  });
  if (certify && proved) found.certificate = {true, rounding_of_angle, Rung::exact};
  return found;
}

}  // namespace burmester::planar
