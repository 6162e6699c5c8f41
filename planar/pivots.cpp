#include "burmester/planar/pivots.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "burmester/geometry/taubin_circle.hpp"
#include "burmester/modules/framework/result_io.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/planar/classify.hpp"
#include "burmester/planar/drawing/stage.hpp"
#include "burmester/planar/enclosed_pair.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

using FoundDyad = Found<Dyads::Design>;
static_assert(PivotGeometry<Pivots>);

// Local coordinates that are free where one pivot is given (planar/dyads/*.hpp).
using RR_of_moving = Holding<RR, std::array{0, 1, 4}>;
using RR_of_fixed = Holding<RR, std::array{2, 3, 4}>;
using PR_of_moving = Holding<PR, std::array{2, 3}>;
using RP_of_fixed = Holding<RP, std::array{2, 3}>;

/// The task seen from pose 1's origin with the task size as unit of length.
Stage unit_task(std::span<const Pose> poses) { return {Vector2(poses[0].x, poses[0].y), planar::task_size(poses)}; }
std::vector<Pose> on_stage(const Stage& stage, std::span<const Pose> poses) {
  std::vector<Pose> out;
  for (const Pose& p : poses) out.push_back(stage.pose(p));
  return out;
}

/// Residual, and the condition with the task size as unit of length.
void judge(FoundDyad& found, Body given, std::span<const Pose> poses) {
  found.residual =
      Dyads::visit(found.design, [&]<class D>(const typename D::Design& d) { return largest_residual<D>(d, poses); });
  const Stage stage = unit_task(poses);
  const std::vector<Pose> unit_poses = on_stage(stage, poses);
  const Dyads::Design design = stage.design(found.design);
  if (std::holds_alternative<PR::Design>(design))
    found.condition = condition_of<PR_of_moving>(design, unit_poses);
  else if (std::holds_alternative<RP::Design>(design))
    found.condition = condition_of<RP_of_fixed>(design, unit_poses);
  else
    found.condition = given == Body::moving ? condition_of<RR_of_moving>(design, unit_poses)
                                            : condition_of<RR_of_fixed>(design, unit_poses);
}

/// The slider that a given pivot's dyad may be.
Slider slider_of(Body given, const Vector2& pivot, std::span<const Pose> poses) {
  if (given == Body::moving) return *PR_through(pivot, poses, poses[0]);
  return *RP_through(pivot - Vector2(poses[0].x, poses[0].y), poses, poses[0]);
}
Dyads::Design design_of(Body given, const Vector2& pivot, const Slider& slider) {
  if (given == Body::moving) return PR::Design{pivot, slider.line};
  return RP::Design{pivot, slider.line};
}

std::vector<Vector2> places_of(Body given, const Vector2& pivot, std::span<const Pose> poses) {
  std::vector<Vector2> places;
  for (const Pose& p : poses) places.push_back(given == Body::moving ? to_fixed(p, pivot) : to_moving(p, pivot));
  return places;
}

/// How far an arc of this radius over the places leaves its chord.
double sagitta(double radius, const std::vector<Vector2>& places) {
  double extent = 0;
  for (const Vector2& p : places) extent = std::max(extent, (p - places[0]).norm());
  return extent * extent / (8 * radius);
}

/// The best circle through the places of a given pivot; nothing where a line is better. On stage.
std::optional<RR::Design> best_RR(Body given, const Vector2& pivot, std::span<const Pose> poses) {
  const std::vector<Vector2> places = places_of(given, pivot, poses);
  const auto circle = taubin_circle(places);
  if (!circle) return std::nullopt;
  const RR::Design best = given == Body::fixed
                              ? refine<RR_of_fixed>({pivot, circle->centre, circle->radius}, poses).design
                              : refine<RR_of_moving>({circle->centre, pivot, circle->radius}, poses).design;
  if (!(sagitta(best.length, places) > slider_departure)) return std::nullopt;
  return best;
}

}  // namespace

FoundDyad judged(const EnclosedDyad& dyad, Body given, const Vector2& pivot, bool far, std::span<const Pose> poses,
                 bool certify) {
  const double size = planar::task_size(poses);
  const Slider slider = slider_of(given, pivot, poses);
  // Two places lie on any line, and so do those that hardly differ by more than they may leave it.
  const bool wide = !(dyad.shown.length <= size) &&
                    detail::three_differ(places_of(given, pivot, poses), 16 * slider_departure * size);
  FoundDyad found;
  if (far || !std::isfinite(dyad.shown.length) || (wide && slider.departure <= slider_departure * size)) {
    found.design = planar::design_of(given, pivot, slider);
    found.departure = slider.departure;
  } else {
    found.design = dyad.shown;
    if (wide && slider.departure <= near_slider_departure * size)
      found.slider = SliderRecord{slider.type, slider.line.record(), slider.departure};
  }
  judge(found, given, poses);
  if (certify)
    if (const double radius = error_bound(found.design, dyad.box, poses, dyad.from); std::isfinite(radius))
      found.certificate = {true, radius, dyad.box.rung};
  return found;
}

FoundDyad Pivots::dyad(Body given, const std::vector<double>& pivot, const Point2<Rational>& partner,
                       std::span<const Pose> poses, bool certify) {
  const auto [x, y, X3, X4] = data(poses[0]);
  const Point2<Rational> at = seen<Rational>(given, {Rational(x), Rational(y), Rational(X3), Rational(X4)},
                                             {Rational(pivot[0]), Rational(pivot[1])});
  const auto place = [](const Point2<Rational>& p) {
    return std::array<Rational, 2>{Rational(p[0] / p[2]), Rational(p[1] / p[2])};
  };
  const bool far = partner[2] == 0;
  PivotPair<Rational> pair;
  (given == Body::moving ? pair.moving : pair.fixed) = place(at);
  if (!far) (given == Body::moving ? pair.fixed : pair.moving) = place(partner);
  return judged(enclosed(pair, poses[0]), given, {pivot[0], pivot[1]}, far, poses, certify);
}

