#include "burmester/geometry/arc_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/real_roots.hpp"
#include "burmester/geometry/simple_roots.hpp"

namespace burmester::detail {
namespace {

constexpr double margin = 1.02;  // how far outside the window the last point of a piece may be
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
using Powers = std::array<T, TernaryForm<T>::highest_degree + 1>;

/// p (a + b t), p of this degree.
template <class T>
void multiply(Powers<T>& p, int degree, const T& a, const T& b) {
  auto k = static_cast<std::size_t>(degree + 1);
  for (p[k] = T(0); k > 0; --k) p[k] = p[k] * a + p[k - 1] * b;
  p[0] *= a;
}

/// F((from, 1) + t (to, 1)): the coefficient of t^k is the k-th Bernstein coefficient of
/// F on the segment, times a binomial.
template <class T>
Powers<T> along(const TernaryForm<T>& f, const Place& from, const Place& to) {
  static constexpr int binomial[TernaryForm<T>::highest_degree + 1][TernaryForm<T>::highest_degree + 1] = {
      {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}, {1, 6, 15, 20, 15, 6, 1}};
  Powers<T> value;
  value.fill(T(0));
  for (int j = f.degree; j >= 0; --j) {  // Horner's rule, as in TernaryForm
    Powers<T> row;
    row[0] = f(f.degree - j, j);
    for (int i = f.degree - j - 1, power = 1; i >= 0; --i, ++power) {
      multiply(row, power - 1, T(from.u), T(to.u));
      for (int k = 0; k <= power; ++k) row[static_cast<std::size_t>(k)] += f(i, j) * T(binomial[power][k]);
    }
    if (j < f.degree) multiply(value, f.degree - j - 1, T(from.v), T(to.v));
    for (std::size_t k = 0; k <= static_cast<std::size_t>(f.degree - j); ++k) value[k] += row[k];
  }
  return value;
}

/// Whether all coefficients have the same sign; nothing where that is not known.
template <class T>
std::optional<bool> one_sign(const Powers<T>& p, int degree) {
  bool positive = false, negative = false, known = true;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k) {
    const std::optional<int> sign = known_sign(p[k]);
    known = known && sign;
    positive = positive || sign == 1, negative = negative || sign == -1;
    if (sign == 0 || (positive && negative)) return false;
  }
  return known ? std::optional(true) : std::nullopt;
}

template <class T>
Vector<T, 2> turned_back(const CurveArcs& arcs, const T& u, const T& v) {
  const T a(arcs.a), b(arcs.b);
  return {T(a * u - b * v), T(b * u + a * v)};
}

}  // namespace

ArcSamples::ArcSamples(const CurveArcs& arcs, double window)
    : arcs_(arcs), window_(window), enclosing_(arcs.form.degree), samples_(arcs.component.size()) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(arcs.form.size()); ++k)
    enclosing_.coefficients[k] = enclosure(arcs.form.coefficients[k]);
  by_u_ = enclosing_.derivative(0), by_v_ = enclosing_.derivative(1);
}

/// Near singular points doubles do not tell it.
double ArcSamples::slope(const Place& at) const {
  const Point2<Interval> box{Interval(at.u), Interval(at.v), Interval(1)};
  const Interval by_u = by_u_(box), by_v = by_v_(box);
  if (!contains_zero(by_v)) return -approximate(by_u) / approximate(by_v);
  const Point2<Rational> exact{Rational(at.u), Rational(at.v), Rational(1)};
  const Rational rise = arcs_.form.derivative(0)(exact), run = arcs_.form.derivative(1)(exact);
  return run == 0 ? infinity : -approximate(Rational(rise / run));
}

/// Of the polynomial in v.
template <class T>
std::vector<T> ArcSamples::coefficients(const TernaryForm<T>& f, double u) const {
  std::vector<T> out;
  for (int j = 0; j <= f.degree; ++j) {
    out.push_back(f(f.degree - j, j));
    for (int i = f.degree - j - 1; i >= 0; --i) out.back() = out.back() * T(u) + f(i, j);
  }
  return out;
}

std::vector<Range> ArcSamples::exact_roots(double u) const {
  std::vector<Range> out;
  for (const RealRoot& root : real_roots(Polynomial<Rational>(coefficients(arcs_.form, u))))
    out.push_back(root.enclosure());
  return out;
}

const std::vector<Range>& ArcSamples::arcs_at(int interval, double u) {
  const auto i = static_cast<std::size_t>(interval);
  const auto [sample, is_new] = samples_[i].try_emplace(u);
  std::vector<Range>& arcs = sample->second;
  if (is_new) {
    const std::size_t expected = arcs_.component[i].size();
    arcs = boxes_of_simple_roots(coefficients(enclosing_, u)).value_or(std::vector<Range>());
    if (arcs.size() != expected) arcs = exact_roots(u);
    if (arcs.size() != expected) arcs.clear();
  }
  return arcs;
}

std::optional<Vertex> ArcSamples::vertex(int interval, int k, double u) {
  const std::vector<Range>& arcs = arcs_at(interval, u);
  if (arcs.empty()) return std::nullopt;
  const auto i = static_cast<std::size_t>(k);
  Vertex out;
  out.at = {u, arcs[i].low / 2 + arcs[i].high / 2};
  out.radius = std::max(arcs[i].high - out.at.v, out.at.v - arcs[i].low);
  out.gap = std::min(i > 0 ? arcs[i].low - arcs[i - 1].high : infinity,
                     i + 1 < arcs.size() ? arcs[i + 1].low - arcs[i].high : infinity);
  out.slope = slope(out.at);
  out.in_plane = in_plane(out.at);
  out.inside = in_window(out.in_plane, 1), out.near = in_window(out.in_plane, margin);
  return out;
}

bool ArcSamples::no_zero_between(const Place& from, const Place& to) const {
  const std::optional<bool> fast = one_sign(along(enclosing_, from, to), arcs_.form.degree);
  return fast ? *fast : *one_sign(along(arcs_.form, from, to), arcs_.form.degree);
}

Point2<double> ArcSamples::in_plane(const Place& at) const {
  const Vector<double, 2> p = turned_back(arcs_, at.u, at.v);
  return {p[0], p[1], 1};
}

bool ArcSamples::in_window(const Point2<double>& p, double factor) const {
  return std::abs(p[0]) <= factor * window_ && std::abs(p[1]) <= factor * window_;
}

bool ArcSamples::outside(const std::array<Place, 4>& corners) const {
  Vector<double, 2> least(infinity, infinity), most = -least;
  for (const Place& corner : corners) {
    const Vector<Interval, 2> p = turned_back(arcs_, Interval(corner.u), Interval(corner.v));
    for (int k = 0; k < 2; ++k) least[k] = std::min(least[k], lower(p[k])), most[k] = std::max(most[k], upper(p[k]));
  }
  return least.maxCoeff() > window_ || most.minCoeff() < -window_;
}

}  // namespace burmester::detail
