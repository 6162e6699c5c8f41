#include "report/surfaces_figure.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "report/svg.hpp"

namespace burmester {
namespace {

/// Ids of the two dyads, the first one first.
std::set<int> dyads_of(const SurfaceDrawing& surfaces) {
  std::set<int> out;
  for (const Part& part : surfaces.parts)
    if (part.role == "surface") out.insert(part.dyad);
  return out;
}

/// In the direction of the axis, past its tip.
Point2 beyond(const Polyline& axis) {
  const Point2 d{axis[1][0] - axis[0][0], axis[1][1] - axis[0][1]};
  const double length = std::hypot(d[0], d[1]);
  return {axis[1][0] + 12 * d[0] / length - 6, axis[1][1] + 12 * d[1] / length + 4};
}

}  // namespace

std::string surfaces_figure(const SurfaceDrawing& surfaces, const std::string& task) {
  std::vector<Point2> seen;
  for (const Polyline& line : surfaces.lines) seen.insert(seen.end(), line.begin(), line.end());
  Svg svg(window_of(seen, 0.03),
          fmt::format("Constraint surfaces of linkage {}{}{}", surfaces.linkage, task.empty() ? "" : " · ", task));
  const std::set<int> dyads = dyads_of(surfaces);
  const auto colour = [&dyads](int dyad) { return pose_colour(dyad == *dyads.begin() ? 0 : 1); };
  std::size_t pose = 0;
  for (std::size_t k = 0; k < surfaces.parts.size(); ++k) {
    const Part& part = surfaces.parts[k];
    Polyline line;
    for (const Point2& p : surfaces.lines[k]) line.push_back(svg.place(p));
    if (part.role == "surface") {
      const double near = static_cast<double>(k) / static_cast<double>(surfaces.parts.size());
      svg.polyline(
          line, part.closed,
          fmt::format("fill=\"none\" stroke=\"{}\" stroke-opacity=\"{:.2f}\"", colour(part.dyad), 0.15 + 0.5 * near));
    } else if (part.role == "axis") {
      svg.polyline(line, false, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"", soft_ink));
      svg.label(beyond(line), part.label, fmt::format("fill=\"{}\"", soft_ink));
    } else if (part.role == "curve") {
      svg.polyline(line, false, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2.4\"", ink));
    } else if (part.role == "pose") {
      svg.circle(line[0], 4.5, fmt::format("fill=\"{}\" stroke=\"#fff\"", pose_colour(pose++)));
      svg.text({line[0][0] + 8, line[0][1] - 6}, part.label, fmt::format("font-weight=\"600\" fill=\"{}\"", ink));
    }
  }
  double row = svg.height() - 16 * static_cast<double>(dyads.size());
  for (const int dyad : dyads) {
    svg.text({svg.width() - 14, row}, fmt::format("dyad {}", dyad),
             fmt::format("text-anchor=\"end\" fill=\"{}\"", colour(dyad)));
    row += 16;
  }
  return svg.finish();
}

}  // namespace burmester
