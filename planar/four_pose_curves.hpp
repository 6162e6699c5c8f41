// Four poses: every dyad that meets them, one for each point of the circle-point curve.
//
// A point p of the body whose four places lie on a circle is a circle point, the centre c a centre point. Each
// displacement from pose 1 gives one bilinear equation, |D_j p - c| = |p - c| (geometry/correlations.hpp); three of
// them leave a cubic for p in E and a cubic for c in S, both circular, paired point by point (L. Burmester, "Lehrbuch
// der Kinematik", 1888; O. Bottema, B. Roth, "Theoretical Kinematics", 1979, chapter VIII). The poles of the
// displacements lie on them. Where one runs to infinity the partner is the pivot of a slider: PR at the end of the
// centre-point curve, RP at that of the circle-point curve. Topology and errors are proved for the doubles given
// (docs/curves.md).
#pragma once

#include <span>
#include <vector>

#include "burmester/modules/framework/curve_report.hpp"
#include "burmester/planar/five_pose_solver.hpp"

namespace burmester::planar {

using FourPoses = std::span<const Pose, 4>;

/// The curves are looked at in this length: the task size or, where the turns are small and the poles far away, half
/// the distance from pose 1's origin within which three of the six poles are; not above 2^20 task sizes. Length units.
double curve_scale(FourPoses poses);
constexpr double largest_scale = 0x1p20;

/// Whether the curve scale is above 2 `unit` task sizes: too coarse a length for what is of `unit` task sizes.
bool curves_are_far(FourPoses poses, double unit = 1);

/// In curve scales, or up to twice as much: the unit is the power of two below the curve scale.
struct CurveOptions {
  double tolerance = 1e-4;  ///< largest error of a piece
  double longest = 0.25;    ///< longest chord
  double window = 8;        ///< both pivots within this distance of pose 1's origin, along x and y
};

using burmester::FourPoseCurves;

/// Preconditions as for five poses. Where three poses turn nearly about one point, the window is about that point and
/// wider by its distance from pose 1's origins (planar/four_pose_frames.hpp).
FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options = {});
/// The pieces near the poses: window, chords and tolerance of CurveOptions in `unit` task sizes (up to half of that).
std::vector<CurveRecord> curves_near_poses(FourPoses poses, double unit = 1);

struct FourPoseSolver {
  using Pose = planar::Pose;
  using Dyads = planar::Dyads;
  static constexpr const char* name = "four poses, curves";
  static constexpr const char* answers =
      "circle-point and centre-point curves with proved topology and error; the PR and the RP dyad on them";
  PlanarReport solve(std::span<const Pose> poses) const;
};

}  // namespace burmester::planar
