// How far the direct five-pose solver is from the quad-precision oracle, class by class: used by the seeded test and
// by the long study, with the same limits.
//
// Error of an RR dyad: distance of (moving, fixed) from the oracle's, divided by the larger of the task size and the
// oracle's distance of (moving, fixed) from the reference pose. Of a slider: displacement of its pivot and of its
// line within the task, divided by the task size.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "burmester/planar/classify.hpp"
#include "burmester/planar/five_pose_oracle.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar::accuracy {

struct Limits {
  double median, tail;  ///< of the errors: median, and 99.9 %
};

/// Generic: median 4e-16, tail 1e-12. Classes measured before (prototype of the anchored basis, 4000 tasks, median /
/// 99.9 %: small rotations 6.1e-16 / 4.8e-12, parallel to 1e-6 6.1e-16 / 3.0e-13, lengths x 1e-3 1.9e-16 / 5.0e-13,
/// origin 1e6 away 1.4e-11, which is rounding of the answer): three times that. Elsewhere: tail 1e-7.
inline Limits limits_of(std::string_view name) {
  if (name == "generic") return {4e-16, 1e-12};
  if (name == "small_rotations") return {3 * 6.1e-16, 3 * 4.8e-12};
  if (name == "nearly_parallel") return {3 * 6.1e-16, 3 * 3.0e-13};
  if (name == "small_coordinates") return {3 * 1.9e-16, 3 * 5.0e-13};
  // 1.4e-11 is rounding of the answer; its 99.9 % depends on the sizes drawn: the largest rounding of a task of size 1,
  // half a unit in the last place of 1e6 in two coordinates, is 8.2e-11.
  if (name == "offset_origin") return {3 * 1.4e-11, 8.2e-11};
  return {1e-7, 1e-7};
}

struct Outcome {
  long tasks = 0, wrong_count = 0, wrong_type = 0;
  std::array<long, 5> with_real{};  ///< tasks with 0 .. 4 real dyads (oracle)
  std::vector<double> errors;
  double floor = 0;  ///< largest error (RR) of the oracle's own answer once it is rounded to doubles
  double largest = 0;

  double quantile(double p) {
    if (errors.empty()) return 0;
    const auto at = static_cast<std::size_t>(p * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + static_cast<long>(at), errors.end());
    return errors[at];
  }
};

namespace detail {

/// (moving in E, fixed in S) in the number type of the root.
template <class T>
Vector<T, 4> pivots(const Anchored<T>& w, const Anchor& anchor, const Pose& reference) {
  const AnchoredPivots<T> p = decode_pivots(w, anchor);
  const T s(reference.X3), c(reference.X4), n = s * s + c * c, cosine = (c - s) * (c + s) / n, sine = 2 * s * c / n;
  const T L(anchor.length);
  return {T(L * (cosine * p.moving[0] + sine * p.moving[1])), T(L * (cosine * p.moving[1] - sine * p.moving[0])),
          T(L * p.fixed[0] + T(reference.x)), T(L * p.fixed[1] + T(reference.y))};
}

inline double distance(const Vector<Quad, 4>& a, const Vector<Quad, 4>& b) {
  return static_cast<double>((a - b).norm());
}

inline double line_change(const Line& a, const Line& b, const Vector2& centre, double size) {
  const double sign = a.normal.dot(b.normal) < 0 ? -1 : 1;
  return std::abs(a.signed_distance(centre) - sign * b.signed_distance(centre)) +
         size * (a.normal - sign * b.normal).norm();
}

inline Vector2 centre_of(const FivePoseTask& task) {
  Vector2 c = Vector2::Zero();
  for (const Pose& p : task) c += Vector2(p.x, p.y) / 5;
  return c;
}

inline double slider_error(const Dyads::Design& a, const Dyads::Design& b, const FivePoseTask& task, double size) {
  if (const auto* x = std::get_if<PR::Design>(&a)) {
    const auto& y = std::get<PR::Design>(b);
    return ((x->moving - y.moving).norm() + line_change(x->line, y.line, centre_of(task), size)) / size;
  }
  const auto &x = std::get<RP::Design>(a), &y = std::get<RP::Design>(b);
  return ((x.fixed - y.fixed).norm() + line_change(x.line, y.line, Vector2::Zero(), size)) / size;
}

/// The oracle's root nearest to w as a point of P^6.
inline int nearest(const Anchored<double>& w, const FivePoseRoots<Quad>& oracle) {
  int best = 0;
  double best_cosine = -1;
  for (int i = 0; i < oracle.count; ++i) {
    const Anchored<double> v = oracle.w[i].template cast<double>();
    const double cosine = std::abs(w.dot(v)) / (w.norm() * v.norm());
    if (cosine > best_cosine) best_cosine = cosine, best = i;
  }
  return best;
}

}  // namespace detail

/// One task: adds its errors to the outcome.
inline void add_task(const FivePoseTask& task, Outcome& out) {
  const FivePoseRoots<double> fast = five_pose_roots(task);
  const FivePoseRoots<Quad> oracle = five_pose_roots_quad(task);
  ++out.tasks;
  ++out.with_real[oracle.count];
  if (fast.count != oracle.count || fast.what != oracle.what) {
    ++out.wrong_count;
    return;
  }
  const Pose& reference = task[fast.anchor.reference];
  const double size = task_size(task);
  for (int i = 0; i < fast.count; ++i) {
    const Anchored<Quad>& truth = oracle.w[detail::nearest(fast.w[i], oracle)];
    const auto got = classify(fast.w[i], fast.anchor, task, size), expected = classify(truth, fast.anchor, task, size);
    if (got.design.index() != expected.design.index()) {
      ++out.wrong_type;
      continue;
    }
    double error = 0;
    if (std::holds_alternative<RR::Design>(got.design)) {
      const Vector<Quad, 4> y = detail::pivots<Quad>(truth, fast.anchor, reference);
      const auto& rr = std::get<RR::Design>(got.design);
      const Vector<Quad, 4> x{rr.moving[0], rr.moving[1], rr.fixed[0], rr.fixed[1]};
      const double away = detail::distance(y, {Quad(0), Quad(0), Quad(reference.x), Quad(reference.y)});
      error = detail::distance(x, y) / std::max(size, away);
      const Vector<Quad, 4> rounded = y.template cast<double>().template cast<Quad>();
      out.floor = std::max(out.floor, detail::distance(rounded, y) / std::max(size, away));
    } else {
      error = detail::slider_error(got.design, expected.design, task, size);
    }
    out.largest = std::max(out.largest, error);
    out.errors.push_back(error);
  }
}

}  // namespace burmester::planar::accuracy
