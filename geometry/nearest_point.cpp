#include "burmester/geometry/nearest_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace burmester {
namespace {

constexpr double farthest = 0.25;  // from a place of the polyline: a chord is no longer

Matrix<double, 3, 2> tangents(Surface surface, const Point2<double>& c) {
  Matrix<double, 3, 2> t = Matrix<double, 3, 2>::Identity();
  if (surface == Surface::sphere) t.col(0) = c.unitOrthogonal(), t.col(1) = c.cross(t.col(0));
  return t;
}

Point2<double> onto(Surface surface, const Point2<double>& c) {
  return surface == Surface::plane ? c : Point2<double>(c.normalized());
}

/// The gradient along the surface.
template <class T>
Point2<double> slope_at(Surface surface, const Cubic<T>& f, const Point2<double>& c) {
  const Vector<T, 3> gradient = f.gradient(c.cast<T>());
  const auto t = tangents(surface, c);
  return t *
         (t.transpose() * Point2<double>(approximate(gradient[0]), approximate(gradient[1]), approximate(gradient[2])));
}

/// A place of a polyline.
struct Place {
  Point2<double> at;
  double distance;  ///< from q
  bool end;
};

/// Nearest to q on the chord from a to b: 0 at a, 1 at b.
double nearest_share(Surface surface, const Point2<double>& a, const Point2<double>& b, const Point2<double>& q) {
  const Point2<double> middle = (a + b) / 2, d = b - a;
  if (d.isZero(0)) return 0;
  if (surface == Surface::plane) return std::clamp(0.5 + d.dot(q - middle) / d.squaredNorm(), 0.0, 1.0);
  const double ahead = q.dot(middle), along = q.dot(d);  // a and b are unit vectors: the middle is across the chord
  if (!(ahead > 0)) return along > 0 ? 1 : 0;
  return std::clamp(0.5 + along / ahead * middle.squaredNorm() / d.squaredNorm(), 0.0, 1.0);
}

/// |c - q| - |q|, which tells near points apart when q is far away.
double farther_than_origin(const Point2<double>& c, const Point2<double>& q) {
  return c.dot(c - 2 * q) / ((c - q).norm() + q.norm());
}

/// The nearest place of each chord of a piece, or of the opposite piece.
std::vector<Place> places_of(Surface surface, const CurvePiece& piece, int sign, const Point2<double>& q) {
  std::vector<Place> out;
  const std::size_t n = piece.points.size();
  for (std::size_t k = piece.closed ? 0 : 1; k < n; ++k) {
    const Point2<double> a = sign * piece.points[(k + n - 1) % n], b = sign * piece.points[k];
    const double t = nearest_share(surface, a, b, q);
    const Point2<double> at = onto(surface, a + t * (b - a));
    out.push_back({at, farther_than_origin(at, q), !piece.closed && ((k == 1 && t == 0) || (k + 1 == n && t == 1))});
  }
  return out;
}

/// Nearer than their neighbours.
void add_least(const std::vector<Place>& places, bool closed, std::vector<Place>& out) {
  const std::size_t n = places.size();
  for (std::size_t k = 0; k < n; ++k) {
    const bool after = (!closed && k == 0) || places[k].distance <= places[(k + n - 1) % n].distance;
    const bool before = (!closed && k + 1 == n) || places[k].distance <= places[(k + 1) % n].distance;
    if (after && before) out.push_back(places[k]);
  }
}

/// The places that the nearest point of the curve may be at.
std::vector<Place> starts(Surface surface, const std::vector<CurvePiece>& pieces, const Point2<double>& q) {
  std::vector<Place> out;
  double error = 0, least = std::numeric_limits<double>::infinity();
  for (const CurvePiece& piece : pieces) {
    error = std::max(error, piece.max_error);
    for (const int sign : {1, -1})
      if (sign == 1 || surface == Surface::sphere) add_least(places_of(surface, piece, sign, q), piece.closed, out);
  }
  for (const Place& place : out) least = std::min(least, place.distance);
  std::erase_if(out, [&](const Place& place) { return place.distance > least + 2 * error; });
  return out;
}

/// Steps towards the curve along the gradient, if they lead nearer; at double points they may not.
template <class T>
Point2<double> projected(Surface surface, const Cubic<T>& f, Point2<double> c) {
  const auto size = [&](const Point2<double>& p) { return approximate(f(p.cast<T>())); };
  for (int i = 0; i < 4; ++i) {
    const Point2<double> slope = slope_at(surface, f, c);
    const Point2<double> next = onto(surface, c - size(c) / slope.squaredNorm() * slope);
    if (!((next - c).norm() <= farthest) || !(std::abs(size(next)) < std::abs(size(c)))) break;
    c = next;
  }
  return c;
}

/// The point to which Newton's method leads; nothing where it leads away.
std::optional<Point2<double>> stationary(Surface surface, const Cubic<double>& f, const Point2<double>& q,
                                         const Point2<double>& start) {
  Point2<double> c = start;
  const Point2<double> first = slope_at(surface, f, c);
  double lambda = (q - c).dot(first) / first.squaredNorm();
  for (int i = 0; i < 20; ++i) {
    const auto t = tangents(surface, c);
    const Vector<double, 3> gradient = f.gradient(c);
    Matrix<double, 3, 2> bent;
    for (int k = 0; k < 2; ++k) bent.col(k) = f.polar(c, t.col(k));
    Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
    system.topLeftCorner<2, 2>() = lambda * t.transpose() * bent;
    system.topLeftCorner<2, 2>().diagonal().array() += surface == Surface::plane ? 1 : c.dot(q);
    system.topRightCorner<2, 1>() = t.transpose() * gradient;
    system.bottomLeftCorner<1, 2>() = gradient.transpose() * t;
    Eigen::Vector3d off;
    off << t.transpose() * (c - q + lambda * gradient), f(c);
    const Eigen::Vector3d step = system.partialPivLu().solve(off);
    c = onto(surface, c - t * step.head<2>()), lambda -= step[2];
    if (!((c - start).norm() <= farthest)) return std::nullopt;  // also where it is not a number
  }
  return projected(surface, f, c);
}

/// Whether the curve passes c within a few roundings, more generously than doubles need.
bool is_on(const Cubic<Rational>& f, double f_bound, const Point2<double>& c) {
  const Point2<Rational> exact = c.cast<Rational>();
  const Vector<Rational, 3> gradient = f.gradient(exact);
  const Point2<double> slope(approximate(gradient[0]), approximate(gradient[1]), approximate(gradient[2]));
  const double off = 0x1p-36 * c.norm(), bend = f_bound * c.norm();
  return std::abs(approximate(f(exact))) <= off * (slope.norm() + bend * off);
}

}  // namespace

