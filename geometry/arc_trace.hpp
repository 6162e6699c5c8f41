// Tracing any plane curve from its arcs (curve_arcs.hpp) into polylines with a proved error.
//
// An arc is a graph v(u) over its interval. So where G has no zero on the two edges of a parallelogram above and below
// a chord, the arc stays between them from one end of the chord to the other: chord and arc are within the half height
// of each other. G on an edge is a binary form; it has no zero if its Bernstein coefficients have one sign, by
// intervals of doubles, or by rationals where those do not tell.
// The arcs that end in a point of a critical line are followed into a box about it with G /= 0 on its horizontal edges.
// All of them stay in the box on the way to the point. Two of them and the point make one continuous path, which passes
// every v between those of its ends: so chords are as far from it as the box is wide, however high the box, and the
// path is as far from its chords as that and what it may overshoot. docs/curves.md has the proofs.
#pragma once

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/curve_arcs.hpp"

namespace burmester {

/// All components within the window, numbered as in `arcs`; isolated points are pieces of one point. A piece goes
/// through a singular point as straight as it can. It ends where it leaves the window; no point is more than 2 %
/// outside. Precondition: arcs.rung is not none. Throws std::invalid_argument for options that are not positive.
TracedCurve trace_arcs(const CurveArcs& arcs, const TraceOptions& options);

}  // namespace burmester
