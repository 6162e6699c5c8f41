#include "burmester/geometry/curve_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "burmester/geometry/partners_about.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester {
namespace {

using Point = Point2<double>;
using Box = Point2<Interval>;
constexpr double margin = 1.02;  // how far outside the window the last point of a piece may be
constexpr int first_chords = 8, deepest = 40;
constexpr double short_passage = 0x1p-12;  // from here on boxes are tried where tubes fail; a matter of speed only

/// A point of the curve and its partner, as each chart shows them.
struct Sample {
  std::array<TubePoint, 2> track;
  bool valid = true;                  ///< not so where a point has no single partner
  bool inside = false, near = false;  ///< of the window; of the window with its margin
};

/// The affine plane z = 1, seen through a square window.
class Plane {
 public:
  static constexpr bool has_opposites = false;
  explicit Plane(double window) : window_(window) {}
  /// (x, y, 1) near the window, a unit vector elsewhere.
  Point place(const Point& x) const {
    const double reach = margin * window_ * std::abs(x[2]);
    return x[2] != 0 && std::abs(x[0]) <= reach && std::abs(x[1]) <= reach ? Point(x / x[2]) : Point(x.normalized());
  }
  bool inside(const Point& x, double factor) const {
    const double reach = factor * window_ * std::abs(x[2]);
    return std::abs(x[0]) <= reach && std::abs(x[1]) <= reach;
  }
  static std::optional<Vector<double, 3>> normal(const Point& x, const Point& y) {
    const double dx = y[0] - x[0], dy = y[1] - x[1], size = std::sqrt(dx * dx + dy * dy);
    return Vector<double, 3>(-dy / size, dx / size, 0);
  }
  static double error(double radius, const Point&, const Point&) { return radius; }
  /// Whether the tube test proves that the curve between two points, without z, passes the window on one side.
  bool outside(const TubeCurve& curve, const TubePoint& from, const TubePoint& to, const Point& z) const {
    const TubePoint x = from.unit(), y = from.at.dot(to.at) < 0 ? to.unit().opposite() : to.unit();
    for (int k = 0; k < 2; ++k) {
      const double sign = x.at[k] < 0 ? -1 : 1, gap = std::min(sign * x.at[k] - window_ * std::abs(x.at[2]),
                                                               sign * y.at[k] - window_ * std::abs(y.at[2]));
      if (!(gap > 0)) continue;
      const Vector<double, 3> across = x.at.cross(y.at), n = across / across.norm();
      const auto proved = tube(curve, x, y, n);
      if (proved && proved->radius * (1 + window_) < gap && !over_chord(x, y, n, proved->radius, z)) return true;
    }
    return false;
  }
  bool outside(const Box& box) const {
    const double height = window_ * magnitude(box[2]);
    return lower(box[0]) > height || upper(box[0]) < -height || lower(box[1]) > height || upper(box[1]) < -height;
  }
  /// Largest distance from a point of the box to another point or to the samples; infinite where it reaches infinity.
  static double extent(const Box& box, const Point& x, const Point& y) {
    if (contains_zero(box[2])) return std::numeric_limits<double>::infinity();
    const auto along = [&](int k) {
      const Interval at = box[k] / box[2];
      return std::max({upper(at), x[k], y[k]}) - std::min({lower(at), x[k], y[k]});
    };
    return std::hypot(along(0), along(1)) * (1 + 0x1p-40);
  }

 private:
  double window_;
};

/// The unit sphere.
class Sphere {
 public:
  static constexpr bool has_opposites = true;
  static Point place(const Point& x) { return x.normalized(); }
  static bool inside(const Point&, double) { return true; }
  static std::optional<Vector<double, 3>> normal(const Point& x, const Point& y) {
    const Vector<double, 3> across = x.cross(y);
    const double size = across.norm();
    if (!(size > 0) || !(x.dot(y) > 0.5)) return std::nullopt;
    return Vector<double, 3>(across / size);
  }
  static double error(double radius, const Point& x, const Point& y) {
    return 2 * radius / (x + y).norm() * (1 + 0x1p-40);
  }
  static bool outside(const TubeCurve&, const TubePoint&, const TubePoint&, const Point&) { return false; }
  static bool outside(const Box&) { return false; }
  static double extent(const Box& box, const Point& x, const Point& y) {
    // Scaled to the height of x along its largest coordinate, the box is a patch near the sphere.
    int k = 0;
    for (int n = 1; n < 3; ++n)
      if (std::abs(x[n]) > std::abs(x[k])) k = n;
    if (contains_zero(box[k])) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (int n = 0; n < 3; ++n) {
      const Interval at = box[n] / box[k] * x[k];
      const double across = std::max({upper(at), x[n], y[n]}) - std::min({lower(at), x[n], y[n]});
      sum += across * across;
    }
    return 2 *
           std::sqrt(sum);  // an angle is at most 1.5 times its chord, and radial scaling at most 1 over |x| - across
  }
};

template <class Chart>
class Tracer {
 public:
  Tracer(const Chart& chart, const TubeCurve& curve, const std::optional<PartnerCurve>& partner,
         const TraceOptions& options)
      : chart_(chart), curve_(curve), partner_(partner), options_(options), tracks_(partner ? 2 : 1) {}

