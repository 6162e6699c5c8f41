// Two dyads closed by the coupler: type, arcs and class of a spherical linkage.
//
// Arcs between the axes as they are shown: ground between the fixed axes, input and output of RR dyads, coupler between
// the moving axes. A slider has neither ground nor output; `offset` is how far the other dyad's fixed axis lies off the
// plane of the guide.
// Class of RRRR: with ground g, input a, coupler h, output b and
//   T1 = g - a + h - b, T2 = g - a - h + b, T3 = h + b - g - a, T4 = 2 pi - g - a - h - b
// the input turns fully where T1 T2 > 0 and T3 T4 > 0 (J. M. McCarthy, G. S. Soh, "Geometric Design of Linkages", 2nd
// ed. 2011, section 7.2); for the output exchange a and b. The rule does not depend on which of the two points of each
// axis is taken. Slider: the same with b = 90 deg.
#pragma once

#include <string>
#include <vector>

#include "burmester/modules/framework/record.hpp"
#include "burmester/modules/framework/report.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// crank-rocker, rocker-crank, double-crank, double-rocker (the coupler turns fully), triple-rocker, change-point (one
/// of T1 .. T4 is 0 to within `tolerance`). Arcs in radians, in [0, pi].
std::string four_bar_class(double ground, double input, double coupler, double output, double tolerance);

/// All pairs of the dyads that make a linkage, none with an axis in common, numbered from 1; dyad ids are places in
/// `dyads`, from 1.
std::vector<LinkageRecord> linkages_of(const std::vector<Found<Dyads::Design>>& dyads);

}  // namespace burmester::spherical