/// As for the origins of poses (planar/pose_format.cpp).
const char* Pivots::complaint(const std::vector<double>& pivot) {
  const bool usable = std::abs(pivot[0]) <= 1e100 && std::abs(pivot[1]) <= 1e100;
  return usable ? nullptr : "coordinates of magnitude at most 1e100";
}

std::vector<FoundDyad> Pivots::fits(Body given, const std::vector<double>& pivot, std::span<const Pose> poses) {
  const Vector2 at(pivot[0], pivot[1]);
  if (!detail::three_differ(places_of(given, at, poses), rounding(pivot, poses))) return {};
  const Slider slider = slider_of(given, at, poses);
  std::vector<FoundDyad> out(1);
  out[0].design = planar::design_of(given, at, slider);
  out[0].departure = slider.departure;
  const Stage stage = unit_task(poses);
  const double unit = stage.unit;
  const Vector2 on = given == Body::moving ? Vector2(at / unit) : Vector2((at - stage.centre) / unit);
  if (const auto rr = best_RR(given, on, on_stage(stage, poses))) {
    out.emplace_back().design = given == Body::moving ? RR::Design{stage.in_problem(rr->fixed), at, unit * rr->length}
                                                      : RR::Design{at, unit * rr->moving, unit * rr->length};
    std::swap(out[0], out[1]);
  }
  for (FoundDyad& found : out) judge(found, given, poses);
  return out;
}

/// Sums of a few products of coordinates, of the data and in the fit.
double Pivots::rounding(const std::vector<double>& pivot, std::span<const Pose> poses) {
  double largest = std::abs(pivot[0]) + std::abs(pivot[1]);
  for (const Pose& p : poses) largest = std::max(largest, std::abs(p.x) + std::abs(p.y));
  return 64 * unit_roundoff * (largest + planar::task_size(poses));
}

PartnersRecord Pivots::partners(Body given, const std::vector<double>& pivot, const LinearForm<double>& line,
                                const Pose& first) {
  const double size = line.head<2>().norm();
  const Line seen{line.head<2>() / size, -line[2] / size};
  if (given == Body::moving) return {{}, pivot, seen.moved({first.x, first.y, 0, 1}).record(), {}};
  return {pivot, {}, seen.moved({0, 0, -first.X3, first.X4}).record(), {}};
}

std::vector<Point2<double>> Pivots::along(const LinearForm<double>& line, const Point2<double>& given, int count) {
  const Vector2 normal = line.head<2>().normalized(), direction(-normal[1], normal[0]);
  const Vector2 p = given.head<2>() / given[2];
  const double away = line.head<2>().dot(p) / line.head<2>().norm() + line[2] / line.head<2>().norm();
  std::vector<Point2<double>> out;
  for (int k = 0; k < count; ++k) {
    const Vector2 at = p - away * normal + (k - (count - 1) / 2) * std::abs(away) * direction;
    out.push_back({at[0], at[1], 1});
  }
  out.push_back({direction[0], direction[1], 0});
  return out;
}

std::vector<std::vector<double>> Pivots::grid(std::span<const Pose> poses) {
  constexpr int steps = 6;
  Vector2 low(poses[0].x, poses[0].y), high = low;
  for (const Pose& p : poses) low = low.cwiseMin(Vector2(p.x, p.y)), high = high.cwiseMax(Vector2(p.x, p.y));
  const double margin = planar::task_size(poses) / 2;
  const Vector2 start = low.array() - margin, step = (high.array() + margin - start.array()) / steps;
  std::vector<std::vector<double>> out;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) out.push_back({start[0] + i * step[0], start[1] + j * step[1]});
  return out;
}

std::optional<PoleRecord> Pivots::pole_of(const Pose& from, const Pose& to) {
  const Vector2 way(to.x - from.x, to.y - from.y);
  PoleRecord out;
  if (same_orientation(from, to)) {
    if (way.isZero(0)) return std::nullopt;
    const Vector2 normal = way.normalized();
    const Vector2 middle = Vector2(from.x, from.y) + way / 2;
    out.far = Line{normal, normal.dot(middle)}.record();
    return out;
  }
  const auto [s, c] = relative_turn<double>(from, to);
  const Pose near{0, 0, from.X3, from.X4}, next{way[0], way[1], to.X3, to.X4};  // seen from the first origin
  const Point2<double> pole = relative_pole(near, next), body = moving_pole(near, next);
  const Vector2 fixed = pole.head<2>() / pole[2] + Vector2(from.x, from.y), moving = body.head<2>() / body[2];
  out.angle = 2 * std::atan2(c < 0 ? -s : s, std::abs(c));
  out.fixed = {fixed[0], fixed[1]}, out.moving = {moving[0], moving[1]};
  return out;
}

std::string Pivots::described(const PoleRecord& pole, const Units& units) {
  const auto angle = [&](double x) {
    return fmt::format("{:.6g} {}", shown_angle(x, units), units.degrees ? "deg" : "rad");
  };
  if (pole.far)
    return fmt::format("a translation, its pole at infinity in the direction of {}: ", angle(pole.far->angle));
  return fmt::format("a rotation by {} about the pole ({:.6g}, {:.6g}): ", angle(pole.angle), pole.fixed[0],
                     pole.fixed[1]);
}

PlanarReport FamilySolver::solve(std::span<const Pose> poses) const {
  assert(poses.size() == 2 || poses.size() == 3);
  return family_of_dyads<Pivots>(poses, units);
}

static_assert(Solver<FamilySolver>);

}  // namespace burmester::planar
