// What tracing needs to know of a curve in its turned plane (curve_arcs.hpp), each answer proved. Not for inclusion by
// users: arc_trace.hpp is. Only for targets that compile intervals, below an UpwardRounding.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/curve_arcs.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester::detail {

/// A point of the turned plane.
struct Place {
  double u = 0, v = 0;
};

/// A point of an arc, a little off it.
struct Vertex {
  Place at;
  double radius = 0;  ///< the arc passes at at.v +- radius
  double slope = 0;   ///< of the arc, about
  double gap = 0;     ///< to the next arcs above and below
  Point2<double> in_plane;
  bool inside = false, near = false;  ///< of the window; of the window with its margin
};

class ArcSamples {
 public:
  ArcSamples(const CurveArcs& arcs, double window);

  /// Arc k of an interval at u, which must be in it; nothing where that could not be told.
  std::optional<Vertex> vertex(int interval, int k, double u);
  /// All arcs of the interval at u, ascending; none where that could not be told.
  const std::vector<Range>& arcs_at(int interval, double u);
  /// Whether G has no zero on the segment; false also where it is not seen.
  bool no_zero_between(const Place& from, const Place& to) const;

  Point2<double> in_plane(const Place& at) const;
  bool in_window(const Point2<double>& p) const { return in_window(p, 1); }
  /// Whether the convex hull of four points passes the window on one side.
  bool outside(const std::array<Place, 4>& corners) const;

 private:
  template <class T>
  std::vector<T> coefficients(const TernaryForm<T>& f, double u) const;
  std::vector<Range> exact_roots(double u) const;
  double slope(const Place& at) const;
  bool in_window(const Point2<double>& p, double factor) const;

  const CurveArcs& arcs_;
  double window_;
  TernaryForm<Interval> enclosing_, by_u_, by_v_;
  std::vector<std::map<double, std::vector<Range>>> samples_;
};

}  // namespace burmester::detail
