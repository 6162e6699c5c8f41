// Two dyads closed by the coupler: type, link dimensions and class of a planar linkage.
//
// Lengths: ground between the fixed pivots, input and output of RR dyads, coupler between the moving pivots; a
// length that a slider takes away is empty. Offsets: of a pivot from a guide line on the same link, `offset` on the
// ground link (PR guide) or, where there is none there, on the coupler (RP guide); both exist for PRPR.
// Class of RRRR by Grashof's rule (F. Grashof, 1883): shortest + longest < sum of the others, then by the place of
// the shortest link. Slider-cranks: the crank turns fully when coupler >= crank + |offset|.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "burmester/modules/framework/record.hpp"
#include "burmester/modules/framework/report.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

inline constexpr std::array four_bar_classes{"crank-rocker",  "rocker-crank",  "double-crank",
                                             "double-rocker", "triple-rocker", "change-point"};
/// One of them; change-point where shortest + longest equals the sum of the others to within `tolerance`, a length.
std::string four_bar_class(double ground, double input, double coupler, double output, double tolerance);

/// All pairs of the dyads that make a linkage, none with a pivot in common, numbered from 1; dyad ids are places in
/// `dyads`, from 1.
std::vector<LinkageRecord> linkages_of(const std::vector<Found<Dyads::Design>>& dyads, double task_size);

}  // namespace burmester::planar
