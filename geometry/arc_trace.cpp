#include "burmester/geometry/arc_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "burmester/geometry/arc_samples.hpp"

namespace burmester {
namespace {

using detail::ArcSamples;
using detail::Place;
using detail::Vertex;

constexpr double safe = 1 + 0x1p-40;
constexpr int deepest = 60;

/// Where an arc ends beside a critical line.
struct HalfBranch {
  double u = std::numeric_limits<double>::quiet_NaN();
  int partner = -1;  ///< the half-branch with which it goes on
  double error = 0;
  std::optional<Point2<double>> through;  ///< the point of the critical line between them, if it is shown
  int run = -1;
};

/// Accepted chords one after the other.
struct Run {
  std::vector<Point2<double>> points;
  double error = 0;
  int component = 0;
  std::array<int, 2> half_branch{-1, -1};  ///< at its beginning and its end, where it goes on
};

class ArcTracer {
 public:
  ArcTracer(const CurveArcs& arcs, const TraceOptions& options)
      : arcs_(arcs),
        options_(options),
        samples_(arcs, options.window),
        scale_(std::hypot(arcs.a, arcs.b)),
        rounding_(0x1p-48 * options.window),  // of coordinates on the way back into the plane, generously
        tolerance_((std::min(options.tolerance, options.window / 200) - rounding_) / (scale_ * safe * safe)),
        reach_(1.05 * (std::abs(arcs.a) + std::abs(arcs.b)) * options.window / (scale_ * scale_)) {
    first_.push_back(0);
    for (const std::vector<int>& interval : arcs.component)
      first_.push_back(first_.back() + static_cast<int>(interval.size()));
    half_branches_.resize(2 * static_cast<std::size_t>(first_.back()));
  }

