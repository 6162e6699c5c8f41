// The circle-point and centre-point curves of four planar poses, beside the bare five-pose solve that one would
// otherwise call again and again to draw them. Counters: points on each curve, pieces, share decided by intervals.
//
// Rows:
//   five_pose_bare        planar::five_pose_roots: the unit that the others are measured in
//   topology              proved by intervals (by rationals where they cannot)
//   topology_rational     proved by rationals alone
//   topology_cgal         the same by CGAL's curve analysis, which takes any plane curve up to degree six
//   traced                topology and about 1000 paired points with a proved error
//   four_pose_curves      the same from poses to records of pairs, as the library gives them
//   four_pose_curves_in_solves   the same in turn with bare solves; counter: bare solves for 1000 pairs
//   traced_one            the traced curve alone, without partners: same tolerance, longest chord and window
//   arcs                  CGAL's arcs of it
//   traced_arcs           the same picture from the arcs, which any plane curve up to degree six has
//   sampled               1000 paired points, evaluated at equal steps; nothing is proved
//   certified             the same samples, and the tube test of the chords between them
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "burmester/geometry/arc_trace.hpp"
#include "burmester/geometry/curve_analysis.hpp"
#include "burmester/geometry/curve_trace.hpp"
#include "burmester/planar/five_pose_roots.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "burmester/planar/space.hpp"
#include "burmester/planar/tasks.hpp"
#include "positions.hpp"
#include "studies/thread_time.hpp"

