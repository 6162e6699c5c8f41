#include "burmester/planar/four_pose_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "burmester/geometry/curve_trace.hpp"
#include "burmester/geometry/line_fit.hpp"
#include "burmester/modules/framework/condition.hpp"
#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/classify.hpp"
#include "burmester/planar/equidistance.hpp"

namespace burmester::planar {
namespace {

template <class T>
using Correlations = std::array<Correlation<T>, 3>;

class Task {
 public:
  explicit Task(FourPoses poses) : poses_(poses), length_(power_of_two_below(task_size(poses))) {}

  FourPoses poses() const { return poses_; }
  const Pose& first() const { return poses_[0]; }
  double length() const { return length_; }
  template <class T>
  Correlations<T> correlations() const {
    Correlations<T> n;
    for (std::size_t j = 0; j < 3; ++j) n[j] = equidistance<T>(poses_[0], poses_[j + 1], 1 / length_);
    return n;
  }
  Vector2 moving(const Point2<double>& p) const {  // in E
    return to_moving({0, 0, first().X3, first().X4}, length_ / p[2] * Vector2(p[0], p[1]));
  }
  Vector2 fixed(const Point2<double>& c) const {  // in S
    return length_ / c[2] * Vector2(c[0], c[1]) + Vector2(first().x, first().y);
  }

 private:
  FourPoses poses_;
  double length_;
};

/// From any of the three poles; intervals first.
CubicBranches branches_of(const Task& task) {
  {
    const UpwardRounding upward;
    const auto n = task.correlations<Interval>();
    const Cubic<Interval> f = points_with_partner(n);
    for (const Correlation<Interval>& from : n)
      if (auto branches = branches_by_intervals(f, vertex(from))) return std::move(*branches);
  }
  const auto n = task.correlations<Rational>();
  const Cubic<Rational> f = points_with_partner(n);
  CubicBranches branches;
  for (const Correlation<Rational>& from : n) {
    const Point2<Rational> pole = vertex(from);
    if (pole.isZero(0)) continue;
    branches = branches_by_rationals(f, pole);
    if (branches.topology.rung != Rung::none) return branches;
  }
  branches.topology.reason =
      "every pole is a singular point of it, as when two poses are equal or all are parallel or rotations about one "
      "point";
  return branches;
}

CurveRecord record_of(const CurvePiece& piece, const Task& task) {
  CurveRecord out{piece.component, piece.closed, piece.max_error * task.length(), {}, {}};
  double farthest = 0;
  const auto add = [&](std::vector<std::vector<double>>& to, const Vector2& p) {
    farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1])});
    to.push_back({p[0], p[1]});
  };
  for (const Point2<double>& p : piece.points) add(out.moving, task.moving(p));
  for (const Point2<double>& c : piece.partners) add(out.fixed, task.fixed(c));
  out.max_error += 16 * unit_roundoff * (farthest + 8 * task.length());  // the change of frame, rounded
  return out;
}

/// The real point at infinity of a circular cubic (x^2 + y^2)(c0 x + c6 y) + .., zero where there is more than one.
Point2<double> far_point(const Cubic<double>& f) { return {f.c[6], -f.c[0], 0}; }

/// The partner of a far point, if it is near.
std::optional<Point2<double>> partner_of_far_point(const Correlations<double>& n) {
  const Cubic<double> f = points_with_partner(n);
  if (!(std::abs(f.c[0]) + std::abs(f.c[6]) > 256 * unit_roundoff * f.gradient_bound())) return std::nullopt;
  const Point2<double> p = partner(n, far_point(f));
  if (!(std::abs(p[2]) > 256 * unit_roundoff * p.norm())) return std::nullopt;
  return p;
}

template <class D>
void add(PlanarReport& report, const typename D::Design& design, FourPoses poses) {
  Found<Dyads::Design> found;
  found.design = design;
  found.residual = largest_residual<D>(design, poses);
  found.condition = condition<D>(design, poses);
  found.departure = found.residual;
  report.dyads.push_back(std::move(found));
}

void add_sliders(const Task& task, PlanarReport& report) {
  const auto n = task.correlations<double>();
  const FourPoses poses = task.poses();
  std::array<Vector2, 4> places;
  if (const auto p = partner_of_far_point({n[0].transpose(), n[1].transpose(), n[2].transpose()})) {
    const Vector2 moving = task.moving(*p);
    for (std::size_t j = 0; j < 4; ++j) places[j] = to_fixed(poses[j], moving);
    add<PR>(report, {moving, line_of(fit_line(places))}, poses);
  }
  if (const auto c = partner_of_far_point(n)) {
    const Vector2 fixed = task.fixed(*c);
    for (std::size_t j = 0; j < 4; ++j) places[j] = to_moving(poses[j], fixed);
    add<RP>(report, {fixed, line_of(fit_line(places))}, poses);
  }
}

std::string description_of(const CurveTopology& t) {
  std::string out = "a curve of dyads: circle points and centre points";
  if (!t.lines.empty())
    out += fmt::format(", split into {} line{}{}", t.lines.size(), t.lines.size() == 1 ? "" : "s",
                       t.conics.empty() ? "" : " and a conic");
  out += fmt::format(", in {} component{}", t.components, t.components == 1 ? "" : "s");
  if (t.ovals > 0) out += ", one of them an oval";
  return out + ", proved";
}

}  // namespace

FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options) {
  const Task task(poses);
  const CubicBranches branches = branches_of(task);
  FourPoseCurves out{branches.topology, {}, true};
  if (branches.topology.rung == Rung::none) return out;
  TracedCurve traced;
  {
    const UpwardRounding upward;
    const auto n = task.correlations<Interval>();
    traced = trace_in_plane(branches, tube_curve(points_with_partner(n)), partner_curve(n),
                            {options.tolerance, options.longest, options.window});
  }
  out.complete = traced.complete;
  for (const CurvePiece& piece : traced.pieces) out.pieces.push_back(record_of(piece, task));
  return out;
}

PlanarReport FourPoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 4);
  const FourPoses four = poses.first<4>();
  FourPoseCurves curves = four_pose_curves(four);
  PlanarReport report;
  if (curves.topology.rung == Rung::none) {
    report.status = Status::degenerate;
    report.message = "the circle-point curve degenerates: " + curves.topology.reason;
    return report;
  }
  report.status = Status::family;
  report.message = description_of(curves.topology);
  report.counts.dimension = 1;
  report.curves = std::move(curves.pieces);
  if (!curves.complete) report.warnings.push_back("a part of the curves could not be proved and is not listed");
  add_sliders(Task(four), report);
  sort_dyads(report);
  return report;
}

static_assert(Solver<FourPoseSolver>);

}  // namespace burmester::planar
