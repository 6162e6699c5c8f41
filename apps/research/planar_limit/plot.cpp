#include "research/planar_limit/plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/label_places.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

constexpr std::string_view grid_line = "stroke=\"#e6e8eb\" stroke-width=\"0.8\"";
constexpr double small = 12;  // font size, pixels

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "1";
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) out += digits[c - '0'];
  return out;
}

std::string number(double value) { return fmt::format("{}{:.3g}", value < 0 ? "−" : "", std::abs(value)); }

/// A rectangle of the sheet with coordinates of its own.
struct Panel {
  Point2 corner, size;           ///< pixels; upper left
  std::array<double, 4> window;  ///< xmin, ymin, xmax, ymax

  Point2 place(const Point2& p) const {
    return {corner[0] + size[0] * (p[0] - window[0]) / (window[2] - window[0]),
            corner[1] + size[1] * (window[3] - p[1]) / (window[3] - window[1])};
  }
  bool holds(const Point2& p) const {
    return p[0] >= window[0] && p[0] <= window[2] && p[1] >= window[1] && p[1] <= window[3];
  }
  void border(Svg& svg) const {
    const auto [w, h] = size;
    svg.polyline({corner, {corner[0] + w, corner[1]}, {corner[0] + w, corner[1] + h}, {corner[0], corner[1] + h}}, true,
                 fmt::format("fill=\"none\" stroke=\"{}\"", soft_ink));
  }
  /// The pieces of the line that are inside.
  void line(Svg& svg, const Polyline& points, const std::string& attributes) const {
    Polyline piece;
    for (const Point2& p : points) {
      if (holds(p)) {
        piece.push_back(place(p));
      } else {
        svg.polyline(piece, false, attributes);
        piece.clear();
      }
    }
    svg.polyline(piece, false, attributes);
  }
  void tick_x(Svg& svg, double x, std::string_view words) const {
    const Point2 below = place({x, window[1]});
    svg.polyline({below, place({x, window[3]})}, false, grid_line);
    svg.text({below[0], below[1] + 16}, words, fmt::format("text-anchor=\"middle\" font-size=\"{}\"", small));
  }
  void tick_y(Svg& svg, double y, std::string_view words) const {
    const Point2 left = place({window[0], y});
    svg.polyline({left, place({window[2], y})}, false, grid_line);
    svg.text({left[0] - 6, left[1] + 4}, words, fmt::format("text-anchor=\"end\" font-size=\"{}\"", small));
  }
  void names(Svg& svg, std::string_view x, std::string_view y, double away) const {
    svg.text({corner[0] + size[0] / 2, corner[1] + size[1] + 36}, x, "text-anchor=\"middle\"");
    const Point2 at{corner[0] - away, corner[1] + size[1] / 2};
    svg.text(at, y, fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.6g} {:.6g})\"", at[0], at[1]));
  }
};

class Plot {
 public:
  Plot(const PlanarLimit& limit, std::string_view title) : limit_(limit), svg_({0, 0, 708, 350}, title) {}

  std::string draw(std::span<const planar::Pose, 5> poses) {
    plane(poses);
    rates();
    legend();
    return svg_.finish();
  }

