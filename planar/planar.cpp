#include "burmester/planar/planar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "burmester/modules/framework/condition.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/planar/curve_linkages.hpp"
#include "burmester/planar/double_slider.hpp"
#include "burmester/planar/drawing.hpp"
#include "burmester/planar/dyad_form.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "burmester/planar/linkage.hpp"
#include "burmester/planar/near_curve.hpp"
#include "burmester/planar/pivots.hpp"
#include "burmester/planar/pose_format.hpp"

namespace burmester::planar {
namespace {

ModuleInfo describe() {
  ModuleInfo info = built_in<Space, Dyads, FamilySolver, FourPoseSolver, DyadForm, FivePoseSolver>();
  info.csv_headers = {{"x", "y", "angle_deg"}, {"x", "y", "angle_rad"}};
  info.linkage_classes.assign(four_bar_classes.begin(), four_bar_classes.end());
  return info;
}

/// Dyad types without a lifted form are found by search; the direct solver does not know them.
template <class D>
constexpr bool searched = !LiftedDyadType<D>;

bool asked_for(const Problem& problem, std::string_view type) {
  return std::find(problem.types.begin(), problem.types.end(), type) != problem.types.end();
}

/// Adds what search finds of the types that are asked for by name and have no direct solver.
void add_searched(const Problem& problem, std::span<const Pose> poses, PlanarReport& report) {
  Dyads::for_each([&]<class D>() {
    if constexpr (searched<D>) {
      if (!asked_for(problem, D::name)) return;
      if (poses.size() < D::parameters)
        throw NotAvailable(fmt::format("{} dyads for fewer than {} poses", D::name, D::parameters));
      const auto found = search<D>(poses);
      for (const auto& f : found)
        report.dyads.push_back({f.design, f.residual, condition<D>(f.design, poses), {}, {}, {}});
      report.warnings.push_back(
          fmt::format("{} dyads were found by search: {} of them, there may be more", D::name, found.size()));
      if (!found.empty() && report.status == Status::none)
        report.status = poses.size() == D::parameters ? Status::exact : Status::approximate;
    }
  });
}

bool only_searched(const Problem& problem) {
  std::size_t known = 0;
  Dyads::for_each([&]<class D>() { known += searched<D> && asked_for(problem, D::name); });
  return known > 0 && known == problem.types.size();
}

CurveLinkageOptions options_of(const LinkageRequest& request) {
  CurveLinkageOptions out;
  const auto window = [](const LinkageRequest::Box& box) {
    return PivotWindow{{box.low[0], box.low[1]}, {box.high[0], box.high[1]}};
  };
  if (request.fixed_in) out.fixed = window(*request.fixed_in);
  if (request.moving_in) out.moving = window(*request.moving_in);
  out.classes = request.classes;
  out.largest_ratio = request.largest_ratio.value_or(out.largest_ratio);
  out.wanted = request.most.value_or(out.wanted);
  return out;
}

PlanarReport solve(const Problem& problem, std::span<const Pose> poses) {
  if (const double size = planar::task_size(poses); size < 1e-100)
    throw InputError(fmt::format("poses: expected origins that are equal or at least 1e-100 apart, got {}", size));
  expect_pivots<Pivots>("near", problem.near);
  PlanarReport report;
  const bool given = !problem.fixed.empty() || !problem.moving.empty();
  if (given) {
    report = GivenPivots<Pivots>(problem, poses).solve();
  } else if (only_searched(problem)) {
    report.message = "the types asked for are found by search, which is not complete";
    report.counts.dimension = 0;
  } else if (poses.size() == 5) {
    report = FivePoseSolver{.certify = problem.certify}.solve(poses);
  } else if (poses.size() == 4) {
    report = FourPoseSolver().solve(poses);
    add_near<Pivots>(dyads_near(std::span(poses).first<4>(), report.curves, problem.near, problem.certify), "points",
                     poses, report);
  } else if (poses.size() < 4) {
    report = FamilySolver{.units = problem.units}.solve(poses);
  } else {
    throw NotAvailable(fmt::format("planar synthesis for {} poses without given pivots", poses.size()));
  }
  if (!given && poses.size() < 5)
    if (const auto pp = double_slider(poses, problem.certify)) {
      report.dyads.push_back(*pp);
      report.message += "; all orientations are equal: a PP dyad";
    }
  for (std::string& warning : ignored_requests<Pivots>(problem)) report.warnings.push_back(std::move(warning));
  add_searched(problem, poses, report);
  sort_dyads(report);
  return report;
}

constexpr const char* no_linkage = "linkages: no two dyads of the curves as listed are as asked for";

void add_candidates(const Problem& problem, FourPoses poses, Synthesis& answer) {
  if (!problem.types.empty() && !asked_for(problem, RR::name)) {
    if (problem.linkages) answer.warnings.push_back("linkages: RR dyads are not asked for; ignored");
    return;
  }
  std::vector<CandidateRecord>& found = answer.candidates.emplace();
  if (answer.curves.empty()) {
    if (problem.linkages) answer.warnings.push_back(no_linkage);
    return;
  }
  CurveLinkageOptions options = options_of(problem.linkages.value_or(LinkageRequest{}));
  const bool boxed = options.fixed || options.moving;
  const double last = CurveOptions().window / 2 * curve_scale(poses) / task_size(poses);  // the boxes hold the window
  for (;; options.unit *= 2) {
    std::vector<CurveRecord> curves = answer.curves;
    if (curves_are_far(poses, options.unit))
      std::ranges::move(curves_near_poses(poses, options.unit), std::back_inserter(curves));
    found = candidates_of(poses, curves, options);
    if (boxed || found.size() >= options.wanted || options.unit >= last) break;
  }
  if (found.empty())
    answer.warnings.push_back(problem.linkages ? no_linkage : "no two dyads of the curves as listed make a four-bar");
  else if (found.size() < options.wanted)
    answer.warnings.push_back(fmt::format("linkages: only {} of {} found{}", found.size(), options.wanted,
                                          problem.linkages ? " that are as asked for" : ""));
  if (!found.empty() && options.unit > 1)
    answer.warnings.push_back(
        fmt::format("the four-bars listed have pivots up to {:.3g} task sizes away: fewer than {} are "
                    "nearer; linkages.fixed_in and linkages.moving_in set where",
                    2 * options.unit, options.wanted));
}

class PlanarModule final : public Module {
 public:
  const ModuleInfo& info() const override { return info_; }

