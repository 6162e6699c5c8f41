// How far polylines and curves are from each other: for the tests of tracing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/random.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/sign.hpp"
#include "cubics.hpp"

namespace burmester::corpus {

/// Whether the curve meets the disc of radius e about p: exactly, where F changes its sign between two of its points.
template <class Form>
bool meets_disc(const Form& f, const Point2<double>& p, double e) {
  const auto sign = [&f](const Point2<double>& x) { return *known_sign(f(cast<Rational>(x))); };
  e += 0x1p-50 * p.norm();  // p itself is rounded
  const Vector<Rational, 3> exact = f.gradient(cast<Rational>(p));
  const Vector<double, 3> gradient(approximate(exact[0]), approximate(exact[1]), approximate(exact[2]));
  Vector<double, 3> u = p.unitOrthogonal(), v = p.cross(u).normalized();
  if (p[2] == 1) u = {1, 0, 0}, v = {0, 1, 0};
  const double along_u = gradient.dot(u), along_v = gradient.dot(v), size = std::hypot(along_u, along_v);
  if (size > 0) {
    const Vector<double, 3> n = (along_u * u + along_v * v) / size * e;
    if (sign(p + n) * sign(p - n) <= 0) return true;
  }
  const int at_p = sign(p);
  for (double angle = 0; angle < 6.2; angle += 0.3)
    if (sign(p + e * (std::cos(angle) * u + std::sin(angle) * v)) != at_p) return true;
  return false;
}

inline double distance_to_chord(const Point2<double>& p, const Point2<double>& a, const Point2<double>& b) {
  const Vector<double, 3> d = b - a;
  const double size = d.squaredNorm(), t = size > 0 ? std::clamp(d.dot(p - a) / size, 0.0, 1.0) : 0;
  return (p - a - t * d).norm();
}

inline double distance_to_pieces(const Point2<double>& p, const std::vector<CurvePiece>& pieces,
                                 bool partners = false) {
  double best = 1e300;
  for (const CurvePiece& piece : pieces) {
    const auto& points = partners ? piece.partners : piece.points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k + 1 == points.size() && !piece.closed && k > 0) break;
      best = std::min(best, distance_to_chord(p, points[k], points[(k + 1) % points.size()]));
    }
  }
  return best;
}

/// Random points of the chords of a piece.
template <class Use>
void for_points_on_chords(const std::vector<Point2<double>>& points, bool closed, Random& random, Use use) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k + 1 == points.size() && !closed) return;
    const double t = random.uniform();
    use(Point2<double>((1 - t) * points[k] + t * points[(k + 1) % points.size()]));
  }
}

}  // namespace burmester::corpus
