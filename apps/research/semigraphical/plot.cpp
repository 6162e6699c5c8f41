#include "research/semigraphical/plot.hpp"

#include <numbers>

#include <fmt/format.h>

#include "report/label_places.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::string_view curve_colours[] = {"#0072b2", "#d55e00", "#009e73", "#b0489c"};
constexpr std::string_view digits[] = {"₁", "₂", "₃", "₄"};

class Plot {
 public:
  explicit Plot(std::string_view title) : svg_({-102, -119, 98, 92}, title) {}

  std::string draw(const spherical::AxisPlot& plot, bool moving, const std::vector<DyadRecord>& algebraic) {
    grid(moving);
    LabelPlaces labels;
    for (std::size_t j = 0; j < 4; ++j)
      for (const Polyline& line : joined(plot.curves[j])) {
        const Polyline points = placed(line);
        svg_.polyline(points, false,
                      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"",
                                  curve_colours[j]));
        for (const Point2& p : points) labels.avoid(p, 1);
      }
    for (const spherical::Crossing& c : plot.crossings)
      if (!c.accepted()) cross(at(c.read_off)), labels.avoid(at(c.read_off), 3);
    for (const spherical::Crossing& c : plot.crossings)
      if (c.accepted()) svg_.circle(at(c.read_off), 3, fmt::format("fill=\"{}\"", ink));
    for (const DyadRecord& dyad : algebraic) ring(dyad, moving), labels.avoid(axis_of(dyad, moving), 3);
    for (const DyadRecord& dyad : algebraic) number(dyad, labels.place(axis_of(dyad, moving), 5));
    legend();
    return svg_.finish();
  }

 private:
  Point2 at(const std::array<double, 2>& radians) const {
    return svg_.place({radians[0] / degree, radians[1] / degree});
  }
  Polyline placed(const Polyline& radians) const {
    Polyline out;
    for (const auto& p : radians) out.push_back(at(p));
    return out;
  }

  void grid(bool moving) {
    for (int tick = -90; tick <= 90; tick += 30) {
      const double t = tick;
      const std::string line =
          fmt::format("stroke=\"{}\" stroke-width=\"{}\"", std::abs(tick) == 90 ? soft_ink : "#e3e3dc",
                      std::abs(tick) == 90 ? 1.2 : 0.8);
      svg_.polyline({svg_.place({t, -90}), svg_.place({t, 90})}, false, line);
      svg_.polyline({svg_.place({-90, t}), svg_.place({90, t})}, false, line);
      const Point2 below = svg_.place({t, -90}), left = svg_.place({-90, t});
      svg_.text({below[0], below[1] + 18}, degrees(tick), "text-anchor=\"middle\" font-size=\"12\"");
      svg_.text({left[0] - 7, left[1] + 4}, degrees(tick), "text-anchor=\"end\" font-size=\"12\"");
    }
    const std::string axis = moving ? "moving axis a" : "fixed axis b", style = "text-anchor=\"middle\"";
    const Point2 below = svg_.place({0, -90}), left = svg_.place({-90, 0});
    svg_.text({below[0], below[1] + 38}, "longitude of the " + axis, style);
    svg_.text({left[0] - 40, left[1]}, "latitude",
              fmt::format("{} transform=\"rotate(-90 {:.6g} {:.6g})\"", style, left[0] - 40, left[1]));
  }
  static std::string degrees(int tick) { return fmt::format("{}{}°", tick < 0 ? "−" : "", std::abs(tick)); }

  void cross(const Point2& p) {
    for (const double s : {-1.0, 1.0})
      svg_.polyline({{p[0] - 4, p[1] - 4 * s}, {p[0] + 4, p[1] + 4 * s}}, false,
                    fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", soft_ink));
  }

  Point2 axis_of(const DyadRecord& dyad, bool moving) const {
    const std::vector<double>& v = moving ? dyad.moving : dyad.fixed;
    return at(spherical::longitude_latitude({v[0], v[1], v[2]}));
  }
  void ring(const DyadRecord& dyad, bool moving) {
    svg_.circle(axis_of(dyad, moving), 8, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", ink));
  }
  void number(const DyadRecord& dyad, const Point2& middle) {
    svg_.text({middle[0], middle[1] + 5}, fmt::format("{}", dyad.id),
              fmt::format("font-size=\"15\" font-weight=\"600\" fill=\"{}\" text-anchor=\"middle\"", ink));
  }

  void legend() {
    const Point2 below = svg_.place({-90, -90});
    Point2 p{below[0] - 24, below[1] + 64};
    const auto words = [&](std::string_view text, double width) {
      svg_.text({p[0] + 30, p[1] + 4}, text, "font-size=\"12\"");
      p[0] += width;
    };
    for (std::size_t j = 0; j < 4; ++j) {
      svg_.polyline({p, {p[0] + 24, p[1]}}, false, fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", curve_colours[j]));
      words(fmt::format("Δ{} = 0", digits[j]), 80);
    }
    svg_.circle({p[0] + 16, p[1]}, 3, fmt::format("fill=\"{}\"", ink));
    words("crossing, rank 2", 130);
    cross({p[0] + 16, p[1]});
    words("rank 3: spurious", 130);
    svg_.circle({p[0] + 16, p[1]}, 8, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", ink));
    words("algebraic", 80);
  }

  Svg svg_;
};

}  // namespace

std::string semigraphical_plot(const spherical::AxisPlot& plot, bool moving, const std::vector<DyadRecord>& algebraic,
                               const std::string& task) {
  const std::string what = moving ? "Moving axes" : "Fixed axes";
  return Plot(task.empty() ? what : what + " · " + task).draw(plot, moving, algebraic);
}

}  // namespace burmester