  std::vector<CurvePiece> trace(const CubicBranch& branch) {
    if (branch.passages.empty()) {
      complete_ = false;
      return {};
    }
    branch_ = &branch, pieces_.clear(), unbroken_ = true, connected_ = false, samples_ = 0;
    const Sample first = sample(start_of(branch.passages.front()), branch.passages.front().sheet);
    references_ = {first, sample(0, branch.passages.front().sheet)};  // 0 is an end of chords
    Sample at = first;
    for (const CubicBranch::Passage& passage : branch.passages)
      for (int k = 0; k < first_chords; ++k) {
        const double from = start_of(passage) * (1 - 2.0 * k / first_chords),
                     to = start_of(passage) * (1 - 2.0 * (k + 1) / first_chords);
        most_ = samples_ + options_.most_samples / first_chords;  // what one place takes is not missing elsewhere
        const bool last = k + 1 == first_chords && &passage == &branch.passages.back();
        at = follow(at, last ? first : sample(to, passage.sheet), from, to, passage.sheet, 0);
      }
    end_piece();
    close(first, at);
    return std::move(pieces_);
  }

  bool complete() const { return complete_; }

 private:
  static double start_of(const CubicBranch::Passage& passage) { return passage.backwards ? 1 : -1; }

  Sample sample(double s, int sheet) {
    Sample out;
    out.inside = out.near = true;
    Point p = branch_->approximate(s, sheet);
    for (std::size_t k = 0; k < tracks_; ++k) {
      if (k == 1) p = partner<double>(partner_->approximate, out.track[0].at);
      out.valid = out.valid && p.squaredNorm() > 0;
      out.track[k] = TubePoint(chart_.place(p), form(k));
      out.inside = out.inside && chart_.inside(out.track[k].at, 1);
      out.near = out.near && chart_.inside(out.track[k].at, margin);
    }
    out.inside = out.inside && out.valid, out.near = out.near && out.valid;
    ++samples_;
    return out;
  }

  /// Of two opposite points that are the same axis, those nearer to the sample before.
  Sample continued(const Sample& before, Sample next) const {
    if constexpr (Chart::has_opposites)
      for (std::size_t k = 0; k < tracks_; ++k)
        if (before.track[k].at.dot(next.track[k].at) < 0) next.track[k] = next.track[k].opposite();
    return next;
  }

  const TubeCurve& form(std::size_t track) const { return track == 0 ? curve_ : partner_->curve; }

  /// From x to what `end` shows, which is returned as the continuation of x.
  Sample follow(const Sample& x, const Sample& end, double from, double to, int sheet, int depth) {
    const Sample y = continued(x, end);
    int parts = 2;
    if (x.near && y.near && (x.inside || y.inside)) {
      const Chord chord = judge(x, y, from, to, sheet);
      if (chord.parts == 1) return accept(x, y, chord, from, sheet);
      parts = chord.parts;
    } else if (!x.valid && !y.valid) {
      complete_ = false;
      return interrupt(y);
    } else if (x.valid && y.valid && left_out(x, y, from, to, sheet)) {
      return interrupt(y);
    }
    const double step = (to - from) / parts;
    if (depth == deepest || samples_ > most_ || from + step == from || to - step == to) {
      complete_ = false;
      return interrupt(y);
    }
    Sample at = x;
    for (int k = 1; k < parts; ++k)
      at = follow(at, sample(from + k * step, sheet), from + (k - 1) * step, from + k * step, sheet, depth + 1);
    return follow(at, end, from + (parts - 1) * step, to, sheet, depth + 1);
  }

  /// parts = 1: accepted, with its proved error; otherwise as many parts as are expected to be.
  struct Chord {
    double error = 0;
    int parts = 2;
    std::array<double, 2> width{};  ///< of the tubes; none: the chord was judged by a box, which holds the branch;
                                    ///< infinite: the partner was
  };