namespace {

using namespace burmester;

using FourPoses = std::array<FourDoubles, 3>;

std::vector<FourPoses> tasks() {
  Random random("bench.curves");
  std::vector<FourPoses> out;
  for (int i = 0; i < 256; ++i)
    out.push_back(
        {random_plane_displacement(random), random_plane_displacement(random), random_plane_displacement(random)});
  return out;
}

std::optional<CubicBranches> by_intervals(const FourPoses& poses) {
  const auto n = equidistant_in_plane<Interval>(poses);
  return branches_by_intervals(points_with_partner(n), vertex(n[0]));
}
CubicBranches by_rationals(const FourPoses& poses) {
  const auto n = equidistant_in_plane<Rational>(poses);
  return branches_by_rationals(points_with_partner(n), vertex(n[0]));
}

std::vector<planar::FivePoseTask> five_pose_tasks() {
  Random random("bench.curves.five_pose_bare");
  std::vector<planar::FivePoseTask> out;
  for (int i = 0; i < 4096; ++i) out.push_back(planar::find_task_class("generic")->make(random));
  return out;
}

void five_pose_bare(benchmark::State& state) {
  const auto pool = five_pose_tasks();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(planar::five_pose_roots(pool[i++ % pool.size()]));
}
BENCHMARK(five_pose_bare);

void topology(benchmark::State& state) {
  const auto pool = tasks();
  std::size_t i = 0, decided = 0;
  for (auto _ : state) {
    const UpwardRounding upward;
    auto branches = by_intervals(pool[i++ % pool.size()]);
    decided += branches.has_value();
    if (!branches) branches = by_rationals(pool[(i - 1) % pool.size()]);
    benchmark::DoNotOptimize(branches);
  }
  state.counters["by_intervals"] = static_cast<double>(decided) / static_cast<double>(i);
}
BENCHMARK(topology);

void topology_rational(benchmark::State& state) {
  const auto pool = tasks();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(by_rationals(pool[i++ % pool.size()]));
}
BENCHMARK(topology_rational);

void topology_cgal(benchmark::State& state) {
  const auto pool = tasks();
  std::vector<TernaryForm<Rational>> forms;
  for (const FourPoses& poses : pool) forms.emplace_back(points_with_partner(equidistant_in_plane<Rational>(poses)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(analyse_curve(forms[i++ % forms.size()]));
}
BENCHMARK(topology_cgal)->Unit(benchmark::kMillisecond);

void traced(benchmark::State& state) {
  const auto pool = tasks();
  std::size_t i = 0, points = 0, pieces = 0;
  for (auto _ : state) {
    const UpwardRounding upward;
    const auto n = equidistant_in_plane<Interval>(pool[i++ % pool.size()]);
    const Cubic<Interval> f = points_with_partner(n);
    const auto branches = branches_by_intervals(f, vertex(n[0]));
    if (!branches) continue;
    const PartnerCurve partner = partner_curve(n, branches->frame);
    const auto found = trace_in_plane(*branches, tube_curve(f), partner, {1.75e-5, 0.5, 10}).pieces;
    pieces += found.size();
    for (const CurvePiece& piece : found) points += piece.points.size();
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(i);
  state.counters["pieces"] = static_cast<double>(pieces) / static_cast<double>(i);
}
BENCHMARK(traced);

std::vector<std::array<planar::Pose, 4>> four_pose_tasks() {
  Random random("bench.curves.four_pose_curves");
  std::vector<std::array<planar::Pose, 4>> out(256);
  for (auto& poses : out)
    for (planar::Pose& p : poses) p = planar::Space::random_pose(random);
  return out;
}

std::size_t listed_pairs(const std::array<planar::Pose, 4>& poses) {
  std::size_t pairs = 0;
  for (const CurveRecord& piece : planar::four_pose_curves(poses, {1.5e-5, 0.5, 8}).pieces)
    pairs += piece.moving.size();
  return pairs;
}

void four_pose_curves(benchmark::State& state) {
  const auto pool = four_pose_tasks();
  std::size_t i = 0, points = 0;
  for (auto _ : state) points += listed_pairs(pool[i++ % pool.size()]);
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(i);
}
BENCHMARK(four_pose_curves);

/// In turn, so that a change of the processor's speed meets both.
void four_pose_curves_in_solves(benchmark::State& state) {
  constexpr std::size_t solves = 256;
  const auto pool = four_pose_tasks();
  const auto five = five_pose_tasks();
  std::size_t i = 0, points = 0;
  double tracing = 0, solving = 0;
  for (auto _ : state) {
    const double start = thread_time();
    points += listed_pairs(pool[i % pool.size()]);
    const double traced = thread_time();
    for (std::size_t k = 0; k < solves; ++k)
      benchmark::DoNotOptimize(planar::five_pose_roots(five[(i * solves + k) % five.size()]));
    tracing += traced - start, solving += thread_time() - traced;
    ++i;
  }
  const double solve = solving / static_cast<double>(i * solves);
  state.counters["solves_per_1000_pairs"] = tracing / solve / static_cast<double>(points) * 1000;
}
BENCHMARK(four_pose_curves_in_solves);

constexpr TraceOptions picture{1.75e-5, 0.5, 10};

void traced_one(benchmark::State& state) {
  const auto pool = tasks();
  std::size_t i = 0, points = 0;
  for (auto _ : state) {
    const UpwardRounding upward;
    const auto n = equidistant_in_plane<Interval>(pool[i++ % pool.size()]);
    const Cubic<Interval> f = points_with_partner(n);
    const auto branches = branches_by_intervals(f, vertex(n[0]));
    if (!branches) continue;
    for (const CurvePiece& piece : trace_in_plane(*branches, tube_curve(f), std::nullopt, picture).pieces)
      points += piece.points.size();
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(i);
}
BENCHMARK(traced_one);

std::vector<CurveArcs> prepared_arcs() {
  std::vector<CurveArcs> out;
  for (const FourPoses& poses : tasks()) {
    if (out.size() == 32) break;
    out.push_back(arcs_of(TernaryForm<Rational>(points_with_partner(equidistant_in_plane<Rational>(poses)))));
  }
  return out;
}

void arcs(benchmark::State& state) {
  const auto pool = tasks();
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        arcs_of(TernaryForm<Rational>(points_with_partner(equidistant_in_plane<Rational>(pool[i++ % pool.size()])))));
}
BENCHMARK(arcs)->Unit(benchmark::kMillisecond);

void traced_arcs(benchmark::State& state) {
  const std::vector<CurveArcs> pool = prepared_arcs();
  std::size_t i = 0, points = 0;
  for (auto _ : state)
    for (const CurvePiece& piece : trace_arcs(pool[i++ % pool.size()], picture).pieces) points += piece.points.size();
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(i);
}
BENCHMARK(traced_arcs);

/// The proved distance between chord and curve; infinite where the test fails.
double error_of(const TubeCurve& curve, const TubePoint& x, const TubePoint& y) {
  const double dx = y.at[0] - x.at[0], dy = y.at[1] - x.at[1], scale = 1 / std::sqrt(dx * dx + dy * dy);
  const auto proved = tube(curve, x, y, HalfChord::between(x.at, y.at, {-dy * scale, dx * scale, 0}));
  return proved ? proved->radius : std::numeric_limits<double>::infinity();
}

struct PreparedCurve {
  CubicBranches branches;
  std::array<Correlation<double>, 3> correlations;
  TubeCurve moving, fixed;
};

std::vector<PreparedCurve> prepared_curves() {
  std::vector<PreparedCurve> out;
  for (const FourPoses& poses : tasks()) {
    const UpwardRounding upward;
    const auto n = equidistant_in_plane<Interval>(poses);
    if (auto branches = by_intervals(poses)) {
      const TubeCurve fixed = partner_curve(n, branches->frame).curve;
      out.push_back(
          {std::move(*branches), equidistant_in_plane<double>(poses), tube_curve(points_with_partner(n)), fixed});
    }
  }
  return out;
}

template <bool certified>
void samples(benchmark::State& state) {
  const auto curves = prepared_curves();
  std::size_t i = 0;
  for (auto _ : state) {
    const PreparedCurve& curve = curves[i++ % curves.size()];
    std::vector<Point2<double>> points, partners;
    std::vector<double> errors;
    TubePoint last_point({0, 0, 1}, curve.moving), last_partner({0, 0, 1}, curve.fixed);
    const auto passages = curve.branches.branches.size() * curve.branches.branches[0].passages.size();
    const double step = 2 * static_cast<double>(passages) / 1000;
    for (const CubicBranch& branch : curve.branches.branches)
      for (const CubicBranch::Passage& passage : branch.passages)
        for (double s = -1; s < 1; s += step) {
          const Point2<double> p = branch.approximate(s, passage.sheet), c = partner(curve.correlations, p);
          points.push_back(p / p[2]);
          partners.push_back(c / c[2]);
          if constexpr (certified) {
            const TubePoint at(points.back(), curve.moving), at_partner(partners.back(), curve.fixed);
            errors.push_back(error_of(curve.moving, last_point, at) + error_of(curve.fixed, last_partner, at_partner));
            last_point = at, last_partner = at_partner;
          }
        }
    benchmark::DoNotOptimize(points.data());
    benchmark::DoNotOptimize(partners.data());
    benchmark::DoNotOptimize(errors.data());
  }
}
BENCHMARK(samples<false>)->Name("sampled");
BENCHMARK(samples<true>)->Name("certified");

}  // namespace
