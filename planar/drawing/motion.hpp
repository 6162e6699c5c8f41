// Sampled motions of a linkage through its task poses. Each dyad is a quadric of the image space
// (constraint_quadric.hpp); the motion is the curve in which the two quadrics meet (geometry/quadric_curve.hpp).
// All lengths are in units of the stage.
#pragma once

#include <vector>

#include "burmester/planar/family.hpp"

namespace burmester::planar {

/// One connected stretch of the motion curve, in frames of about equal visual speed: the largest path of any point
/// that is drawn with the moving body. A closed one does not repeat its first frame.
struct Stretch {
  std::vector<Pose> frames;
  std::vector<int> poses;        ///< indices of the task poses on it, from 0, in the order in which it passes them
  std::vector<int> pose_frames;  ///< the frames that show them
  bool closed = false;
};

struct Motions {
  std::vector<Pose> shown;  ///< the task poses; where the linkage misses one visibly, the nearest that it reaches
  std::vector<Stretch> stretches;
};

/// At most this many frames in a stretch (more only where more poses lie on it).
inline constexpr int most_frames = 240;
/// Only sliders and far pivots let a motion leave the view for good. It ends where the origin of E is this far away;
/// an excursion between two task poses, or one that closes the motion, may go to the outer horizon.
inline constexpr double horizon = 3, outer_horizon = 8;

Motions motions_through(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b);

}  // namespace burmester::planar
