#include <algorithm>
#include <vector>

#include "burmester/geometry/interval.hpp"
#include "burmester/planar/five_pose_certificate.hpp"

namespace burmester::planar {
namespace {

using Point = std::array<Interval, 2>;

Interval interval_of(const Range& r) { return {r.low, r.high}; }

double off(double value, double origin, const Range& range) {
  return magnitude(Interval(Interval(value) - (Interval(origin) + interval_of(range))));
}

double length(double x, double y) { return std::sqrt(x * x + y * y) * (1 + 0x1p-40); }

Point rotated(const Interval& cosine, const Interval& sine, const Point& p) {
  return {Interval(cosine * p[0] - sine * p[1]), Interval(sine * p[0] + cosine * p[1])};
}

struct Turn {
  Interval cosine, sine;
  explicit Turn(const Pose& x) {
    const Interval s(x.X3), c(x.X4), n = s * s + c * c;
    cosine = (c * c - s * s) / n, sine = Interval(2) * s * c / n;
  }
};

Point to_fixed(const Pose& x, const Point& p) {
  const Turn turn(x);
  const Point moved = rotated(turn.cosine, turn.sine, p);
  return {Interval(moved[0] + Interval(x.x)), Interval(moved[1] + Interval(x.y))};
}

Point to_moving(const Pose& x, const Point& p) {
  const Turn turn(x);
  return rotated(turn.cosine, Interval(-turn.sine), {Interval(p[0] - Interval(x.x)), Interval(p[1] - Interval(x.y))});
}

/// Error of a line's angle and foot against the places it stands for.
double line_error(const Line& line, const std::vector<Point>& places) {
  double away = 0, reach = 0, spread = 0;
  for (const Point& p : places) {
    const Interval n0(line.normal[0]), n1(line.normal[1]);
    away = std::max(away, magnitude(Interval(n0 * p[0] + n1 * p[1] - Interval(line.offset))));
    reach = std::max(reach, magnitude(p[0]) + magnitude(p[1]));
    for (const Point& q : places) {
      const Interval x = p[0] - q[0], y = p[1] - q[1], square = x * x + y * y;
      spread = std::max(spread, std::sqrt(std::max(0.0, square.inf())) * (1 - 0x1p-50));
    }
  }
  if (!(spread > 2 * away)) return std::numeric_limits<double>::infinity();
  // Two places at most `away` from the line and `spread` apart: sin(angle) <= 2 away / spread, and asin(x) <= pi/2 x.
  const double rounding = 16 * unit_roundoff * (4 + reach);  // of the angle and the foot as they are shown
  const double angle = 3.1415926535897936 * away / spread + rounding;
  return length(angle, away + reach * angle + rounding);
}

}  // namespace

double error_bound(const Dyads::Design& shown, const DyadBox& box, std::span<const Pose> poses, const Pose& reference) {
  const UpwardRounding upward;
  // Distances, not coordinates; roundings upward, and a step outward for those of the square root.
  const auto moving = [&](const Vector2& p) {
    return length(off(p[0], 0, box.moving[0]), off(p[1], 0, box.moving[1]));
  };
  const auto fixed = [&](const Vector2& p) {
    return length(off(p[0], reference.x, box.fixed[0]), off(p[1], reference.y, box.fixed[1]));
  };
  std::vector<Point> places;
  if (const auto* rr = std::get_if<RR::Design>(&shown))
    return length(length(moving(rr->moving), fixed(rr->fixed)), off(rr->length, 0, box.length));
  if (const auto* pr = std::get_if<PR::Design>(&shown)) {
    const Point pivot{interval_of(box.moving[0]), interval_of(box.moving[1])};
    for (const Pose& pose : poses) places.push_back(to_fixed(pose, pivot));
    return length(moving(pr->moving), line_error(pr->line, places));
  }
  if (const auto* rp = std::get_if<RP::Design>(&shown)) {
    const Point pivot{Interval(interval_of(box.fixed[0]) + Interval(reference.x)),
                      Interval(interval_of(box.fixed[1]) + Interval(reference.y))};
    for (const Pose& pose : poses) places.push_back(to_moving(pose, pivot));
    return length(fixed(rp->fixed), line_error(rp->line, places));
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace burmester::planar