std::optional<NearestPoint> nearest_point(Surface surface, const Cubic<Rational>& exact,
                                          const std::vector<CurvePiece>& pieces, const Point2<double>& q) {
  Cubic<double> f;
  for (std::size_t k = 0; k < f.c.size(); ++k) f.c[k] = approximate(exact.c[k]);
  std::optional<NearestPoint> best;
  const auto distance = [&](const Point2<double>& c) { return farther_than_origin(c, q); };
  for (const Place& place : starts(surface, pieces, q)) {
    Point2<double> c = projected(surface, f, place.at);
    // where both are the same point, rounding does not choose the less accurate one
    if (const auto s = stationary(surface, f, q, place.at); s && distance(*s) <= distance(c) + 0x1p-40 * c.norm())
      c = *s;
    if (!is_on(exact, f.gradient_bound(), c)) continue;
    if (!best || distance(c) < distance(best->at)) best = {c, place.end};
  }
  if (best) best->at = projected(surface, exact, best->at);
  return best;
}

std::optional<Point2<RationalInterval>> crossing(Surface surface, const Cubic<Rational>& f, const Point2<double>& c) {
  const Point2<double> normal = slope_at(surface, f, c).normalized();
  for (double reach = unit_roundoff * (1 + c.norm()); reach < 1e-6; reach *= 4) {
    const Point2<double> a = c - reach * normal, b = c + reach * normal;
    if (f(a.cast<Rational>()) * f(b.cast<Rational>()) > 0) continue;
    const auto hull = [&](int i) { return RationalInterval(std::min(a[i], b[i]), std::max(a[i], b[i])); };
    return Point2<RationalInterval>{hull(0), hull(1), hull(2)};
  }
  return std::nullopt;
}

}  // namespace burmester
