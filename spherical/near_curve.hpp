// Four orientations: the dyad of the cone whose fixed axis is nearest to a given direction, by the angle between them
// (modules/framework/near_curve.hpp tells how). A direction and its opposite are the same axis.
#pragma once

#include <vector>

#include "burmester/modules/framework/near_curve.hpp"
#include "burmester/spherical/four_pose_curves.hpp"

namespace burmester::spherical {

using NearDyads = burmester::NearestDyads<Dyads>;

/// One RR dyad for each direction of S, of any length, or a warning. curves: those of the poses. Throws InputError for
/// a direction that is zero.
NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify);

}  // namespace burmester::spherical
