#include "burmester/geometry/curve_trace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "burmester/geometry/branch_box.hpp"
#include "burmester/geometry/paired_points.hpp"
#include "burmester/geometry/partners_about.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/trace_pieces.hpp"

namespace burmester {
namespace {

using namespace detail;  // the charts and their samples
constexpr int first_chords = 8;
constexpr double short_step = 0x1p-22, short_step_at_line = 0x1p-36;  // effort only: what is kept is proved
constexpr double shortest_step = 0x1p-200;  // where doubles may fail to tell points apart; a guard
constexpr double told = 0x1p-10;            // well below half a chord, which a point that is to lie elsewhere must miss
constexpr double aim = 0.85;                // of the allowed error (as a length), for the next chord
constexpr double short_passage = 0x1p-12;   // from here on boxes are tried where tubes fail; a matter of speed only

template <class Chart>
class Tracer {
 public:
  Tracer(const Chart& chart, const TubeCurve& curve, const std::optional<PartnerCurve>& partner,
         const TraceOptions& options)
      : chart_(chart),
        curve_(curve),
        partner_(partner),
        options_(options),
        tracks_(partner ? 2 : 1),
        both_(curve, form(tracks_ - 1)),
        per_longest_(1 / options.longest),
        per_tolerance_(1 / options.tolerance),
        pieces_(tracks_, options.tolerance) {}

  std::vector<CurvePiece> trace(const CubicBranch& branch) {
    branch_ = &branch, samples_ = 0, density_ = 0;
    pieces_.start(branch.component);
    if (branch.passages.empty()) {
      pieces_.give_up();
      return {};
    }
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
        march(at, next, from, to, passage.sheet);
      }
    return pieces_.take(first, at);
  }

  bool complete() const { return pieces_.complete(); }

 private:
  static double start_of(const CubicBranch::Passage& passage) { return passage.backwards ? 1 : -1; }

  Sample sample(double s, int sheet) {
    Sample out;
    out.inside = out.near = true;
    std::array<Point, 2> at;
    const PairedPoints pair = pair_at(s, sheet);
    for (std::size_t k = 0; k < tracks_; ++k) {
      const Point p = k == 1 ? pair.c : branch_->approximate.frame.placed(pair.p);
      out.valid = out.valid && p.squaredNorm() > 0;
      at[k] = chart_.place(p);
      out.inside = out.inside && chart_.inside(at[k], 1);
      out.near = out.near && chart_.inside(at[k], margin);
    }
    out.inside = out.inside && out.valid, out.near = out.near && out.valid;
    const Point& other = at[tracks_ - 1];
    out.both = {side_by_side(at[0], other), both_};
    ++samples_;
    return out;
  }

  /// A point in the frame of the branch, and its partner.
  PairedPoints pair_at(double s, int sheet) const {
    const Point p = branch_->approximate.seen(s, sheet);
    if (!partner_) return {p, {}};
    const auto& n = partner_->approximate;
    const auto& squares = partner_->squares;
    if (meets_line()) {  // beside the point with the line a box knows better which of its points is the partner
      const Box box = boxes(s, s, sheet).track[1];
      const Point c(approximate(box[0]), approximate(box[1]), approximate(box[2]));
      if (patch_of_box(box, c.normalized(), c.normalized()) <= options_.tolerance)
        return paired_points(n, squares, PairedPoints{p, c});
    }
    return paired_points(n, squares, p);
  }

  /// Of two opposite points that are the same axis, those nearer to the sample before.
  decltype(auto) continued(const Sample& before, const Sample& next) const {
    if constexpr (Chart::has_opposites) {
      const Lanes cosine = TubePointOf<Lanes>::dot(before.both.at, next.both.at);
      Sample out = next;
      out.both = next.both.times({cosine[0] < 0 ? -1.0 : 1.0, cosine[1] < 0 ? -1.0 : 1.0});
      return out;
    } else {
      return (next);
    }
  }

  const TubeCurve& form(std::size_t track) const { return track == 0 ? curve_ : partner_->curve; }

  /// Leads x to what `end` shows, as the continuation of x, in steps as long as the last chord lets one expect. Not so
  /// behind a box: longer chords may have tubes where short ones have none.
  void march(Sample& x, const Sample& end, double from, double to, int sheet) {
    for (double steps; samples_ <= most_ && (steps = std::abs(to - from) * density_) > 1;) {
      const double next = from + (to - from) / std::ceil(steps);
      follow(x, sample(next, sheet), from, next, sheet);
      from = next;
    }
    follow(x, end, from, to, sheet);
  }

