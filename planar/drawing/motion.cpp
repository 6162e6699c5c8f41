#include "burmester/planar/drawing/motion.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "burmester/geometry/quadric_curve.hpp"
#include "burmester/planar/drawing/chart.hpp"
#include "burmester/planar/drawing/stage.hpp"

namespace burmester::planar {
namespace {

using Point = Point3<double>;

constexpr double visible = 1e-6;  // stage units and radians: a miss that the eye could never see

/// How far the origin of E can go while an RR dyad in view holds; the outer horizon for others.
double reach_of(const Family::Design& design) {
  const auto* d = std::get_if<RR::Design>(&design);
  if (!d || d->fixed.norm() > 1.001 || d->length > 2.001 || d->moving.norm() > 2.001) return outer_horizon;
  return 1.001 * (d->fixed.norm() + d->length + d->moving.norm());
}

/// Points of E whose paths are watched: origin, a tip, moving pivots, ends of guides that the body carries.
std::vector<Vector2> watched_points(const Family::Design& a, const Family::Design& b) {
  std::vector<Vector2> out{{0, 0}, {0.2, 0}};
  for (const Family::Design* design : {&a, &b}) {
    if (const Vector2* m = moving_pivot(*design); m && m->norm() <= 5) out.push_back(*m);
    if (const auto* d = std::get_if<RP::Design>(design); d && std::abs(d->line.offset) <= 5)
      for (const double along : {-0.5, 0.5})
        out.push_back(d->line.offset * d->line.normal + along * Vector2(d->line.normal[1], -d->line.normal[0]));
  }
  return out;
}

/// A walk with the task poses put in where it passes them.
struct Track {
  struct Station {
    Point x;
    Pose pose;
    int task = -1;
  };
  std::vector<Station> stations;
  bool closed = false;
};

class Sampler {
 public:
  Sampler(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b)
      : chart_(chart_for(poses, a, b)),
        curve_(chart_.quadric(a), chart_.quadric(b)),
        watched_(watched_points(a, b)),
        poses_(poses),
        reach_(std::min(reach_of(a), reach_of(b))) {
    for (Pose& pose : poses_) points_.push_back(settle(pose));
  }

  Motions run() {
    Motions out;
    std::vector<bool> placed(poses_.size(), false);
    for (std::size_t j = 0; j < poses_.size(); ++j) {
      if (placed[j] || chart_.beyond(reach_, points_[j])) continue;
      const Walk path = walk(curve_, points_[j], {.stop = [this](const Point& x) { return chart_.beyond(reach_, x); }});
      if (path.points.size() < 2) continue;
      const Track track = track_of(path, placed);
      out.stretches.push_back(stretch_of(track));
    }
    out.shown = poses_;
    return out;
  }

 private:
  /// The point of a pose on the curve; moves the pose there if it lies visibly off.
  Point settle(Pose& pose) const {
    const Point x = chart_.point(pose);
    const std::optional<Point> on = curve_.corrected(x);
    if (!on) return x;
    if ((*on - x).norm() > visible) pose = chart_.pose(*on);
    return *on;
  }
  /// Where a walk passes x: index and fraction of the way to the next point; negative where it does not.
  static double passage(const Walk& path, const Point& x) {
    const std::size_t n = path.points.size();
    double best = -1, smallest = 1;
    for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {  // all: the next strand may have the nearest point
      const Point& p = path.points[i];
      const Point chord = aligned(path.points[(i + 1) % n], p) - p, offset = aligned(x, p) - p;
      const double f = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      const double miss = (offset - f * chord).norm() / (0.05 * chord.norm() + visible);
      if (miss > smallest) continue;
      smallest = miss;
      best = static_cast<double>(f > 1 - 1e-6 ? (i + 1) % n : i) + (f < 1e-6 || f > 1 - 1e-6 ? 0 : f);
    }
    return best;
  }

