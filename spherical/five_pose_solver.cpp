#include "burmester/spherical/five_pose_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numbers>

#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/counted.hpp"
#include "burmester/spherical/exact_orientations.hpp"
#include "burmester/spherical/family.hpp"
#include "burmester/spherical/five_pose_certificate.hpp"
#include "burmester/spherical/five_pose_roots.hpp"

namespace burmester::spherical {
namespace {

/// At a distance x of the poses from those where two dyads coincide the conditions of the two are about 1 / sqrt(x):
/// 2^22 says that a change of the poses by some hundred unit roundoffs can make them coincide.
constexpr double merging_condition = 0x1p22;
constexpr const char* merging_warning =
    "two dyads coincide within rounding of the poses: the number of real dyads may be off by two";
constexpr const char* nearly_merging_warning =
    "two dyads nearly merge: a change of the poses by their rounding may make two dyads merge or appear";
constexpr const char* undecided_indistinct =
    "not decided: two orientations, or axes of the rotations between them, agree almost to within rounding of the data";
constexpr const char* undecided =
    "not decided: to within rounding the six dyads over the complex numbers cannot be told from infinitely many";
constexpr const char* indistinct_warning =
    "two orientations, or axes of the rotations between them, agree almost to within rounding: the answer holds for "
    "the doubles given";

SphericalReport degenerate(std::string message) {
  SphericalReport report;
  report.status = Status::degenerate;
  report.message = std::move(message);
  return report;
}

/// The report on poses with six dyads over the complex numbers, of which these are the real ones.
SphericalReport regular(std::vector<Found<Dyads::Design>> dyads) {
  SphericalReport report;
  const int count = static_cast<int>(dyads.size());
  report.dyads = std::move(dyads);
  report.status = count > 0 ? Status::exact : Status::none;
  report.counts = {0, 6, count, false};
  report.message = count > 0 ? counted(count, "real dyad") + " of 6 over the complex numbers"
                             : "no real dyad exists: all 6 are complex";
  sort_dyads(report);
  return report;
}

std::vector<RR::Design> dyads_of(const FivePoseRoots& roots, FivePoses poses) {
  std::vector<RR::Design> out;
  for (int i = 0; i < roots.count; ++i)
    out.push_back(dyad_of(roots.equations, roots.root[static_cast<std::size_t>(i)], poses));
  return out;
}

bool nearly_merge(const FivePoseRoots& roots, const SphericalReport& report) {
  return roots.merging || std::any_of(report.dyads.begin(), report.dyads.end(), [](const auto& found) {
           return !(found.condition.value_or(0) < merging_condition);
         });
}

// ---- With proof ----

/// Dyad i as it was found where intervals proved it, else as elimination gives it.
Found<Dyads::Design> certified_dyad(const CertifiedAxes& proved, std::size_t i, const std::vector<RR::Design>& real,
                                    FivePoses poses) {
  const Pose& reference = poses[static_cast<std::size_t>(proved.reference)];
  RR::Design dyad{proved.axes[i].fixed, proved.axes[i].moving, 0};
  dyad.arc = proved.boxes[i].rung == Rung::intervals ? real[i].arc : RR::residual(dyad, reference);
  auto found = found_dyad(dyad, poses);
  const double bound = error_bound(found.design, proved.boxes[i], reference);
  found.certificate = {std::isfinite(bound), bound, proved.boxes[i].rung};
  return found;
}

SphericalReport certified_report(const CertifiedAxes& proved, const std::vector<RR::Design>& real, FivePoses poses) {
  std::vector<Found<Dyads::Design>> dyads;
  double radius = 0;
  bool coincide = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(proved.count); ++i) {
    dyads.push_back(certified_dyad(proved, i, real, poses));
    radius = std::max(radius, dyads.back().certificate.radius);
    coincide = coincide || proved.boxes[i].multiplicity > 1;
  }
  SphericalReport report = regular(std::move(dyads));
  report.counts.certified = std::isfinite(radius);
  if (report.counts.certified)  // printed: never below the radius
    report.message +=
        report.dyads.empty() ? ", proved" : fmt::format(", proved complete, true to {:.0e}", 1.5 * radius);
  if (coincide) report.warnings.push_back("some of the dyads coincide: they count more than once among the 6");
  return report;
}

/// The verdict on orientations that are degenerate within rounding: proved of the doubles, or what is true of these.
SphericalReport judged_degenerate(Degeneracy what, const CertifiedAxes& proved, FivePoses poses) {
  SphericalReport report = degenerate(name_degeneracy(what, poses, same_orientation));
  report.counts.certified = proved.degeneracy != Degeneracy::none;
  if (report.counts.certified) {
    report.message = name_degeneracy(proved.degeneracy, poses, equal_exactly) +
                     (proved.isolated ? "; one dyad beside them" : "") + ", proved";
    if (proved.isolated) report.dyads.push_back(certified_dyad(proved, 0, {}, poses));
  } else if (proved.count >= 0)
    report.message +=
        fmt::format("; true within rounding, the doubles given have {}", counted(proved.count, "real dyad"));
  else
    report.message += ", within rounding";
  return report;
}

}  // namespace

