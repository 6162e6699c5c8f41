#include "report/sphere_figure.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "report/figure.hpp"
#include "report/globe.hpp"
#include "report/label_places.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

constexpr std::string_view task_colour = "#e69f00", task_ink = "#8a5f00", body_colour = "#c1121f",
                           dyad_colours[] = {"#0072b2", "#009e73"};
constexpr double pitch = 2.48;  // between the centres of neighbouring views; the sphere's radius is 1

struct Style {
  std::string_view colour;
  double width;
  double opacity = 1;
  std::string_view dashes = "";
};

class Sheet {
 public:
  Sheet(const SphereDrawing& drawing, std::string_view title)
      : drawing_(drawing), svg_({-0.95, -1.56 - pitch * (rows() - 1), 0.95 + pitch, 0.92}, title) {}

  std::string draw() {
    for (std::size_t v = 0; v < drawing_.views.size(); ++v) {
      view_ = &drawing_.views[v];
      centre_ = {pitch * static_cast<double>(v % 2), -pitch * static_cast<double>(v / 2)};
      panel();
    }
    legend();
    return svg_.finish();
  }

 private:
  double rows() const { return static_cast<double>((drawing_.views.size() + 1) / 2); }

  Point2 at(const Point2& p) const { return svg_.place({centre_[0] + p[0], centre_[1] + p[1]}); }
  Point2 seen(const std::array<double, 3>& p) const { return at(projected(*view_, p)); }

  void panel() {
    labels_ = {};
    const Point2 caption = at({0, -1.18});
    for (const double shift : {-50, -25, 0, 25, 50}) labels_.avoid({caption[0] + shift, caption[1] - 4}, 4);
    globe();
    for (const bool near : {false, true}) {
      for (const std::string_view role : {"moving_curve", "fixed_curve", "guide", "ground", "path"}) lines(role, near);
      for (const bool first : {false, true})
        for (const std::string_view role : {"coupler", "link", "block"}) lines(role, near, first);
      frames("task", near);
      frames("body", near);
      pins("moving_axis", near);
      pins("fixed_axis", near);
    }
    names();
    svg_.text(caption, view_->name, fmt::format("text-anchor=\"middle\" fill=\"{}\" font-style=\"italic\"", soft_ink));
  }

