#include "burmester/geometry/curve_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "burmester/geometry/branch_box.hpp"
#include "burmester/geometry/partners_about.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/trace_charts.hpp"

namespace burmester {
namespace {

using namespace detail;  // the charts and their samples
constexpr int first_chords = 8;
constexpr int deep = 20, deepest = 200;    // halvings: from where doubles may fail to tell points apart, and a guard
constexpr double told = 0x1p-10;           // well below half a chord, which a point that is to lie elsewhere must miss
constexpr double short_passage = 0x1p-12;  // from here on boxes are tried where tubes fail; a matter of speed only

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
    Sample first = sample(start_of(branch.passages.front()), branch.passages.front().sheet);
    first.end = 0;
    find_references(branch.passages.front());
    Sample at = first;
    int end = 0;
    for (const CubicBranch::Passage& passage : branch.passages)
      for (int k = 0; k < first_chords; ++k) {
        const double from = start_of(passage) * (1 - 2.0 * k / first_chords),
                     to = start_of(passage) * (1 - 2.0 * (k + 1) / first_chords);
        most_ = samples_ + options_.most_samples / first_chords;  // what one place takes is not missing elsewhere
        const bool last = k + 1 == first_chords && &passage == &branch.passages.back();
        Sample next = last ? first : sample(to, passage.sheet);
        if (!last) next.end = ++end;
        follow(at, next, from, to, passage.sheet, 0);
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
    const Point seen = branch_->approximate.seen(s, sheet);
    Point p = branch_->approximate.frame.placed(seen);
    for (std::size_t k = 0; k < tracks_; ++k) {
      if (k == 1) p = partner<double>(partner_->approximate, seen);
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
  decltype(auto) continued(const Sample& before, const Sample& next) const {
    if constexpr (Chart::has_opposites) {
      Sample out = next;
      for (std::size_t k = 0; k < tracks_; ++k)
        if (before.track[k].at.dot(next.track[k].at) < 0) out.track[k] = next.track[k].opposite();
      return out;
    } else {
      return (next);
    }
  }

  const TubeCurve& form(std::size_t track) const { return track == 0 ? curve_ : partner_->curve; }

  /// Leads x to what `end` shows, as the continuation of x.
  void follow(Sample& x, const Sample& end, double from, double to, int sheet, int depth) {
    const Sample& y = continued(x, end);
    const int parts = step(x, y, from, to, sheet, depth);
    if (parts == 1) {
      x = y;
      return;
    }
    const double length = (to - from) / parts;
    for (int k = 1; k < parts; ++k)
      follow(x, sample(from + k * length, sheet), from + (k - 1) * length, from + k * length, sheet, depth + 1);
    follow(x, end, from + (parts - 1) * length, to, sheet, depth + 1);
  }

  /// Accepts the chord, leaves it out or gives it up: 1. Otherwise as many parts as are to be looked at.
  int step(const Sample& x, const Sample& y, double from, double to, int sheet, int depth) {
    int parts = 2;
    if (x.near && y.near && (x.inside || y.inside)) {
      const Chord chord = judge(x, y, from, to, sheet);
      if (chord.parts == 1) accept(x, y, chord, from, to, sheet);
      parts = chord.parts;
    } else if (!x.valid && !y.valid) {
      give_up();
      parts = 1;
    } else if (x.valid && y.valid && left_out(x, y, from, to, sheet)) {
      interrupt();
      parts = 1;
    }
    if (parts == 1) return 1;
    const double length = (to - from) / parts;
    const bool no_more = depth == deepest || samples_ > most_ || from + length == from || to - length == to;
    if (!no_more && (depth < deep || tells(x, from, sheet) || tells(y, to, sheet))) return parts;
    give_up();
    return 1;
  }

  /// parts = 1: accepted, with its proved error; otherwise as many parts as are expected to be.
  struct Chord {
    double error = 0;
    int parts = 2;
    std::array<double, 2> width{};  ///< of the tubes; infinite: a box proved it, which holds the branch
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
        if (const double extent =
                partner_extent(x, y, box_with_partners(branch_->enclosing, *partner_, from, to, sheet).seen);
            extent <= options_.tolerance) {
          error = std::max(error, extent);
          width[k] = std::numeric_limits<double>::infinity();
          continue;
        }
      const auto n = chart_.normal(a.at, b.at);
      const Reference* other = elsewhere(x, y, k);
      const auto proved = n && other ? tube(form(k), a, b, *n) : std::nullopt;
      if (!proved) {
        if (!((b.at - a.at).norm() < options_.tolerance)) return {};
        const double extent = extent_of_box(k, x, y, from, to, sheet);
        if (!(extent <= options_.tolerance)) return {};  // also where it is not a number
        error = std::max(error, extent);
        width[k] = std::numeric_limits<double>::infinity();
        continue;
      }
      if (over_chord(a, b, *n, proved->radius, other->at, other->off)) return {};
      error = std::max(error, chart_.error(proved->radius, a.at, b.at));
      width[k] = proved->width;
    }
    if (error <= options_.tolerance) return {error, 1, width};
    return {error, parts_for(std::sqrt(error / options_.tolerance)), width};
  }
  struct Reference {
    int end;  ///< as in Sample
    Point at;
    double off = 0;  ///< how far a point of the branch may be from it, as an angle
  };
  /// Ends of first chords where a box tells the point of each track.
  void find_references(const CubicBranch::Passage& passage) {
    references_ = {};
    for (const int k : {0, 4, 2, 6, 1, 3, 5, 7}) {
      if (references_[0].size() == 2 && references_[tracks_ - 1].size() == 2) return;
      const double s = start_of(passage) * (1 - 2.0 * k / first_chords);
      const Sample at = sample(s, passage.sheet);
      const BranchBox box = boxes(s, s, passage.sheet);
      for (std::size_t track = 0; track < tracks_; ++track)
        if (const double off = distance_from_box(box.track[track], at.track[track].unit().at); off < told)
          references_[track].push_back({k, at.track[track].at, off});
    }
  }
  /// A point of the track that is not between x and y, nor one of them; none where no box tells one.
  const Reference* elsewhere(const Sample& x, const Sample& y, std::size_t track) const {
    for (const Reference& reference : references_[track])
      if (reference.end != x.end && reference.end != y.end) return &reference;
    return nullptr;
  }
  static int parts_for(double ratio) {
    return std::clamp(static_cast<int>(std::ceil(std::min(1.05 * ratio, 8.0))), 2, 8);
  }

  double extent_of_box(std::size_t k, const Sample& x, const Sample& y, double from, double to, int sheet) const {
    const BranchBox box = boxes(from, to, sheet);
    const double extent = chart_.extent(box.track[k], x.track[k].at, y.track[k].at);
    return k == 1 && !(extent <= options_.tolerance) ? partner_extent(x, y, box.seen) : extent;
  }

  BranchBox boxes(double from, double to, int sheet) const {
    const BranchForms<Interval>& branch = branch_->enclosing;
    if (from == to) {
      const Box seen = branch.seen(Interval(from), sheet), at = branch.frame.placed(seen);
      return {{at, tracks_ == 2 ? partner<Interval>(partner_->enclosing, seen) : at}, seen};
    }
    if (tracks_ == 2) return box_with_partners(branch, *partner_, from, to, sheet);
    return {{box_of_points(branch, from, to, sheet)}, {}};
  }

  /// As Chart::extent, of the partners of a box in the frame: no matter how long it is where all of them are one point.
  double partner_extent(const Sample& x, const Sample& y, const Box& p) const {
    return chart_.extent(partners_about(*partner_, x.track[1].at, p), x.track[1].at, y.track[1].at);
  }

  /// Whether doubles tell where on the curves x is, well within the tolerance: not so beside a point that has a line of
  /// partners.
  bool tells(const Sample& x, double s, int sheet) const {
    for (std::size_t k = 0; x.near && k < tracks_; ++k)
      if (!(extent_of_box(k, x, x, s, s, sheet) <= 0x1p-2 * options_.tolerance)) return false;
    return true;
  }

  bool left_out(const Sample& x, const Sample& y, double from, double to, int sheet) const {
    for (std::size_t k = 0; k < tracks_; ++k) {
      const Reference* other = elsewhere(x, y, k);
      const auto at_x = [&] { return boxes(from, from, sheet).track[k]; };
      if (other && chart_.outside(form(k), x.track[k], y.track[k], other->at, other->off, at_x)) return true;
    }
    if (std::abs(to - from) > short_passage) return false;
    const BranchBox box = boxes(from, to, sheet);  // near singular points no tube can be proved
    return chart_.outside(box.track[0]) || (tracks_ == 2 && chart_.outside(box.track[1]));
  }

  void accept(const Sample& x, const Sample& y, const Chord& chord, double from, double to, int sheet) {
    if (!connected_) {
      pieces_.emplace_back();
      pieces_.back().component = branch_->component;
      append(x);
      merged_.open = unproved_ = false, runs_ = {};
    }
    connected_ = true;
    for (std::size_t k = 0; k < tracks_; ++k) continue_run(k, x, y, chord, from, to, sheet);
    merge_or_append(x, y, chord);
  }

  /// Chords with tubes, one after the other, follow one part of the curve. It is this branch if one point of it is
  /// proved to be. A box holds the branch itself, and ends the run.
  void continue_run(std::size_t k, const Sample& x, const Sample& y, const Chord& chord, double from, double to,
                    int sheet) {
    Run& run = runs_[k];
    if (!std::isfinite(chord.width[k])) {
      unproved_ = unproved_ || run == Run::claimed;
      run = Run::none;
    } else if (run != Run::proved) {
      const bool proved =
          is_on_branch(k, x, y, chord.width[k], from, sheet) || is_on_branch(k, y, x, chord.width[k], to, sheet);
      run = proved ? Run::proved : Run::claimed;
    }
  }

  /// Near singular points chords are far shorter than the tolerance. Those that lie in a disc about the beginning x of
  /// the first become one: the curve is within their largest error of them, and they are within the disc's radius of x.
  void merge_or_append(const Sample& x, const Sample& y, const Chord& chord) {
    CurvePiece& piece = pieces_.back();
    double error = chord.error;
    const bool by_box = !std::isfinite(chord.width[0]) || !std::isfinite(chord.width[1]);
    if (by_box) {
      const auto distance = [&](const Sample& from) {
        double out = 0;
        for (std::size_t k = 0; k < tracks_; ++k) out = std::max(out, (y.track[k].at - from.track[k].at).norm());
        return out;
      };
      const Merged more{merged_.from, std::max(merged_.reach, distance(merged_.from)), std::max(merged_.error, error),
                        true};
      if (merged_.open && more.reach + more.error <= options_.tolerance) {
        piece.points.pop_back();
        if (tracks_ == 2) piece.partners.pop_back();
        merged_ = more;
        error = more.reach + more.error;
      } else {
        merged_ = {x, distance(x), error, true};
      }
    }
    merged_.open = by_box;
    append(y);
    piece.max_error = std::max(piece.max_error, error);
  }

  /// Whether the box that holds the branch at x lies in the tube of the chord, or in a wider one.
  bool is_on_branch(std::size_t k, const Sample& x, const Sample& y, double width, double from, int sheet) const {
    const TubePoint &a = x.track[k], &b = y.track[k];
    const double extent = chart_.extent(boxes(from, from, sheet).track[k], a.at, a.at);
    if (extent <= width) return true;
    const auto n = chart_.normal(a.at, b.at);
    return std::isfinite(extent) && n && tube(form(k), a, b, *n, extent);
  }

  /// Where a part cannot be proved. What was proved beside it is not shown if it is smaller than the tolerance.
  void give_up() {
    complete_ = false;
    const auto tiny = [&](const std::vector<Point>& all) {
      return std::ranges::all_of(all, [&](const Point& p) { return (p - all[0]).norm() <= options_.tolerance; });
    };
    if (connected_) unproved_ = unproved_ || (tiny(pieces_.back().points) && tiny(pieces_.back().partners));
    interrupt();
  }
  void interrupt() {
    end_piece();
    connected_ = unbroken_ = false;
  }
  /// A piece that could not be proved to be of this branch is not shown.
  void end_piece() {
    const bool claimed = std::ranges::find(runs_, Run::claimed) != runs_.end();
    if (!connected_ || !(unproved_ || claimed)) return;
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
        go_on(end, CurvePiece(end), first, last);  // round again
      end.points.pop_back();
      if (tracks_ == 2) end.partners.pop_back();
      end.closed = true;
      return;
    }
    CurvePiece& begin = pieces_.front();
    if (pieces_.size() < 2 || !connected_ || begin.points.front() != first.track[0].at) return;
    go_on(end, begin, first, last);
    end.max_error = std::max(end.max_error, begin.max_error);
    pieces_.erase(pieces_.begin());
  }

