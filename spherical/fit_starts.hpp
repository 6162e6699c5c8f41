// Starts of fits: the dyads and sliders that come near to many orientations by linear algebra.
//
// Two sides: the singular vectors of the lifted equations (angle_errors.hpp (1)), decoded to dyads; and a scan. For a
// given moving axis a the places R_j a are points of the sphere, and the plane that fits them best (through the centre
// for a slider) gives the fixed axis b and the arc; so what is left is a function of a alone. Its local minima on a
// grid of the half sphere are starts, those with the second best plane too, and some further points of the grid. All
// this is in units of the turns from one orientation to another, so that close ones are like any others, and done once
// more near the axis of turns that are all about nearly one.
#pragma once

#include <vector>

#include "burmester/spherical/angle_errors.hpp"

namespace burmester::spherical {

/// D: RR or PR. Axes as seen in the reference orientation. Precondition: the turns are not all about one axis.
template <class D>
std::vector<AxesAt> fit_starts(const TurnedTask& task);

}  // namespace burmester::spherical
