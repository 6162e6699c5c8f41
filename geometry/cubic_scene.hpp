// What the branches and the topology of a cubic depend on, collected from intervals or from rationals. Not for
// inclusion by users: cubic_branches.hpp is.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "burmester/geometry/cubic_branches.hpp"
#include "burmester/geometry/rational_interval.hpp"

namespace burmester::detail {

inline double positive_root(double x) { return std::sqrt(std::max(0.0, x)); }
inline double middle(const Interval& x) { return approximate(x); }
inline Point1<double> middle(const Point1<Interval>& u) { return {middle(u[0]), middle(u[1])}; }
inline BinaryForm<double> middle(const BinaryForm<Interval>& f) {
  return converted<double>(f, [](const Interval& x) { return middle(x); });
}

/// A root of D, its multiplicity, and the sign of D behind it, between it and the next one.
struct CubicScene {
  struct Root {
    Point1<Interval> at;
    int multiplicity = 1;
    int sign_behind = 0;
    std::optional<std::array<RationalInterval, 2>> refined;  ///< `at`, to some 40 digits
  };
  explicit CubicScene(const CubicPencil<Interval>& seen) : pencil(seen), discriminant(seen.discriminant()) {}

  std::optional<Point2<Rational>> base;   ///< of the pencil, where it comes from rationals
  CubicPencil<Interval> pencil;           ///< where a line through the base splits off: of the conic that is left
  BinaryForm<Interval> discriminant;      ///< D
  BinaryForm<Interval> factor, rest;      ///< D = S^2 G: S and G
  std::vector<LocalForm<Interval>> dips;  ///< G where D nearly vanishes twice, if it does
  std::vector<Root> roots;                ///< of D, in their order on the projective line: (1 : x) with x ascending
  int sign = 0;                           ///< of D where it has no root; 0: D = 0
  std::optional<Point1<Interval>> line;   ///< the line through the base
  int sign_on_line = 0;                   ///< of D there
};

/// Divides forms by vanishing_at(u), and drops those seen from near u.
void divide_by_root(std::vector<LocalForm<Interval>>& dips, const Point1<Interval>& u);

std::optional<CubicScene> cubic_scene(const Cubic<Interval>& f, const Point2<Interval>& on_curve);
/// Nothing where on_curve is a singular point or F = 0.
std::optional<CubicScene> cubic_scene(const Cubic<Rational>& f, const Point2<Rational>& on_curve);

/// Everything but components, ovals and points at infinity.
CurveTopology singular_points_and_factors(const CubicScene& scene);

/// Real points with z = 0 and their tangents; nothing where the intervals do not tell. None where z divides F.
std::optional<std::vector<PointAtInfinity>> points_at_infinity(const Cubic<Interval>& f);
std::vector<PointAtInfinity> points_at_infinity(const Cubic<Rational>& f);

}  // namespace burmester::detail
