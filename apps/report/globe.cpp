#include "report/globe.hpp"

#include <cmath>
#include <numbers>

namespace burmester {
namespace {

using Point = std::array<double, 3>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Where the chord from p to q crosses the plane of the limb, moved out to the limb.
std::array<double, 2> on_limb(const SphereView& view, const Point& p, const Point& q) {
  const double a = dot(view.towards, p), b = dot(view.towards, q), f = a / (a - b);
  const auto from = projected(view, p), to = projected(view, q);
  const std::array<double, 2> at{from[0] + f * (to[0] - from[0]), from[1] + f * (to[1] - from[1])};
  const double length = std::hypot(at[0], at[1]);
  return length > 0 ? std::array<double, 2>{at[0] / length, at[1] / length} : at;
}

Point on_globe(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

}  // namespace

bool is_near(const SphereView& view, const Point& p) { return dot(view.towards, p) >= 0; }

std::array<double, 2> projected(const SphereView& view, const Point& p) {
  return {dot(view.right, p), dot(view.up, p)};
}

std::vector<GlobeRun> runs_of(const SphereView& view, const std::vector<Point>& points, bool closed) {
  std::vector<GlobeRun> out;
  for (std::size_t i = 0; i < points.size() + (closed && !points.empty() ? 1 : 0); ++i) {
    const Point& p = points[i % points.size()];
    const bool near = is_near(view, p);
    if (i == 0) out.push_back({near, {}});
    if (near != out.back().near) {
      const auto cut = on_limb(view, points[i - 1], p);
      out.back().points.push_back(cut);
      out.push_back({near, {cut}});
    }
    out.back().points.push_back(projected(view, p));
  }
  return out;
}

std::vector<std::vector<Point>> graticule() {
  constexpr double degree = std::numbers::pi / 180;
  std::vector<std::vector<Point>> out;
  for (int longitude = 0; longitude < 360; longitude += 30) {
    auto& line = out.emplace_back();
    for (int latitude = -90; latitude <= 90; latitude += 5)
      line.push_back(on_globe(longitude * degree, latitude * degree));
  }
  for (int latitude = -60; latitude <= 60; latitude += 30) {
    auto& line = out.emplace_back();
    for (int longitude = 0; longitude <= 360; longitude += 5)
      line.push_back(on_globe(longitude * degree, latitude * degree));
  }
  return out;
}

}  // namespace burmester