  void globe() {
    svg_.circle(at({0, 0}), svg_.scale(), fmt::format("fill=\"#fbfbf8\" stroke=\"{}\" stroke-width=\"1.1\"", soft_ink));
    for (const auto& line : graticule())
      for (const GlobeRun& run : runs_of(*view_, line, false))
        if (run.near) svg_.polyline(placed(run), false, "fill=\"none\" stroke=\"#e3e3dc\" stroke-width=\"0.8\"");
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> tip{};
      tip[static_cast<std::size_t>(k)] = 1;
      if (!is_near(*view_, tip)) continue;
      svg_.circle(seen(tip), 1.6, "fill=\"#8d959f\"");
      labels_.avoid(seen(tip), 1);
    }
  }

  Polyline placed(const GlobeRun& run) const {
    Polyline out;
    for (const Point2& p : run.points) out.push_back(at(p));
    return out;
  }

  std::string_view dyad_colour(int dyad) const {
    int first = 0;
    for (const SphereStroke& s : drawing_.strokes)
      if (s.role == "fixed_axis" && first == 0) first = s.dyad;
    return dyad_colours[dyad == first ? 0 : 1];
  }

  Style style_of(const SphereStroke& s) const {
    const bool first = s.pose <= 1;
    if (s.role == "link") return {dyad_colour(s.dyad), first ? 4.2 : 1.4, first ? 1 : 0.75};
    if (s.role == "block") return {dyad_colour(s.dyad), first ? 2.2 : 1.2};
    if (s.role == "guide") return {dyad_colour(s.dyad), 1.6};
    if (s.role == "coupler") return {body_colour, first ? 2 : 0.8, first ? 1 : 0.6};
    if (s.role == "ground") return {soft_ink, 1.6, 1, "10 3 2 3"};
    if (s.role == "path") return {body_colour, 1, 0.9, "1.5 3"};
    return {s.role == "fixed_curve" ? ink : body_colour, 1.5};
  }

  void lines(std::string_view role, bool near) {
    for (const SphereStroke& s : drawing_.strokes)
      if (s.role == role) line(s, near);
  }
  void lines(std::string_view role, bool near, bool first_pose) {
    for (const SphereStroke& s : drawing_.strokes)
      if (s.role == role && (s.pose <= 1) == first_pose) line(s, near);
  }

  void line(const SphereStroke& s, bool near) {
    const Style style = style_of(s);
    for (const GlobeRun& run : runs_of(*view_, s.points, s.closed)) {
      if (run.near != near) continue;
      const Polyline points = placed(run);
      const std::string_view dashes = near ? style.dashes : "3 4";
      svg_.polyline(points, false,
                    fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.3g}\" stroke-opacity=\"{:.2g}\" "
                                "stroke-linejoin=\"round\" stroke-linecap=\"{}\"{}",
                                s.role == "block" && near ? "#fff" : "none", style.colour,
                                near ? style.width : std::min(style.width, 1.6), style.opacity * (near ? 1 : 0.35),
                                near && dashes.empty() ? "round" : "butt",
                                dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dashes)));
      if (near)
        for (std::size_t i = 0; i < points.size(); i += 2) labels_.avoid(points[i], s.pose <= 1 ? 0.6 : 0.25);
    }
  }

  /// Two arrows from the x axis; on the far side thin lines.
  void frames(std::string_view role, bool near) {
    const bool task = role == "task";
    const std::string_view colour = task ? task_colour : body_colour;
    for (const SphereStroke& s : drawing_.strokes) {
      if (s.role != role || s.points.size() != 3 || is_near(*view_, s.points[1]) != near) continue;
      const Point2 o = seen(s.points[1]);
      for (const std::size_t k : {0u, 2u}) {
        const Point2 tip = seen(s.points[k]);
        if (near && task)
          svg_.polyline(
              {o, tip}, false,
              fmt::format("stroke=\"{}\" stroke-width=\"7\" stroke-opacity=\"0.75\" stroke-linecap=\"round\"", colour));
        if (near && (!task || !has("body"))) arm(o, tip, task ? task_ink : colour, k == 2);
        if (!near)
          svg_.polyline({o, tip}, false,
                        fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"0.4\"", colour, task ? 4 : 1));
        if (near) labels_.avoid(tip, 2), labels_.avoid({(o[0] + tip[0]) / 2, (o[1] + tip[1]) / 2}, 2);
      }
      if (near) svg_.circle(o, task ? 4.5 : 2.4, fmt::format("fill=\"{}\"", colour)), labels_.avoid(o, 3);
    }
  }

  void arm(const Point2& o, const Point2& tip, std::string_view colour, bool open) {
    const double length = std::hypot(tip[0] - o[0], tip[1] - o[1]);
    if (length > 9)
      svg_.arrow(o, {(tip[0] - o[0]) / length, (tip[1] - o[1]) / length}, length, colour, open);
    else
      svg_.polyline({o, tip}, false, fmt::format("stroke=\"{}\" stroke-width=\"1.7\"", colour));
  }

  void pins(std::string_view role, bool near) {
    const bool fixed = role == "fixed_axis";
    for (const SphereStroke& s : drawing_.strokes) {
      if (s.role != role || s.points.empty() || is_near(*view_, s.points[0]) != near) continue;
      const Point2 p = seen(s.points[0]);
      const double radius = fixed ? 5 : s.pose <= 1 ? 4 : 2.4;
      const std::string_view colour = dyad_colour(s.dyad);
      svg_.circle(p, radius,
                  fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\" opacity=\"{}\"", fixed ? colour : "#fff",
                              fixed ? ink : colour, fixed || s.pose <= 1 ? 1.6 : 1.2, near ? 1 : 0.35));
      if (near) labels_.avoid(p, s.pose <= 1 ? 3 : 1);
    }
  }

  /// Names of what is on the near side: axes first, then attitudes, then the fixed frame.
  void names() {
    for (const std::string_view role : {"fixed_axis", "moving_axis", "task"})
      for (const SphereStroke& s : drawing_.strokes) {
        const std::size_t k = role == "task" ? 1 : 0;
        if (s.role != role || s.label.empty() || s.points.size() <= k || !is_near(*view_, s.points[k])) continue;
        if (role == "moving_axis" && s.pose > 1) continue;
        name(s.label, seen(s.points[k]), role == "task" ? task_ink : ink);
      }
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> tip{};
      tip[static_cast<std::size_t>(k)] = 1;
      if (is_near(*view_, tip)) name(std::string(1, "xyz"[k]), seen(tip), "#8d959f");
    }
  }
  void name(const std::string& label, const Point2& p, std::string_view colour) {
    const Point2 at = labels_.place(p, 4.0 * static_cast<double>(label.size()));
    const bool number = label[0] >= '0' && label[0] <= '9';
    const std::string attributes = fmt::format("text-anchor=\"middle\" fill=\"{}\"", colour);
    if (number)
      svg_.text({at[0], at[1] + 4.5}, label, attributes + " font-weight=\"600\"");
    else
      svg_.label({at[0], at[1] + 4.5}, label, attributes + " font-style=\"italic\"");
  }

  // ---- legend
  bool has(std::string_view role) const {
    return std::any_of(drawing_.strokes.begin(), drawing_.strokes.end(),
                       [&](const SphereStroke& s) { return s.role == role; });
  }

  void legend() {
    const double top = svg_.place({0, -pitch * (rows() - 1) - 1.34})[1];
    Point2 p{30, top};
    const auto entry = [&](double width, std::string_view words) {
      svg_.text({p[0] + 36, p[1] + 4}, words, fmt::format("font-size=\"12\" fill=\"{}\"", ink));
      p[0] += width;
      if (p[0] > svg_.width() - 150) p = {30, p[1] + 22};
    };
    const auto sample = [&](std::string_view colour, double width, std::string_view dashes) {
      svg_.polyline({{p[0], p[1]}, {p[0] + 28, p[1]}}, false,
                    fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"", colour, width, dashes));
    };
    svg_.polyline(
        {{p[0] + 4, p[1]}, {p[0] + 26, p[1]}}, false,
        fmt::format("stroke=\"{}\" stroke-width=\"7\" stroke-opacity=\"0.75\" stroke-linecap=\"round\"", task_colour));
    entry(150, "task attitude");
    if (has("body")) {
      svg_.arrow({p[0] + 2, p[1]}, {1, 0}, 26, body_colour, false);
      entry(175, "coupler and attitude");
    }
    if (has("path")) sample(body_colour, 1.2, "1.5 3"), entry(205, "path of the moving x axis");
    for (const SphereStroke& s : drawing_.strokes)
      if (s.role == "fixed_axis") sample(dyad_colour(s.dyad), 4, ""), entry(110, fmt::format("dyad {}", s.dyad));
    if (has("ground")) sample(soft_ink, 1.6, "10 3 2 3"), entry(110, "ground");
    if (has("fixed_curve")) sample(ink, 1.5, ""), entry(170, "curve of fixed axes");
    if (has("moving_curve")) sample(body_colour, 1.5, ""), entry(250, "curve of moving axes, in pose 1");
    sample("#8d959f", 1.4, "3 4");
    entry(120, "far side");
  }

  const SphereDrawing& drawing_;
  Svg svg_;
  const SphereView* view_ = nullptr;
  Point2 centre_{};
  LabelPlaces labels_;
};

}  // namespace

std::string sphere_figure(const SphereDrawing& drawing, const std::string& task) {
  const std::string what = drawing.linkage == 0 ? "Task attitudes" : fmt::format("Linkage {}", drawing.linkage);
  return Sheet(drawing, task.empty() ? what : what + " · " + task).draw();
}

}  // namespace burmester
