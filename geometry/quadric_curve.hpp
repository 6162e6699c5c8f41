// Walks along the curve in which two quadrics A, B of projective space meet. FOR DRAWING ONLY: a walk is a sample.
// Where two components pass each other closer than about 1e-6 it goes straight on, as if they crossed, so no
// verdict about circuits or branches follows from it.
//
// Points are unit vectors x of R^4; x and -x are the same point. The tangent is the kernel of x, grad A(x) and
// grad B(x), oriented by the determinant: along a smooth component it never vanishes, and where two branches
// cross (grad A and grad B dependent) it changes sign for one who goes straight on. That is how a walk knows a
// crossing from a narrow turn. Steps: Euler predictor, Newton corrector of least norm (E. L. Allgower, K. Georg,
// "Introduction to Numerical Continuation Methods", 2003, chapters 2 to 6).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "burmester/geometry/quadric.hpp"

namespace burmester {

class QuadricCurve {
 public:
  /// Precondition: neither quadric is zero.
  QuadricCurve(const Quadric<double>& a, const Quadric<double>& b);

  /// Largest of |A(x)|, |B(x)|, coefficients scaled to size 1.
  double distance(const Point3<double>& x) const;
  /// The oriented tangent at x; its length, 0 to 1, says how far x is from a singular point.
  Point3<double> tangent(const Point3<double>& x) const;
  /// The point of the curve next to x, of norm 1; empty where the corrector does not settle.
  std::optional<Point3<double>> corrected(Point3<double> x) const;

 private:
  Matrix<double, 3, 4> frame(const Point3<double>& x) const;

  Quadric<double> a_, b_;
};

struct WalkOptions {
  double longest_step = 0.02;  ///< radians on the unit sphere
  double turning = 0.1;        ///< radians that the tangent may turn in one step
  std::size_t most_points = 10000;
  std::function<bool(const Point3<double>&)> stop;  ///< where true the walk ends; empty: nowhere
};

enum class WalkEnd { closed, stopped, singular, too_long };

struct Walk {
  std::vector<Point3<double>> points;  ///< neighbours have a positive scalar product
  std::size_t start = 0;               ///< index of the start point
  bool closed = false;                 ///< the last point's neighbour is the first, up to sign
  WalkEnd ends[2] = {WalkEnd::singular, WalkEnd::singular};  ///< behind the last point, before the first one
};

/// From a point on or near the curve in the direction of its tangent until the walk closes or ends; where it ends,
/// the other way too. Two ends `singular` and at most one point: the start is off the curve, or a singular point.
Walk walk(const QuadricCurve& curve, const Point3<double>& start, const WalkOptions& options = {});

/// Index of the point next to x. Precondition: the walk has points.
std::size_t nearest_point(const Walk& walk, const Point3<double>& x);

/// x or -x, whichever lies on the side of `beside`.
inline Point3<double> aligned(const Point3<double>& x, const Point3<double>& beside) {
  return x.dot(beside) < 0 ? Point3<double>(-x) : x;
}

}  // namespace burmester
