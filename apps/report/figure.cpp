#include "report/figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/svg.hpp"

namespace burmester {
namespace {

double distance(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

std::string titled(const std::string& figure, const std::string& task) {
  return task.empty() ? figure : figure + " · " + task;
}

/// Length of a pose's arrows: half the usual gap to the next pose.
double arrow_length(const std::vector<Point2>& origins) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < std::min<std::size_t>(origins.size(), 200); ++i) {
    double nearest = 1e9;
    for (std::size_t j = 0; j < origins.size(); ++j)
      if (j != i) nearest = std::min(nearest, distance(origins[i], origins[j]));
    gaps.push_back(nearest);
  }
  if (gaps.empty()) return 40;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return std::clamp(0.45 * gaps[gaps.size() / 2], 18.0, 46.0);
}

/// One linkage on a sheet.
class Figure {
 public:
  Figure(const LinkageDrawing& linkage, const Drawing& drawing, std::string_view title)
      : linkage_(linkage), drawing_(drawing), svg_(window(linkage), title) {}

  std::string draw(const std::string& unit) {
    for (std::size_t k = 0; k < linkage_.parts.size(); ++k)
      if (linkage_.parts[k].role == "guide") guide(k);
    ground();
    for (const std::string_view role : {"coupler", "link", "block"})
      for (std::size_t i = 0; i < linkage_.at_pose.size(); ++i) bodies(role, i);
    for (std::size_t i = 0; i < linkage_.at_pose.size(); ++i) points(i);
    for (std::size_t k = 0; k < linkage_.parts.size(); ++k)
      if (linkage_.parts[k].role == "fixed_pivot") fixed_pivot(k);
    svg_.scale_bar(unit);
    return svg_.finish();
  }

 private:
  /// Guides run out of the figure and do not count.
  static std::array<double, 4> window(const LinkageDrawing& linkage) {
    std::vector<Point2> seen;
    for (const Snapshot& shot : linkage.at_pose)
      for (std::size_t k = 0; k < std::min(shot.size(), linkage.parts.size()); ++k)
        if (linkage.parts[k].role != "guide") seen.insert(seen.end(), shot[k].begin(), shot[k].end());
    return window_of(seen, 0.03);
  }

  /// Part k in pose i, on the sheet; empty where it has no points.
  Polyline placed(std::size_t k, std::size_t i) const {
    Polyline line;
    if (k < linkage_.at_pose[i].size())
      for (const Point2& p : linkage_.at_pose[i][k]) line.push_back(svg_.place(p));
    return line;
  }

  bool still(std::size_t k) const {
    for (std::size_t i = 1; i < linkage_.at_pose.size(); ++i)
      if (placed(k, i) != placed(k, 0)) return false;
    return true;
  }

  void guide(std::size_t k) {
    const bool fixed = still(k);
    for (std::size_t i = 0;
         i < (fixed ? std::min<std::size_t>(1, linkage_.at_pose.size()) : linkage_.at_pose.size()); ++i) {
      const Polyline line = placed(k, i);
      if (line.size() > 1) svg_.guide(line.front(), line.back(), fixed, fixed ? ink : pose_colour(i));
    }
  }

  void ground() {
    if (linkage_.at_pose.empty()) return;
    for (std::size_t k = 0; k < linkage_.parts.size(); ++k)
      if (linkage_.parts[k].role == "ground")
        svg_.polyline(placed(k, 0), false,
                      fmt::format("fill=\"none\" stroke=\"{}\" stroke-dasharray=\"12 4 2 4\"", soft_ink));
  }

  void bodies(std::string_view role, std::size_t i) {
    for (std::size_t k = 0; k < linkage_.parts.size(); ++k) {
      if (linkage_.parts[k].role != role) continue;
      Polyline line = placed(k, i);
      if (role == "block") grow(line);
      const bool closed = linkage_.parts[k].closed || role == "block";
      const std::string fill =
          role == "link" ? "fill=\"none\"" : fmt::format("fill=\"{}\" fill-opacity=\"0.10\"", pose_colour(i));
      svg_.polyline(
          line, closed,
          fmt::format(
              "{} stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" stroke-opacity=\"0.75\"", fill,
              pose_colour(i), role == "link" ? "2" : "1.6"));
    }
  }

  /// A slider's block is a symbol: between 10 and 20 pixels of half diagonal.
  static void grow(Polyline& line) {
    Point2 centre{};
    for (const Point2& p : line)
      centre = {centre[0] + p[0] / double(line.size()), centre[1] + p[1] / double(line.size())};
    double radius = 0;
    for (const Point2& p : line) radius = std::max(radius, distance(p, centre));
    if (!(radius > 0)) return;
    const double factor = std::clamp(radius, 10.0, 20.0) / radius;
    for (Point2& p : line)
      p = {centre[0] + factor * (p[0] - centre[0]), centre[1] + factor * (p[1] - centre[1])};
  }

  void points(std::size_t i) {
    const std::string label = i < drawing_.poses.size() ? drawing_.poses[i].label : fmt::format("{}", i + 1);
    for (std::size_t k = 0; k < linkage_.parts.size(); ++k) {
      const Polyline p = placed(k, i);
      if (linkage_.parts[k].role == "moving_pivot" && !p.empty())
        svg_.circle(p[0], 3, fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.6\"", pose_colour(i)));
      if (linkage_.parts[k].role == "frame" && p.size() > 2)
        svg_.frame(p[1], {p[0][0] - p[1][0], p[0][1] - p[1][1]}, {p[2][0] - p[1][0], p[2][1] - p[1][1]},
                   std::clamp(distance(p[0], p[1]), 14.0, 34.0), pose_colour(i), label);
    }
  }

