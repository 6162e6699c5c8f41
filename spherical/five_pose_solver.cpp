#include "burmester/spherical/five_pose_solver.hpp"

#include <fmt/format.h>

#include <cassert>
#include <numbers>

#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/equal_poses.hpp"
#include "burmester/spherical/family.hpp"
#include "burmester/spherical/five_pose_roots.hpp"

namespace burmester::spherical {
namespace {

/// At a distance x of the poses from those where two dyads coincide the conditions of the two are about 1 / sqrt(x):
/// 2^22 says that a change of the poses by some hundred unit roundoffs can make them coincide.
constexpr double merging_condition = 0x1p22;
constexpr const char* merging_warning =
    "two dyads coincide within rounding of the poses: the number of real dyads may be off by two";

std::string name_degeneracy(FivePoseCase what, std::span<const Pose> poses) {
  switch (what) {
    case FivePoseCase::equal_poses:
      return name_equal_poses([&](int i, int j) {
        return same_orientation(poses[static_cast<std::size_t>(i)], poses[static_cast<std::size_t>(j)]);
      });
    case FivePoseCase::common_axis:
      return "all rotations from one orientation to another have one axis: every moving axis keeps its angle from it, "
             "and the moving axis that coincides with it keeps its angle from every fixed axis";
    case FivePoseCase::rank_deficient:
      return "the five orientations give fewer than four independent conditions: infinitely many dyads";
    default:
      return "infinitely many dyads: the four conditions are independent, but share a curve of dyads";
  }
}

SphericalReport degenerate(std::string message) {
  SphericalReport report;
  report.status = Status::degenerate;
  report.message = std::move(message);
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
  SphericalReport report;
  for (const RR::Design& dyad : real) report.dyads.push_back(found_dyad(dyad, poses));
  const int count = static_cast<int>(real.size());
  report.status = count > 0 ? Status::exact : Status::none;
  report.counts = {0, 6, count, false};
  report.message = count > 0 ? fmt::format("{} real dyad{} of 6 over the complex numbers", count, count == 1 ? "" : "s")
                             : "no real dyad exists: all 6 are complex";
  sort_dyads(report);
  return report;
}

SphericalReport FivePoseSolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 5);
  const FivePoses five = poses.first<5>();
  const FivePoseRoots roots = five_pose_roots(five);
  if (roots.what != FivePoseCase::regular) return degenerate(name_degeneracy(roots.what, poses));
  // The sextic may have six roots where there are infinitely many dyads (one moving axis for a plane of fixed ones).
  if (roots.path == FivePosePath::sextic && !detail::action_of(roots.equations))
    return degenerate(name_degeneracy(FivePoseCase::infinite, poses));
  if (roots.indistinct)
    return degenerate(
        "not decided: two orientations, or the axes of all rotations, agree to within rounding of the data");
  std::vector<RR::Design> real;
  for (int i = 0; i < roots.count; ++i)
    real.push_back(dyad_of(roots.equations, roots.root[static_cast<std::size_t>(i)], five));
  SphericalReport report = report_of(real, poses);
  bool merging = roots.merging;
  for (const auto& found : report.dyads) merging = merging || !(found.condition.value_or(0) < merging_condition);
  if (merging) report.warnings.push_back(merging_warning);
  return report;
}

static_assert(Solver<FivePoseSolver>);

}  // namespace burmester::spherical