Found<Dyads::Design> found_dyad(const RR::Design& dyad, std::span<const Pose> poses) {
  Found<Dyads::Design> found;
  const double departure = std::abs(dyad.arc - std::numbers::pi / 2);
  if (departure <= slider_arc_tolerance)
    found.design = PR::Design{dyad.fixed, dyad.moving}, found.departure = departure;
  else
    found.design = dyad;
  if (departure > slider_arc_tolerance && departure <= near_slider_departure)
    found.slider = SliderRecord{PR::name, std::nullopt, departure};
  found.condition = condition<RR>(dyad, poses);
  Dyads::visit(found.design,
               [&]<class D>(const typename D::Design& d) { found.residual = largest_residual<D>(d, poses); });
  return found;
}

SphericalReport report_of(const std::vector<RR::Design>& real, std::span<const Pose> poses) {
  std::vector<Found<Dyads::Design>> dyads;
  for (const RR::Design& dyad : real) dyads.push_back(found_dyad(dyad, poses));
  return regular(std::move(dyads));
}

SphericalReport FivePoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 5);
  const FivePoses five = poses.first<5>();
  const FivePoseRoots roots = five_pose_roots(five);
  const std::vector<RR::Design> real = dyads_of(roots, five);
  CertifiedAxes proved;
  if (certify) {
    std::vector<AxisPair> found;
    for (const RR::Design& dyad : real) found.push_back({dyad.moving, dyad.fixed});
    proved = certified_axes(five, found);
  }
  SphericalReport report = proved.complete ? certified_report(proved, real, five) : report_of(real, poses);
  const bool merging = nearly_merge(roots, report);
  // the sextic may have six roots where there are infinitely many dyads (one moving axis for a plane of fixed ones)
  const bool hidden =
      roots.what == Degeneracy::none && roots.path == FivePosePath::sextic && (merging || !proved.complete);
  const NearDegeneracy near = hidden ? axis_in_two_places(five) : NearDegeneracy{roots.what, 1};
  const Degeneracy what = near.kind;
  const bool indistinct = roots.indistinct || near.distance < indistinct_tolerance;
  if (what != Degeneracy::none || proved.degeneracy != Degeneracy::none)
    return certify
               ? judged_degenerate(what, proved, five)
               : degenerate(fmt::format("{}{}", name_degeneracy(what, poses, same_orientation),
                                        what >= Degeneracy::moving_on_circle ? " (any others are not listed)" : ""));
  if (!proved.complete && (indistinct || !roots.decided))
    return degenerate(indistinct ? undecided_indistinct : undecided);
  if (indistinct) report.warnings.push_back(indistinct_warning);
  if (proved.complete && proved.count != roots.count)
    report.warnings.push_back(
        fmt::format("{} proved, but {} found at first", counted(proved.count, "real dyad"), roots.count));
  if (merging) report.warnings.push_back(proved.complete ? nearly_merging_warning : merging_warning);
  return report;
}

static_assert(Solver<FivePoseSolver>);

}  // namespace burmester::spherical
