// A linkage on the sphere: the strokes of its parts in a pose, and the paths that its motion follows.
//   RR  fixed axis, link, moving axis             PR  guide (a great circle), block, moving axis
// The coupler is the spherical triangle of the two moving axes and the x axis of the moving frame.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/modules/framework/record.hpp"
#include "burmester/spherical/drawing/arcs.hpp"
#include "burmester/spherical/family.hpp"

namespace burmester::spherical {

struct SketchDyad {
  int id = 0;
  bool slider = false;
  Axis fixed, moving;
  double arc = 0;  ///< 90 deg for a slider
};

/// Empty where the record's type or entries are not those of a spherical dyad.
std::optional<SketchDyad> sketch_dyad(const DyadRecord& record);

/// The same dyads, each axis by that one of its two points which keeps the moving axes near each other and near the x
/// axis of the moving frame, and the fixed axes near each other.
std::array<SketchDyad, 2> compact(std::array<SketchDyad, 2> dyads);

/// What stays in place: ground, guides, fixed axes.
std::vector<SphereStroke> fixed_strokes(const std::array<SketchDyad, 2>& dyads);
/// What moves, in pose number `pose`: coupler, links, blocks, moving axes, the coupler's attitude.
std::vector<SphereStroke> moving_strokes(const std::array<SketchDyad, 2>& dyads, const Pose& at, int pose);

/// The linkage's motion through the poses, sampled.
struct Motions {
  std::vector<Pose> shown;               ///< the task poses; where the linkage misses one, the nearest that it reaches
  std::vector<std::vector<Pose>> paths;  ///< each connected stretch once; a closed one ends where it began
};
Motions motions_through(const std::vector<Pose>& poses, const std::array<SketchDyad, 2>& dyads);

}  // namespace burmester::spherical
