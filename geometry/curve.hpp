// What a real plane algebraic curve looks like: plain types that every route to the answer fills.
//
// All statements are about the real points in the projective plane. A component is a maximal connected set of them;
// a curve of odd degree without singular points has exactly one component that a line meets an odd number of times
// (the odd branch) and besides it only ovals.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

/// By the number of real half-branches that end in the point.
enum class SingularKind {
  isolated,  ///< 0: a point of the curve with no other real point near it
  cusp,      ///< 2: one real branch, with a cusp or smooth in appearance
  crossing   ///< 4 or more: real branches that cross or touch each other
};

struct SingularPoint {
  Point2<double> at;  ///< largest coordinate 1 or -1; third coordinate 0 iff at infinity
  SingularKind kind = SingularKind::crossing;
};

struct PointAtInfinity {
  Point2<double> at;           ///< third coordinate 0
  LinearForm<double> tangent;  ///< the asymptote, largest entry 1 or -1; zero where the form is singular
};

struct CurveTopology {
  Rung rung = Rung::none;  ///< what proved it; none: not available, `reason` says why, the rest means nothing
  std::string reason;
  bool repeated = false;  ///< a factor occurs more than once; all is about the curve with each factor once
  int components = 0;  ///< isolated points included
  int ovals = 0;       ///< components without singular points, not single points, met by lines an even number of times
  int isolated = 0;    ///< components that are one point
  std::vector<SingularPoint> singular;              ///< real ones
  std::vector<LinearForm<double>> lines;            ///< real lines that split off
  std::vector<Conic<double>> conics;                ///< real conics, irreducible over the reals, that split off
  bool factors_proved = true;  ///< false: a conic whose coefficients are rational may be missing in `conics`
  std::vector<PointAtInfinity> at_infinity;         ///< real ones; none listed if the line at infinity splits off
};

/// A part of a traced curve, or of two curves whose points are partners. Each point of the polyline is within max_error
/// of the curve, and each point of the part of the curve that it stands for is within max_error of the polyline.
struct CurvePiece {
  int component = 0;    ///< pieces of one component share the number, from 0
  bool closed = false;  ///< a whole closed component; the first point is not repeated
  double max_error = 0;
  std::vector<Point2<double>> points;    ///< in the plane (x, y, 1); on the sphere unit vectors
  std::vector<Point2<double>> partners;  ///< of the points, one by one, if the curve has a partner
};

struct TraceOptions {
  double tolerance = 1e-4;    ///< largest max_error: a length, on the sphere an angle in radians
  double longest = 0.25;      ///< longest chord, in the same unit
  double window = 10;         ///< in the plane: |x| and |y| up to this, of partners too
  int most_samples = 100000;  ///< for each arc, or passage of a branch; pieces end where more would be needed
};
/// Throws std::invalid_argument for options that are not positive.
inline void check(const TraceOptions& options) {
  if (!(options.tolerance > 0) || !(options.longest > 0) || !(options.window > 0))
    throw std::invalid_argument("tracing a curve: tolerance, longest chord and window must be positive");
}

struct TracedCurve {
  std::vector<CurvePiece> pieces;
  bool complete = true;  ///< not so where a part that may be in the window could not be proved, and is not shown
};

/// A curve of points with their partners.
struct PairedCurves {
  CurveTopology topology;  ///< of the points; rung none: not available, `reason` says why
  TracedCurve traced;
  int lines_of_partners = 0;  ///< singular points each of which is paired with a whole line, which is traced too
};

}  // namespace burmester
