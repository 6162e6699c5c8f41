#include "burmester/geometry/diameter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace burmester {
namespace {

using Point = Vector<double, 2>;

static_assert(std::numeric_limits<long double>::max_exponent > 2 * std::numeric_limits<double>::max_exponent + 1);

/// (b - a) x (d - c). In long double, whose range holds all products of doubles.
long double cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto difference = [](double from, double to) { return static_cast<long double>(to) - from; };
  return difference(a[0], b[0]) * difference(c[1], d[1]) - difference(a[1], b[1]) * difference(c[0], d[0]);
}

bool is_left(const Point& a, const Point& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; }

/// Counterclockwise, each vertex a true corner; of points in one line the two ends, of equal ones two of them. Sorts
/// the points. Precondition: at least two.
std::vector<Point> convex_hull(std::vector<Point>& points) {
  std::sort(points.begin(), points.end(), is_left);
  std::vector<Point> hull;
  const auto add_chain = [&](auto from, auto to) {
    const std::size_t start = hull.size() + 1;
    for (; from != to; ++from) {
      while (hull.size() > start && cross(hull.end()[-2], hull.back(), hull.back(), *from) <= 0) hull.pop_back();
      hull.push_back(*from);
    }
    hull.pop_back();  // the next chain begins with it
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace

double diameter(std::vector<Point> points) {
  if (points.size() < 2) return 0;
  const std::vector<Point> hull = convex_hull(points);
  const std::size_t n = hull.size();
  const auto at = [&](std::size_t i) -> const Point& { return hull[i % n]; };
  double largest = 0;
  const auto look = [&](const Point& a, const Point& b) {
    largest = std::max(largest, std::hypot(b[0] - a[0], b[1] - a[1]));
  };
  // far: the vertex farthest from the edge i, i + 1
  for (std::size_t i = 0, far = 1; i < n; ++i) {
    while (far < i + n && cross(at(i), at(i + 1), at(far), at(far + 1)) > 0) ++far;
    for (const std::size_t k : {far, far + 1}) look(at(i), at(k)), look(at(i + 1), at(k));
  }
  return largest;
}

}  // namespace burmester
