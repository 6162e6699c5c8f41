// The diameter of a set of points of the plane: the largest distance between two of them.
//
// It is that of two vertices of the convex hull through which parallel lines can pass that have all points between
// them: rotating calipers (M. Shamos, "Computational Geometry", thesis, Yale 1978), on the hull by monotone chains
// (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
#pragma once

#include <vector>

#include "burmester/geometry/vector.hpp"

namespace burmester {

/// In time n log n; 0 for one point or none. Finite coordinates, of any size whose differences are finite. The distance
/// of two of the points, and the largest to about one rounding. Needs a long double of wider range than double.
double diameter(std::vector<Vector<double, 2>> points);

}  // namespace burmester
