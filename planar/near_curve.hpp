// Four poses in the plane: the dyad of the curve whose fixed pivot is nearest to a given point
// (modules/framework/near_curve.hpp tells how).
#pragma once

#include <vector>

#include "burmester/modules/framework/near_curve.hpp"
#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

using NearDyads = burmester::NearestDyads<Dyads>;

/// One RR dyad for each point, or a warning. curves: those of the poses. Throws InputError for coordinates above 1e100.
NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify);

}  // namespace burmester::planar
