// The curve of the points that have a partner under three correlations, and the curve of the partners: topology and
// polylines in one call. Only for targets that compile intervals.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "burmester/geometry/curve_trace.hpp"
#include "burmester/geometry/surface.hpp"

namespace burmester {

template <class T>
using ThreeCorrelations = std::array<Correlation<T>, 3>;

/// The same three correlations, each of rank two or zero, in the two number types that decide.
struct DecidingCorrelations {
  std::function<ThreeCorrelations<Interval>()> intervals;  ///< called below an UpwardRounding
  std::function<ThreeCorrelations<Rational>()> rationals;  ///< exact; called where the intervals do not tell
  bool tell_near_origin = false;  ///< the vertices are near the origin: small numbers tell where
};

/// The curves are seen from a vertex of one of the correlations, or from a point between two of them. A vertex that has
/// a whole line of partners is paired with each of them in a piece of its own: part of the component it lies on, or a
/// component where it is isolated. No answer where every point has a partner, or where a line of such points counts
/// more than once. Not more than 600 sqrt(longest / tolerance) samples are taken (options.most_samples, where that is
/// less). Throws std::invalid_argument for options that are not positive.
PairedCurves paired_curves(const DecidingCorrelations& correlations, Surface surface, const TraceOptions& options);

}  // namespace burmester
