#include "burmester/planar/five_pose_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "burmester/geometry/diameter.hpp"
#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/counted.hpp"
#include "burmester/planar/classify.hpp"
#include "burmester/planar/degeneracy.hpp"
#include "burmester/planar/double_slider.hpp"
#include "burmester/planar/five_pose_certificate.hpp"
#include "burmester/planar/five_pose_oracle.hpp"
#include "burmester/planar/merge_distance.hpp"

namespace burmester::planar {
namespace {

/// Of the task size: where a radius is larger the roots and boxes are computed again, sharper.
constexpr double largest_radius = 1e-9;
/// Two dyads are looked at for merging below this many times the rounding estimate of the discriminant.
constexpr double merging_factor = 0x1p16;

/// Distances below this are rounding of quad precision.
constexpr double coinciding = 0x1p-90;

/// The task seen from the reference pose's origin with the task size as unit of length: there conditions do not
/// depend on the user's frame and unit.
struct UnitTask {
  std::array<Pose, 5> poses;
  Anchor anchor;
  UnitTask(FivePoses given, const Anchor& from, double size) : anchor(from) {
    const Pose& reference = given[from.reference];
    for (int j = 0; j < 5; ++j) {
      const Pose& p = given[j];
      poses[j] = {(p.x - reference.x) / size, (p.y - reference.y) / size, p.X3, p.X4};
    }
    anchor.length = from.length / size;
  }
};

/// Of an RR that is nearly a slider, the slider's: the far pivot itself is hardly determined, and means nothing.
template <class T>
double condition_of(const Anchored<T>& w, const UnitTask& unit) {
  const auto found = classify(w, unit.anchor, unit.poses, 1, near_slider_departure);
  return Dyads::visit(found.design, [&]<class D>(const typename D::Design& d) {
    return condition<D>(d, unit.poses);
  });
}

void add(PlanarReport& report, Found<Dyads::Design> found, std::optional<double> condition, FivePoses poses) {
  found.residual = Dyads::visit(
      found.design, [&]<class D>(const typename D::Design& d) { return largest_residual<D>(d, poses); });
  found.condition = condition;
  report.dyads.push_back(std::move(found));
}

std::string type_of(const Dyads::Design& design) {
  return Dyads::visit(design, []<class D>(const typename D::Design&) { return std::string(D::name); });
}

/// How near two dyads are to merging, where that is near; the last part of a certified answer's message.
void state_merging(const auto& roots, FivePoses poses, PlanarReport& report) {
  const bool finite = roots.what == FivePoseCase::regular || roots.what == FivePoseCase::two_orientations;
  if (!finite || !(std::abs(roots.discriminant) < merging_factor * roots.rounding)) return;
  const auto merging = merge_distance(roots.what, poses, roots.anchor, roots.count);
  if (!merging) return;
  report.counts.merge_distance = merging->distance;
  if (merging->distance < coinciding) {
    report.warnings.push_back("two dyads coincide");
    report.message += "; not proved, because two dyads coincide";
    return;
  }
  const std::string by = fmt::format("if the poses changed by {:.0e}", merging->distance);
  if (report.counts.certified)
    report.message += (merging->appear ? "; two more would appear " : "; two of them would merge ") + by;
  if (merging->distance < near_merging)
    report.warnings.push_back(
        (merging->appear ? "two more dyads nearly exist: they would " : "two dyads nearly merge: they would ") + by);
  else if (!report.counts.certified && std::abs(roots.discriminant) < roots.rounding)
    report.warnings.push_back(
        "two dyads merge within rounding of the data: the number of real dyads may be off by two");
}

/// Puts the certificate of root i on the last dyad of the report.
void attach(const CertifiedRoots& certified, int i, FivePoses poses, PlanarReport& report) {
  const DyadBox& box = certified.boxes[static_cast<std::size_t>(i)];
  if (box.rung == Rung::none) return;
  auto& found = report.dyads.back();
  const Pose& reference = poses[static_cast<std::size_t>(certified.roots.anchor.reference)];
  const double radius = error_bound(found.design, box, poses, reference);
  if (std::isfinite(radius)) found.certificate = {true, radius, box.rung};
}

bool all_certified(const PlanarReport& report) {
  return std::all_of(report.dyads.begin(), report.dyads.end(),
                     [](const auto& found) { return found.certificate.certified; });
}

double radius_of(const PlanarReport& report) {
  double radius = 0;
  for (const auto& found : report.dyads) radius = std::max(radius, found.certificate.radius);
  return radius;
}

/// Of degenerate poses: proved, or how far rounding alone makes them so.
void state_degeneracy(const CertifiedRoots& certified, PlanarReport& report) {
  report.counts.certified = certified.degenerate && all_certified(report);
  if (report.counts.certified)
    report.message += ", proved";
  else if (certified.count >= 0)
    report.message +=
        fmt::format("; true within rounding, the doubles given have {}", counted(certified.count, "real dyad"));
  else
    report.message += ", within rounding";
}

void state_proof(const CertifiedRoots& certified, PlanarReport& report) {
  const FivePoseCase what = certified.roots.what;
  if (what != FivePoseCase::regular && what != FivePoseCase::two_orientations)
    return state_degeneracy(certified, report);
  if (certified.count >= 0 && certified.count != certified.roots.count)
    report.warnings.push_back(
        fmt::format("{} proved, but {} found at first", counted(certified.count, "real dyad"), certified.roots.count));
  report.counts.certified = certified.complete && all_certified(report);
  if (!report.counts.certified) return;
  if (report.dyads.empty())
    report.message += ", proved";
  else  // printed: never below the radius
    report.message += fmt::format(", proved complete, true to {:.0e}", 1.5 * radius_of(report));
}

/// Poses that rounding can hardly tell apart: what is proved of the doubles stands, the rest is not decided.
void judge_indistinct(PlanarReport& report) {
  if (report.counts.certified) {
    report.warnings.push_back(
        "two poses, or all orientations, agree to within rounding: the answer holds for the doubles given");
    return;
  }
  report.status = Status::degenerate;
  report.message = "not decided: two poses, or all orientations, agree to within rounding of the data";
  report.counts = {};
  report.dyads.clear();
}

template <class T>
PlanarReport report_of(const FivePoseRoots<T>& roots, FivePoses poses, const CertifiedRoots* certified = nullptr) {
  PlanarReport report;
  const double size = task_size(poses);
  const UnitTask unit(poses, roots.anchor, size);
  for (int i = 0; i < roots.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto found = certified && certified->sharp ? classify(certified->quad[k], roots.anchor, poses, size)
                                                     : classify(roots.w[k], roots.anchor, poses, size);
    add(report, found, condition_of(roots.w[k], unit), poses);
    if (certified) attach(*certified, i, poses, report);
  }
  std::string family_type;
  if (roots.what == FivePoseCase::common_line)
    family_type = type_of(classify(roots.family, roots.anchor, poses, size).design);
  if (roots.what == FivePoseCase::all_parallel || roots.what == FivePoseCase::translation) {
    Found<Dyads::Design> found;
    found.design = PP::Design{angle_of(poses[0])};
    if (certified && certified->degenerate) found.certificate = {true, rounding_of_angle, Rung::exact};
    add(report, found, 1, poses);
  }
  const Verdict v = verdict(roots.what, poses, static_cast<int>(report.dyads.size()), family_type);
  report.status = v.status;
  report.message = v.message;
  report.counts = v.counts;
  if (certified) state_proof(*certified, report);
  state_merging(roots, poses, report);
  if (roots.indistinct) judge_indistinct(report);
  sort_dyads(report);
  return report;
}

}  // namespace

PlanarReport FivePoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 5);
  const FivePoses five = poses.first<5>();
  if (!certify) {
    FivePoseRoots<double> roots = five_pose_roots(five);
    roots.indistinct = roots.indistinct || !degenerate_within_rounding(roots.what, five, roots.anchor);
    return report_of(roots, five);
  }
  CertifiedRoots certified = certified_five_pose_roots(five);
  PlanarReport report = report_of(certified.roots, five, &certified);
  const bool wide = !all_certified(report) || radius_of(report) > largest_radius * task_size(five);
  if (wide && sharpen(five, certified)) return report_of(certified.roots, five, &certified);
  return report;
}

PlanarReport FivePoseOracle::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 5);
  const FivePoses five = poses.first<5>();
  return report_of(five_pose_roots_quad(five), five);
}

double task_size(std::span<const Pose> poses) {
  std::vector<Vector2> origins;
  for (const Pose& pose : poses) origins.emplace_back(pose.x, pose.y);
  const double size = diameter(std::move(origins));
  return size > 0 ? size : 1;
}

static_assert(Solver<FivePoseSolver> && Solver<FivePoseOracle>);

}  // namespace burmester::planar
