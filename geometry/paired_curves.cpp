#include "burmester/geometry/paired_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "burmester/geometry/enclosure.hpp"

namespace burmester {
namespace {

/// How far lines through a point of the cubic are from being part of it, as a share of what would be without
/// cancellation; zero where they are, or where it is singular there. A line that nearly splits off is run through while
/// the pencil hardly turns.
double suitability(const Cubic<double>& f, const Point2<double>& base) {
  Cubic<double> sizes;
  std::ranges::transform(f.c, sizes.c.begin(), [](double c) { return std::abs(c); });
  const CubicPencil<double> pencil(f, base.normalized()), most(sizes, base.cwiseAbs().normalized());
  double out = std::numeric_limits<double>::infinity();
  const auto see = [&](const Point1<double>& direction) {
    const Point1<double> u = direction.normalized(), v = u.cwiseAbs();
    const double left = std::max({std::abs(pencil.a(u)), std::abs(pencil.b(u)), std::abs(pencil.c(u))});
    const double all = most.a(v) + most.b(v) + most.c(v);
    out = std::min(out, all > 0 ? left / all : 0);
  };
  const Point1<double> tangent{pencil.a.c[1], -pencil.a.c[0]};
  if (!(tangent.norm() > 0)) return 0;  // also where it is not a number
  see(tangent);
  const double b0 = pencil.b.c[0], half = pencil.b.c[1] / 2, b2 = pencil.b.c[2],
               q = half + std::copysign(std::sqrt(std::max(0.0, half * half - b0 * b2)), half);
  for (const Point1<double>& root : {Point1<double>(b2, -q), Point1<double>(q, -b0)})
    if (root.squaredNorm() > 0) see(root);
  return out;
}

/// The vertices, the most suitable first.
std::array<std::size_t, 3> order_of_bases(const ThreeCorrelations<Interval>& enclosing) {
  ThreeCorrelations<double> n;
  for (std::size_t k = 0; k < 3; ++k) n[k] = enclosing[k].unaryExpr([](const Interval& x) { return approximate(x); });
  const Cubic<double> f = points_with_partner(n);
  std::array<double, 3> value;
  for (std::size_t k = 0; k < 3; ++k) value[k] = suitability(f, vertex(n[k]));
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return value[i] > value[k]; });
  return order;
}

std::optional<CubicBranches> branches_by_intervals(const ThreeCorrelations<Interval>& n,
                                                   const std::array<std::size_t, 3>& order) {
  const Cubic<Interval> f = points_with_partner(n);
  for (const std::size_t k : order)
    if (auto branches = branches_by_intervals(f, vertex(n[k]))) return branches;
  return std::nullopt;
}

/// Where two of the vertices are singular points, the cubic holds the line between them: it meets it too often.
CubicBranches branches_by_rationals(const ThreeCorrelations<Rational>& n, const std::array<std::size_t, 3>& order) {
  const Cubic<Rational> f = points_with_partner(n);
  std::vector<Point2<Rational>> bases;
  for (const std::size_t k : order) bases.push_back(vertex(n[k]));
  for (std::size_t k = 0; k < 3; ++k) bases.push_back(bases[k] + bases[(k + 1) % 3]);
  for (const Point2<Rational>& base : bases) {
    if (base.isZero(0)) continue;
    CubicBranches branches = branches_by_rationals(f, base);
    if (branches.topology.rung != Rung::none) return branches;
  }
  CubicBranches none;
  const bool zero = std::all_of(f.c.begin(), f.c.end(), [](const Rational& c) { return c == 0; });
  none.topology.reason = zero ? "every point lies on it" : "a line of it counts more than once";
  return none;
}

/// Coefficients (k, j), j < k: N_k less their sum of the N_j before it is orthogonal to these. Nothing where that
/// leaves a 64th of each N or more. Two pairs of close positions make two of the N nearly multiples of each other, and
/// their common points and partners cancel. With small numbers that tell places near the origin only near-multiples are
/// subtracted: others would swamp them.
std::optional<Matrix<double, 3, 3>> dependence(const ThreeCorrelations<Interval>& enclosing, bool tell_near_origin) {
  constexpr double nearly = 0x1p-6;
  ThreeCorrelations<double> n;
  Matrix<double, 3, 3> out = Matrix<double, 3, 3>::Zero();
  bool some = false;
  for (int k = 0; k < 3; ++k) {
    auto& left = n[static_cast<std::size_t>(k)];
    left = enclosing[static_cast<std::size_t>(k)].unaryExpr([](const Interval& x) { return approximate(x); });
    const double size = left.norm();
    for (int j = 0; j < k; ++j) {
      const auto& other = n[static_cast<std::size_t>(j)];
      if (!(other.squaredNorm() > 0)) return std::nullopt;
      const double factor = left.cwiseProduct(other).sum() / other.squaredNorm();
      const Correlation<double> less = left - factor * other;
      if (tell_near_origin && !(less.norm() < nearly * left.norm())) continue;
      out(k, j) = factor, left = less;
    }
    some = some || left.norm() < nearly * size;
  }
  return some && out.allFinite() ? std::optional(out) : std::nullopt;
}

