// The pieces of a branch, put together from its proved chords. Not for inclusion by users: curve_trace.hpp is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/trace_charts.hpp"

namespace burmester::detail {

/// What is proved of a chord.
struct ProvedChord {
  double error = 0;
  std::array<double, 2> width{};  ///< of the tubes
  /// In place of a width: a box proved it, which holds the branch.
  static constexpr double by_box = std::numeric_limits<double>::infinity();
  bool has_box() const { return width[0] == by_box || width[1] == by_box; }
};

class TracePieces {
 public:
  /// tracks: 2 with partners, else 1.
  TracePieces(std::size_t tracks, double tolerance) : tracks_(tracks), tolerance_(tolerance) {}

  void start(int component) { component_ = component, pieces_.clear(), unbroken_ = true, connected_ = false; }

  /// The chord from x, where the piece ends or a new one begins, to y. is_on_branch(k): whether the tube on track k is
  /// proved to hold the branch at x.
  template <class IsOnBranch>
  void add(const Sample& x, const Sample& y, const ProvedChord& chord, const IsOnBranch& is_on_branch) {
    if (!connected_) {
      pieces_.emplace_back();
      pieces_.back().component = component_;
      append(x);
      merged_.open = unproved_ = false, runs_ = {};
    }
    connected_ = true;
    for (std::size_t k = 0; k < tracks_; ++k) continue_run(k, chord, is_on_branch);
    merge_or_append(x, y, chord);
  }
  /// The next chord begins a new piece.
  void interrupt() {
    end_piece();
    connected_ = unbroken_ = false;
  }
  /// Where a part cannot be proved. What was proved beside it is not shown if it is smaller than the tolerance.
  void give_up() {
    complete_ = false;
    const auto tiny = [&](const std::vector<Point>& all) {
      return std::ranges::all_of(all, [&](const Point& p) { return (p - all[0]).norm() <= tolerance_; });
    };
    if (connected_) unproved_ = unproved_ || (tiny(pieces_.back().points) && tiny(pieces_.back().partners));
    interrupt();
  }
  /// All of them, when the branch came back from `last` to `first`.
  std::vector<CurvePiece> take(const Sample& first, const Sample& last) {
    end_piece();
    close(first, last);
    return std::move(pieces_);
  }
  /// Not so if a part was given up.
  bool complete() const { return complete_; }

 private:
  /// Chords with tubes, one after the other, follow one part of the curve. It is this branch if one point of it is
  /// proved to be. A box holds the branch itself, and ends the run.
  template <class IsOnBranch>
  void continue_run(std::size_t k, const ProvedChord& chord, const IsOnBranch& is_on_branch) {
    Run& run = runs_[k];
    if (chord.width[k] == ProvedChord::by_box) {
      unproved_ = unproved_ || run == Run::claimed;
      run = Run::none;
    } else if (run != Run::proved) {
      run = is_on_branch(k) ? Run::proved : Run::claimed;
    }
  }

  /// Near singular points chords are far shorter than the tolerance. Those that lie in a disc about the beginning x of
  /// the first become one: the curve is within their largest error of them, and they are within the disc's radius of x.
  void merge_or_append(const Sample& x, const Sample& y, const ProvedChord& chord) {
    CurvePiece& piece = pieces_.back();
    double error = chord.error;
    const bool by_box = chord.has_box();
    if (by_box) {
      const auto distance = [&](const Sample& from) { return std::sqrt(largest(squared_distances(from, y))); };
      const Merged alone{x, distance(x), error, true};
      const Merged more = merged_.open ? Merged{merged_.from, std::max(merged_.reach, distance(merged_.from)),
                                                std::max(merged_.error, error), true}
                                       : alone;
      if (merged_.open && more.reach + more.error <= tolerance_) {
        piece.points.pop_back();
        if (tracks_ == 2) piece.partners.pop_back();
        merged_ = more;
        error = more.reach + more.error;
      } else {
        merged_ = alone;
      }
    }
    merged_.open = by_box;
    append(y);
    piece.max_error = std::max(piece.max_error, error);
  }

  /// A piece that could not be proved to be of this branch is not shown.
  void end_piece() {
    const bool claimed = std::ranges::find(runs_, Run::claimed) != runs_.end();
    if (!connected_ || !(unproved_ || claimed)) return;
    pieces_.pop_back();
    connected_ = unbroken_ = complete_ = false;
  }

  void append(const Sample& x) {
    pieces_.back().points.push_back(x.at(0));
    if (tracks_ == 2) pieces_.back().partners.push_back(x.at(1));
  }

  /// Joins the end of the branch to its beginning.
  void close(const Sample& first, const Sample& last) {
    if (pieces_.empty()) return;
    CurvePiece& end = pieces_.back();
    if (unbroken_) {
      if (first.at(0).dot(last.at(0)) < 0 || first.at(1).dot(last.at(1)) < 0)
        go_on(end, CurvePiece(end), first, last);  // round again
      end.points.pop_back();
      if (tracks_ == 2) end.partners.pop_back();
      end.closed = true;
      return;
    }
    CurvePiece& begin = pieces_.front();
    if (pieces_.size() < 2 || !connected_ || begin.points.front() != first.at(0)) return;
    go_on(end, begin, first, last);
    end.max_error = std::max(end.max_error, begin.max_error);
    pieces_.erase(pieces_.begin());
  }

  /// Appends what follows `first` to what ends at `last`: the same, or on the sphere the opposite, as may be its
  /// partner.
  static void go_on(CurvePiece& piece, const CurvePiece& next, const Sample& first, const Sample& last) {
    const auto append = [](std::vector<Point>& to, const std::vector<Point>& from, const Point& a, const Point& b) {
      const double sign = a.dot(b) < 0 ? -1 : 1;
      for (std::size_t k = 1; k < from.size(); ++k) to.push_back(sign * from[k]);
    };
    append(piece.points, next.points, first.at(0), last.at(0));
    if (!piece.partners.empty()) append(piece.partners, next.partners, first.at(1), last.at(1));
  }

  std::size_t tracks_;
  double tolerance_;
  int component_ = 0;
  std::vector<CurvePiece> pieces_;
  enum class Run { none, claimed, proved };
  std::array<Run, 2> runs_{};  ///< of chords with tubes, on each track
  struct Merged {
    Sample from;
    double reach = 0, error = 0;
    bool open = false;
  } merged_;  ///< the last chord, if a box proved it
  bool unbroken_ = true, connected_ = false, unproved_ = false, complete_ = true;
};

}  // namespace burmester::detail
