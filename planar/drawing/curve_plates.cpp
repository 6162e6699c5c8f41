#include "burmester/planar/drawing/curve_plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "burmester/planar/dyad_form.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

std::array<double, 2> pair_of(const Vector2& p) { return {p[0], p[1]}; }
std::array<double, 2> pair_of(Complex z) { return {z.real(), z.imag()}; }
Vector2 vector_of(std::span<const double> p) { return {p[0], p[1]}; }

/// A plate in the making, and the box that its window is made of.
class Sheet {
 public:
  Sheet(const std::string& name, const std::string& title, const std::string& caption) {
    plate_.name = name, plate_.title = title, plate_.caption = caption;
  }
  void add(const std::string& role, const std::string& label, Polyline line, int style = 0, bool closed = false) {
    plate_.parts.push_back({role, label, closed, style});
    plate_.lines.push_back(std::move(line));
  }
  void show(const std::array<double, 2>& p) {
    for (std::size_t k = 0; k < 2; ++k) low_[k] = std::min(low_[k], p[k]), high_[k] = std::max(high_[k], p[k]);
  }
  void show(const Polyline& line) {
    for (const auto& p : line) show(p);
  }
  Plate finished(double margin) {
    const double grow = margin * std::max(high_[0] - low_[0], high_[1] - low_[1]);
    plate_.window = {low_[0] - grow, low_[1] - grow, high_[0] + grow, high_[1] + grow};
    return std::move(plate_);
  }

 private:
  Plate plate_;
  std::array<double, 2> low_{1e300, 1e300}, high_{-1e300, -1e300};
};

class Plates {
 public:
  /// Windows hold the poles within two `reach` of the poses.
  Plates(FourPoses poses, double reach) : poses_(poses), size_(task_size(poses)), reach_(reach), centre_(0, 0) {
    for (const Pose& p : poses) centre_ += Vector2(p.x, p.y) / 4;
  }

  Plate curves(const char* name, const char* title, const std::vector<CurveRecord>& curves,
               const std::vector<CandidateRecord>& candidates) const {
    Sheet sheet(name, title, "circles: circle points (body in pose 1); stars: centre points; squares: poles");
    for (const CurveRecord& c : curves) {
      Polyline moving, fixed;
      for (const auto& m : c.moving) moving.push_back(pair_of(to_fixed(poses_[0], vector_of(m))));
      for (const auto& f : c.fixed) fixed.push_back({f[0], f[1]});
      sheet.add("circle_points", "", std::move(moving), 0, c.closed);
      sheet.add("centre_points", "", std::move(fixed), 0, c.closed);
    }
    add_poses(sheet);
    add_poles(sheet);
    if (!candidates.empty()) add_linkage(sheet, candidates[0]);
    return sheet.finished(0.3);
  }

  Plate modes(const DyadForm& form) const {
    Sheet sheet("dyad_form", "Dyad form: K and M by assembly mode",
                "K circles, M stars; mode 1 blue and orange, mode -1 green and purple; diamonds: the modes meet");
    for (const DyadFormPiece& piece : form.sampled()) {
      Polyline moving, fixed;
      for (const Vector2& m : piece.moving) moving.push_back(pair_of(to_fixed(poses_[0], m)));
      for (const Vector2& f : piece.fixed) fixed.push_back(pair_of(f));
      const int style = piece.mode == 1 ? 0 : 1;
      sheet.add("circle_points", "", std::move(moving), style, piece.closed);
      sheet.add("centre_points", "", std::move(fixed), style, piece.closed);
    }
    for (const FreeRange& range : form.ranges())
      for (const double end : {range.middle - range.half, range.middle + range.half})
        if (const auto pair = range.full ? std::nullopt : form.at(end, 1)) {
          sheet.add("meeting", "K", {pair_of(to_fixed(poses_[0], pair->moving))});
          sheet.add("meeting", "M", {pair_of(pair->fixed)});
        }
    add_poses(sheet);
    add_poles(sheet);
    return sheet.finished(0.3);
  }

  /// Of one dyad: M at `fixed`, K at `moving` in E.
  Plate vectors(const Vector2& moving, const Vector2& fixed) const {
    Sheet sheet("vector_diagram", "Vector diagram of a dyad",
                "in each pose Z1 from M to K, Z2 from K to the body's origin; δj moves the origin");
    const auto origin = [&](std::size_t j) { return std::array{poses_[j].x, poses_[j].y}; };
    for (std::size_t j = 0; j < 4; ++j) {
      const auto joint = pair_of(to_fixed(poses_[j], moving));
      const int style = static_cast<int>(j);
      sheet.add("vector", j == 0 ? "Z1" : "", {pair_of(fixed), joint}, style);
      sheet.add("vector", j == 0 ? "Z2" : "", {joint, origin(j)}, style);
      if (j > 0) sheet.add("vector", fmt::format("δ{}", j + 1), {origin(0), origin(j)}, style);
      sheet.add("moving_pivot", fmt::format("K{}", j + 1), {joint});
      sheet.show(joint);
    }
    sheet.add("fixed_pivot", "M", {pair_of(fixed)});
    sheet.show(pair_of(fixed));
    add_poses(sheet);
    return sheet.finished(0.15);
  }