  Chord judge(const Sample& x, const Sample& y, double from, double to, int sheet) const {
    double error = 0, length = 0;
    std::array<double, 2> width{};
    for (std::size_t k = 0; k < tracks_; ++k) length = std::max(length, (y.track[k].at - x.track[k].at).squaredNorm());
    length = std::sqrt(length);
    if (length > options_.longest) return {0, parts_for(length / options_.longest)};
    for (std::size_t k = 0; k < tracks_; ++k) {
      const TubePoint &a = x.track[k], &b = y.track[k];
      if (k == 1 && (b.at - a.at).norm() <= options_.tolerance)
        if (const double extent = partner_extent(x, y, box_of(from, to, sheet)); extent <= options_.tolerance) {
          error = std::max(error, extent);
          width[k] = std::numeric_limits<double>::infinity();
          continue;
        }
      const auto n = chart_.normal(a.at, b.at);
      const auto proved = n ? tube(form(k), a, b, *n) : std::nullopt;
      if (!proved) return length < options_.tolerance ? judge_by_box(x, y, from, to, sheet) : Chord();
      if (over_chord(a, b, *n, proved->radius, elsewhere(x, y).track[k].at)) return {};
      error = std::max(error, chart_.error(proved->radius, a.at, b.at));
      width[k] = proved->width;
    }
    if (error <= options_.tolerance) return {error, 1, width};
    return {error, parts_for(std::sqrt(error / options_.tolerance)), width};
  }
  /// A sample that is not between x and y, nor one of them.
  const Sample& elsewhere(const Sample& x, const Sample& y) const {
    const Point& first = references_[0].track[0].at;
    const auto is_first = [&](const Sample& sample) {
      return sample.track[0].at == first || sample.track[0].at == -first;
    };
    return references_[is_first(x) || is_first(y) ? 1 : 0];
  }
  static int parts_for(double ratio) {
    return std::clamp(static_cast<int>(std::ceil(std::min(1.05 * ratio, 8.0))), 2, 8);
  }

  Chord judge_by_box(const Sample& x, const Sample& y, double from, double to, int sheet) const {
    const std::array<Box, 2> box = boxes(from, to, sheet);
    double error = 0;
    for (std::size_t k = 0; k < tracks_; ++k) {
      double extent = chart_.extent(box[k], x.track[k].at, y.track[k].at);
      if (k == 1 && !(extent <= options_.tolerance)) extent = partner_extent(x, y, box[0]);
      if (!(extent <= options_.tolerance)) return {};  // also where it is not a number
      error = std::max(error, extent);
    }
    return {error, 1};
  }

  Box box_of(double from, double to, int sheet) const {
    return branch_->enclosing(Interval(std::min(from, to), std::max(from, to)), sheet);
  }
  std::array<Box, 2> boxes(double from, double to, int sheet) const {
    std::array<Box, 2> box{box_of(from, to, sheet)};
    if (tracks_ == 2) box[1] = partner<Interval>(partner_->enclosing, box[0]);
    return box;
  }

  /// As Chart::extent, of the partners of a box: no matter how long it is where all of them are one point.
  double partner_extent(const Sample& x, const Sample& y, const Box& p) const {
    return chart_.extent(partners_about(*partner_, x.track[1].at, p), x.track[1].at, y.track[1].at);
  }

  bool left_out(const Sample& x, const Sample& y, double from, double to, int sheet) const {
    for (std::size_t k = 0; k < tracks_; ++k)
      if (chart_.outside(form(k), x.track[k], y.track[k], elsewhere(x, y).track[k].at)) return true;
    if (std::abs(to - from) > short_passage) return false;
    const std::array<Box, 2> box = boxes(from, to, sheet);  // near singular points no tube can be proved
    return chart_.outside(box[0]) || (tracks_ == 2 && chart_.outside(box[1]));
  }

  const Sample& accept(const Sample& x, const Sample& y, const Chord& chord, double from, int sheet) {
    if (!connected_) {
      pieces_.emplace_back();
      pieces_.back().component = branch_->component;
      append(x);
      on_branch_ = false;
    }
    connected_ = true;
    on_branch_ = on_branch_ || is_on_branch(x, chord, from, sheet);
    append(y);
    pieces_.back().max_error = std::max(pieces_.back().max_error, chord.error);
    return y;
  }

  /// The chords of a piece follow one part of the curve. It is this branch if one point of it is proved to be: if the box
  /// that holds the branch at x lies in the tube of the chord.
  bool is_on_branch(const Sample& x, const Chord& chord, double from, int sheet) const {
    if (chord.width[0] == 0) return true;  // judged by a box
    const std::array<Box, 2> box = boxes(from, from, sheet);
    for (std::size_t k = 0; k < tracks_; ++k)
      if (!(chart_.extent(box[k], x.track[k].at, x.track[k].at) <= chord.width[k])) return false;
    return true;
  }