  /// The same in steps that are halved, or cut into more parts, where they prove too long.
  void follow(Sample& x, const Sample& end, double from, double to, int sheet) {
    const Sample& y = continued(x, end);
    const int parts = step(x, y, from, to, sheet);
    if (parts == 1) {
      x = y;
      return;
    }
    const double length = (to - from) / parts;
    for (int k = 1; k < parts; ++k)
      follow(x, sample(from + k * length, sheet), from + (k - 1) * length, from + k * length, sheet);
    follow(x, end, from + (parts - 1) * length, to, sheet);
  }

  /// Accepts the chord, leaves it out or gives it up: 1. Otherwise as many parts as are to be looked at.
  int step(const Sample& x, const Sample& y, double from, double to, int sheet) {
    int parts = 2;
    if (x.near && y.near && (x.inside || y.inside)) {
      const Chord chord = judge(x, y, from, to, sheet);
      parts = chord.parts;
      if (parts == 1) {
        pieces_.add(x, y, chord, [&](std::size_t k) {
          return is_on_branch(k, x, y, chord.width[k], from, sheet) || is_on_branch(k, y, x, chord.width[k], to, sheet);
        });
        density_ = chord.density;
      }
    } else if (!x.valid && !y.valid) {
      give_up();
      parts = 1;
    } else if (x.valid && y.valid && left_out(x, y, from, to, sheet)) {
      pieces_.interrupt();
      density_ = 0;
      parts = 1;
    }
    if (parts == 1) return 1;
    const double length = (to - from) / parts, size = std::abs(length);
    const bool no_more = size < shortest_step || samples_ > most_ || from + length == from || to - length == to;
    if (!no_more &&
        (size > (meets_line() ? short_step_at_line : short_step) || tells(x, from, sheet) || tells(y, to, sheet)))
      return parts;
    give_up();
    return 1;
  }
  void give_up() {
    pieces_.give_up();
    density_ = 0;
  }

  /// parts = 1: accepted; otherwise as many parts as are expected to be.
  struct Chord : ProvedChord {
    int parts = 2;
    double density = 0;  ///< chords of the allowed error per unit of the parameter; 0: not known
    Chord() = default;
    explicit Chord(int p) : parts(p) {}
  };

  Chord judge(const Sample& x, const Sample& y, double from, double to, int sheet) const {
    const Lanes squares = squared_distances(x, y);
    const double length = largest(squares) * per_longest_ * per_longest_;
    if (length > 1) return Chord(parts_for(std::sqrt(length)));
    Chord out;
    const bool tiny = tracks_ == 2 && squares[1] <= options_.tolerance * options_.tolerance;
    if (tiny || !judge(x, y, out))
      for (std::size_t k = 0; k < tracks_; ++k)
        if (!judge(k, x, y, from, to, sheet, out)) return {};
    const double ratio = std::sqrt(std::max(out.error * per_tolerance_, length));
    if (out.error > options_.tolerance) return Chord(parts_for(ratio));
    out.parts = 1;
    if (!out.has_box()) out.density = std::max(ratio, 0.25) / (aim * std::abs(to - from));
    return out;
  }

  /// Whether tubes prove it, on both tracks at once, and plainly; with an error that may be larger than the tolerance.
  bool judge(const Sample& x, const Sample& y, Chord& out) const {
    const auto chord = chart_.chord(x.both.at, y.both.at);
    const Reference* other = elsewhere(x, y, largest);
    const auto proved = chord && other ? tube(both_, x.both, y.both, *chord) : std::nullopt;
    if (!proved || !beside_chord(x.both, y.both, *chord, proved->radius, other->at, other->off)) return false;
    const Lanes error = chart_.error(proved->radius, x.both.at, y.both.at);
    out.error = largest(error);
    out.width = {proved->width[0], proved->width[1]};
    return true;
  }

  /// Whether tubes or boxes prove it on one track.
  bool judge(std::size_t k, const Sample& x, const Sample& y, double from, double to, int sheet, Chord& out) const {
    const TubePoint a = x.track(k), b = y.track(k);
    const auto by_box = [&](double extent) {
      if (!(extent <= options_.tolerance)) return false;  // also where it is not a number
      out.error = std::max(out.error, extent);
      out.width[k] = ProvedChord::by_box;
      return true;
    };
    const bool tiny = (b.at - a.at).squaredNorm() <= options_.tolerance * options_.tolerance;
    if (k == 1 && tiny && meets_line() && by_box(extent_of_box(k, x, y, from, to, sheet))) return true;
    if (k == 1 && tiny && by_box(partner_extent(x, y, box_seen(branch_->enclosing, from, to, sheet)))) return true;
    const auto chord = chart_.chord(a.at, b.at);
    const Reference* other = elsewhere(x, y, k);
    const auto proved = chord && other ? tube(form(k), a, b, *chord) : std::nullopt;
    if (!proved) return tiny && by_box(extent_of_box(k, x, y, from, to, sheet));
    if (over_chord(a, b, *chord, proved->radius, other->of(k), other->off[k])) return false;
    out.error = std::max(out.error, chart_.error(proved->radius, a.at, b.at));
    out.width[k] = proved->width;
    return true;
  }

