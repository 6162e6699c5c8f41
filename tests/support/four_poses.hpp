// Four planar poses: random tasks, what it means for a pair of pivots to meet them, distances from polylines.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "burmester/geometry/rational.hpp"
#include "burmester/planar/equidistance.hpp"
#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

using FourPoseTask = std::array<Pose, 4>;

inline FourPoseTask random_four_poses(Random& random) {
  FourPoseTask task;
  for (Pose& p : task) p = Space::random_pose(random);
  return task;
}
inline FourPoseTask four_poses(const std::array<std::array<double, 3>, 4>& degrees) {
  FourPoseTask task;
  for (std::size_t j = 0; j < 4; ++j) task[j] = pose_from_degrees(degrees[j][0], degrees[j][1], degrees[j][2]);
  return task;
}

/// Difference between the largest and the least distance of the two pivots over the poses, in the largest of them and
/// the task size. A pivot rounded once moves by up to a unit roundoff of its distance from the origin of its frame.
inline double concyclicity(const FourPoseTask& task, const Vector2& moving, const Vector2& fixed) {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Pose& pose : task) {
    const double r = (to_fixed(pose, moving) - fixed).norm();
    least = std::min(least, r), largest = std::max(largest, r);
  }
  return (largest - least) / (task_size(task) + largest);
}

/// The two cubics of four poses in rational numbers, and how far points are from them.
class ExactCubics {
 public:
  explicit ExactCubics(const FourPoseTask& task) : first_(task[0]), length_(power_of_two_below(task_size(task))) {
    std::array<Correlation<Rational>, 3> n;
    for (std::size_t j = 0; j < 3; ++j) n[j] = equidistance<Rational>(task[0], task[j + 1], 1 / length_);
    moving_ = points_with_partner(n);
    for (auto& m : n) m.transposeInPlace();
    fixed_ = points_with_partner(n);
  }
  const Cubic<Rational>& moving() const { return moving_; }
  const Cubic<Rational>& fixed() const { return fixed_; }

  /// Of a moving pivot (fixed pivot) to first order, |F| / |gradient|, in task sizes, or in distances from pose 1's
  /// origin where that is more. The point is taken as it stands; its distance is rounded only at the end.
  double distance_of_moving(const Vector2& p) const {
    return distance(moving_, rotated({0, 0, first_.X3, first_.X4}, p) / length_);
  }
  double distance_of_fixed(const Vector2& p) const {
    return distance(fixed_, (p - Vector2(first_.x, first_.y)) / length_);
  }

 private:
  static double distance(const Cubic<Rational>& f, const Vector2& p) {
    const Point2<Rational> at{Rational(p[0]), Rational(p[1]), Rational(1)}, gradient = f.gradient(at);
    const double slope = std::hypot(approximate(gradient[0]), approximate(gradient[1]));
    return std::abs(approximate(f(at))) / slope / std::max(1.0, p.norm());
  }

  Pose first_;
  double length_;
  Cubic<Rational> moving_, fixed_;
};

inline double distance_to_chord(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - t * d).norm();
}

/// `point_at(k)`: the k-th of n vertices.
template <class PointAt>
double distance_to_polyline(const Vector2& p, std::size_t n, bool closed, PointAt point_at) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = closed ? 0 : 1; k < n; ++k)
    best = std::min(best, distance_to_chord(p, point_at(k == 0 ? n - 1 : k - 1), point_at(k)));
  return best;
}

/// Distance of a pivot from the traced curves, less their proved error.
inline double distance_to_curves(const Vector2& p, const std::vector<CurveRecord>& curves, bool moving) {
  double best = std::numeric_limits<double>::infinity();
  for (const CurveRecord& curve : curves) {
    const auto& points = moving ? curve.moving : curve.fixed;
    const auto at = [&](std::size_t k) { return Vector2(points[k][0], points[k][1]); };
    best = std::min(best, distance_to_polyline(p, points.size(), curve.closed, at) - curve.max_error);
  }
  return best;
}

/// Both pivots within a share of the window that curves are traced in.
inline bool within_window(const Vector2& moving, const Vector2& fixed, const FourPoseTask& task, double share = 0.99) {
  const double window = 8 * power_of_two_below(curve_scale(task)) * share;
  const Vector2 m = rotated({0, 0, task[0].X3, task[0].X4}, moving), c = fixed - Vector2(task[0].x, task[0].y);
  return m.cwiseAbs().maxCoeff() < window && c.cwiseAbs().maxCoeff() < window;
}

}  // namespace burmester::planar
