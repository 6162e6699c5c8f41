#include "burmester/planar/curve_linkages.hpp"

#include <algorithm>
#include <cmath>

#include "burmester/planar/linkage.hpp"

namespace burmester::planar {
namespace {

constexpr std::size_t most_dyads = 200;
constexpr double vertex_error = 1e-12;  // of the lengths: vertices of traced curves are concyclic to this

bool within(const PivotWindow& window, const Vector2& p) {
  return (p.array() >= window.low.array()).all() && (p.array() <= window.high.array()).all();
}

double cross(const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// How far apart two dyads are: the larger distance of their pivots.
double distance(const RR::Design& a, const RR::Design& b) {
  return std::max((a.fixed - b.fixed).norm(), (a.moving - b.moving).norm());
}

class Search {
 public:
  Search(FourPoses poses, const CurveLinkageOptions& options)
      : poses_(poses), options_(options), unit_(options.unit * task_size(poses)) {
    Vector2 centroid(0, 0);
    for (const Pose& p : poses) centroid += Vector2(p.x, p.y) / 4;
    const Vector2 half(2 * unit_, 2 * unit_);
    near_ = {centroid - half, centroid + half};
  }

  std::vector<CurveLinkage> run(std::span<const CurveRecord> curves) const {
    std::vector<RR::Design> dyads = thinned(curves, options_.spacing * unit_);
    for (double spacing = options_.spacing * unit_; dyads.size() > most_dyads;) dyads = thinned(curves, spacing *= 1.5);
    std::vector<CurveLinkage> all;
    for (std::size_t i = 0; i < dyads.size(); ++i)
      for (std::size_t j = i + 1; j < dyads.size(); ++j)
        if (auto linkage = linked(dyads[i], dyads[j])) all.push_back(std::move(*linkage));
    std::stable_sort(all.begin(), all.end(), [](const CurveLinkage& a, const CurveLinkage& b) {
      return a.one_branch != b.one_branch ? a.one_branch : a.link_ratio < b.link_ratio;
    });
    return different(all);
  }

 private:
  std::vector<RR::Design> thinned(std::span<const CurveRecord> curves, double spacing) const {
    std::vector<RR::Design> out;
    for (const CurveRecord& curve : curves)
      for (std::size_t k = 0; k < curve.moving.size(); ++k) {
        RR::Design d{{curve.fixed[k][0], curve.fixed[k][1]}, {curve.moving[k][0], curve.moving[k][1]}, 0};
        const Vector2 place = to_fixed(poses_[0], d.moving);
        d.length = (place - d.fixed).norm();
        if (!within(options_.fixed.value_or(near_), d.fixed)) continue;
        if (options_.moving ? !within(*options_.moving, d.moving) : !within(near_, place)) continue;
        if (out.empty() || distance(out.back(), d) >= spacing) out.push_back(d);
      }
    return out;
  }

  /// Nothing where a limit of the options is not kept.
  std::optional<CurveLinkage> linked(const RR::Design& a, const RR::Design& b) const {
    const double ground = (a.fixed - b.fixed).norm(), coupler = (a.moving - b.moving).norm();
    const auto [shortest, longest] = std::minmax({ground, a.length, coupler, b.length});
    if (!(longest <= options_.largest_ratio * shortest)) return std::nullopt;
    const auto driven_at = [&](const RR::Design& first, const RR::Design& second) {
      const std::string motion_class = class_of(first, second);
      return CurveLinkage{first, second, motion_class, longest / shortest, passes(first, second, motion_class)};
    };
    CurveLinkage out = driven_at(a, b);
    if (wanted(out) && out.one_branch) return out;
    CurveLinkage other = driven_at(b, a);
    if (wanted(other) && (other.one_branch || !wanted(out))) out = std::move(other);
    return wanted(out) ? std::optional(std::move(out)) : std::nullopt;
  }
  bool wanted(const CurveLinkage& linkage) const {
    const auto& classes = options_.classes;
    return classes.empty() || std::ranges::find(classes, linkage.motion_class) != classes.end();
  }

  static std::string class_of(const RR::Design& a, const RR::Design& b) {
    const double ground = (a.fixed - b.fixed).norm(), coupler = (a.moving - b.moving).norm();
    return four_bar_class(ground, a.length, coupler, b.length, vertex_error * (ground + a.length + coupler + b.length));
  }

  /// Through all poses with the first dyad as driver.
  bool passes(const RR::Design& driver, const RR::Design& driven, const std::string& motion_class) const {
    if (motion_class == "change-point") return false;
    const bool two_ranges = motion_class == "rocker-crank" || motion_class == "double-rocker";
    return keeps_sign([&](const Pose& pose) {
             const Vector2 a = to_fixed(pose, driver.moving), b = to_fixed(pose, driven.moving);
             return cross(b - a, b - driven.fixed);
           }) &&
           (!two_ranges || keeps_sign([&](const Pose& pose) {
             return cross(driven.fixed - driver.fixed, to_fixed(pose, driver.moving) - driver.fixed);
           }));
  }
  template <class AtPose>
  bool keeps_sign(AtPose at) const {
    return std::ranges::all_of(poses_, [&](const Pose& pose) { return at(pose) * at(poses_[0]) > 0; });
  }

  std::vector<CurveLinkage> different(const std::vector<CurveLinkage>& ranked) const {
    std::vector<CurveLinkage> out;
    const auto close = [&](const CurveLinkage& a, const CurveLinkage& b) {
      const double same = std::max(distance(a.first, b.first), distance(a.second, b.second)),
                   swapped = std::max(distance(a.first, b.second), distance(a.second, b.first));
      return std::min(same, swapped) < options_.apart * unit_;
    };
    for (const CurveLinkage& linkage : ranked) {
      if (out.size() == options_.wanted) break;
      if (std::ranges::none_of(out, [&](const CurveLinkage& other) { return close(linkage, other); }))
        out.push_back(linkage);
    }
    return out;
  }

  FourPoses poses_;
  const CurveLinkageOptions& options_;
  double unit_;
  PivotWindow near_;
};

}  // namespace

std::vector<CurveLinkage> linkages_from_curves(FourPoses poses, std::span<const CurveRecord> curves,
                                               const CurveLinkageOptions& options) {
  return Search(poses, options).run(curves);
}

std::vector<CandidateRecord> candidates_of(FourPoses poses, std::span<const CurveRecord> curves,
                                           const CurveLinkageOptions& options) {
  std::vector<CandidateRecord> out;
  for (const CurveLinkage& found : linkages_from_curves(poses, curves, options)) {
    PlanarReport pair;
    for (const RR::Design& d : {found.first, found.second})
      pair.dyads.push_back({d, largest_residual<RR>(d, poses), {}, {}, {}, {}});
    const std::vector<DyadRecord> dyads = records_of(pair);
    out.push_back(
        {{dyads[0], dyads[1]}, linkages_of(pair.dyads, task_size(poses))[0], found.link_ratio, found.one_branch});
  }
  return out;
}

}  // namespace burmester::planar
