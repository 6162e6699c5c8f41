// Five orientations in, a report with every dyad out.
#pragma once

#include "burmester/modules/framework/report.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

using SphericalReport = Report<Dyads>;

/// An RR whose arc is within this of 90 deg also says which slider it nearly is (radians).
inline constexpr double near_slider_departure = 1e-3;

/// The direct solver (five_pose_roots.hpp) with types, residuals, conditions, a verdict on degenerate poses and, unless
/// told otherwise, the proof that the list is complete (five_pose_certificate.hpp).
/// Precondition: exactly five poses of finite numbers, no quaternion zero.
struct FivePoseSolver {
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* name = "five orientations, direct";
  static constexpr const char* answers = "all RR and PR dyads for five orientations in one solve, proved complete";
  bool certify = true;
  SphericalReport solve(std::span<const Pose> poses) const;
};

/// What a five-orientation answer says of one dyad that meets the poses: a slider where its arc is within
/// slider_arc_tolerance of 90 deg, with residual and condition.
Found<Dyads::Design> found_dyad(const RR::Design& dyad, std::span<const Pose> poses);

/// The report on poses with six dyads over the complex numbers, of which these are the real ones.
SphericalReport report_of(const std::vector<RR::Design>& real, std::span<const Pose> poses);

}  // namespace burmester::spherical
