#include "burmester/planar/drawing/construction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/pivots.hpp"

namespace burmester::planar {
namespace {

std::array<double, 2> pair_of(const Vector2& p) { return {p[0], p[1]}; }
Vector2 across(const Vector2& v) { return {-v[1], v[0]}; }

class Construction {
 public:
  Construction(std::span<const Pose> poses, const Vector2& given, const std::optional<Vector2>& moving)
      : poses_(poses), given_(given), moving_(moving), arrow_(0.3 * task_size(poses)) {}

  Plate inversion(int number) const {
    Sheet sheet = start("inversion", number);
    sheet.drawing.caption =
        "M2 and M3: the given pivot M carried along when poses 2 and 3 are laid on pose 1. The moving pivot in pose 1, "
        "A1, is where the perpendicular bisectors meet.";
    for (std::size_t j = 1; j < 3; ++j) {
      sheet.add("chord", j + 1, {given_, image(j)});
      bisector(sheet, j + 1, given_, image(j));
    }
    sheet.add("chord", 0, {image(1), image(2)});
    bisector(sheet, 0, image(1), image(2));
    if (moving_) sheet.add("circle", 1, arc(place(0), given_, 2 * std::numbers::pi));
    finish(sheet);
    for (std::size_t j = 0; moving_ && j < 3; ++j) {
      sheet.add("link", j + 1, {given_, place(j)});
      constructed(sheet, j);
    }
    if (moving_) sheet.add("circle", 0, arc(given_, place(0), 2 * std::numbers::pi));
    return frame_up(sheet);
  }

  Plate poles(int number) const {
    Sheet sheet = start("poles", number);
    sheet.drawing.caption =
        "P12 and P13: where the bisectors of the paths of an arrow's tail and tip meet. M turned back about them comes "
        "to "
        "M2 and M3; the bisectors of M M2 and M M3 pass through the poles and meet in the moving pivot A1. P'23, the "
        "image "
        "pole: the point of the body at the pole of poses 2 and 3, as it lies in pose 1; M2 turned about it comes to "
        "M3.";
    for (std::size_t j = 1; j < 3; ++j) turn_back(sheet, j);
    if (const auto pole = Pivots::pole_of(poses_[1], poses_[2]); pole && !pole->far) {
      const Vector2 at = to_fixed(poses_[0], Vector2(pole->moving[0], pole->moving[1]));
      sheet.add("arc", 0, arc(at, image(1), -pole->angle));
      sheet.add("pole", 0, {at}, "P'23");
      bisector(sheet, 0, image(1), image(2));
    }
    finish(sheet);
    if (moving_) sheet.add("link", 1, {given_, place(0)});
    if (moving_) constructed(sheet, 0);
    return frame_up(sheet);
  }

  /// Step by step, as MECH 576 has it: inversion with each pose, one pole, the moving pivot's travel, the dyad.
  /// Precondition: a moving pivot.
  Plate panels(int number) const {
    Plate out = start("steps", number).drawing;
    out.title = fmt::format("Three poses, fixed pivot {}: step by step", number);
    out.caption =
        "Above: M carried along when the other poses are laid on pose 1, 2 and 3; the bisectors meet in the moving "
        "pivot in that pose. Below: M2 by a turn about the pole of poses 1 and 2; the moving pivot's travel about M; "
        "the dyad, whose second link is the same triangle with the arrow in all poses.";
    out.parts.clear(), out.lines.clear();
    for (std::size_t k = 0; k < 3; ++k) out.panels.push_back(inverted(k));
    out.panels.push_back(turned_back());
    out.panels.push_back(travel());
    out.panels.push_back(dyad());
    out.window = out.panels[0].window;
    for (const Plate& p : out.panels)
      for (std::size_t i = 0; i < 4; ++i)
        out.window[i] = i < 2 ? std::min(out.window[i], p.window[i]) : std::max(out.window[i], p.window[i]);
    for (Plate& p : out.panels) p.window = out.window;
    return out;
  }

 private:
  struct Sheet {
    Plate drawing;
    void add(const char* role, std::size_t pose, const std::vector<Vector2>& points, const std::string& label = "") {
      drawing.parts.push_back({role, label, std::string_view(role) == "circle", static_cast<int>(pose)});
      drawing.lines.emplace_back();
      for (const Vector2& p : points) drawing.lines.back().push_back(pair_of(p));
    }
  };

  /// M seen from the body in pose j, placed with the body in pose k.
  Vector2 image(std::size_t j, std::size_t k = 0) const { return to_fixed(poses_[k], to_moving(poses_[j], given_)); }
  Vector2 place(std::size_t j) const { return to_fixed(poses_[j], *moving_); }

  static std::vector<Vector2> arc(const Vector2& centre, const Vector2& from, double angle) {
    constexpr int steps = 120;
    std::vector<Vector2> out;
    for (int k = 0; k <= steps; ++k) {
      const double t = angle * k / steps;
      const Vector2 r = from - centre;
      out.push_back(centre + std::cos(t) * r + std::sin(t) * across(r));
    }
    return out;
  }

  static void bisector(Sheet& sheet, std::size_t pose, const Vector2& a, const Vector2& b) {
    const Vector2 middle = (a + b) / 2;
    sheet.add("bisector", pose, {middle, middle + across(b - a)});
  }

