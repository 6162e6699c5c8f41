#include "burmester/spherical/pivots.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/modules/framework/result_io.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/degeneracy.hpp"
#include "burmester/spherical/family.hpp"
#include "burmester/spherical/five_pose_solver.hpp"

namespace burmester::spherical {
namespace {

using FoundDyad = Found<Dyads::Design>;
using ExactAxis = Point2<Rational>;
static_assert(PivotGeometry<Pivots>);

constexpr double right_angle = std::numbers::pi / 2;

// Local coordinates that are free where one axis is given (spherical/dyads.cpp).
using RR_of_moving = Holding<RR, std::array{0, 1, 4}>;
using RR_of_fixed = Holding<RR, std::array{2, 3, 4}>;
using PR_of_moving = Holding<PR, std::array{0, 1}>;
using PR_of_fixed = Holding<PR, std::array{2, 3}>;

template <class T>
Space::Point<T> back(const Pose& pose) {
  return Space::conjugate<T>(Space::point<T>(pose));
}

ExactAxis exact_axis(const std::vector<double>& a) { return {Rational(a[0]), Rational(a[1]), Rational(a[2])}; }
Axis unit_axis(const ExactAxis& a) { return detail::to_double(a).normalized(); }

/// Distance of the axis shown from the true unit vector, at most: chord <= angle <= 1.2 sine below one radian.
double error_of(const Axis& shown, const ExactAxis& exact) {
  const ExactAxis s = shown.cast<Rational>(), across = s.cross(exact);
  const Rational square = s.squaredNorm(), length = square - 1;
  const Rational sine2 = across.squaredNorm() / (square * exact.squaredNorm());
  return 1.2 * root_of(range_of(RationalInterval(sine2))).high + magnitude(RationalInterval(length));
}

void judge(FoundDyad& found, Body given, std::span<const Pose> poses) {
  const bool moving = given == Body::moving;
  found.residual =
      Dyads::visit(found.design, [&]<class D>(const typename D::Design& d) { return largest_residual<D>(d, poses); });
  if (std::holds_alternative<PR::Design>(found.design))
    found.condition =
        moving ? condition_of<PR_of_moving>(found.design, poses) : condition_of<PR_of_fixed>(found.design, poses);
  else
    found.condition =
        moving ? condition_of<RR_of_moving>(found.design, poses) : condition_of<RR_of_fixed>(found.design, poses);
}

/// The eigenvector of the least eigenvalue of sum v v^T.
Axis least_direction(const std::vector<Axis>& v) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Axis& a : v) moments += a * a.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
}

/// Places of the given axis: in S if it moves, as the body sees it if it is fixed.
std::vector<Axis> places_of(Body given, const Axis& axis, std::span<const Pose> poses) {
  std::vector<Axis> places;
  for (const Pose& p : poses) {
    const auto x = given == Body::moving ? Space::point<double>(p) : back<double>(p);
    places.push_back(Space::act<double>(x, axis).normalized());
  }
  return places;
}

/// Best slider and best small circle through the places.
PR::Design best_PR(Body given, const Axis& axis, std::span<const Pose> poses) {
  const Axis normal = least_direction(places_of(given, axis, poses));
  return given == Body::moving ? refine<PR_of_moving>({normal, axis}, poses).design
                               : refine<PR_of_fixed>({axis, normal}, poses).design;
}
RR::Design best_RR(Body given, const Axis& axis, std::span<const Pose> poses) {
  const std::vector<Axis> places = places_of(given, axis, poses);
  Axis mean = Axis::Zero();
  for (const Axis& a : places) mean += a / static_cast<double>(places.size());
  std::vector<Axis> spread;
  for (const Axis& a : places) spread.push_back(a - mean);
  const Axis centre = least_direction(spread);
  const double arc = std::acos(std::clamp(centre.dot(mean), -1.0, 1.0));
  return given == Body::moving ? refine<RR_of_moving>({centre, axis, arc}, poses).design
                               : refine<RR_of_fixed>({axis, centre, arc}, poses).design;
}

bool is_slider(double arc) { return std::abs(arc - right_angle) <= slider_arc_tolerance; }

}  // namespace

FoundDyad judged(const Axis& fixed, const Axis& moving, Body given, std::span<const Pose> poses) {
  const double arc = Space::distance(fixed, Space::act<double>(Space::point<double>(poses[0]), moving));
  const double departure = std::abs(arc - right_angle);
  FoundDyad found;
  if (is_slider(arc)) {
    found.design = PR::Design{fixed, moving};
    found.departure = departure;
  } else {
    found.design = RR::Design{fixed, moving, arc};
    if (poses.size() > 2 && departure <= near_slider_departure)  // two places lie on any great circle
      found.slider = SliderRecord{PR::name, std::nullopt, departure};
  }
  judge(found, given, poses);
  return found;
}

