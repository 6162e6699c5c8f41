// A small SVG writer: a window of the plane, y up, same scale on both axes, below a title.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

using Point2 = std::array<double, 2>;

/// The first line of every figure.
inline constexpr std::string_view figure_mark = "<!-- A figure by burmester -->\n";

/// Okabe and Ito's colours, grey and ink; poses take them in turn.
std::string_view pose_colour(std::size_t pose);
inline constexpr std::string_view ink = "#1d2126", soft_ink = "#5a626c", bar_fill = "#e9edf1";

/// xmin, ymin, xmax, ymax of all points, made a little larger; not empty even for none.
std::array<double, 4> window_of(const std::vector<Point2>& points, double margin);

/// The name of a mark on the sheet, at the mark's middle.
struct MarkLabel {
  Point2 placed;
  std::string name, attributes;
  Point2 side = {1, -1};  ///< where it is best read, a direction on the sheet
};

class Svg {
 public:
  /// sheet: pixels of the longer side, about
  Svg(const std::array<double, 4>& window, std::string_view title, double sheet = 800);

  /// Position on the sheet, in pixels.
  Point2 place(const Point2& p) const;
  double scale() const { return scale_; }
  double width() const { return width_; }
  double height() const { return height_; }
  bool inside(const Point2& placed) const;

  /// Attributes are SVG: stroke="..". Points are placed already.
  void polyline(const Polyline& placed, bool closed, std::string_view attributes);
  void circle(const Point2& placed, double radius, std::string_view attributes);
  void text(const Point2& placed, std::string_view words, std::string_view attributes);
  /// A0: the digits below the line, but not those of a number.
  void label(const Point2& placed, std::string_view name, std::string_view attributes);
  /// Beside their marks, as label() writes them, none over a mark or another label: farther off with a line to the mark
  /// where there is no room.
  void labels(const std::vector<MarkLabel>& labels);
  void scale_bar(std::string_view unit);
  void frame(const Point2& placed, const Point2& x, const Point2& y, double length, std::string_view colour,
             std::string_view label);
  void axes();
  void ground(const Point2& placed);
  void arrow(const Point2& placed, const Point2& direction, double length, std::string_view colour, bool open);
  /// A straight guide through the window, hatched below where it belongs to the ground.
  void guide(const Point2& a, const Point2& b, bool hatched, std::string_view colour);

  /// The <svg> element alone; `place`: attributes of its own, each followed by a space, where it is part of another.
  std::string element(std::string_view place = "") const;
  /// The file: the mark, and the element.
  std::string finish() const;

 private:
  std::array<double, 4> window_;
  double scale_ = 1, width_ = 0, height_ = 0;
  std::string title_, body_;
};

/// Figures of one size, three in a row, under a title.
std::string side_by_side(const std::vector<Svg>& figures, std::string_view title);

}  // namespace burmester