  /// The pole of poses 1 and j + 1 from the paths of the arrow's tail and tip, and M turned back about it.
  void turn_back(Sheet& sheet, std::size_t j) const {
    for (const double tip : {0.0, arrow_}) {
      const Vector2 from = to_fixed(poses_[0], {tip, 0}), to = to_fixed(poses_[j], {tip, 0});
      sheet.add("chord", j + 1, {from, to});
      bisector(sheet, j + 1, from, to);
    }
    const auto pole = Pivots::pole_of(poses_[0], poses_[j]);
    if (pole && !pole->far) {
      const Vector2 at(pole->fixed[0], pole->fixed[1]);
      sheet.add("arc", j + 1, arc(at, given_, -pole->angle));
      sheet.add("pole", j + 1, {at}, fmt::format("P1{}", j + 1));
    }
    bisector(sheet, 0, given_, image(j));
  }

  Plate inverted(std::size_t k) const {
    Sheet sheet = titled(fmt::format("Other poses laid on pose {}", k + 1));
    for (std::size_t j = 0; j < 3; ++j) {
      if (j == k) continue;
      sheet.add("chord", j + 1, {given_, image(j, k)});
      bisector(sheet, j + 1, given_, image(j, k));
      sheet.add("image", j + 1, {image(j, k)}, fmt::format("M{}", j + 1));
    }
    sheet.add("circle", k + 1, arc(place(k), given_, 2 * std::numbers::pi));
    constructed(sheet, k);
    return frame_up(sheet);
  }
  Plate turned_back() const {
    Sheet sheet = titled("Pole of poses 1 and 2");
    turn_back(sheet, 1);
    sheet.add("chord", 2, {given_, image(1)});
    sheet.add("image", 2, {image(1)}, "M2");
    constructed(sheet, 0);
    return frame_up(sheet);
  }
  Plate travel() const {
    Sheet sheet = titled("Travel of the moving pivot");
    sheet.add("circle", 0, arc(given_, place(0), 2 * std::numbers::pi));
    for (std::size_t j = 0; j < 3; ++j) constructed(sheet, j);
    return frame_up(sheet);
  }
  Plate dyad() const {
    Sheet sheet = titled("The dyad in the three poses");
    for (std::size_t j = 0; j < 3; ++j) {
      sheet.add("link", j + 1, {given_, place(j), {poses_[j].x, poses_[j].y}});
      constructed(sheet, j);
    }
    return frame_up(sheet);
  }
  /// The moving pivot in pose j + 1.
  void constructed(Sheet& sheet, std::size_t j) const {
    sheet.add("constructed", j + 1, {place(j)}, fmt::format("A{}", j + 1));
  }

  Sheet titled(const std::string& title) const {
    Sheet sheet = start("", 0);
    sheet.drawing.title = title;
    sheet.add("given", 0, {given_}, "M");
    return sheet;
  }
  Sheet start(const std::string& method, int number) const {
    Sheet sheet;
    sheet.drawing.name = fmt::format("construction_{}_{}", number, method);
    sheet.drawing.title = fmt::format("Three poses, fixed pivot {}: by {}", number, method);
    for (std::size_t j = 0; j < 3; ++j)
      sheet.add("frame", j + 1,
                {to_fixed(poses_[j], {arrow_, 0}), to_fixed(poses_[j], {0, 0}), to_fixed(poses_[j], {0, arrow_ / 2})},
                std::to_string(j + 1));
    return sheet;
  }

  void finish(Sheet& sheet) const {
    for (std::size_t j = 1; j < 3; ++j) sheet.add("image", j + 1, {image(j)}, fmt::format("M{}", j + 1));
    sheet.add("given", 0, {given_}, "M");
  }

  /// All points but those more than a task size and a half beyond the others; lines and circles run out of the picture.
  Plate frame_up(Sheet& sheet) const {
    if (!moving_)
      sheet.drawing.caption +=
          " Here the bisectors with M are parallel: the moving pivot is at infinity, the dyad an RP.";
    std::vector<Vector2> core, all;
    for (std::size_t k = 0; k < sheet.drawing.parts.size(); ++k) {
      const std::string& role = sheet.drawing.parts[k].role;
      if (role == "bisector" || role == "circle" || role == "arc" || role == "chord") continue;
      for (const auto& p : sheet.drawing.lines[k])
        (role == "frame" || role == "given" ? core : all).push_back({p[0], p[1]});
    }
    const auto box = [](const std::vector<Vector2>& points) {
      std::pair<Vector2, Vector2> out{points[0], points[0]};
      for (const Vector2& p : points) out = {out.first.cwiseMin(p), out.second.cwiseMax(p)};
      return out;
    };
    const auto [low, high] = box(core);
    const double reach = 1.5 * (high - low).maxCoeff();
    for (const Vector2& p : all)
      if (((p - low).array() > -reach).all() && ((high - p).array() > -reach).all()) core.push_back(p);
    const auto [left, right] = box(core);
    const double margin = 0.05 * (right - left).maxCoeff();
    sheet.drawing.window = {left[0] - margin, left[1] - margin, right[0] + margin, right[1] + margin};
    return std::move(sheet.drawing);
  }

  std::span<const Pose> poses_;
  Vector2 given_;
  std::optional<Vector2> moving_;
  double arrow_;
};

}  // namespace

std::vector<Plate> three_pose_constructions(std::span<const Pose> poses, const Dyads::Design& dyad,
                                                          int number) {
  std::vector<Plate> out;
  const auto draw = [&](const Vector2& given, const std::optional<Vector2>& moving) {
    const Construction construction(poses, given, moving);
    out.push_back(construction.inversion(number));
    out.push_back(construction.poles(number));
    if (moving) out.push_back(construction.panels(number));
  };
  if (const auto* rr = std::get_if<RR::Design>(&dyad)) draw(rr->fixed, rr->moving);
  if (const auto* rp = std::get_if<RP::Design>(&dyad)) draw(rp->fixed, std::nullopt);
  return out;
}

}  // namespace burmester::planar
