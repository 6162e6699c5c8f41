// Four poses: the dyad of the curve whose fixed pivot is nearest to a given point.
//
// The centre points c fill the cubic F(c) = 0 (four_pose_curves.hpp). Nearest to q: c - q + lambda grad F(c) = 0 and
// F(c) = 0, by Newton's method from the traced curve. Where F has opposite exact signs at the two ends of a short
// segment across the curve, a dyad of the curve has its fixed pivot there; its circle point is enclosed with rational
// intervals.
#pragma once

#include <string>
#include <vector>

#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

struct NearDyads {
  std::vector<Found<Dyads::Design>> dyads;  ///< RR
  std::vector<std::string> warnings;        ///< of points without a dyad, and where the trace ends: "near[0]: .."
};

/// Dyads near points q of the fixed frame, one for each: nearest on the curve as it is traced. None where the nearest
/// centre point is a slider's (these are listed with the curve) or a common pole of several displacements, or no curve is
/// shown; a warning says so. curves: those of the poses. A certificate's radius bounds the distance to some dyad of the
/// curve.
NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify);

}  // namespace burmester::planar
