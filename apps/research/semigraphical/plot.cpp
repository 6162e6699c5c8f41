#include "research/semigraphical/plot.hpp"

#include <numbers>

#include <fmt/format.h>

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
    for (std::size_t j = 0; j < 4; ++j)
      for (const Polyline& line : joined(plot.curves[j]))
        svg_.polyline(placed(line), false,
                      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"",
                                  curve_colours[j]));
    for (const spherical::Crossing& c : plot.crossings)
      if (!c.accepted()) cross(at(c.read_off));
    for (const spherical::Crossing& c : plot.crossings)
      if (c.accepted()) svg_.circle(at(c.read_off), 3, fmt::format("fill=\"{}\"", ink));
    for (const DyadRecord& dyad : algebraic) ring(dyad, moving);
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

  void ring(const DyadRecord& dyad, bool moving) {
    const std::vector<double>& v = moving ? dyad.moving : dyad.fixed;
    if (v.size() != 3) return;
    const Point2 p = at(spherical::longitude_latitude({v[0], v[1], v[2]}));
    svg_.circle(p, 8, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", ink));
    const double side = p[0] > svg_.width() - 90 ? -1 : 1;
    svg_.text({p[0] + 12 * side, p[1] - 9}, fmt::format("{}", dyad.id),
              fmt::format("font-size=\"15\" font-weight=\"600\" fill=\"{}\" text-anchor=\"{}\"", ink,
                          side > 0 ? "start" : "end"));
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
