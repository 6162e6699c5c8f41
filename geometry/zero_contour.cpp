#include "burmester/geometry/zero_contour.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace burmester {
namespace {

using Point = std::array<double, 2>;

struct Corner {
  Point at;
  double value;
};

/// The same doubles from both cells that share the edge.
Point zero_between(const Corner& a, const Corner& b) {
  if (b.at < a.at) return zero_between(b, a);
  const double f = a.value / (a.value - b.value);
  return {a.at[0] + f * (b.at[0] - a.at[0]), a.at[1] + f * (b.at[1] - a.at[1])};
}

void add_cell(const std::array<Corner, 4>& corners, int cell, std::vector<ContourSegment>& out) {
  std::vector<Point> zeros;  // in the order of the edges, round the cell
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % 4];
    if ((a.value < 0) != (b.value < 0)) zeros.push_back(zero_between(a, b));
  }
  if (zeros.size() == 2) out.push_back({zeros[0], zeros[1], cell});
  if (zeros.size() != 4) return;
  // corner 0 lies between the edges 3 and 0, which are joined where it is cut off from the middle
  const double middle = corners[0].value + corners[1].value + corners[2].value + corners[3].value;
  const std::size_t first = (corners[0].value < 0) != (middle < 0) ? 3 : 0;
  out.push_back({zeros[first], zeros[(first + 1) % 4], cell});
  out.push_back({zeros[(first + 2) % 4], zeros[(first + 3) % 4], cell});
}

double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }

std::optional<Point> crossing(const ContourSegment& f, const ContourSegment& g) {
  const Point d = minus(f.to, f.from), e = minus(g.to, g.from), offset = minus(g.from, f.from);
  const double area = cross(d, e);
  if (area == 0) return std::nullopt;
  const double s = cross(offset, e) / area, t = cross(offset, d) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return Point{f.from[0] + s * d[0], f.from[1] + s * d[1]};
}

}  // namespace

SampledSquare sampled(double extent, int cells, const std::function<double(double u, double v)>& f) {
  SampledSquare out{extent, cells, {}};
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) out.values.push_back(f(out.coordinate(i), out.coordinate(j)));
  return out;
}

std::vector<ContourSegment> zero_contour(const SampledSquare& f) {
  std::vector<ContourSegment> out;
  const auto corner = [&](int i, int j) { return Corner{{f.coordinate(i), f.coordinate(j)}, f.value(i, j)}; };
  for (int j = 0; j < f.cells; ++j)
    for (int i = 0; i < f.cells; ++i)
      add_cell({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, j * f.cells + i, out);
  return out;
}

std::vector<std::vector<Point>> joined(const std::vector<ContourSegment>& segments) {
  std::map<Point, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const Point& p : {segments[i].from, segments[i].to}) at[p].push_back(i);
  std::vector<bool> used(segments.size(), false);
  const auto extend = [&](std::vector<Point>& line) {
    for (bool more = true; more;) {
      const Point end = line.back();
      more = false;
      for (const std::size_t i : at[end])
        if (!used[i]) {
          used[i] = more = true;
          line.push_back(segments[i].from == end ? segments[i].to : segments[i].from);
          break;
        }
    }
  };
  std::vector<std::vector<Point>> out;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::vector<Point>& line = out.emplace_back(std::vector<Point>{segments[i].from, segments[i].to});
    extend(line);
    std::reverse(line.begin(), line.end());
    extend(line);
  }
  return out;
}

std::vector<Point> crossings(const std::vector<ContourSegment>& f, const std::vector<ContourSegment>& g) {
  std::vector<Point> out;
  auto begin = g.begin();
  for (const ContourSegment& s : f) {
    while (begin != g.end() && begin->cell < s.cell) ++begin;
    for (auto t = begin; t != g.end() && t->cell == s.cell; ++t)
      if (const auto p = crossing(s, *t)) out.push_back(*p);
  }
  return out;
}

}  // namespace burmester
