// A point and its partner in doubles, brought to where they meet all three correlations.
//
// p^T N_k c = 0, k = 1, 2, 3, are three equations for the four coordinates of a pair. A point that a parametrisation
// gives is off the curve by what cancels there, and where the three lines p^T N_k nearly are one its partner may miss
// the third line by far more. Newton's method, each step the shortest (C. F. Gauss; A. Ben-Israel, "A Newton-Raphson
// method for the solution of systems of equations", J. Math. Anal. Appl. 15, 1966), moves both as little as it takes.
#pragma once

#include <array>

#include "burmester/geometry/correlations.hpp"

namespace burmester {

struct PairedPoints {
  Point2<double> p, c;
};

/// How far p^T N c may be from zero, as a share of |p| |N| |c|: a few times its rounding. Of the
/// three shares the root of the sum of their squares.
inline constexpr double paired_within = 0x1p-49;

/// A pair near the two points given, and these where they are within paired_within; or as near as doubles get.
/// squares: |N_k|^2, sums of the squares of all entries.
PairedPoints paired_points(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                           const PairedPoints& near);

/// The same near p and what two of the three lines tell of its partner. c: zero where they are one line.
PairedPoints paired_points(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                           const Point2<double>& p);

}  // namespace burmester
