// Five poses in, a report with every dyad of every type out.
#pragma once

#include "burmester/modules/framework/report.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

using PlanarReport = Report<Dyads>;

/// The direct solver (five_pose_roots.hpp) with types, residuals, conditions, a verdict on degenerate poses and, unless
/// told otherwise, the proof that the list is complete (five_pose_certificate.hpp).
/// Precondition of both: exactly five poses of finite numbers, X3 and X4 of no pose both zero.
struct FivePoseSolver {
  using Pose = planar::Pose;
  using Dyads = planar::Dyads;
  static constexpr const char* name = "five poses, direct";
  static constexpr const char* answers = "all RR, PR, RP and PP dyads for five poses in one solve, proved complete";
  bool certify = true;
  PlanarReport solve(std::span<const Pose> poses) const;
};

/// The same in quad precision, about sixty times as slow: what tests hold the direct solver against.
struct FivePoseOracle {
  using Pose = planar::Pose;
  using Dyads = planar::Dyads;
  static constexpr const char* name = "five poses, quad precision";
  static constexpr const char* answers = "the slow oracle of the direct solver: 113 bits, the same exact data";
  PlanarReport solve(std::span<const Pose> poses) const;
};

/// Largest distance between two pose origins, 1 if all coincide.
double task_size(std::span<const Pose> poses);

}  // namespace burmester::planar