/// The same points and partners: N_k less those multiples.
ThreeCorrelations<Rational> independent(ThreeCorrelations<Rational> n,
                                        const std::optional<Matrix<double, 3, 3>>& dependence) {
  for (int k = 0; dependence && k < 3; ++k)
    for (int j = 0; j < k; ++j)
      n[static_cast<std::size_t>(k)] -= Rational((*dependence)(k, j)) * n[static_cast<std::size_t>(j)];
  return n;
}

/// Each brought to size 1.
ThreeCorrelations<Interval> enclosures(const ThreeCorrelations<Rational>& n) {
  ThreeCorrelations<Interval> out;
  for (std::size_t k = 0; k < 3; ++k) {
    double size = 0;
    for (int i = 0; i < 9; ++i) size = std::max(size, std::abs(approximate(n[k](i))));
    const Rational scale(size > 0 ? 1 / power_of_two_below(size) : 1);
    for (int i = 0; i < 9; ++i) out[k](i) = enclosure(Rational(scale * n[k](i)));
  }
  return out;
}

/// The one line of partners that all three leave to p; zero where p has other partners.
LinearForm<Rational> common_line_of_partners(const ThreeCorrelations<Rational>& n, const Point2<Rational>& p) {
  std::array<LinearForm<Rational>, 3> lines;
  for (std::size_t k = 0; k < 3; ++k) lines[k] = line_of_partners(n[k], p);
  const auto other = std::ranges::find_if(lines, [](const auto& line) { return !line.isZero(0); });
  const bool one = other != lines.end() && concurrence(lines).isZero(0);
  return one ? LinearForm<Rational>(*other / Rational(other->cwiseAbs().maxCoeff())) : LinearForm<Rational>::Zero();
}

/// A double point that has a line of partners, for the tracing.
PointWithLine point_with_line(const ThreeCorrelations<Rational>& n, const Point2<Rational>& p,
                              const BranchFrame<Rational>& frame) {
  std::array<LinearForm<Rational>, 3> lines;
  for (std::size_t k = 0; k < 3; ++k) lines[k] = line_of_partners(n[k], p);
  const auto size = [&](std::size_t k) { return Rational(lines[k].cwiseAbs().maxCoeff()); };
  std::size_t first = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (size(k) > size(first)) first = k;
  Eigen::Index at = 0;
  lines[first].cwiseAbs().maxCoeff(&at);
  ThreeCorrelations<Rational> sums;
  for (std::size_t k = 0; k < 3; ++k) {
    const Correlation<Rational>& each = n[(first + k) % 3];
    const Rational share = k == 0 ? Rational(0) : Rational(lines[(first + k) % 3][at] / lines[first][at]);
    sums[k] = frame.seen(Correlation<Rational>(each - share * n[first]));
  }
  const auto seen = enclosures(sums);
  const int i = frame.i, j = frame.j, k = 3 - i - j;
  const Rational along = p[k] / frame.base[k], scale = 1 / p.cwiseAbs().maxCoeff();
  const Point2<Rational> base = along == 0 ? frame.base : Point2<Rational>(along * frame.base);
  return {{enclosure(Rational(scale * along)), enclosure(Rational(scale * (p[i] - along * frame.base[i]))),
           enclosure(Rational(scale * (p[j] - along * frame.base[j])))},
          points_with_partner(n)(Point2<Rational>(base + p)) == 0,
          seen[0],
          {seen[1], seen[2]}};
}

/// A point as pieces have it; nothing outside the window.
std::optional<Point2<double>> placed(const Point2<Rational>& p, Surface surface, double window) {
  const Point2<Rational> near = p / Rational(p.cwiseAbs().maxCoeff());
  const Point2<double> at(approximate(near[0]), approximate(near[1]), approximate(near[2]));
  if (surface == Surface::sphere) return at.normalized();
  if (!(at.head<2>().cwiseAbs().maxCoeff() <= window * std::abs(at[2]))) return std::nullopt;
  return at / at[2];
}