  void fixed_pivot(std::size_t k) {
    if (linkage_.at_pose.empty()) return;
    const Polyline p = placed(k, 0);
    if (p.empty()) return;
    svg_.ground(p[0]);
    svg_.label({p[0][0] + 11, p[0][1] - 9}, linkage_.parts[k].label, fmt::format("fill=\"{}\"", ink));
  }

  const LinkageDrawing& linkage_;
  const Drawing& drawing_;
  Svg svg_;
};

/// One part of a construction: its line or symbol; the labels last.
class ConstructionFigure {
 public:
  ConstructionFigure(const Plate& drawing, std::string_view title, double sheet = 800)
      : drawing_(drawing), svg_(drawing.window, title, sheet) {}

  Svg draw(const std::string& unit) {
    for (const std::string_view role :
         {"circle", "bisector", "chord", "arc", "link", "frame", "image", "pole", "constructed", "given"})
      for (std::size_t k = 0; k < drawing_.parts.size(); ++k)
        if (drawing_.parts[k].role == role) part(drawing_.parts[k], placed(k));
    svg_.labels(labels_);
    svg_.scale_bar(unit);
    return svg_;
  }

 private:
  Polyline placed(std::size_t k) const {
    Polyline line;
    for (const Point2& p : drawing_.lines[k]) line.push_back(svg_.place(p));
    return line;
  }

  /// The straight line through two points, out of the sheet at both ends.
  Polyline endless(const Polyline& line) const {
    const Point2 d{line[1][0] - line[0][0], line[1][1] - line[0][1]};
    const double size = std::hypot(d[0], d[1]), far = size > 0 ? 4 * (svg_.width() + svg_.height()) / size : 0;
    return {{line[0][0] - far * d[0], line[0][1] - far * d[1]}, {line[0][0] + far * d[0], line[0][1] + far * d[1]}};
  }

  void part(const Part& part, const Polyline& line) {
    const std::string_view colour = part.dyad > 0 ? pose_colour(static_cast<std::size_t>(part.dyad) - 1) : soft_ink;
    const auto stroke = [&](const char* more) {
      return fmt::format("fill=\"none\" stroke=\"{}\" {}", colour, more);
    };
    if (part.role == "bisector") svg_.polyline(endless(line), false, stroke("stroke-dasharray=\"10 3 2 3\""));
    if (part.role == "chord") svg_.polyline(line, false, stroke("stroke-dasharray=\"3 3\""));
    if (part.role == "arc") svg_.polyline(line, false, stroke("stroke-width=\"1.4\""));
    if (part.role == "link") svg_.polyline(line, false, stroke("stroke-width=\"2.4\""));
    if (part.role == "circle") svg_.polyline(line, true, stroke("stroke-width=\"0.9\" stroke-opacity=\"0.7\""));
    if (part.role == "frame")
      svg_.frame(line[1], {line[0][0] - line[1][0], line[0][1] - line[1][1]},
                 {line[2][0] - line[1][0], line[2][1] - line[1][1]}, distance(line[0], line[1]), colour, part.label);
    if (part.role == "given") svg_.ground(line[0]);
    if (part.role == "image" || part.role == "constructed")
      svg_.circle(line[0], 4.5, fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"",
                                          part.role == "image" ? "#fff" : colour, colour));
    if (part.role == "pole") {
      const auto [x, y] = line[0];
      svg_.polyline({{x - 8, y}, {x + 8, y}}, false, stroke("stroke-width=\"2\""));
      svg_.polyline({{x, y - 8}, {x, y + 8}}, false, stroke("stroke-width=\"2\""));
    }
    if (line.size() == 1)
      labels_.push_back(
          {line[0], part.label, fmt::format("font-weight=\"600\" fill=\"{}\"", part.dyad > 0 ? colour : ink)});
  }

  const Plate& drawing_;
  Svg svg_;
  std::vector<MarkLabel> labels_ = {};
};

}  // namespace

std::string construction_figure(const Plate& construction, const std::string& task,
                                const std::string& unit) {
  const std::string title = titled(construction.title, task);
  if (construction.panels.empty()) return ConstructionFigure(construction, title).draw(unit).finish();
  std::vector<Svg> panels;
  for (const Plate& panel : construction.panels)
    panels.push_back(ConstructionFigure(panel, panel.title, 480).draw(unit));
  return side_by_side(panels, title);
}

std::string poses_figure(const Drawing& drawing, const std::string& task, const std::string& unit) {
  std::vector<Point2> origins, placed;
  for (const PoseDrawing& pose : drawing.poses) origins.push_back(pose.origin);
  Svg svg(window_of(origins, 0.08), titled("Task poses", task));
  for (const Point2& origin : origins) placed.push_back(svg.place(origin));
  const double length = arrow_length(placed);
  svg.axes();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PoseDrawing& pose = drawing.poses[i];
    svg.frame(placed[i], {pose.x_axis[0], -pose.x_axis[1]}, {pose.y_axis[0], -pose.y_axis[1]}, length,
              pose_colour(i), pose.label);
  }
  svg.scale_bar(unit);
  return svg.finish();
}

std::string linkage_figure(const LinkageDrawing& linkage, const Drawing& drawing, const std::string& task,
                           const std::string& unit) {
  return Figure(linkage, drawing, titled(fmt::format("Linkage {}", linkage.id), task)).draw(unit);
}

}  // namespace burmester
