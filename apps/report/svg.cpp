#include "report/svg.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

constexpr double edge = 46, head = 44;

Point2 sum(const Point2& a, const Point2& b, double factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1]};
}
double length_of(const Point2& a) { return std::hypot(a[0], a[1]); }
Point2 unit(const Point2& a) {
  const double length = length_of(a);
  return length > 0 ? Point2{a[0] / length, a[1] / length} : Point2{1, 0};
}

std::string number(double value) {
  return fmt::format("{:.6g}", std::round(std::clamp(value, -1e6, 1e6) * 100) / 100 + 0.0);
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '<'   ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '&' ? "&amp;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

/// The part of the line through a and b inside 0..width, 0..height; empty where it misses.
Polyline clipped(const Point2& a, const Point2& b, double width, double height) {
  const Point2 d = sum(b, a, -1);
  double low = -1e9, high = 1e9;
  for (const int k : {0, 1}) {
    const double size = k == 0 ? width : height;
    if (std::abs(d[k]) < 1e-9) {
      if (a[k] < 0 || a[k] > size) return {};
      continue;
    }
    const double s = -a[k] / d[k], t = (size - a[k]) / d[k];
    low = std::max(low, std::min(s, t));
    high = std::min(high, std::max(s, t));
  }
  if (low >= high) return {};
  return {sum(a, d, low), sum(a, d, high)};
}

/// On the sheet, in pixels.
struct Box {
  Point2 low, high;

  bool overlaps(const Box& other) const {
    return low[0] < other.high[0] && other.low[0] < high[0] && low[1] < other.high[1] && other.low[1] < high[1];
  }
};

/// Room for a label: by `off` farther from the mark than a label that touches it, to the side `d`.
Box room(const MarkLabel& label, const std::array<int, 2>& d, double off) {
  const double w = 9.0 * static_cast<double>(label.name.size()), h = 17, gap = d[0] == 0 || d[1] == 0 ? 9 : 5;
  const Point2 middle{label.placed[0] + d[0] * (9 + off + w / 2), label.placed[1] + d[1] * (gap + off + h / 2)};
  return {{middle[0] - w / 2, middle[1] - h / 2}, {middle[0] + w / 2, middle[1] + h / 2}};
}

/// The free room nearest to the mark, and how far off it is; that beside the mark where there is none.
std::pair<Box, double> free_room(const MarkLabel& label, const std::vector<Box>& taken, const Box& page) {
  std::array<std::array<int, 2>, 8> sides{{{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};
  std::ranges::stable_sort(sides, std::greater<>(), [&](const auto& d) {
    return (d[0] * label.side[0] + d[1] * label.side[1]) / std::hypot(d[0], d[1]);
  });
  for (double off = 0; off < page.high[0]; off += 10)
    for (const auto& side : sides) {
      const Box box = room(label, side, off);
      const bool inside = box.low[0] > page.low[0] && box.low[1] > page.low[1] && box.high[0] < page.high[0] &&
                          box.high[1] < page.high[1];
      if (inside && std::ranges::none_of(taken, [&](const Box& other) { return box.overlaps(other); }))
        return {box, off};
    }
  return {room(label, sides[0], 0), 0};
}

}  // namespace

std::string_view pose_colour(std::size_t pose) {
  constexpr std::string_view colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                          "#e69f00", "#56b4e9", "#7a7a7a", "#1d2126"};
  return colours[pose % std::size(colours)];
}

std::array<double, 4> window_of(const std::vector<Point2>& points, double margin) {
  if (points.empty()) return {-1, -1, 1, 1};
  std::array<double, 4> w = {points[0][0], points[0][1], points[0][0], points[0][1]};
  for (const Point2& p : points)
    w = {std::min(w[0], p[0]), std::min(w[1], p[1]), std::max(w[2], p[0]), std::max(w[3], p[1])};
  const double size = std::max(w[2] - w[0], w[3] - w[1]), grow = size > 0 ? margin * size : 1;
  return {w[0] - grow, w[1] - grow, w[2] + grow, w[3] + grow};
}

Svg::Svg(const std::array<double, 4>& window, std::string_view title, double sheet) : window_(window), title_(title) {
  const double w = std::max(window[2] - window[0], 1e-300), h = std::max(window[3] - window[1], 1e-300);
  scale_ = (sheet - 2 * edge) / std::max(w, h);
  width_ = std::max(w * scale_ + 2 * edge, 480.0);
  height_ = std::max(h * scale_ + 2 * edge, 300.0);
}

Point2 Svg::place(const Point2& p) const {
  return {width_ / 2 + (p[0] - (window_[0] + window_[2]) / 2) * scale_,
          height_ / 2 - (p[1] - (window_[1] + window_[3]) / 2) * scale_};
}

bool Svg::inside(const Point2& p) const { return p[0] > 0 && p[1] > 0 && p[0] < width_ && p[1] < height_; }

void Svg::polyline(const Polyline& placed, bool closed, std::string_view attributes) {
  if (placed.empty()) return;
  std::string path;
  for (const Point2& p : placed)
    path += fmt::format("{}{} {}", path.empty() ? 'M' : 'L', number(p[0]), number(p[1]));
  body_ += fmt::format("<path d=\"{}{}\" {}/>\n", path, closed ? "Z" : "", attributes);
}

void Svg::circle(const Point2& placed, double radius, std::string_view attributes) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(placed[0]), number(placed[1]),
                       number(radius), attributes);
}

