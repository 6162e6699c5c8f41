// The dyad types of the sphere: axes through the centre take the place of points, arcs that of lengths.
//
// RR: the moving axis a (in E) keeps the angle `arc` from the fixed axis b (in S): b . Q a = cos(arc).
// PR: the slider, an RR whose arc is 90 deg: a stays in the plane through the centre perpendicular to b. Seen
// from the moving body it is again a slider, so that on the sphere PR and RP are one type.
//
// Axes are lines: (b, a, arc) ~ (-b, a, pi - arc) ~ (b, -a, pi - arc).
//
// Source: J. M. McCarthy, G. S. Soh, "Geometric Design of Linkages", 2nd ed. 2011 (spherical chains).
#pragma once

#include "burmester/modules/framework/dyad_type.hpp"
#include "burmester/spherical/space.hpp"

namespace burmester::spherical {

struct Family;
using Axis = Space::Feature<double>;  ///< unit vector

struct RR {
  using Space = spherical::Space;
  using Family = spherical::Family;
  using Inverse = RR;
  static constexpr const char* name = "RR";
  static constexpr int parameters = 5;  ///< two tangents at b, two at a, arc

  struct Design {
    Axis fixed, moving;  ///< b in S, a in E
    double arc = 0;      ///< radians, in [0, pi]
  };

  static double residual(const Design& d, const Pose& pose);
  static Design moved(const Design& d, const Space::Point<double>& g, const Space::Point<double>& h);
  static Design inverse(const Design& d) { return {d.moving, d.fixed, d.arc}; }
  static Design nudged(const Design& d, const Vector<double, parameters>& u);
  static Design random_design(Random& random);
  /// As people see it: the moving axis with its last non-zero coordinate positive, then the fixed axis so
  /// that the arc is at most 90 deg (PR: last non-zero coordinate positive). Coordinates up to `zero` count
  /// as zero.
  static DyadRecord record(const Design& d, double zero = 0);
  static Vector<double, 10> encode(const Design& d);
};

struct PR {
  using Space = spherical::Space;
  using Family = spherical::Family;
  using Inverse = PR;
  static constexpr const char* name = "PR";
  static constexpr int parameters = 4;  ///< two tangents at b, two at a

  struct Design {
    Axis fixed, moving;  ///< b in S, a in E
  };

  static double residual(const Design& d, const Pose& pose);
  static Design moved(const Design& d, const Space::Point<double>& g, const Space::Point<double>& h);
  static Design inverse(const Design& d) { return {d.moving, d.fixed}; }
  static Design nudged(const Design& d, const Vector<double, parameters>& u);
  static Design random_design(Random& random);
  static DyadRecord record(const Design& d, double zero = 0);
  static Vector<double, 10> encode(const Design& d);
};

using Dyads = DyadList<RR, PR>;

}  // namespace burmester::spherical