  Track track_of(const Walk& path, std::vector<bool>& placed) const {
    std::vector<std::pair<double, int>> met;
    for (std::size_t j = 0; j < poses_.size(); ++j) {
      const double at = placed[j] ? -1 : passage(path, points_[j]);
      if (at < 0) continue;
      met.push_back({at, static_cast<int>(j)});
      placed[j] = true;
    }
    std::sort(met.begin(), met.end());
    Track out;
    out.closed = path.closed;
    auto next = met.begin();
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Point& p = path.points[i];
      if (next == met.end() || next->first != static_cast<double>(i)) out.stations.push_back({p, chart_.pose(p)});
      for (; next != met.end() && next->first < static_cast<double>(i + 1); ++next)
        out.stations.push_back({aligned(points_[next->second], p), poses_[next->second], next->second});
    }
    if (out.closed)
      out.stations.push_back({out.stations.front().x, out.stations.front().pose});
    else
      trim(out.stations);
    return out;
  }
  /// Leaves away what lies beyond the horizon before the first and after the last task pose.
  void trim(std::vector<Track::Station>& stations) const {
    const auto goes_on = [this](const Track::Station& s) { return s.task < 0 && chart_.beyond(horizon, s.x); };
    const auto is_task = [](const Track::Station& s) { return s.task >= 0; };
    const auto last = std::find_if(stations.rbegin(), stations.rend(), is_task).base();
    stations.erase(std::find_if(last, stations.end(), goes_on), stations.end());
    const auto first = std::find_if(stations.begin(), stations.end(), is_task);
    const auto before = std::find_if(std::make_reverse_iterator(first), stations.rend(), goes_on);
    stations.erase(stations.begin(), before.base());
  }

  double visual_distance(const Pose& p, const Pose& q) const {
    double largest = 0;
    for (const Vector2& m : watched_) largest = std::max(largest, (to_fixed(p, m) - to_fixed(q, m)).norm());
    return largest;
  }

  /// The pose between two neighbouring stations.
  Pose between(const Track::Station& s, const Track::Station& t, double fraction) const {
    const Point guess = s.x + fraction * (aligned(t.x, s.x) - s.x);
    return chart_.pose(curve_.corrected(guess).value_or(guess));
  }

  Stretch stretch_of(const Track& track) const {
    const auto& s = track.stations;
    std::vector<double> way(s.size(), 0);
    std::vector<std::size_t> knots{0};
    for (std::size_t i = 1; i < s.size(); ++i) {
      way[i] = way[i - 1] + visual_distance(s[i - 1].pose, s[i].pose);
      if (s[i].task >= 0 || i + 1 == s.size()) knots.push_back(i);
    }
    const int most = std::max(48, most_frames - 2 - static_cast<int>(knots.size()));
    const double step = way.back() / std::clamp(std::ceil(way.back() / 0.04), 48.0, static_cast<double>(most));
    Stretch out;
    out.closed = track.closed;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) append_frames(track, way, knots[k], knots[k + 1], step, out);
    if (!track.closed) append_station(s.back(), out);
    return out;
  }
  static void append_station(const Track::Station& station, Stretch& out) {
    if (station.task >= 0) {
      out.poses.push_back(station.task);
      out.pose_frames.push_back(static_cast<int>(out.frames.size()));
    }
    out.frames.push_back(station.pose);
  }
  /// The station `from`, then frames at even distances before the station `to`.
  void append_frames(const Track& track, const std::vector<double>& way, std::size_t from, std::size_t to, double step,
                     Stretch& out) const {
    append_station(track.stations[from], out);
    const double length = way[to] - way[from];
    const int count = step > 0 ? std::max(1, static_cast<int>(std::ceil(length / step - 1e-9))) : 1;
    for (int j = 1; j < count; ++j) {
      const double at = way[from] + length * j / count;
      std::size_t i = from + 1;
      while (i < to && way[i] <= at) ++i;
      const double gap = way[i] - way[i - 1];
      out.frames.push_back(between(track.stations[i - 1], track.stations[i], gap > 0 ? (at - way[i - 1]) / gap : 0));
    }
  }

  Chart chart_;
  QuadricCurve curve_;
  std::vector<Vector2> watched_;
  std::vector<Pose> poses_;
  double reach_;
  std::vector<Point> points_;
};

}  // namespace

Motions motions_through(const std::vector<Pose>& poses, const Family::Design& a, const Family::Design& b) {
  return Sampler(poses, a, b).run();
}

}  // namespace burmester::planar