  const Sample& interrupt(const Sample& y) {
    end_piece();
    connected_ = unbroken_ = false;
    return y;
  }
  /// A piece that could not be proved to be of this branch is not shown.
  void end_piece() {
    if (!connected_ || on_branch_) return;
    pieces_.pop_back();
    connected_ = unbroken_ = complete_ = false;
  }

  void append(const Sample& x) {
    pieces_.back().points.push_back(x.track[0].at);
    if (tracks_ == 2) pieces_.back().partners.push_back(x.track[1].at);
  }

  /// Joins the end of the branch to its beginning.
  void close(const Sample& first, const Sample& last) {
    if (pieces_.empty()) return;
    CurvePiece& end = pieces_.back();
    if (unbroken_) {
      if (first.track[0].at.dot(last.track[0].at) < 0 || (tracks_ == 2 && first.track[1].at.dot(last.track[1].at) < 0))
        go_round_again(end, first, last);
      end.points.pop_back();
      if (tracks_ == 2) end.partners.pop_back();
      end.closed = true;
      return;
    }
    CurvePiece& begin = pieces_.front();
    if (pieces_.size() < 2 || !connected_ || begin.points.front() != first.track[0].at) return;
    end.points.insert(end.points.end(), begin.points.begin() + 1, begin.points.end());
    if (tracks_ == 2) end.partners.insert(end.partners.end(), begin.partners.begin() + 1, begin.partners.end());
    end.max_error = std::max(end.max_error, begin.max_error);
    pieces_.erase(pieces_.begin());
  }

  /// On the sphere: the branch has come to the opposite of its beginning, or its partner has.
  static void go_round_again(CurvePiece& piece, const Sample& first, const Sample& last) {
    const auto repeat = [](std::vector<Point>& points, double sign) {
      for (std::size_t k = 1, n = points.size(); k < n; ++k) points.push_back(sign * points[k]);
    };
    repeat(piece.points, first.track[0].at.dot(last.track[0].at) < 0 ? -1 : 1);
    if (!piece.partners.empty()) repeat(piece.partners, first.track[1].at.dot(last.track[1].at) < 0 ? -1 : 1);
  }

  Chart chart_;
  const TubeCurve& curve_;
  const std::optional<PartnerCurve>& partner_;
  TraceOptions options_;
  std::size_t tracks_;
  const CubicBranch* branch_ = nullptr;
  std::array<Sample, 2> references_;
  std::vector<CurvePiece> pieces_;
  bool unbroken_ = true, connected_ = false, on_branch_ = false, complete_ = true;
  int samples_ = 0, most_ = 0;
};

template <class Chart>
TracedCurve trace(const Chart& chart, const CubicBranches& traced, const TubeCurve& curve,
                              const std::optional<PartnerCurve>& partner, const TraceOptions& options) {
  check(options);
  Tracer<Chart> tracer(chart, curve, partner, options);
  TracedCurve out;
  for (const CubicBranch& branch : traced.branches)
    for (CurvePiece& piece : tracer.trace(branch)) out.pieces.push_back(std::move(piece));
  out.complete = tracer.complete();
  return out;
}

}  // namespace

TubeCurve tube_curve(const Cubic<Interval>& f) {
  Cubic<double> middle;
  double error = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    middle.c[k] = approximate(f.c[k]);
    error = std::max(error, magnitude(Interval(f.c[k] - middle.c[k])));
  }
  return TubeCurve(middle, error);
}

PartnerCurve partner_curve(const std::array<Correlation<Interval>, 3>& n) {
  std::array<Correlation<double>, 3> middle;
  std::array<Correlation<Interval>, 3> back;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 9; ++i) middle[k](i) = approximate(n[k](i));
    back[k] = n[k].transpose();
  }
  return {middle, n, tube_curve(points_with_partner(back))};
}

TracedCurve trace_in_plane(const CubicBranches& traced, const TubeCurve& curve,
                                       const std::optional<PartnerCurve>& partner, const TraceOptions& options) {
  return trace(Plane(options.window), traced, curve, partner, options);
}

TracedCurve trace_on_sphere(const CubicBranches& traced, const TubeCurve& curve,
                                        const std::optional<PartnerCurve>& partner, const TraceOptions& options) {
  return trace(Sphere(), traced, curve, partner, options);
}

}  // namespace burmester
