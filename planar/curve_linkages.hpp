// Four-bars for four poses: pairs of points of the circle-point curve with their centre points, ranked.
//
// Every two dyads of the curve are a linkage whose coupler can be put into the four poses. Order of the list:
//   1. those that pass through the poses without being taken apart or led over a dead point, driven at their first
//      dyad: the signed angle between coupler and driven link keeps its sign over the poses and, where the driver has
//      two ranges (K. J. Waldron, E. N. Stevensen, "Elimination of branch, Grashof, and order defects in path-angle
//      generation and function generation synthesis", J. Mech. Des. 101 (1979)), so does that between ground and
//      driver. The order in which the poses are passed is not looked at;
//   2. the ratio of the longest to the shortest link, smallest first.
// Of linkages that are nearly the same only the best is listed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

/// Both corners belong to it. Length units.
struct PivotWindow {
  Vector2 low, high;
};

struct CurveLinkageOptions {
  /// Where fixed pivots (in S) and moving pivots (in E) may be. None: within two `unit` task sizes, along x and y, of
  /// the centroid of the pose origins; moving pivots as they lie in pose 1.
  std::optional<PivotWindow> fixed = {}, moving = {};
  double largest_ratio = 10;              ///< longest to shortest link
  std::vector<std::string> classes = {};  ///< wanted, by the names of four_bar_class; none: all
  std::size_t wanted = 6;                 ///< length of the list, at most
  double unit = 1;                        ///< of the lengths here and of the boxes by default, in task sizes
  double spacing = 0.05;                  ///< of the dyads tried, in units: the larger move of their two pivots
  double apart = 0.4;                     ///< of listed linkages: one of the four pivots differs by this many units
};

struct CurveLinkage {
  RR::Design first, second;
  std::string motion_class;
  double link_ratio = 1;    ///< longest to shortest link
  bool one_branch = false;  ///< 1. of the order
};

/// `curves`: of four_pose_curves for the same poses. Empty where no pair is as wanted. Some 200 dyads are tried at
/// most; where there would be more the spacing grows.
std::vector<CurveLinkage> linkages_from_curves(FourPoses poses, std::span<const CurveRecord> curves,
                                               const CurveLinkageOptions& options = {});
/// The same for results.
std::vector<CandidateRecord> candidates_of(FourPoses poses, std::span<const CurveRecord> curves,
                                           const CurveLinkageOptions& options = {});

}  // namespace burmester::planar
