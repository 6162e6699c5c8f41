// The poses that meet two dyads: the curve in which their constraint manifolds meet, the motion of a linkage's coupler.
//
// Parametrised by t : w = X3 : X4 = tan(angle / 2). The plane of an orientation cuts a circle from the surface of an RR
// and a straight line from those of PR and RP; they meet in at most two poses, those of two RR on their radical line
// (geometry/quadric_intersection.hpp). The orientations with real poses end at real zeros of a form of degree 4 in t :
// w, found exactly from the coefficients of the surfaces as doubles.
#pragma once

#include <vector>

#include "burmester/geometry/quadric_intersection.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/planar/constraint_manifold.hpp"

namespace burmester::planar {

/// The planes X4 : X3 = s : t through the line X3 = X4 = 0.
template <class T>
PlanePencil<T> planes_of_constant_angle() {
  return planes_through<T>({T(0), T(0), T(1), T(0)}, {T(0), T(0), T(0), T(1)});
}

/// What two surfaces share in the plane of one orientation.
struct CommonPoses {
  std::vector<Pose> poses;  ///< none, one or two; where the curves touch, both or none, by rounding
  bool all = false;         ///< the two curves are the same: a whole circle or line of poses
};

class ConstraintCurve {
 public:
  /// Precondition: RR, PR or RP. (A PP holds one orientation: ConstraintManifold::section has the curve.)
  ConstraintCurve(const ConstraintManifold& a, const ConstraintManifold& b);

  /// In the plane X3 : X4 = t : w. Precondition: not both zero.
  CommonPoses at(double t, double w) const;

  /// The angles, radians, at which there are real poses, closed ranges in ascending order, the first low end in
  /// (-pi, pi], `high` up to 2 pi above it; {-pi, pi}: all. Two ranges of an RRRR: two circuits. A range of one angle:
  /// the circles only touch. Where guides are parallel to each other the poses may lie at infinity.
  std::vector<Range> orientations() const;

 private:
  std::array<Quadric<double>, 2> surface_;  // lengths in units of unit_
  double unit_;
};

}  // namespace burmester::planar