void Svg::text(const Point2& placed, std::string_view words, std::string_view attributes) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" class=\"halo\" {}>{}</text>\n", number(placed[0]),
                       number(placed[1]), attributes, escaped(printable(words, 100)));
}

void Svg::label(const Point2& placed, std::string_view name, std::string_view attributes) {
  constexpr std::string_view any = "0123456789";
  const std::size_t digits = std::min(name.find_first_of(any, name.find_first_not_of(any)), name.size());
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" class=\"halo\" {}>{}<tspan dy=\"4\" font-size=\"10\">{}</tspan></text>\n",
      number(placed[0]), number(placed[1]), attributes, escaped(printable(name.substr(0, digits), 20)),
      escaped(printable(name.substr(digits), 20)));
}

void Svg::labels(const std::vector<MarkLabel>& labels) {
  std::vector<Box> taken;
  for (const MarkLabel& label : labels) taken.push_back({sum(label.placed, {-4, -4}), sum(label.placed, {4, 4})});
  for (const MarkLabel& l : labels) {
    if (!inside(l.placed)) continue;
    const auto [box, off] = free_room(l, taken, {{0, 0}, {width_, height_}});
    taken.push_back(box);
    if (off > 0)
      polyline({l.placed,
                {std::clamp(l.placed[0], box.low[0], box.high[0]), std::clamp(l.placed[1], box.low[1], box.high[1])}},
               false, fmt::format("stroke=\"{}\" stroke-width=\"0.7\"", soft_ink));
    label({box.low[0], box.high[1] - 4}, l.name, l.attributes);
  }
}

void Svg::scale_bar(std::string_view unit_name) {
  const double goal = std::min(110.0, width_ / 4) / scale_,
               power = std::pow(10, std::floor(std::log10(goal)));
  const double step = (goal >= 5 * power   ? 5
                       : goal >= 2 * power ? 2
                                           : 1) *
                      power,
               length = step * scale_, y = height_ - 16;
  body_ += fmt::format("<path d=\"M14 {0}v8M14 {1}h{2}m0 -4v8\" fill=\"none\" stroke=\"{3}\"/>\n",
                       number(y - 4), number(y), number(length), soft_ink);
  text({22 + length, y + 4}, fmt::format("{:.3g}{}{}", step, unit_name.empty() ? "" : " ", unit_name),
       "font-size=\"12\"");
}

void Svg::arrow(const Point2& from, const Point2& direction, double length, std::string_view colour,
                bool open) {
  const Point2 tip = sum(from, direction, length), foot = sum(tip, direction, -8),
               side = {-direction[1] * 3.4, direction[0] * 3.4};
  polyline({from, foot}, false, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.7\"", colour));
  polyline({tip, sum(foot, side), sum(foot, side, -1)}, true,
           fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.2\"", open ? "#fff" : colour, colour));
}

