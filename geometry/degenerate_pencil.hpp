// Pencils of conics whose members are all singular, over rationals: the line or the vertex that all share. The exact
// counterpart of degenerate_common_points (common_points.hpp), with no tolerance.
//
// Members that share no line share a vertex. At most two of them are double lines, which have none, so two of any four
// have vertices. Where these differ they move along the shared line, which joins them. Where all are one point a shared
// line passes through it, and is the common root of two quadratic forms on a line that misses the vertex.
#pragma once

#include <optional>

#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// One of the conics may be zero.
bool exactly_proportional(const Conic<Rational>& a, const Conic<Rational>& b);

/// The point where the lines of a singular conic meet, of any size; zero for a double line.
Point2<Rational> vertex_of(const Conic<Rational>& c);

/// Points and line of any size. Nothing where some member of the pencil is regular.
std::optional<CommonPoints<Rational>> degenerate_common_points_exactly(const Conic<Rational>& a,
                                                                       const Conic<Rational>& b);

}  // namespace burmester
