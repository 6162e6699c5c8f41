#include "burmester/planar/four_pose_curves.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "burmester/geometry/line_fit.hpp"
#include "burmester/geometry/paired_curves.hpp"
#include "burmester/modules/framework/equal_poses.hpp"
#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/classify.hpp"
#include "burmester/planar/dyad_form.hpp"
#include "burmester/planar/equidistance.hpp"

namespace burmester::planar {
namespace {

class Task {
 public:
  explicit Task(FourPoses poses) : poses_(poses), length_(power_of_two_below(task_size(poses))) {}

  FourPoses poses() const { return poses_; }
  const Pose& first() const { return poses_[0]; }
  double length() const { return length_; }
  template <class T>
  ThreeCorrelations<T> correlations() const {
    ThreeCorrelations<T> n;
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

/// The real point at infinity of a circular cubic (x^2 + y^2)(c0 x + c6 y) + .., zero where there is more than one.
Point2<double> far_point(const Cubic<double>& f) { return {f.c[6], -f.c[0], 0}; }

/// The partner of a far point, if it is near.
std::optional<Point2<double>> partner_of_far_point(const ThreeCorrelations<double>& n) {
  const Cubic<double> f = points_with_partner(n);
  if (!(std::abs(f.c[0]) + std::abs(f.c[6]) > 256 * unit_roundoff * f.gradient_bound())) return std::nullopt;
  const Point2<double> p = partner(n, far_point(f));
  if (!(std::abs(p[2]) > 256 * unit_roundoff * p.norm())) return std::nullopt;
  return p;
}

void add_sliders(const Task& task, PlanarReport& report) {
  const auto n = task.correlations<double>();
  const FourPoses poses = task.poses();
  std::array<Vector2, 4> places;
  if (const auto p = partner_of_far_point({n[0].transpose(), n[1].transpose(), n[2].transpose()})) {
    const Vector2 moving = task.moving(*p);
    for (std::size_t j = 0; j < 4; ++j) places[j] = to_fixed(poses[j], moving);
    report.dyads.push_back(found_slider<PR, Dyads>({moving, line_of(fit_line(places))}, poses));
  }
  if (const auto c = partner_of_far_point(n)) {
    const Vector2 fixed = task.fixed(*c);
    for (std::size_t j = 0; j < 4; ++j) places[j] = to_moving(poses[j], fixed);
    report.dyads.push_back(found_slider<RP, Dyads>({fixed, line_of(fit_line(places))}, poses));
  }
}

std::string degeneracy_of(FourPoses poses) {
  const auto same = [&](int i, int j) {
    const Pose &a = poses[static_cast<std::size_t>(i)], &b = poses[static_cast<std::size_t>(j)];
    return a.x == b.x && a.y == b.y && same_orientation(a, b);
  };
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (same(i, j)) return name_equal_poses(same, 4);
  return DyadForm(poses).degeneracy();
}

constexpr CurveWords words{"line", "conic"};

}  // namespace

FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options) {
  const Task task(poses);
  PairedCurves curves =
      paired_curves({[&] { return task.correlations<Interval>(); }, [&] { return task.correlations<Rational>(); }},
                    trace_in_plane, {options.tolerance, options.longest, options.window});
  if (curves.topology.rung == Rung::none)
    if (const std::string words = degeneracy_of(poses); !words.empty()) curves.topology.reason += "; " + words;
  return curves_in_frames(curves, task);
}

PlanarReport FourPoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 4);
  const FourPoses four = poses.first<4>();
  PlanarReport report = curve_report<Dyads>(four_pose_curves(four), words);
  if (report.status == Status::degenerate) return report;
  add_sliders(Task(four), report);
  sort_dyads(report);
  return report;
}

static_assert(Solver<FourPoseSolver>);

}  // namespace burmester::planar
