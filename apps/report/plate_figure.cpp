#include "report/plate_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/svg.hpp"

namespace burmester {
namespace {

constexpr double mark_gap = 15;  // pixels between marks along a curve
constexpr std::string_view circle_colour[] = {"#0072b2", "#009e73"}, star_colour[] = {"#d55e00", "#cc79a7"};

class Sheet {
 public:
  Sheet(const Plate& plate, std::string_view title) : plate_(plate), svg_(plate.window, title) {}

  std::string draw(const std::string& unit) {
    for (const std::string_view role : {"coupler", "limit", "circle_points", "centre_points", "frame_link", "bar",
                                        "link", "vector", "pole", "meeting", "fixed_pivot", "moving_pivot", "frame"})
      for (std::size_t k = 0; k < plate_.parts.size(); ++k)
        if (plate_.parts[k].role == role) part(plate_.parts[k], placed(plate_.lines[k]));
    svg_.labels(labels_);
    svg_.text({14, 8}, plate_.caption, fmt::format("font-size=\"12\" fill=\"{}\"", soft_ink));
    svg_.scale_bar(unit);
    return svg_.finish();
  }

 private:
  Polyline placed(const Polyline& line) const {
    Polyline out;
    for (const Point2& p : line) out.push_back(svg_.place(p));
    return out;
  }

  void part(const Part& part, const Polyline& line) {
    const std::size_t style = part.dyad == 0 ? 0 : 1;
    if (line.empty()) return;
    if (part.role == "circle_points") {
      curve(part, line, circle_colour[style]);
      for (const Point2& p : marks(line)) svg_.circle(p, 2.6, stroked(circle_colour[style], "#fff"));
    } else if (part.role == "centre_points") {
      curve(part, line, star_colour[style]);
      for (const Point2& p : marks(line)) star(p, star_colour[style]);
    } else if (part.role == "coupler") {
      svg_.polyline(line, true,
                    fmt::format("fill=\"{0}\" fill-opacity=\"0.12\" stroke=\"{0}\" stroke-width=\"1.6\"", ink));
    } else if (part.role == "link" || part.role == "bar" || part.role == "frame_link") {
      bar(part, line, style == 1);
    } else if (part.role == "vector") {
      vector(part, line);
    } else if (part.role == "limit") {
      svg_.polyline(line, false,
                    fmt::format("fill=\"none\" stroke=\"{}\" stroke-dasharray=\"1 4\" stroke-linecap=\"round\" "
                                "stroke-width=\"2\"",
                                soft_ink));
    } else if (part.role == "frame" && line.size() > 2) {
      const Point2 x{line[0][0] - line[1][0], line[0][1] - line[1][1]};
      const Point2 y{line[2][0] - line[1][0], line[2][1] - line[1][1]};
      const std::string_view colour = pose_colour(static_cast<std::size_t>(part.dyad));
      svg_.frame(line[1], x, y, 26, colour, "");
      labels_.push_back(
          {line[1], part.label, fmt::format("font-weight=\"600\" fill=\"{}\"", colour), {-x[0] - y[0], -x[1] - y[1]}});
    } else {
      mark(part, line[0]);
    }
  }

  void curve(const Part& part, const Polyline& line, std::string_view colour) {
    svg_.polyline(line, part.closed, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"", colour));
  }
  void bar(const Part& part, const Polyline& line, bool dashed) {
    svg_.polyline(
        line, false,
        fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}", ink, part.role == "frame_link" ? "4" : "2.4",
                    dashed ? " stroke-dasharray=\"7 5\" stroke-opacity=\"0.6\"" : ""));
    if (part.role == "link") return;
    for (const Point2& p : line) svg_.circle(p, 4, stroked(ink, "#fff"));
    const Point2 along{line[1][0] - line[0][0], line[1][1] - line[0][1]};
    const double size = std::max(std::hypot(along[0], along[1]), 1.0);
    svg_.label({(line[0][0] + line[1][0]) / 2 - 16 * along[1] / size - 8,
                (line[0][1] + line[1][1]) / 2 + 16 * along[0] / size},
               part.label, fmt::format("fill=\"{}\"", ink));
  }
  void vector(const Part& part, const Polyline& line) {
    const std::string_view colour = pose_colour(static_cast<std::size_t>(part.dyad));
    const Point2 along{line[1][0] - line[0][0], line[1][1] - line[0][1]};
    const double size = std::hypot(along[0], along[1]);
    if (!(size > 8)) return;  // pixels: no room for an arrow
    svg_.arrow(line[0], {along[0] / size, along[1] / size}, size, colour, false);
    svg_.label({(line[0][0] + line[1][0]) / 2 + 6, (line[0][1] + line[1][1]) / 2 - 6}, part.label,
               fmt::format("fill=\"{}\"", colour));
  }
  void mark(const Part& part, const Point2& p) {
    if (!svg_.inside(p)) return;
    if (part.role == "fixed_pivot") svg_.ground(p);
    if (part.role == "moving_pivot") svg_.circle(p, 4, stroked(ink, "#fff"));
    if (part.role == "pole")
      svg_.polyline({{p[0] - 4, p[1] - 4}, {p[0] + 4, p[1] - 4}, {p[0] + 4, p[1] + 4}, {p[0] - 4, p[1] + 4}}, true,
                    stroked(ink, "#f0e442"));
    if (part.role == "meeting")
      svg_.polyline({{p[0], p[1] - 7}, {p[0] + 7, p[1]}, {p[0], p[1] + 7}, {p[0] - 7, p[1]}}, true,
                    stroked(ink, "#fff"));
    labels_.push_back({p, part.label, fmt::format("fill=\"{}\"", ink)});
  }

  static std::string stroked(std::string_view colour, std::string_view fill) {
    return fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.3\"", fill, colour);
  }
  void star(const Point2& p, std::string_view colour) {
    for (int k = 0; k < 3; ++k) {
      const double c = 4 * std::cos(1.0472 * k), s = 4 * std::sin(1.0472 * k);
      svg_.polyline({{p[0] - c, p[1] - s}, {p[0] + c, p[1] + s}}, false, fmt::format("stroke=\"{}\"", colour));
    }
  }
  /// Points of a polyline at least so far apart along it, on the sheet.
  Polyline marks(const Polyline& line) const {
    Polyline out;
    double way = mark_gap;
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (k > 0) way += std::hypot(line[k][0] - line[k - 1][0], line[k][1] - line[k - 1][1]);
      if (way < mark_gap || !svg_.inside(line[k])) continue;
      out.push_back(line[k]);
      way = 0;
    }
    return out;
  }

  const Plate& plate_;
  Svg svg_;
  std::vector<MarkLabel> labels_ = {};
};

}  // namespace

std::string plate_figure(const Plate& plate, const std::string& task, const std::string& unit) {
  return Sheet(plate, task.empty() ? plate.title : plate.title + " · " + task).draw(unit);
}

}  // namespace burmester
