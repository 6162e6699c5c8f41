#include "burmester/geometry/quadric_intersection.hpp"

#include <Eigen/LU>

#include "burmester/geometry/number.hpp"

namespace burmester {
namespace {

/// Above the rounding errors of the pencil determinants of conics of size 1: sums up to 96 with 8 roundings
/// on the way.
constexpr double rounding = 1024 * unit_roundoff;

Conic<double> scaled(Conic<double> c) {
  const double size = size_of(c);
  if (size > 0)
    for (double& q : c.q) q /= size;
  return c;
}

CommonPoints<double> common_points(const Conic<double>& a, const Conic<double>& b) {
  const std::array<double, 4> f = pencil_determinant(a, b);
  const auto small = [](double x) { return std::abs(x) <= rounding; };
  return std::all_of(f.begin(), f.end(), small) ? degenerate_common_points(a, b, rounding)
                                                : regular_common_points(a, b, f);
}

/// One Newton step on both conics, at right angles to x.
Point2<double> improved(const Conic<double>& a, const Conic<double>& b, const Point2<double>& x) {
  Matrix<double, 3, 3> J;
  J << a.gradient(x).transpose(), b.gradient(x).transpose(), x.transpose();
  const Point2<double> step = J.inverse() * Point2<double>(a(x), b(x), 0);
  return step.norm() < 0x1p-10 ? Point2<double>(x - step) : x;
}

}  // namespace

SectionPoints points_in_plane(const QuadricSections<double>& sections, double s, double t) {
  CommonPoints<double> found;
  SectionPoints out;
  if (sections.axis_is_chord()) {
    const Conic<double> conic = sections.conic(sections.leading(), s, t);
    const LinearForm<double> line = sections.radical_line(s, t);
    if (sections.axis_is_common()) {
      found.point[0] = LinearForm<double>(conic.q[4], conic.q[3], conic.q[2]).cross(line);
      found.count = !found.point[0].isZero(0);
      out.holds_curve = found.count == 0;
    } else {
      out.holds_curve = line.isZero(0);
      if (!out.holds_curve) detail::intersect_line(line, conic, found);
    }
  } else {
    const Conic<double> a = scaled(sections.conic(0, s, t)), b = scaled(sections.conic(1, s, t));
    found = common_points(a, b);
    out.holds_curve = found.kind == PencilKind::common_line || found.kind == PencilKind::same_conic;
    if (found.kind == PencilKind::regular)
      for (int i = 0; i < found.count; ++i) found.point[i] = improved(a, b, found.point[i]);
  }
  out.count = found.count;
  for (int i = 0; i < found.count; ++i) out.point[i] = sections.planes().point(found.point[i], s, t);
  return out;
}

}  // namespace burmester
