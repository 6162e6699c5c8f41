// The chart in which motions are walked: image points of the stage, for a task of any proportions.
//
// The moving frame is turned so that the middle orientation of the task is the identity, and X3 is multiplied by a
// weight, so that the rotations of a task with far pivots count as much as its translations. (Otherwise the motion
// of a body that turns by 1e-6 about pivots 1e6 away would be a loop too small to walk.) Coordinates:
// (X4, weight X3, X2, -X1), of unit norm.
#pragma once

#include <vector>

#include "burmester/geometry/quadric.hpp"
#include "burmester/planar/family.hpp"

namespace burmester::planar {

struct Chart {
  Pose middle;        ///< a rotation
  double weight = 1;

  Point3<double> point(const Pose& pose) const;
  Pose pose(const Point3<double>& x) const;
  /// The poses that meet a design, as a quadric that has tangent planes: PP's double plane becomes the pair of it and
  /// the plane of the orientation half a turn away, which it meets in no displacement.
  Quadric<double> quadric(const Family::Design& design) const;
  /// Whether the origin of E is farther than this from the centre of the stage.
  bool beyond(double distance, const Point3<double>& x) const;
};

/// Precondition: at least one pose.
Chart chart_for(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b);

}  // namespace burmester::planar
