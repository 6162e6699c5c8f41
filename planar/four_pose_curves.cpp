#include "burmester/planar/four_pose_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "burmester/geometry/line_fit.hpp"
#include "burmester/geometry/paired_curves.hpp"
#include "burmester/modules/framework/equal_poses.hpp"
#include "burmester/planar/classify.hpp"
#include "burmester/planar/dyad_form.hpp"
#include "burmester/planar/four_pose_frames.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

using Task = FourPoseFrames;

constexpr double farthest_slider = 0x1p31;  // task sizes: at 2^31 its places are rounded by 2^-22 of one

/// The partner of the real point at infinity of a circular cubic (x^2 + y^2)(c0 x + c6 y) + ..; zero where there is
/// more than one such point or more than one partner.
Point2<Rational> partner_of_far_point(const ThreeCorrelations<Rational>& n) {
  const Cubic<Rational> f = points_with_partner(n);
  return partner(n, Point2<Rational>{f.c[6], Rational(-f.c[0]), Rational(0)});
}

/// The slider whose one pivot is the point p, in units of the task, or a warning that says why there is none.
template <class D>
void add_slider(const Point2<Rational>& p, Vector2 (Task::*pivot_of)(const Point2<double>&) const,
                Vector2 (*place)(const Pose&, const Vector2&), const Task& task, PlanarReport& report) {
  const auto missing = [&](const std::string& why) {
    report.warnings.push_back(fmt::format("no {} dyad is listed: {}", D::name, why));
  };
  if (p.isZero(0)) return missing("its pivot is not a single point");
  if (p[2] == 0) return missing("its pivot is at infinity");
  const Point2<double> near{approximate(Rational(p[0] / p[2])), approximate(Rational(p[1] / p[2])), 1};
  const double distance = task.length() * near.head<2>().norm(), size = task_size(task.poses());
  if (!(distance < farthest_slider * size))
    return missing(fmt::format("its pivot is {:.1e} task sizes away", distance / size));
  const Vector2 pivot = (task.*pivot_of)(near);
  std::array<Vector2, 4> places;
  std::ranges::transform(task.poses(), places.begin(), [&](const Pose& pose) { return place(pose, pivot); });
  report.dyads.push_back(found_slider<D, Dyads>({pivot, line_of(fit_line(places))}, task.poses()));
}

/// Exact, as a sum of terms that nearly cancel where the turns are small.
void add_sliders(const Task& task, PlanarReport& report) {
  auto n = task.correlations<Rational>();
  add_slider<RP>(partner_of_far_point(n), &Task::fixed, to_moving, task, report);
  for (Correlation<Rational>& m : n) m.transposeInPlace();
  add_slider<PR>(partner_of_far_point(n), &Task::moving, to_fixed, task, report);
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

/// Where the pole is; what rounding the data may have made of a zero is shown as 0.
std::string shown(const CommonPole& pole) {
  const auto coordinate = [&](double x) { return std::abs(x) <= pole.rounding ? 0 : x; };
  return fmt::format("({:.6g}, {:.6g})", coordinate(pole.at[0]), coordinate(pole.at[1]));
}

std::string described(const CommonPole& pole, FourPoses poses) {
  const auto& [i, j, k] = pole.poses;
  if (pole.spread > together * task_size(poses))
    return fmt::format(
        "; the poles of poses {}, {} and {} are close together for curves of this extent, within {:.1e} of {}: one "
        "pivot of each dyad is near them",
        i + 1, j + 1, k + 1, pole.spread, shown(pole));
  return fmt::format("; poses {}, {} and {} turn about one point, {}, to within {}: one pivot of each dyad is there",
                     i + 1, j + 1, k + 1, shown(pole),
                     pole.spread <= pole.rounding ? "rounding" : fmt::format("{:.1e}", pole.spread));
}

constexpr CurveWords words{"line", "conic"};

double distance_of(const Point2<double>& p) {
  return p[2] == 0 ? std::numeric_limits<double>::infinity() : p.head<2>().norm() / std::abs(p[2]);
}

}  // namespace

double curve_scale(FourPoses poses) {
  const auto seen = [&](std::size_t j) {  // from pose 1's origin
    return Pose{poses[j].x - poses[0].x, poses[j].y - poses[0].y, poses[j].X3, poses[j].X4};
  };
  std::array<double, 6> distances;
  for (std::size_t i = 0, k = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) distances[k++] = distance_of(relative_pole(seen(i), seen(j)));
  std::ranges::nth_element(distances, distances.begin() + 2);
  const double size = task_size(poses);
  return std::clamp(distances[2] / 2, size, largest_scale * size);
}

bool curves_are_far(FourPoses poses, double unit) { return curve_scale(poses) > 2 * unit * task_size(poses); }

FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options) {
  const Task task(poses);
  if (task.pole() && task.pole()->all) {
    FourPoseCurves none;
    none.topology.reason =
        fmt::format("every point lies on it to within rounding; all four poses are rotations about one point, {}",
                    shown(*task.pole()));
    return none;
  }
  PairedCurves curves =
      paired_curves({[&] { return task.correlations<Interval>(); }, [&] { return task.correlations<Rational>(); },
                     task.is_about_pole()},
                    Surface::plane, {options.tolerance, options.longest, task.window(options.window)});
  if (curves.topology.rung == Rung::none)
    if (const std::string words = degeneracy_of(poses); !words.empty()) curves.topology.reason += "; " + words;
  return curves_in_frames(curves, task);
}

std::vector<CurveRecord> curves_near_poses(FourPoses poses, double unit) {
  const double share = unit * task_size(poses) / curve_scale(poses);
  const CurveOptions whole;
  return four_pose_curves(poses, {share * whole.tolerance, share * whole.longest, share * whole.window}).pieces;
}

PlanarReport FourPoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 4);
  const FourPoses four = poses.first<4>();
  PlanarReport report = curve_report<Dyads>(four_pose_curves(four), words);
  if (report.status == Status::degenerate) return report;
  const Task task(four);
  const double size = task_size(four), window = CurveOptions().window * task.length();
  if (curves_are_far(four))
    report.message += fmt::format("; the poles are far: listed within {:.3g} of {}, {:.3g} task sizes", window,
                                  task.pole() ? "the common pole" : "pose 1's origin", window / size);
  if (task.pole()) report.message += described(*task.pole(), four);
  add_sliders(task, report);
  sort_dyads(report);
  return report;
}

static_assert(Solver<FourPoseSolver>);

}  // namespace burmester::planar