FoundDyad Pivots::dyad(Body given, const std::vector<double>& axis, const ExactAxis& partner,
                       std::span<const Pose> poses, bool certify) {
  const Pose& first = poses[0];
  const bool moving_given = given == Body::moving;
  const ExactAxis fixed = moving_given ? partner : exact_axis(axis);
  const ExactAxis moving = moving_given ? exact_axis(axis) : Space::act<Rational>(back<Rational>(first), partner);
  const Axis b = unit_axis(fixed), a = unit_axis(moving);
  FoundDyad found = judged(b, a, given, poses);
  if (certify) {
    const double off_b = error_of(b, fixed), off_a = error_of(a, moving), rounding = 64 * unit_roundoff;
    const double off_arc = 1.2 * (off_a + off_b) + rounding + found.departure.value_or(0);  // a slider states 90 deg
    found.certificate = {true, std::hypot(off_b, off_a, off_arc) * (1 + 0x1p-40), Rung::exact};
  }
  return found;
}

const char* Pivots::complaint(const std::vector<double>& axis) {
  const bool zero = std::all_of(axis.begin(), axis.end(), [](double x) { return x == 0; });
  return zero ? "an axis that is not zero" : nullptr;
}

std::vector<FoundDyad> Pivots::fits(Body given, const std::vector<double>& axis, std::span<const Pose> poses) {
  const Axis at = unit_axis(exact_axis(axis));
  if (!detail::three_differ(places_of(given, at, poses), rounding(axis, poses))) return {};
  std::vector<FoundDyad> out(1);
  out[0].design = best_PR(given, at, poses);
  if (const RR::Design rr = best_RR(given, at, poses); !is_slider(rr.arc)) {
    out.emplace_back().design = rr;
    std::swap(out[0], out[1]);
  }
  for (FoundDyad& found : out) judge(found, given, poses);
  return out;
}

double Pivots::rounding(const std::vector<double>&, std::span<const Pose>) { return 64 * unit_roundoff; }

PartnersRecord Pivots::partners(Body given, const std::vector<double>& axis, const LinearForm<double>& line,
                                const Pose& first) {
  const Axis normal = given == Body::moving ? line : Axis(Space::act<double>(back<double>(first), line));
  const Axis unit = normal.normalized();
  PartnersRecord out;
  (given == Body::moving ? out.moving : out.fixed) = axis;
  out.normal = {unit[0], unit[1], unit[2]};
  return out;
}

std::vector<Point2<double>> Pivots::along(const LinearForm<double>& line, const Point2<double>& given, int count) {
  const Axis normal = line.normalized(), across = normal.cross(given.normalized());
  const Axis sideways = across.norm() > 1e-6 ? Axis(across.normalized()) : Axis(normal.unitOrthogonal());
  const Axis foot = sideways.cross(normal);
  std::vector<Point2<double>> out;
  for (int k = 0; k <= count; ++k) {
    const double t = k * std::numbers::pi / (count + 1);
    out.push_back(std::cos(t) * foot + std::sin(t) * sideways);
  }
  return out;
}

std::vector<std::vector<double>> Pivots::grid(std::span<const Pose>) {
  std::vector<std::vector<double>> out;
  for (int latitude = 15; latitude < 90; latitude += 30)
    for (int longitude = 0; longitude < 360; longitude += 30) {
      const double l = longitude * std::numbers::pi / 180, b = latitude * std::numbers::pi / 180;
      out.push_back({std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)});
    }
  return out;
}

std::optional<PoleRecord> Pivots::pole_of(const Pose& from, const Pose& to) {
  if (same_orientation(from, to)) return std::nullopt;
  const auto q = rotation_between<double>(Space::point<double>(from), Space::point<double>(to));
  const double sine = q.tail<3>().norm();
  const Axis axis = (q[0] < 0 ? -1 : 1) / sine * q.tail<3>();
  const Axis moving = Space::act<double>(back<double>(from), axis).normalized();
  PoleRecord out;
  out.angle = 2 * std::atan2(sine, std::abs(q[0]));
  out.fixed = {axis[0], axis[1], axis[2]}, out.moving = {moving[0], moving[1], moving[2]};
  return out;
}

std::string Pivots::described(const PoleRecord& pole, const Units& units) {
  return fmt::format(
      "a rotation by {:.6g} {} about the axis ({:.6g}, {:.6g}, {:.6g}): ", shown_angle(pole.angle, units),
      units.degrees ? "deg" : "rad", pole.fixed[0], pole.fixed[1], pole.fixed[2]);
}

Report<Dyads> solve_linear(const Problem& problem, std::span<const Pose> poses) {
  if (!problem.fixed.empty() || !problem.moving.empty()) return GivenPivots<Pivots>(problem, poses).solve();
  Report<Dyads> report = family_of_dyads<Pivots>(poses, problem.units);
  if (std::string why = degeneracy_of(poses); !why.empty())
    report.message = report.counts.dimension ? why + "; a two-dimensional family of dyads (samples)" : std::move(why);
  return report;
}

}  // namespace burmester::spherical
