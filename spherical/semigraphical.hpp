// The semigraphical method for five orientations (J. Angeles, S. Bai, "A robust solution of the spherical Burmester
// problem", Eqs. 11, 12, 16): plot, read off, refine, reject.
//
// With N_j = Q_j - Q_0, j = 1..4, a dyad of the fixed axis b (in S) and the moving axis a (in E) satisfies
//   b . N_j a = 0,
// so the 4 x 3 matrix with the rows (N_j a)^T has rank 2 at most, and its four 3 x 3 minors vanish:
//   Delta_j(a) = det of the rows without row j = 0,
// four cubic cones. Their zero curves are drawn over longitude and latitude, each in [-90, 90] deg: half the sphere,
// which holds each axis once. Two of the cones have nine common axes over the complex numbers; at six all four meet,
// at the other three the two rows that they share are dependent: spurious. The same holds for b with N_j transposed.
//
// Read off: every crossing of two zero curves. Refine: Newton on these two minors. Reject: where the matrix keeps rank
// 3 there. What is left is polished on the four bilinear equations. A picture finds what a picture shows: dyads closer
// to each other than a cell of the grid may be missed. FivePoseSolver is the method to rely on; this one is to look at.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "burmester/geometry/zero_contour.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

/// A crossing whose smallest singular value is at most this part of the largest one has rank 2: the square root of the
/// unit roundoff, as where two curves touch their crossing is known no better than that.
inline constexpr double rank_tolerance = 1.5e-8;

struct Crossing {
  std::array<int, 2> curves;       ///< j of the two minors, from 1
  std::array<double, 2> read_off;  ///< longitude and latitude, radians
  Axis axis;                       ///< refined
  double rank_ratio = 0;           ///< smallest over largest singular value there
  bool accepted() const { return rank_ratio <= rank_tolerance; }
};

/// One of the two plots.
struct AxisPlot {
  std::array<std::vector<ContourSegment>, 4> curves;  ///< of Delta_1 .. Delta_4; longitude, latitude in radians
  std::vector<Crossing> crossings;                    ///< those whose refinement stayed within two cells
};

struct SemigraphicalAnswer {
  AxisPlot moving, fixed;
  std::vector<RR::Design> dyads;       ///< from the plot of moving axes; every axis once
  std::vector<RR::Design> from_fixed;  ///< from the plot of fixed axes
  bool degenerate = false;             ///< a minor vanishes all over the sphere; nothing was read off
};

/// The axis at a longitude and a latitude (Eq. 16), and back, into the half sphere of longitudes in [-pi/2, pi/2].
Axis axis_at(double longitude, double latitude);
std::array<double, 2> longitude_latitude(const Axis& axis);

/// Precondition: five poses, at least 2 cells.
SemigraphicalAnswer semigraphical(std::span<const Pose> poses, int cells = 180);

}  // namespace burmester::spherical
