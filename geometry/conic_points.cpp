#include "burmester/geometry/conic_points.hpp"

#include <Eigen/LU>

#include <optional>
#include <stdexcept>

#include "burmester/geometry/conic_count.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/krawczyk.hpp"
#include "burmester/geometry/enclosure.hpp"

namespace burmester {
namespace {

/// a = b = 0 in the chart where coordinate number `unit` is 1.
template <class T>
struct Pair {
  static constexpr int size = 2;
  const Conic<T>&a, &b;
  int unit;

  int first() const { return (unit + 1) % 3; }
  int second() const { return (unit + 2) % 3; }
  Point2<T> point(const Vector<T, 2>& x) const {
    Point2<T> p;
    p[unit] = T(1), p[first()] = x[0], p[second()] = x[1];
    return p;
  }
  Vector<T, 2> value(const Vector<T, 2>& x) const {
    const Point2<T> p = point(x);
    return {a(p), b(p)};
  }
  Matrix<T, 2, 2> jacobian(const Vector<T, 2>& x) const {
    const Vector<T, 3> ga = a.gradient(point(x)), gb = b.gradient(point(x));
    Matrix<T, 2, 2> J;
    J << ga[first()], ga[second()], gb[first()], gb[second()];
    return J;
  }
};

struct Start {
  int unit;
  Vector<double, 2> at;
};

/// In the chart of the largest coordinate, after two of Newton's steps.
Start polished(const Conic<double>& a, const Conic<double>& b, const Point2<double>& p) {
  Start out;
  p.cwiseAbs().maxCoeff(&out.unit);
  const Pair<double> pair{a, b, out.unit};
  out.at = {p[pair.first()] / p[out.unit], p[pair.second()] / p[out.unit]};
  for (int i = 0; i < 2; ++i) out.at -= pair.jacobian(out.at).inverse() * pair.value(out.at);
  return out;
}

bool different(const Point2<Interval>& p, const Point2<Interval>& q) {
  const Point2<Interval> cross = p.cross(q);
  return !contains_zero(cross[0]) || !contains_zero(cross[1]) || !contains_zero(cross[2]);
}

/// Below an UpwardRounding.
std::optional<CertifiedCommonPoints> proved(const Conic<Interval>& a, const Conic<Interval>& b,
                                            const std::vector<Start>& starts) {
  if (count_common_points(a, b) != static_cast<int>(starts.size())) return std::nullopt;
  CertifiedCommonPoints out;
  out.rung = Rung::intervals;
  std::vector<Point2<Interval>> points;
  for (const Start& start : starts) {
    const Pair<Interval> pair{a, b, start.unit};
    const auto box = krawczyk<Interval>(pair, start.at);
    if (!box) return std::nullopt;
    const Point2<Interval> point = pair.point(box->template hull<Interval>());
    for (const Point2<Interval>& other : points)
      if (!different(point, other)) return std::nullopt;
    points.push_back(point);
    out.points.push_back({{start.unit, {range_of(point[0]), range_of(point[1]), range_of(point[2])}}, 1});
  }
  return out;
}

/// `a` and `b`: of size about 1; `enclosed`: makes the same two conics over intervals.
template <class Enclosed>
std::optional<CertifiedCommonPoints> points_in_doubles(const Conic<double>& a, const Conic<double>& b,
                                                       Enclosed enclosed) {
  const CommonPoints<double> found = regular_common_points(a, b, pencil_determinant(a, b));
  std::vector<Start> starts;
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    starts.push_back(polished(a, b, found.point[i]));
  const UpwardRounding upward;
  const std::array<Conic<Interval>, 2> conics = enclosed();
  return proved(conics[0], conics[1], starts);
}

template <class T, class S, class Convert>
Conic<T> converted(const Conic<S>& c, Convert convert) {
  Conic<T> out;
  std::transform(c.q.begin(), c.q.end(), out.q.begin(), convert);
  return out;
}

Conic<Rational> unit_sized(const Conic<Rational>& c) {
  Rational size = 0;
  for (const Rational& q : c.q) size = std::max(size, Rational(abs(q)));
  return size == 0 ? c : converted<Rational>(c, [&](const Rational& q) { return Rational(q / size); });
}

}  // namespace

CertifiedCommonPoints certified_common_points(const Conic<double>& a, const Conic<double>& b) {
  for (const Conic<double>* c : {&a, &b})
    if (!std::all_of(c->q.begin(), c->q.end(), [](double q) { return std::isfinite(q); }))
      throw std::invalid_argument("a conic has finite coefficients");
  const auto exactly = [](const Conic<double>& c) {
    return converted<Rational>(c, [](double q) { return Rational(q); });
  };
  const double size_a = size_of(a), size_b = size_of(b);
  if (std::min(size_a, size_b) > 0x1p-1000 && std::max(size_a, size_b) < 0x1p1000) {
    const double scale_a = unit_scale(size_a), scale_b = unit_scale(size_b);
    const auto scaled = [](const Conic<double>& c, double by) {
      return converted<double>(c, [=](double q) { return q * by; });
    };
    const auto enclosed = [](const Conic<double>& c, double by) {
      return converted<Interval>(c, [=](double q) { return Interval(q) * Interval(by); });
    };
    if (auto out = points_in_doubles(scaled(a, scale_a), scaled(b, scale_b), [&] {
          return std::array<Conic<Interval>, 2>{enclosed(a, scale_a), enclosed(b, scale_b)};
        }))
      return std::move(*out);
  }
  return certified_common_points_exactly(exactly(a), exactly(b));
}

CertifiedCommonPoints certified_common_points(const Conic<Rational>& a, const Conic<Rational>& b) {
  const Conic<Rational> unit_a = unit_sized(a), unit_b = unit_sized(b);
  const auto rounded = [](const Conic<Rational>& c) { return converted<double>(c, approximate<Rational>); };
  const auto enclosed = [](const Conic<Rational>& c) {
    return converted<Interval>(c, [](const Rational& q) { return enclosure(q); });
  };
  if (auto out = points_in_doubles(rounded(unit_a), rounded(unit_b), [&] {
        return std::array<Conic<Interval>, 2>{enclosed(unit_a), enclosed(unit_b)};
      }))
    return std::move(*out);
  return certified_common_points_exactly(a, b);
}

}  // namespace burmester