  TracedCurve trace() {
    for (int i = 0; i < lines(); ++i)
      if (reaches_window(i))
        for (const ArcEnds& ends : line(i).points) join(i, ends);
    for (int i = 0; i <= lines(); ++i) {
      if ((i > 0 && !(lower(line(i - 1).u) < reach_)) || (i < lines() && !(upper(line(i).u) > -reach_))) continue;
      for (int k = 0; k < arcs_in(i); ++k) trace_arc(i, k);
    }
    chain();
    std::stable_sort(out_.pieces.begin(), out_.pieces.end(),
                     [](const CurvePiece& a, const CurvePiece& b) { return a.component < b.component; });
    return std::move(out_);
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  int lines() const { return static_cast<int>(arcs_.lines.size()); }
  const CriticalLine& line(int i) const { return arcs_.lines[index(i)]; }
  int arcs_in(int interval) const { return static_cast<int>(arcs_.component[index(interval)].size()); }
  bool reaches_window(int i) const { return upper(line(i).u) > -reach_ && lower(line(i).u) < reach_; }
  /// side 0: where the arc begins, 1: where it ends
  int half_branch_id(int interval, int k, int side) const { return 2 * (first_[index(interval)] + k) + side; }
  HalfBranch& half_branch(int id) { return half_branches_[index(id)]; }

  // ---- Critical lines ----

  /// A box about a point of a critical line.
  struct Star {
    Place low, high;  ///< corners
    std::vector<int> ids;
    std::vector<Vertex> vertices;
    double overshoot(double least, double most) const { return std::max(least - low.v, high.v - most); }
  };

  /// How far the next lines are, at least.
  double room(int i) const {
    double out = tolerance_;
    if (i > 0) out = std::min(out, lower(Interval(lower(line(i).u)) - upper(line(i - 1).u)));
    if (i + 1 < lines()) out = std::min(out, lower(Interval(lower(line(i + 1).u)) - upper(line(i).u)));
    return out / 4;
  }

  /// Nothing where no box of this width is proved to hold the arcs up to the point.
  std::optional<Star> star(int i, const ArcEnds& ends, double width) {
    Star out;
    out.low.u = ends.left > 0 ? lower(line(i).u) - width : lower(line(i).u);
    out.high.u = ends.right > 0 ? upper(line(i).u) + width : upper(line(i).u);
    double clearance = tolerance_, radius = 0;
    out.low.v = 1e300, out.high.v = -1e300;
    if (ends.known_place) out.low.v = lower(ends.v), out.high.v = upper(ends.v);
    const auto add = [&](int interval, int first, int count, double u, int side) {
      for (int k = first; k < first + count; ++k) {
        const std::optional<Vertex> x = samples_.vertex(interval, k, u);
        if (!x) return false;
        out.low.v = std::min(out.low.v, x->at.v), out.high.v = std::max(out.high.v, x->at.v);
        radius = std::max(radius, x->radius);
        out.ids.push_back(half_branch_id(interval, k, side));
        out.vertices.push_back(*x);
      }
      if (count == 0) return true;
      const std::vector<Range>& all = samples_.arcs_at(interval, u);
      if (first > 0) clearance = std::min(clearance, all[index(first)].low - all[index(first - 1)].high);
      if (const int next = first + count; next < arcs_in(interval))
        clearance = std::min(clearance, all[index(next)].low - all[index(next - 1)].high);
      return true;
    };
    if (!add(i, ends.first_left, ends.left, out.low.u, 1)) return std::nullopt;
    if (!add(i + 1, ends.first_right, ends.right, out.high.u, 0)) return std::nullopt;
    const double beyond = std::min(tolerance_, clearance) / 4 + radius;
    out.low.v -= beyond, out.high.v += beyond;
    const bool holds = samples_.no_zero_between(out.low, {out.high.u, out.low.v}) &&
                       samples_.no_zero_between({out.low.u, out.high.v}, out.high);
    return holds ? std::optional(out) : std::nullopt;
  }

  /// Finds where the arcs at a point of line i go on.
  void join(int i, const ArcEnds& ends) {
    std::optional<Place> at;
    if (ends.known_place) at = Place{approximate(enclosure_of(line(i).u)), approximate(enclosure_of(ends.v))};
    if (ends.left + ends.right == 0) {
      if (const Point2<double> p = samples_.in_plane(*at); samples_.in_window(p))
        out_.pieces.push_back({ends.component, false, rounding_ + point_error(line(i).u, ends.v), {p}, {}});
      return;
    }
    double width = room(i);
    for (int k = 0; k < ends.left; ++k)
      half_branch(half_branch_id(i, ends.first_left + k, 1)).u = lower(line(i).u) - width;
    for (int k = 0; k < ends.right; ++k)
      half_branch(half_branch_id(i + 1, ends.first_right + k, 0)).u = upper(line(i).u) + width;
    for (int step = 0; step < deepest; ++step, width /= 4) {
      if (!(lower(line(i).u) - width < lower(line(i).u)) || !(upper(line(i).u) + width > upper(line(i).u))) break;
      const std::optional<Star> box = star(i, ends, width);
      if (!box) continue;
      for (std::size_t k = 0; k < box->ids.size(); ++k) half_branch(box->ids[k]).u = box->vertices[k].at.u;
      const Place &low = box->low, &high = box->high;
      if (samples_.outside(std::array{low, Place{low.u, high.v}, high, Place{high.u, low.v}}) || link(*box, at)) return;
    }
    give_up();
  }
  static Interval enclosure_of(const RationalInterval& x) { return {lower(x), upper(x)}; }
  double point_error(const RationalInterval& u, const RationalInterval& v) const {
    const auto width = [](const Interval& x) { return upper(x) - lower(x); };
    return scale_ * safe * (width(enclosure_of(u)) + width(enclosure_of(v)));
  }

  /// Pairs the arcs such that they go on as straight as they can; false where an error is above the tolerance.
  bool link(const Star& star, const std::optional<Place>& at) {
    const std::size_t n = star.ids.size();
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> pairs;  // cosine of the angle between them
    const auto direction = [&](std::size_t k) {
      const Vector<double, 2> d(star.vertices[k].at.u - at->u, star.vertices[k].at.v - at->v);
      return Vector<double, 2>(d / d.norm());
    };
    for (std::size_t k = 0; k < n; ++k) {
      if (!star.vertices[k].near) return false;
      for (std::size_t m = 0; m < k; ++m) pairs.push_back({n == 2 ? 0 : direction(k).dot(direction(m)), {k, m}});
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<bool> taken(n);
    std::vector<HalfBranch> linked(n);
    for (const auto& [cosine, pair] : pairs) {
      const auto [k, m] = pair;
      if (taken[k] || taken[m]) continue;
      taken[k] = taken[m] = true;
      const std::optional<double> error = error_of(star, star.vertices[k].at, star.vertices[m].at, at);
      if (!error) return false;
      linked[k] = {star.vertices[k].at.u, star.ids[m], *error, {}};
      linked[m] = {star.vertices[m].at.u, star.ids[k], *error, {}};
      if (at) linked[k].through = linked[m].through = samples_.in_plane(*at);
    }
    for (std::size_t k = 0; k < n; ++k) half_branch(star.ids[k]) = linked[k];
    return true;
  }
  /// Of the chords from x, through the point, to y.
  std::optional<double> error_of(const Star& star, const Place& x, const Place& y,
                                 const std::optional<Place>& at) const {
    double least = std::min(x.v, y.v), most = std::max(x.v, y.v);
    if (at) least = std::min(least, at->v), most = std::max(most, at->v);
    const double error = std::hypot(star.high.u - star.low.u, star.overshoot(least, most)) * safe;
    const bool good = error <= tolerance_ && (most - least) * scale_ <= options_.longest;
    return good ? std::optional(error) : std::nullopt;
  }

  // ---- Arcs ----

  void trace_arc(int interval, int k) {
    const int begin = half_branch_id(interval, k, 0), end = half_branch_id(interval, k, 1);
    const bool from_line = interval > 0 && reaches_window(interval - 1),
               to_line = interval < lines() && reaches_window(interval);
    const double from = from_line ? half_branch(begin).u : -reach_, to = to_line ? half_branch(end).u : reach_;
    interval_ = interval, arc_ = k, connected_ = false, count_ = 0;
    if (std::isnan(from) || std::isnan(to)) return give_up();
    const std::optional<Vertex> x = samples_.vertex(interval, k, from), y = samples_.vertex(interval, k, to);
    if (!x || !y) return give_up();
    if (half_branch(begin).partner >= 0) {
      start_run(*x);
      runs_.back().half_branch[0] = begin, half_branch(begin).run = static_cast<int>(runs_.size()) - 1;
    }
    if (from < to) follow(*x, *y, 0);
    if (half_branch(end).partner < 0) return;
    if (!connected_) start_run(*y);
    runs_.back().half_branch[1] = end, half_branch(end).run = static_cast<int>(runs_.size()) - 1;
  }

  void follow(const Vertex& x, const Vertex& y, int depth) {
    const double du = y.at.u - x.at.u, dv = y.at.v - x.at.v;
    const double p = std::abs(x.slope - dv / du), q = std::abs(y.slope - dv / du);
    // The cubic with the same ends and slopes is du t (1 - t) ((1 - t) p -+ t q) above the chord.
    const double sagitta = du * std::min(0.25 * std::max(p, q), 0.15 * (p + q));
    const double height =
        1.1 * sagitta + std::min(tolerance_ / 4, std::min(x.gap, y.gap)) / 4 + std::max(x.radius, y.radius);
    const double length = std::hypot(du, dv) * scale_;
    const bool near = x.near && y.near, fine = height <= tolerance_ && length <= options_.longest;
    if (std::isfinite(height) && (fine || !near)) {
      const std::array<Place, 4> corners = {Place{x.at.u, x.at.v - height}, Place{y.at.u, y.at.v - height},
                                            Place{y.at.u, y.at.v + height}, Place{x.at.u, x.at.v + height}};
      const bool left_out = samples_.outside(corners), accepted = near && (x.inside || y.inside || length < tolerance_);
      if ((left_out || accepted) && samples_.no_zero_between(corners[0], corners[1]) &&
          samples_.no_zero_between(corners[3], corners[2]))
        return left_out ? void(connected_ = false) : accept(x, y, height);
    }
    const double middle = x.at.u + du / 2;
    const bool can_halve = depth < deepest && ++count_ < options_.most_samples && x.at.u < middle && middle < y.at.u;
    const std::optional<Vertex> between = can_halve ? samples_.vertex(interval_, arc_, middle) : std::nullopt;
    if (!between) {
      connected_ = false;
      return give_up();
    }
    follow(x, *between, depth + 1);
    follow(*between, y, depth + 1);
  }

  void start_run(const Vertex& x) {
    runs_.emplace_back();
    runs_.back().component = arcs_.component[index(interval_)][index(arc_)];
    runs_.back().points.push_back(x.in_plane);
    connected_ = true;
  }
  void accept(const Vertex& x, const Vertex& y, double error) {
    if (!connected_) start_run(x);
    runs_.back().points.push_back(y.in_plane);
    runs_.back().error = std::max(runs_.back().error, error);
  }
  void give_up() { out_.complete = false; }

  // ---- Pieces ----

  void chain() {
    std::vector<bool> done(runs_.size());
    for (const bool only_open : {true, false})
      for (int r = 0; r < static_cast<int>(runs_.size()); ++r)
        for (const int side : {0, 1})
          if (!done[index(r)] && (!only_open || runs_[index(r)].half_branch[index(side)] < 0)) add_piece(r, side, done);
  }
  /// From this side of run r as far as it goes.
  void add_piece(int r, int side, std::vector<bool>& done) {
    CurvePiece& piece = out_.pieces.emplace_back();
    piece.component = runs_[index(r)].component;
    double error = 0;
    while (!piece.closed) {
      Run& run = runs_[index(r)];
      done[index(r)] = true;
      if (side == 1) std::reverse(run.points.begin(), run.points.end());
      piece.points.insert(piece.points.end(), run.points.begin(), run.points.end());
      error = std::max(error, run.error);
      const int last = run.half_branch[index(1 - side)];
      if (last < 0) break;
      const HalfBranch& here = half_branch(last);
      error = std::max(error, here.error);
      if (here.through) piece.points.push_back(*here.through);
      r = half_branch(here.partner).run, side = here.partner % 2;
      if (r < 0) break;
      piece.closed = done[index(r)];
    }
    piece.max_error = error * scale_ * safe + rounding_;
  }

  const CurveArcs& arcs_;
  const TraceOptions options_;
  ArcSamples samples_;
  const double scale_;      ///< lengths in the plane, over those in (u, v)
  const double rounding_;   ///< in the plane
  const double tolerance_;  ///< in (u, v)
  const double reach_;      ///< the window and its margin are within |u| < reach
  std::vector<int> first_;  ///< arc of each interval
  std::vector<HalfBranch> half_branches_;
  std::vector<Run> runs_;
  TracedCurve out_;
  int interval_ = 0, arc_ = 0, count_ = 0;
  bool connected_ = false;
};

}  // namespace

TracedCurve trace_arcs(const CurveArcs& arcs, const TraceOptions& options) {
  check(options);
  if (arcs.form.degree == 0) return {};
  const UpwardRounding upward;
  return ArcTracer(arcs, options).trace();
}

}  // namespace burmester
