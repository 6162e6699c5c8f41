// The real common points of two conics, proved: how many, their multiplicities, a box around each. For all pencils.
//
// First in intervals of doubles: the number of points by conic_count.hpp, and a Krawczyk box around each point that
// common_points.hpp finds; that settles pencils with simple common points. Else exactly. Seen from a point c on none of
// the conics' common chords and tangents, the points lie on different lines:
// with z along the lines through c the conics are
//     a z^2 + a1 z + a2,  b z^2 + b1 z + b2     (a1, b1 linear, a2, b2 quadratic forms of the line),
// the lines are the roots of the resultant s0^2 - s1 (a1 b2 - b1 a2), multiplicities included, and z = -s0 / s1, where
// s1 = a b1 - b a1 and s0 = a b2 - b a2 (the first subresultant). A line with s1 = s0 = 0 is part of a member of the
// pencil; there are six at most, so some c on a curve (1, k, k^2) serves.
#pragma once

#include <array>
#include <vector>

#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

/// A point (or a line) of the projective plane, scaled so that coordinate number `unit`,
/// the largest or nearly so, is 1.
struct ProjectivePointBox {
  int unit = 0;
  std::array<Range, 3> at;  ///< at[unit] is [1, 1]
};

struct CertifiedCommonPoint {
  ProjectivePointBox box;  ///< about 1e-15 wide; boxes of points that are closer may overlap where the rung is exact
  int multiplicity = 1;
};

struct CertifiedCommonPoints {
  PencilKind kind = PencilKind::regular;
  Rung rung = Rung::none;                    ///< what proved all of it: intervals or exact
  std::vector<CertifiedCommonPoint> points;  ///< the different real ones, none left out; of common_line those off it
  ProjectivePointBox line;                   ///< common_line: the shared line
};

/// Throws std::invalid_argument for coefficients that are not finite.
CertifiedCommonPoints certified_common_points(const Conic<double>& a, const Conic<double>& b);
CertifiedCommonPoints certified_common_points(const Conic<Rational>& a, const Conic<Rational>& b);
/// Without the attempt in doubles.
CertifiedCommonPoints certified_common_points_exactly(const Conic<Rational>& a, const Conic<Rational>& b);

}  // namespace burmester