TracedCurve trace(Surface surface, const CubicBranches& branches, const TubeCurve& curve,
                  const std::optional<PartnerCurve>& partners, const TraceOptions& options) {
  return (surface == Surface::plane ? trace_in_plane : trace_on_sphere)(branches, curve, partners, options);
}

TracedCurve traced_line(const LinearForm<Rational>& line, int component, Surface surface, const TraceOptions& options) {
  Conic<Interval> squares;
  for (int k = 0; k < 3; ++k) squares.add_product(LinearForm<Interval>::Unit(k), LinearForm<Interval>::Unit(k), 1);
  const LinearForm<Interval> form(enclosure(line[0]), enclosure(line[1]), enclosure(line[2]));
  Cubic<Interval> alone;  // no other real points
  alone.add_product(form, squares);
  CubicBranches branches;
  branches.branches.push_back(line_branch(line, component));
  return trace(surface, branches, tube_curve(alone), std::nullopt, options);
}

using VerticesWithLine = std::vector<std::pair<Point2<Rational>, LinearForm<Rational>>>;

/// The vertices that have a line of partners, with that line.
VerticesWithLine vertices_with_line(const ThreeCorrelations<Rational>& n) {
  VerticesWithLine out;
  for (const Correlation<Rational>& each : n) {
    const Point2<Rational> p = vertex(each);
    const LinearForm<Rational> line = common_line_of_partners(n, p);
    const auto same = [&](const auto& other) { return other.first.cross(p).isZero(0); };
    if (!line.isZero(0) && std::ranges::none_of(out, same)) out.emplace_back(p, line);
  }
  return out;
}

/// Adds a vertex with its line of partners: other points of the curve are not paired with it.
void add_line_of_partners(const Point2<Rational>& p, const LinearForm<Rational>& line, Surface surface,
                          const TraceOptions& options, PairedCurves& out) {
  ++out.lines_of_partners;
  const auto at = placed(p, surface, options.window);
  if (!at) return;
  const int component = out.topology.isolated > 0 ? out.topology.components - 1 : 0;  // else a crossing
  TracedCurve traced = traced_line(line, component, surface, options);
  out.traced.complete = out.traced.complete && traced.complete;
  for (CurvePiece& piece : traced.pieces) {
    piece.partners.swap(piece.points);
    piece.points.assign(piece.partners.size(), *at);
    out.traced.pieces.push_back(std::move(piece));
  }
}

}  // namespace

PairedCurves paired_curves(const DecidingCorrelations& correlations, Surface surface, const TraceOptions& options) {
  const UpwardRounding upward;
  auto n = correlations.intervals();
  const auto order = order_of_bases(n);
  const auto nearly = dependence(n, correlations.tell_near_origin);
  // Chords go with the square root of the tolerance. Whole curves took fewer samples; more are of use only where
  // doubles do not tell.
  TraceOptions limited = options;
  limited.most_samples = static_cast<int>(
      std::min<double>(options.most_samples, 600 * std::sqrt(std::max(1.0, options.longest / options.tolerance))));
  if (const auto branches = nearly ? std::nullopt : branches_by_intervals(n, order)) {
    TracedCurve traced =
        trace(surface, *branches, tube_curve(points_with_partner(n)), partner_curve(n, branches->frame), limited);
    if (traced.complete) return {branches->topology, std::move(traced)};
  }
  const ThreeCorrelations<Rational> given = correlations.rationals();
  const CubicBranches branches = branches_by_rationals(given, order);
  PairedCurves out{branches.topology, {}};
  if (branches.topology.rung == Rung::none) return out;
  const auto vertices = branches.topology.singular.empty() ? VerticesWithLine() : vertices_with_line(given);
  const ThreeCorrelations<Rational> exact = independent(given, nearly);
  const BranchFrame<Rational> frame{*branches.base, branches.frame.i, branches.frame.j};
  n = enclosures(exact);
  PartnerCurve partners =
      partner_curve(n, enclosures({frame.seen(exact[0]), frame.seen(exact[1]), frame.seen(exact[2])}));
  for (const auto& [p, line] : vertices) partners.with_line.push_back(point_with_line(exact, p, frame));
  out.traced = trace(surface, branches, tube_curve(points_with_partner(n)), partners, limited);
  for (const auto& [p, line] : vertices) add_line_of_partners(p, line, surface, limited, out);
  return out;
}

}  // namespace burmester
