// Tracing a cubic, alone or with a partner curve, into polylines with a proved error. Only for targets that compile
// intervals.
//
// A chord is accepted when the tube test (curve_tube.hpp) proves that the curve is a graph over it within the
// tolerance, or, near singular points, when the whole part of the branch lies in a box smaller than the tolerance;
// otherwise it is cut into two to eight. The next chord is as long as the last one lets one expect: chords are short
// where the curve bends. Parts outside the window are left
// out only where a box, or a tube that a box ties to the branch, proves that they are outside.
#pragma once

#include <optional>

#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/partner_curve.hpp"

namespace burmester {

/// All branches within the window, components numbered as in `traced`. `curve` is the form whose branches they are.
/// A piece ends where it leaves the window; no point is more than 2 % outside. Below an UpwardRounding. Throws
/// std::invalid_argument for options that are not positive.
TracedCurve trace_in_plane(const CubicBranches& traced, const TubeCurve& curve,
                           const std::optional<PartnerCurve>& partner, const TraceOptions& options);

/// The cone, met by the unit sphere: each branch once as one closed piece, unless a part of it could not be
/// proved. A branch that a great circle meets an odd
/// number of times runs through both opposite points of each of its axes. Below an UpwardRounding.
TracedCurve trace_on_sphere(const CubicBranches& traced, const TubeCurve& curve,
                            const std::optional<PartnerCurve>& partner, const TraceOptions& options);

}  // namespace burmester