  /// Appends what follows `first` to what ends at `last`: the same, or on the sphere the opposite, as may be its
  /// partner.
  static void go_on(CurvePiece& piece, const CurvePiece& next, const Sample& first, const Sample& last) {
    const auto append = [](std::vector<Point>& to, const std::vector<Point>& from, const TubePoint& a,
                           const TubePoint& b) {
      const double sign = a.at.dot(b.at) < 0 ? -1 : 1;
      for (std::size_t k = 1; k < from.size(); ++k) to.push_back(sign * from[k]);
    };
    append(piece.points, next.points, first.track[0], last.track[0]);
    if (!piece.partners.empty()) append(piece.partners, next.partners, first.track[1], last.track[1]);
  }

  Chart chart_;
  const TubeCurve& curve_;
  const std::optional<PartnerCurve>& partner_;
  TraceOptions options_;
  std::size_t tracks_;
  const CubicBranch* branch_ = nullptr;
  std::array<std::vector<Reference>, 2> references_;
  enum class Run { none, claimed, proved };
  std::array<Run, 2> runs_{};  ///< of chords with tubes, on each track
  std::vector<CurvePiece> pieces_;
  struct Merged {
    Sample from;
    double reach = 0, error = 0;
    bool open = false;
  } merged_;  ///< the last chord, if a box proved it
  bool unbroken_ = true, connected_ = false, unproved_ = false, complete_ = true;
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

TracedCurve trace_in_plane(const CubicBranches& traced, const TubeCurve& curve,
                           const std::optional<PartnerCurve>& partner, const TraceOptions& options) {
  return trace(Plane(options.window), traced, curve, partner, options);
}

TracedCurve trace_on_sphere(const CubicBranches& traced, const TubeCurve& curve,
                            const std::optional<PartnerCurve>& partner, const TraceOptions& options) {
  return trace(Sphere(), traced, curve, partner, options);
}

}  // namespace burmester