  Plate compatibility(const DyadForm& form) const {
    Sheet sheet(
        "compatibility_linkage", "Compatibility linkage",
        fmt::format("at one phi{}: mode 1 solid, mode -1 dashed; dotted: limits of the free link", form.free_pose()));
    const FreeRange& range = form.ranges()[0];
    const std::size_t first = static_cast<std::size_t>(form.free_pose()) - 1;
    if (!range.full)
      for (const double end : {range.middle - range.half, range.middle + range.half}) {
        const Complex from = form.delta()[0], to = from + form.delta()[first] * std::polar(1.0, end);
        sheet.add("limit", "", {pair_of(from), pair_of(to)});
        sheet.show(pair_of(to));
      }
    for (const int mode : {-1, 1})
      if (const auto pair = form.at(range.middle + 0.4 * range.half, mode)) {
        // The free link follows the frame: the order in which four vectors of sum zero are drawn is a choice.
        std::array<std::size_t, 4> order{0, first, 0, 0};
        for (std::size_t k = 1, n = 2; k < 4; ++k)
          if (k != first) order[n++] = k;
        Complex at = 0;
        for (const std::size_t k : order) {
          const Complex next = at + form.delta()[k] * (k == 0 ? 1.0 : std::polar(1.0, pair->phi[k - 1]));
          const Polyline bar{pair_of(at), pair_of(next)};
          sheet.add(k == 0 ? "frame_link" : "bar", fmt::format("Δ{}", k + 1), bar, mode == 1 ? 0 : 1);
          sheet.show(bar);
          at = next;
        }
      }
    return sheet.finished(0.1);
  }

  /// In which the linkage is of ordinary size, as CurveLinkageOptions::unit; 1 or more.
  double unit_of(const CandidateRecord& candidate) const {
    double farthest = 2 * size_;
    for (const DyadRecord& dyad : candidate.dyads)
      for (const Vector2& p : {vector_of(dyad.fixed), to_fixed(poses_[0], vector_of(dyad.moving))})
        farthest = std::max(farthest, (p - centre_).cwiseAbs().maxCoeff());
    return farthest / (2 * size_);
  }

 private:
  bool near(const Vector2& p) const { return (p - centre_).cwiseAbs().maxCoeff() < 2 * reach_; }

  void add_poses(Sheet& sheet) const {
    for (std::size_t j = 0; j < 4; ++j) {
      const Pose& p = poses_[j];
      const Vector2 origin(p.x, p.y), arm = rotated(p, {0.12 * size_, 0}), side = rotated(p, {0, 0.12 * size_});
      const Polyline frame{pair_of(origin + arm), pair_of(origin), pair_of(origin + side)};
      sheet.add("frame", std::to_string(j + 1), frame, static_cast<int>(j));
      sheet.show(frame);
    }
  }
  void add_poles(Sheet& sheet) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Point2<double> p = relative_pole(poses_[i], poses_[j]);
        const Vector2 pole = p.head<2>() / p[2];
        if (!pole.allFinite()) continue;  // of a translation
        sheet.add("pole", fmt::format("P{}{}", i + 1, j + 1), {pair_of(pole)});
        if (near(pole)) sheet.show(pair_of(pole));
      }
  }
  void add_linkage(Sheet& sheet, const CandidateRecord& candidate) const {
    std::array<Vector2, 2> fixed, moving;
    for (std::size_t k = 0; k < 2; ++k) {
      fixed[k] = vector_of(candidate.dyads[k].fixed);
      moving[k] = to_fixed(poses_[0], vector_of(candidate.dyads[k].moving));
    }
    sheet.add("coupler", "", {pair_of(moving[0]), pair_of(moving[1]), {poses_[0].x, poses_[0].y}}, 0, true);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string name = k == 0 ? "A" : "B";
      sheet.add("link", "", {pair_of(fixed[k]), pair_of(moving[k])});
      sheet.add("fixed_pivot", name + "0", {pair_of(fixed[k])});
      sheet.add("moving_pivot", name, {pair_of(moving[k])});
      sheet.show(pair_of(fixed[k])), sheet.show(pair_of(moving[k]));
    }
  }

  FourPoses poses_;
  double size_, reach_;
  Vector2 centre_;
};

}  // namespace

std::vector<Plate> four_pose_plates(FourPoses poses, const std::vector<CurveRecord>& curves,
                                    const std::vector<CandidateRecord>& candidates) {
  const Plates plates(poses, curve_scale(poses));
  const double unit = candidates.empty() ? 1 : plates.unit_of(candidates[0]);
  const bool linkage_is_small = !candidates.empty() && curves_are_far(poses, unit);
  std::vector<Plate> out;
  if (!curves.empty())
    out.push_back(plates.curves("curves", "Circle points and centre points", curves,
                                linkage_is_small ? std::vector<CandidateRecord>() : candidates));
  if (linkage_is_small)
    out.push_back(Plates(poses, unit * task_size(poses))
                      .curves("curves_near", "Circle points and centre points near the poses",
                              curves_near_poses(poses, unit), candidates));
  const DyadForm form(poses);
  if (!form.degeneracy().empty()) return out;
  out.push_back(plates.modes(form));
  out.push_back(plates.compatibility(form));
  if (!candidates.empty()) {
    const DyadRecord& dyad = candidates[0].dyads[0];
    out.push_back(plates.vectors(vector_of(dyad.moving), vector_of(dyad.fixed)));
  } else if (const FreeRange& range = form.ranges()[0]; const auto pair = form.at(range.middle + 0.4 * range.half, 1)) {
    out.push_back(plates.vectors(pair->moving, pair->fixed));
  }
  return out;
}

}  // namespace burmester::planar