 private:
  static std::string stroke(std::size_t dyad, double width, std::string_view more = "") {
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" {}",
                       pose_colour(dyad), width, more);
  }
  Point2 scaled(const planar::Vector2& p) const { return {p[0] / limit_.size, p[1] / limit_.size}; }
  Polyline path(const FollowedDyad& dyad, planar::Vector2 DyadPlace::*pivot) const {
    Polyline out{scaled(dyad.planar.*pivot)};
    for (const DyadPlace& place : dyad.path) out.push_back(scaled(place.*pivot));
    return out;
  }

  /// A window for the poses, pivots of planar dyads within 20 L, and paths within 3 L.
  Panel plane_panel(std::span<const planar::Pose, 5> poses) const {
    std::vector<Point2> seen;
    for (const planar::Pose& p : poses) seen.push_back(scaled({p.x, p.y}));
    for (const FollowedDyad& d : limit_.dyads)
      for (const auto pivot : {&DyadPlace::fixed, &DyadPlace::moving})
        for (double room = 20; const Point2& p : path(d, pivot)) {
          if (std::hypot(p[0], p[1]) < room) seen.push_back(p);
          room = 3;
        }
    const std::array<double, 4> w = window_of(seen, 0.08);
    const double half = std::max(w[2] - w[0], w[3] - w[1]) / 2, x = (w[0] + w[2]) / 2, y = (w[1] + w[3]) / 2;
    return {{66, 14}, {350, 350}, {x - half, y - half, x + half, y + half}};
  }

  void plane(std::span<const planar::Pose, 5> poses) {
    const Panel panel = plane_panel(poses);
    const double width = panel.window[2] - panel.window[0], power = std::pow(10, std::floor(std::log10(width / 3)));
    const double step = width / 3 >= 5 * power ? 5 * power : width / 3 >= 2 * power ? 2 * power : power;
    for (double k = std::ceil(panel.window[0] / step); k * step < panel.window[2]; ++k)
      panel.tick_x(svg_, k * step, number(k * step));
    for (double k = std::ceil(panel.window[1] / step); k * step < panel.window[3]; ++k)
      panel.tick_y(svg_, k * step, number(k * step));
    panel.border(svg_);
    panel.names(svg_, "x / L", "y / L", 46);
    for (const planar::Pose& p : poses) {
      const planar::Vector2 x = planar::rotated(p, {1, 0}), y = planar::rotated(p, {0, 1});
      svg_.frame(panel.place(scaled({p.x, p.y})), {x[0], -x[1]}, {y[0], -y[1]}, 20, "#a9b1ba", "");
    }
    LabelPlaces labels;
    for (const planar::Pose& p : poses) labels.avoid(panel.place(scaled({p.x, p.y})), 2);
    for (std::size_t k = 0; k < limit_.dyads.size(); ++k) {
      const FollowedDyad& d = limit_.dyads[k];
      panel.line(svg_, {scaled(d.planar.fixed), scaled(d.planar.moving)}, stroke(k, 1, "stroke-opacity=\"0.45\""));
      for (const auto pivot : {&DyadPlace::fixed, &DyadPlace::moving}) {
        const Polyline places = path(d, pivot);
        panel.line(svg_, places, stroke(k, 2));
        mark_end(panel, k, places);
        for (const Point2& p : places)
          if (panel.holds(p)) labels.avoid(panel.place(p), 1);
        if (!panel.holds(places[0])) continue;
        svg_.circle(panel.place(places[0]), 4.5,
                    fmt::format("fill=\"{0}\" stroke=\"{1}\" stroke-width=\"1.8\"",
                                pivot == &DyadPlace::fixed ? pose_colour(k) : "#fff", pose_colour(k)));
      }
    }
    for (std::size_t k = 0; k < limit_.dyads.size(); ++k) name(panel, k, labels);
  }

  /// A square where the path is for the largest e.
  void mark_end(const Panel& panel, std::size_t dyad, const Polyline& places) {
    if (places.size() == limit_.e.size() + 1 && panel.holds(places.back()))
      square(panel.place(places.back()), pose_colour(dyad));
  }
  void square(const Point2& p, std::string_view colour) {
    svg_.polyline({{p[0] - 3, p[1] - 3}, {p[0] + 3, p[1] - 3}, {p[0] + 3, p[1] + 3}, {p[0] - 3, p[1] + 3}}, true,
                  fmt::format("fill=\"{}\"", colour));
  }
  /// Beside the fixed pivot.
  void name(const Panel& panel, std::size_t dyad, LabelPlaces& labels) {
    const Point2 fixed = scaled(limit_.dyads[dyad].planar.fixed);
    if (!panel.holds(fixed)) return;
    const Point2 at = labels.place(panel.place(fixed), 5);
    svg_.text({at[0], at[1] + 5}, fmt::format("{}", dyad + 1), number_style(dyad));
  }
  static std::string number_style(std::size_t dyad) {
    return fmt::format("text-anchor=\"middle\" font-size=\"14\" font-weight=\"600\" fill=\"{}\"", pose_colour(dyad));
  }

  void rates() {
    std::vector<Polyline> lines;
    double low = 1, high = 1e-300;
    for (const FollowedDyad& d : limit_.dyads) {
      lines.emplace_back();
      for (std::size_t i = 0; i < d.path.size(); ++i) {
        const double by = std::max(apart(d.path[i], d.planar) / limit_.size, 1e-16);  // rounding of the two
        low = std::min(low, by), high = std::max(high, by);
        lines.back().push_back({std::log10(limit_.e[i]), std::log10(by)});
      }
    }
    const double left = std::floor(std::log10(limit_.e.front()) + 1e-9);
    const Panel panel{{484, 14},
                      {296, 350},
                      {left, std::floor(std::log10(low)), std::ceil(std::log10(limit_.e.back())),
                       std::clamp(std::ceil(std::log10(high)), std::floor(std::log10(low)) + 1, 1.0)}};
    for (int k = static_cast<int>(left); k <= panel.window[2]; ++k) panel.tick_x(svg_, k, power_of_ten(k));
    for (int k = static_cast<int>(panel.window[1]); k <= panel.window[3]; ++k) panel.tick_y(svg_, k, power_of_ten(k));
    panel.border(svg_);
    panel.names(svg_, "e = L / radius of the sphere", "distance from the planar dyad / L", 44);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      panel.line(svg_, lines[k], stroke(k, 1.8));
      for (std::size_t i = 0; i < lines[k].size(); i += 15)
        if (panel.holds(lines[k][i]))
          svg_.circle(panel.place(lines[k][i]), 2.6, fmt::format("fill=\"{}\"", pose_colour(k)));
    }
    slope(panel);
    numbers(panel, lines);
    const Point2 corner = panel.place({panel.window[0], panel.window[3]});
    svg_.text({corner[0] + 10, corner[1] + 20}, fmt::format("the other {} dyads:", 6 - limit_.dyads.size()),
              fmt::format("font-size=\"{}\"", small));
    svg_.text({corner[0] + 10, corner[1] + 36}, about_others(limit_), fmt::format("font-size=\"{}\"", small));
  }

  /// A triangle of slope two over one decade, in the lower right corner.
  void slope(const Panel& panel) {
    const double x = panel.window[2] - 1.35, y = panel.window[1] + 0.7;
    svg_.polyline({panel.place({x, y}), panel.place({x + 1, y}), panel.place({x + 1, y + 2})}, true,
                  fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"", ink));
    const std::string style = fmt::format("text-anchor=\"middle\" font-size=\"{}\"", small);
    const Point2 below = panel.place({x + 0.5, y}), right = panel.place({x + 1, y + 1});
    svg_.text({below[0], below[1] + 15}, "1", style);
    svg_.text({right[0] + 10, right[1] + 4}, "2", style);
  }
  /// The dyads' numbers at the upper ends of their lines, one below the other in the order of these.
  void numbers(const Panel& panel, const std::vector<Polyline>& lines) {
    std::vector<std::pair<Point2, std::size_t>> ends;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const auto last =
          std::find_if(lines[k].rbegin(), lines[k].rend(), [&](const Point2& p) { return panel.holds(p); });
      if (last != lines[k].rend()) ends.emplace_back(panel.place(*last), k);
    }
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first[1] < b.first[1]; });
    double above = panel.corner[1];
    for (const auto& [end, k] : ends) {
      above = std::max(above + 15, end[1]);
      svg_.text({end[0] + 11, above + 4}, fmt::format("{}", k + 1), number_style(k));
    }
  }

  void legend() {
    const double y = 422;
    double x = 20;
    const auto words = [&](std::string_view text, double width) {
      svg_.text({x + 22, y + 4}, text, fmt::format("font-size=\"{}\"", small));
      x += width;
    };
    const std::string line = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", ink);
    svg_.circle({x + 10, y}, 4.5, fmt::format("fill=\"{}\"", ink));
    words("fixed pivot of a planar dyad", 196);
    svg_.circle({x + 10, y}, 4.5, fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.8\"", ink));
    words("its moving pivot, in pose 1", 196);
    svg_.polyline({{x, y}, {x + 18, y}}, false, line);
    words("axes of the spherical dyads", 196);
    square({x + 10, y}, ink);
    words(fmt::format("the same at e = {:.3g}", limit_.e.back()), 0);
  }

  const PlanarLimit& limit_;
  Svg svg_;
};

}  // namespace

std::string planar_limit_plot(const PlanarLimit& limit, std::span<const planar::Pose, 5> poses,
                              const std::string& task) {
  return Plot(limit, task.empty() ? "Planar limit" : "Planar limit · " + task).draw(poses);
}

std::string about_others(const PlanarLimit& limit) {
  std::size_t real = 0;
  while (real < limit.e.size() && limit.others[real].empty()) ++real;
  if (real == limit.e.size()) return fmt::format("complex for every e up to {:.3g}", limit.e.back());
  if (real == 0) return fmt::format("{} real already at e = {:.3g}", limit.others[0].size(), limit.e[0]);
  return fmt::format("complex below e = {:.3g}", limit.e[real]);
}

}  // namespace burmester