  struct Reference {
    int end;           ///< as in Sample
    Point2<Lanes> at;  ///< unit
    Lanes off;         ///< how far a point of the branch may be from it, as an angle
    Point of(std::size_t k) const { return {at[0][k], at[1][k], at[2][k]}; }
  };
  /// Ends of first chords where a box tells the point of each track.
  void find_references(const CubicBranch::Passage& passage) {
    references_.clear();
    std::array<int, 2> found{};
    for (const int k : {0, 4, 2, 6, 1, 3, 5, 7}) {
      if (found[0] >= 2 && found[tracks_ - 1] >= 2) return;
      const double s = start_of(passage) * (1 - 2.0 * k / first_chords);
      const Sample sampled = sample(s, passage.sheet);
      const BranchBox box = boxes(s, s, passage.sheet);
      const TubePointOf<Lanes> at = sampled.both.unit();
      std::array<double, 2> off{};
      for (std::size_t track = 0; track < 2; ++track) {
        off[track] = distance_from_box(box.track[std::min(track, tracks_ - 1)], sampled.track(track).unit().at);
        found[track] += off[track] < told;
      }
      references_.push_back({k, at.at, {off[0], off[1]}});
    }
  }
  /// A point of the track that is not between x and y, nor one of them; none where no box tells one.
  const Reference* elsewhere(const Sample& x, const Sample& y, std::size_t track) const {
    return elsewhere(x, y, [&](const Lanes& off) { return off[track]; });
  }
  template <class Off>
  const Reference* elsewhere(const Sample& x, const Sample& y, const Off& off) const {
    for (const Reference& reference : references_)
      if (reference.end != x.end && reference.end != y.end && off(reference.off) < told) return &reference;
    return nullptr;
  }
  static int parts_for(double ratio) {
    return std::clamp(static_cast<int>(std::ceil(std::min(1.05 * ratio, 8.0))), 2, 8);
  }

  double extent_of_box(std::size_t k, const Sample& x, const Sample& y, double from, double to, int sheet) const {
    const BranchBox box = boxes(from, to, sheet);
    const double extent = chart_.extent(box.track[k], x.at(k), y.at(k));
    return k == 1 && !(extent <= options_.tolerance) ? partner_extent(x, y, box.seen) : extent;
  }

  /// Whether boxes take care of points with a whole line of partners.
  bool meets_line() const { return partner_ && !partner_->with_line.empty(); }

  BranchBox boxes(double from, double to, int sheet) const {
    const BranchForms<Interval>& branch = branch_->enclosing;
    if (from == to && !meets_line()) {
      const Box seen = branch.seen(Interval(from), sheet), at = branch.frame.placed(seen);
      return {{at, tracks_ == 2 ? partner<Interval>(partner_->enclosing, seen) : at}, seen};
    }
    if (tracks_ == 2) return box_with_partners(branch, *partner_, from, to, sheet);
    return {{box_of_points(branch, from, to, sheet)}, {}};
  }

  /// As Chart::extent, of the partners of a box in the frame: no matter how long it is where all of them are one point.
  double partner_extent(const Sample& x, const Sample& y, const Box& p) const {
    return chart_.extent(partners_about(*partner_, x.at(1), p), x.at(1), y.at(1));
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
      if (other && chart_.outside(form(k), x.track(k), y.track(k), other->of(k), other->off[k], at_x)) return true;
    }
    if (std::abs(to - from) > short_passage) return false;
    const BranchBox box = boxes(from, to, sheet);  // near singular points no tube can be proved
    return chart_.outside(box.track[0]) || (tracks_ == 2 && chart_.outside(box.track[1]));
  }

  /// Whether the box that holds the branch at x lies in the tube of the chord, or in a wider one.
  bool is_on_branch(std::size_t k, const Sample& x, const Sample& y, double width, double from, int sheet) const {
    const TubePoint a = x.track(k), b = y.track(k);
    const double extent = chart_.extent(boxes(from, from, sheet).track[k], a.at, a.at);
    if (extent <= width) return true;
    const auto chord = chart_.chord(a.at, b.at);
    return std::isfinite(extent) && chord && tube(form(k), a, b, *chord, extent);
  }

  Chart chart_;
  const TubeCurve& curve_;
  const std::optional<PartnerCurve>& partner_;
  TraceOptions options_;
  std::size_t tracks_;
  TubeCurveOf<Lanes> both_;
  double per_longest_, per_tolerance_;
  const CubicBranch* branch_ = nullptr;
  std::vector<Reference> references_;
  TracePieces pieces_;
  int samples_ = 0, most_ = 0;
  double density_ = 0;  ///< chords per unit of the parameter that the last one lets one expect; 0: not known
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