void Svg::frame(const Point2& o, const Point2& x, const Point2& y, double length, std::string_view colour,
                std::string_view label) {
  arrow(o, unit(x), length, colour, false);
  arrow(o, unit(y), length, colour, true);
  circle(o, 3, fmt::format("fill=\"{}\"", colour));
  if (label.empty()) return;
  const Point2 at = sum(o, unit(sum(x, y)), -15);
  text({at[0], at[1] + 4}, label,
       fmt::format("text-anchor=\"middle\" font-weight=\"600\" fill=\"{}\"", colour));
}

void Svg::axes() {
  const Point2 o = place({0, 0});
  if (!inside(o) || o[1] > height_ - 44) return;
  arrow(o, {1, 0}, 46, "#8d959f", false);
  arrow(o, {0, -1}, 46, "#8d959f", false);
  text({o[0] + 50, o[1] + 4}, "X", "fill=\"#8d959f\"");
  text({o[0] - 4, o[1] - 50}, "Y", "fill=\"#8d959f\"");
}

void Svg::ground(const Point2& p) {
  std::string marks;
  for (double k = -12; k <= 8; k += 5)
    marks += fmt::format("M{} {}l-5 6", number(p[0] + k + 5), number(p[1] + 17));
  body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", marks, soft_ink);
  polyline({p, {p[0] - 10, p[1] + 17}, {p[0] + 10, p[1] + 17}}, true,
           fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.5\"", ink));
  polyline({{p[0] - 14, p[1] + 17}, {p[0] + 14, p[1] + 17}}, false,
           fmt::format("stroke=\"{}\" stroke-width=\"1.5\"", ink));
  circle(p, 4.5, fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.8\"", ink));
}

void Svg::guide(const Point2& a, const Point2& b, bool hatched, std::string_view colour) {
  Polyline line = clipped(a, b, width_, height_);
  if (line.empty()) return;
  if (line[1][0] < line[0][0]) std::swap(line[0], line[1]);
  const Point2 span = sum(line[1], line[0], -1), d = unit(span);
  std::string marks;
  for (double k = 4; hatched && k < length_of(span); k += 8) {
    const Point2 p = sum(line[0], d, k);
    marks += fmt::format("M{} {}l{} {}", number(p[0]), number(p[1]), number(-5 * d[0] - 6 * d[1]),
                         number(6 * d[0] - 5 * d[1]));
  }
  if (hatched) body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#b6bcc3\"/>\n", marks);
  polyline(line, false, fmt::format("stroke=\"{}\" stroke-width=\"1.5\"", colour));
}

std::string Svg::element(std::string_view place) const {
  return fmt::format(
      R"(<svg {6}xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 {2} {0} {1}"
 font-family="Helvetica, Arial, sans-serif" font-size="13">
<title>{3}</title>
<style>.halo{{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}}</style>
<rect y="{2}" width="{0}" height="{1}" fill="#fff"/>
{5}<text x="14" y="-16" font-size="16" class="halo" fill="{4}">{3}</text>
</svg>
)",
      number(width_), number(height_ + head), number(-head), escaped(printable(title_, 90)), ink, body_, place);
}

std::string Svg::finish() const { return fmt::format("{}{}", figure_mark, element()); }

std::string side_by_side(const std::vector<Svg>& figures, std::string_view title) {
  constexpr std::size_t columns = 3;
  double width = 0, height = 0;
  for (const Svg& figure : figures)
    width = std::max(width, figure.width()), height = std::max(height, figure.height() + head);
  std::string body;
  for (std::size_t k = 0; k < figures.size(); ++k)
    body += figures[k].element(fmt::format("x=\"{}\" y=\"{}\" ", number(width * static_cast<double>(k % columns)),
                                           number(head + height * static_cast<double>(k / columns))));
  const double rows = static_cast<double>((figures.size() + columns - 1) / columns);
  return fmt::format(
      R"({0}<svg xmlns="http://www.w3.org/2000/svg" width="{1}" height="{2}" viewBox="0 0 {1} {2}"
 font-family="Helvetica, Arial, sans-serif">
<title>{3}</title>
<rect width="{1}" height="{2}" fill="#fff"/>
{4}<text x="14" y="28" font-size="18" fill="{5}">{3}</text>
</svg>
)",
      figure_mark, number(columns * width), number(head + rows * height), escaped(printable(title, 90)), body, ink);
}

}  // namespace burmester
