#include "burmester/geometry/quadric_curve.hpp"

#include <Eigen/QR>

namespace burmester {
namespace {

using Point = Point3<double>;

constexpr double smallest_step = 1e-9;   // in hairpins
constexpr double near_crossing = 1e-4;   // length of the tangent; there ..
constexpr double narrowest_gap = 2e-6;   // .. steps end here, and two branches count as crossing
constexpr double leap = 2e-3;            // the step across a crossing
constexpr double singular = 1e-7;        // length of a tangent that shows no direction
constexpr double on_curve = 4e-16;        // values of quadrics of size 1 at unit vectors: a few roundoffs
constexpr double last_change = 1e-10;    // the corrector's next change would be its square

Quadric<double> scaled(Quadric<double> s) {
  const double size = size_of(s);
  for (double& q : s.q) q /= size;
  return s;
}

double angle_between(const Point& u, const Point& v) { return 2 * std::asin(std::min(1.0, (u - v).norm() / 2)); }

class Walker {
 public:
  Walker(const QuadricCurve& curve, const WalkOptions& options, const Point& start, double direction)
      : curve_(curve), options_(options), at_(start), sign_(direction) {
    heading_ = start_heading_ = heading_at(start);
    points_.push_back(start);
  }

  WalkEnd run() {
    double step = options_.longest_step / 4;
    for (std::size_t steps = 1; steps < options_.most_points; ++steps) {
      const std::optional<double> done = advance(step);
      if (!done) return WalkEnd::singular;
      if (closes(*done)) return WalkEnd::closed;
      if (options_.stop && options_.stop(at_)) return WalkEnd::stopped;
      points_.push_back(at_);
      step = std::min(1.5 * std::max(*done, narrowest_gap), options_.longest_step);
    }
    return WalkEnd::too_long;
  }
  std::vector<Point>& points() { return points_; }

 private:
  Point heading_at(const Point& x) const {
    const Point t = sign_ * curve_.tangent(x);
    return t.norm() > singular ? Point(t.normalized()) : Point(Point::Zero());
  }

  /// Moves on by a step of at most the given length, and across a crossing; the length, or nothing.
  std::optional<double> advance(double step) {
    const double smallest = curve_.tangent(at_).norm() < near_crossing ? narrowest_gap : smallest_step;
    for (; step > smallest; step /= 2)
      if (try_step(step, options_.turning)) return step;
    return leap_ahead();
  }

  /// Straight on from a little before the crossing, where the tangent has not begun to turn.
  std::optional<double> leap_ahead() {
    const Point near = at_;
    while (points_.size() > 1 && (points_.back() - near).norm() < leap / 2) points_.pop_back();
    at_ = points_.back();
    heading_ = heading_at(at_);
    const double step = (at_ - near).norm() + leap / 2;
    for (const double sign : {-sign_, sign_}) {
      sign_ = sign;
      if (try_step(step, 0.3)) return step;
    }
    return std::nullopt;
  }

  bool try_step(double step, double turning) {
    const Point guess = (at_ + step * heading_).normalized();
    const std::optional<Point> next = curve_.corrected(guess);
    if (!next) return false;
    const Point heading = heading_at(*next);
    const double turn = angle_between(heading, heading_);
    if (heading.isZero() || turn > turning) return false;
    // On one smooth arc the predictor misses by half of step times turn; a larger miss is another arc.
    if (angle_between(*next, guess) > step * (turn + 0.01)) return false;
    before_ = at_, at_ = *next, heading_ = heading;
    return true;
  }

  /// Whether the last step led past the start point, in the direction in which the walk left it.
  bool closes(double step) const {
    if (points_.size() < 4) return false;
    const Point& start = points_.front();
    const double side = start.dot(at_) < 0 ? -1 : 1;
    const Point home = side * start;
    return (home - at_).norm() <= 1.5 * step && side * start_heading_.dot(heading_) > 0.5 &&
           (home - before_).dot(heading_) > 0 && (home - at_).dot(heading_) <= 1e-3 * step &&
           off_chord(home) <= 0.05 * step;
  }
  double off_chord(const Point& x) const {
    const Point chord = (at_ - before_).normalized(), offset = x - before_;
    return (offset - chord.dot(offset) * chord).norm();
  }

  const QuadricCurve& curve_;
  const WalkOptions& options_;
  Point at_, before_ = Point::Zero(), heading_, start_heading_;
  double sign_;
  std::vector<Point> points_;
};

}  // namespace

QuadricCurve::QuadricCurve(const Quadric<double>& a, const Quadric<double>& b) : a_(scaled(a)), b_(scaled(b)) {}

double QuadricCurve::distance(const Point& x) const { return std::max(std::abs(a_(x)), std::abs(b_(x))); }

Matrix<double, 3, 4> QuadricCurve::frame(const Point& x) const {
  Matrix<double, 3, 4> rows;
  rows << x.transpose(), a_.gradient(x).transpose(), b_.gradient(x).transpose();
  return rows;
}

Point QuadricCurve::tangent(const Point& x) const {
  Matrix<double, 3, 4> m = frame(x);
  m.row(1).normalize(), m.row(2).normalize();
  Point t;
  for (int skip = 0; skip < 4; ++skip) {
    Eigen::Matrix3d minor;
    for (int c = 0; c < 3; ++c) minor.col(c) = m.col(c < skip ? c : c + 1);
    t[skip] = (skip % 2 ? -1 : 1) * minor.determinant();
  }
  return t;
}

std::optional<Point> QuadricCurve::corrected(Point x) const {
  if (!(x.norm() > 0)) return std::nullopt;
  for (int iteration = 0; iteration < 12; ++iteration) {
    x.normalize();
    if (distance(x) <= on_curve) return x;
    const Eigen::Matrix<double, 3, 4> jacobian = frame(x);
    const Eigen::Vector3d value(0, a_(x), b_(x));
    const Eigen::Vector4d change = jacobian.completeOrthogonalDecomposition().solve(value);
    if (!change.allFinite() || change.norm() > 1) return std::nullopt;
    x -= change;
    if (change.norm() < last_change) return Point(x.normalized());
  }
  return std::nullopt;
}

Walk walk(const QuadricCurve& curve, const Point& start, const WalkOptions& options) {
  Walk out;
  const std::optional<Point> first = curve.corrected(start);
  if (!first) return out;
  out.points = {*first};
  if (!(curve.tangent(*first).norm() > singular)) return out;
  Walker forward(curve, options, *first, 1);
  out.ends[0] = out.ends[1] = forward.run();
  out.points = std::move(forward.points());
  out.closed = out.ends[0] == WalkEnd::closed;
  if (out.closed) return out;
  Walker backward(curve, options, *first, -1);
  out.ends[1] = backward.run();
  const std::vector<Point>& behind = backward.points();
  out.start = behind.size() - 1;
  out.points.insert(out.points.begin(), behind.rbegin(), behind.rend() - 1);
  return out;
}

std::size_t nearest_point(const Walk& walk, const Point& x) {
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t i = 0; i < walk.points.size(); ++i) {
    const double cosine = std::abs(walk.points[i].dot(x));
    if (cosine > largest) largest = cosine, best = i;
  }
  return best;
}

}  // namespace burmester
