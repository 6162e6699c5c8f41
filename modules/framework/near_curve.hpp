// Four poses: the dyads of the curve whose fixed pivots are nearest to given points, in any geometry whose
// displacements are correlations.
//
// The centre points c fill a cubic F(c) = 0 (geometry/correlations.hpp). From the traced curve Newton's method leads to
// the one nearest to the given point (geometry/nearest_point.hpp). Where F has opposite exact signs at the two ends of
// a short segment across the curve, a dyad of the curve has its fixed pivot there; its partner is enclosed with
// rational intervals. (planar/near_curve.hpp, spherical/near_curve.hpp)
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burmester/geometry/nearest_point.hpp"
#include "burmester/modules/framework/given_pivots.hpp"
#include "burmester/modules/framework/repeated.hpp"

namespace burmester {

template <class Dyads>
struct NearestDyads {
  std::vector<Found<typename Dyads::Design>> dyads;  ///< no sliders
  std::vector<std::string> warnings;  ///< of points without a dyad, and where the trace ends: "near[0]: .."
};

/// A centre point and its partner, each in a box.
struct PairBox {
  Point2<RationalInterval> centre, partner;
};

/// Four poses as centre points see them: the geometry's part.
template <class Task>
concept CentrePoints = PivotGeometry<typename Task::Pivots> &&
    requires(const Task task, std::span<const double> fixed, const Point2<double> centre,
             const Point2<Rational> partner, const std::optional<PairBox> box) {
  { Task::surface } -> std::convertible_to<Surface>;
  { task.length() } -> std::same_as<double>;             ///< the unit of length on the surface
  { task.seen(fixed) } -> std::same_as<Point2<double>>;  ///< a fixed pivot, on the surface
  task.template correlations<Rational>();                ///< three, c^T N^T p = 0 for the partner p of c
  { Task::finite(box->partner) } -> std::same_as<bool>;  ///< whether all in this box are partners of RR dyads
  /// The dyad as it is listed, a slider with its departure; certified by the box.
  { task.dyad(centre, partner, box) } -> std::same_as<Found<typename Task::Pivots::Dyads::Design>>;
};

namespace detail {

/// The fixed pivots of traced curves, on the surface.
template <CentrePoints Task>
std::vector<CurvePiece> centre_pieces(const Task& task, const std::vector<CurveRecord>& curves) {
  std::vector<CurvePiece> out;
  for (const CurveRecord& curve : curves) {
    CurvePiece& piece = out.emplace_back();
    piece.closed = curve.closed, piece.max_error = curve.max_error / task.length();
    for (const auto& fixed : curve.fixed) piece.points.push_back(task.seen(fixed));
  }
  return out;
}

/// Whether the partner p of a rounded c tells nothing: c, within rounding, is the pole of two displacements, and a line
/// of partners is left. Each line of partners is known to a few unit roundoffs of |N| |c|.
inline bool undetermined_partner(const Point2<Rational>& p, const std::array<Correlation<double>, 3>& n,
                                 const Point2<double>& c) {
  double size = 0;
  for (const Correlation<double>& form : n) size = std::max(size, form.norm() * c.norm());
  return !(Point2<double>(approximate(p[0]), approximate(p[1]), approximate(p[2])).norm() >
           64 * unit_roundoff * size * size);
}

template <CentrePoints Task>
std::optional<PairBox> pair_box(const Task& task, const Cubic<Rational>& f, const Point2<double>& c) {
  const auto centre = crossing(Task::surface, f, c);
  if (!centre) return std::nullopt;
  const PairBox box{*centre, partner(task.template correlations<RationalInterval>(), *centre)};
  if (!Task::finite(box.partner)) return std::nullopt;
  return box;
}

}  // namespace detail

/// Dyads near points of the fixed frame, one for each: nearest on the curve as it is traced. None where the nearest
/// centre point is a slider's (these are listed with the curve) or a common pole of several displacements, or no curve
/// is shown; a warning says so. curves: those of the poses. A certificate's radius bounds the distance to some dyad of
/// the curve. Throws InputError for points that cannot be used.
template <CentrePoints Task>
NearestDyads<typename Task::Pivots::Dyads> dyads_near(const Task& task, const std::vector<CurveRecord>& curves,
                                                      const std::vector<std::vector<double>>& near, bool certify) {
  using G = typename Task::Pivots;
  expect_pivots<G>("near", near);
  const auto n = task.template correlations<double>();
  const auto exact = task.template correlations<Rational>();
  const Cubic<Rational> f = points_with_partner(exact);
  const std::vector<CurvePiece> pieces = detail::centre_pieces(task, curves);
  NearestDyads<typename G::Dyads> out;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const auto warn = [&](const std::string& words) { out.warnings.push_back(fmt::format("near[{}]: {}", k, words)); };
    const auto nearest = nearest_point(Task::surface, f, pieces, task.seen(near[k]));
    if (!nearest) {
      warn(pieces.empty() ? "no curve is listed; no dyad" : "no point of the curve is found near; no dyad");
      continue;
    }
    const Point2<double>& c = nearest->at;
    const Point2<Rational> p = partner(exact, Point2<Rational>(c.cast<Rational>()));
    if (detail::undetermined_partner(p, n, c)) {
      warn(fmt::format("the nearest centre point is a common {}, every point of a {} is its partner; no dyad", G::pole,
                       G::locus));
      continue;
    }
    auto found = task.dyad(c, p, certify ? detail::pair_box(task, f, c) : std::nullopt);
    if (found.departure) {
      warn(fmt::format("the nearest centre point is the {} of a slider; no RR dyad", G::pivot));
      continue;
    }
    if (nearest->end) warn("the curve is traced no farther than to this dyad; farther out it may be nearer");
    out.dyads.push_back(std::move(found));
  }
  return out;
}

/// Adds them to the report of the curve, each once. `points`: what people call what was given. G: a PivotGeometry.
template <class G>
void add_near(NearestDyads<typename G::Dyads> near, std::string_view points, std::span<const typename G::Pose> poses,
              Report<typename G::Dyads>& report) {
  std::ranges::move(near.dyads, std::back_inserter(report.dyads));
  std::ranges::move(near.warnings, std::back_inserter(report.warnings));
  drop_repeated<G>(report, poses, points);
  sort_dyads(report);
}

}  // namespace burmester