  PoseData read_pose(const InputNode& node, const Units& units) const override {
    return planar::read_pose(node, units);
  }
  PoseData read_csv_pose(std::size_t header, const std::vector<double>& row) const override {
    return planar::read_csv_pose(header == 0, row);
  }
  std::vector<std::pair<std::string, double>> show_pose(const PoseData& data, const Units& units) const override {
    const double angle = angle_of(pose_of(data)), shown = units.degrees ? angle * 180 / std::numbers::pi : angle;
    return {{"x", data[0]},
            {"y", data[1]},
            {"angle", std::strtod(fmt::format("{:.15g}", shown).c_str(), nullptr)}};  // 9.58, as it was typed
  }
  double task_size(const Problem& problem) const override { return planar::task_size(poses_of(problem)); }

  Synthesis synthesize(const Problem& problem) const override {
    const std::vector<Pose> poses = poses_of(problem);
    const PlanarReport report = solve(problem, poses);
    Synthesis answer{report.status,
                     report.message,
                     report.counts,
                     records_of(report),
                     linkages_of(report.dyads, planar::task_size(poses)),
                     report.warnings,
                     report.curves,
                     report.family};
    if (poses.size() == 4 && problem.fixed.empty() && problem.moving.empty())
      add_candidates(problem, std::span(poses).first<4>(), answer);
    return answer;
  }
  Drawing draw(const Problem& problem, const Synthesis& answer) const override {
    return draw_synthesis(problem, answer);
  }

 private:
  ModuleInfo info_ = describe();
};

}  // namespace

std::unique_ptr<Module> make_module() { return std::make_unique<PlanarModule>(); }

}  // namespace burmester::planar
