#include "burmester/planar/constraint_curve.hpp"

#include <algorithm>
#include <numbers>

#include "burmester/geometry/real_roots.hpp"

namespace burmester::planar {
namespace {

double size_of(const RR::Design& d) { return std::max({d.fixed.norm(), d.moving.norm(), d.length}); }
double size_of(const PR::Design& d) { return std::max(d.moving.norm(), std::abs(d.line.offset)); }
double size_of(const RP::Design& d) { return std::max(d.fixed.norm(), std::abs(d.line.offset)); }
double size_of(const PP::Design&) { return 0; }

/// A power of two near the largest length of the two dyads: the change of unit rounds nothing.
double unit_of(const ConstraintManifold& a, const ConstraintManifold& b) {
  double size = 0;
  for (const ConstraintManifold* m : {&a, &b})
    size = std::max(size, std::visit([](const auto& d) { return size_of(d); }, m->design()));
  return size > 0 ? power_of_two_below(size) : 1;
}

Quadric<double> in_units(Quadric<double> q, double unit) {
  for (const int i : {2, 3, 9}) q.q[static_cast<std::size_t>(i)] *= unit * unit;
  for (const int i : {5, 6, 7, 8}) q.q[static_cast<std::size_t>(i)] *= unit;
  const double size = power_of_two_below(burmester::size_of(q));
  for (double& c : q.q) c /= size;
  return q;
}

Quadric<Rational> exact(const Quadric<double>& q) {
  Quadric<Rational> out;
  std::copy(q.q.begin(), q.q.end(), out.q.begin());
  return out;
}

/// The angles of the zeros of a form in (X4 : X3), in (-pi, pi], ascending.
std::vector<double> angles_of_zeros(const BinaryForm<Rational>& form) {
  std::vector<double> out;
  const Polynomial<Rational> p(form.coefficients());
  for (const RealRoot& root : real_roots(p)) out.push_back(2 * std::atan(root.approximate()));
  if (p.degree() < static_cast<int>(form.degree)) out.push_back(std::numbers::pi);
  return out;
}

bool is_positive(const BinaryForm<Rational>& form, double angle) {
  return form(Rational(std::cos(angle / 2)), Rational(std::sin(angle / 2))) > 0;
}

}  // namespace

ConstraintCurve::ConstraintCurve(const ConstraintManifold& a, const ConstraintManifold& b) : unit_(unit_of(a, b)) {
  surface_ = {in_units(a.quadric(), unit_), in_units(b.quadric(), unit_)};
}

CommonPoses ConstraintCurve::at(double t, double w) const {
  const double h = std::hypot(t, w);
  const QuadricSections<double> sections(surface_[0], surface_[1], planes_of_constant_angle<double>());
  const SectionPoints found = points_in_plane(sections, w / h, t / h);
  CommonPoses out;
  out.all = found.holds_curve;
  for (int i = 0; i < found.count; ++i) {
    Pose pose = Space::pose(found.point[static_cast<std::size_t>(i)]);
    pose.x *= unit_, pose.y *= unit_;
    if (std::isfinite(pose.x) && std::isfinite(pose.y)) out.poses.push_back(pose);
  }
  return out;
}

std::vector<Range> ConstraintCurve::orientations() const {
  constexpr double pi = std::numbers::pi;
  const QuadricSections<Rational> sections(exact(surface_[0]), exact(surface_[1]),
                                           planes_of_constant_angle<Rational>());
  const BinaryForm<Rational> form = sections.discriminant();
  const Range all{-pi, pi};
  if (sections.axis_is_common() || form.is_zero()) return {all};
  const std::vector<double> zero = angles_of_zeros(form);
  if (zero.empty()) return is_positive(form, 0) ? std::vector<Range>{all} : std::vector<Range>{};

  const std::size_t n = zero.size();
  const auto angle = [&](std::size_t i) { return zero[i % n] + 2 * pi * static_cast<double>(i / n); };
  std::vector<bool> real(n);  // between angle(i) and angle(i + 1)
  for (std::size_t i = 0; i < n; ++i) real[i] = is_positive(form, (angle(i) + angle(i + 1)) / 2);
  const std::size_t empty = static_cast<std::size_t>(std::find(real.begin(), real.end(), false) - real.begin());
  if (empty == n) return {all};
  std::vector<Range> out;
  const std::size_t first = (empty + 1) % n;
  for (std::size_t i = first; i < first + n; ++i) {
    if (!real[(i + n - 1) % n]) out.push_back({angle(i), angle(i)});
    if (real[i % n]) out.back().high = angle(i + 1);
  }
  return out;
}

}  // namespace burmester::planar
