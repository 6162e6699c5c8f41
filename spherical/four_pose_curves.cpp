#include "burmester/spherical/four_pose_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numbers>

#include "burmester/geometry/paired_curves.hpp"
#include "burmester/modules/framework/counted.hpp"
#include "burmester/spherical/degeneracy.hpp"
#include "burmester/spherical/four_pose_frames.hpp"

namespace burmester::spherical {
namespace {

constexpr double arc_kept = 1e-12;  // radians; some fifty times what rounding leaves of random pairs

constexpr CurveWords words{"great circle", "quadric cone"};

void list(const std::vector<FoundSlider>& found, SphericalReport& report) {
  for (const auto& [slider, multiplicity] : found) {
    report.dyads.push_back(slider);
    if (multiplicity > 1) report.warnings.push_back(fmt::format("{} sliders coincide", multiplicity));
  }
}

void add_infinitely_many_sliders(const SliderFamily& family, SphericalReport& report) {
  static constexpr std::array<const char*, 5> cone{"single axes", "a plane", "a cone of degree 2", "a cone of degree 3",
                                                   "all directions"};
  report.message +=
      fmt::format("; infinitely many sliders, proved: their moving axes fill {}, their fixed axes {}",
                  cone[static_cast<std::size_t>(family.moving)], cone[static_cast<std::size_t>(family.fixed)]);
  report.message += !family.isolated ? "; whether others exist is not decided"
                    : family.isolated->empty()
                        ? "; no others exist"
                        : fmt::format("; {} beside them", counted(family.isolated->size(), "slider"));
  if (family.isolated) list(*family.isolated, report);
}

std::string described(const SharedRotation& shared) {
  const auto& [i, j, k, l] = shared.poses;
  return fmt::format(
      "; the rotations from pose {} to {} and from pose {} to {} are one to within rounding, {:.1e} rad, and taken to "
      "be one",
      i + 1, j + 1, k + 1, l + 1, shared.off);
}

/// How far the arc between the axes of a pair changes over the poses, radians; the largest of all pairs.
double largest_change_of_arc(FourPoses poses, const std::vector<CurveRecord>& curves) {
  std::array<Matrix<double, 3, 3>, 4> turn;
  std::ranges::transform(poses, turn.begin(), [](const Pose& pose) {
    Matrix<double, 3, 3> out;
    const auto q = Space::point<double>(pose).normalized().eval();
    for (int k = 0; k < 3; ++k) out.col(k) = Space::act<double>(q, Axis::Unit(k));
    return out;
  });
  double most = 0;
  for (const CurveRecord& curve : curves)
    for (std::size_t k = 0; k < curve.moving.size(); ++k) {
      const Axis a(curve.moving[k][0], curve.moving[k][1], curve.moving[k][2]),
          b(curve.fixed[k][0], curve.fixed[k][1], curve.fixed[k][2]);
      double least = std::numbers::pi, largest = 0;
      for (const auto& r : turn) {
        const double arc = Space::distance(r * a, b);
        least = std::min(least, arc), largest = std::max(largest, arc);
      }
      most = std::max(most, largest - least);
    }
  return most;
}

void add_sliders(FourPoses poses, SphericalReport& report) {
  if (const auto found = sliders(poses)) {
    report.message += found->empty() ? "; none of them a slider" : "; " + counted(found->size(), "slider");
    list(*found, report);
  } else if (const auto family = slider_family(poses)) {
    add_infinitely_many_sliders(*family, report);
  } else {
    report.message += "; the sliders among them are not decided";
  }
}

}  // namespace

FourPoseCurves four_pose_curves(FourPoses poses, const CurveOptions& options) {
  if (std::string why = degeneracy_of(poses); !why.empty()) {
    FourPoseCurves none;
    none.topology.reason = std::move(why);
    return none;
  }
  const FourPoseFrames task(poses);
  const auto shared = shared_rotation(poses);
  const PairedCurves curves = paired_curves(
      {[&] { return task.correlations<Interval>(shared); }, [&] { return task.correlations<Rational>(shared); }},
      Surface::sphere, {.tolerance = options.tolerance, .longest = options.longest});
  return curves_in_frames(curves, task);
}

SphericalReport FourPoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 4);
  const FourPoses four = poses.first<4>();
  SphericalReport report = curve_report<Dyads>(four_pose_curves(four), words);
  if (report.status != Status::family) return report;
  if (const auto shared = shared_rotation(four); shared && !shared->exact) report.message += described(*shared);
  if (const double change = largest_change_of_arc(four, report.curves); change > arc_kept)
    report.warnings.push_back(fmt::format("pairs of axes on the curves keep their arc to {:.1e} rad only", change));
  add_sliders(four, report);
  return report;
}

static_assert(Solver<FourPoseSolver>);

}  // namespace burmester::spherical
