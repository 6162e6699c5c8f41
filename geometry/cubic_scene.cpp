#include "burmester/geometry/cubic_scene.hpp"

#include <algorithm>

#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/real_roots.hpp"
#include "burmester/geometry/simple_roots.hpp"

namespace burmester::detail {
namespace {

using burmester::enclosure;

BinaryForm<Interval> enclosure(const BinaryForm<Rational>& f) {
  return converted<Interval>(f, [](const Rational& x) { return enclosure(x); });
}

/// (u0 : u1) of a box; there s = u1 and t = u0.
Point1<Interval> point(const ProjectiveBox& box) {
  const Interval at(box.at.low, box.at.high);
  return box.reciprocal ? Point1<Interval>(at, Interval(1)) : Point1<Interval>(Interval(1), at);
}

/// Makes the determinant with the root before positive, so that the sum of two neighbours lies between them.
void orient(std::vector<CubicScene::Root>& roots) {
  for (std::size_t k = 1; k < roots.size(); ++k) {
    const Point1<double> a = middle(roots[k - 1].at), b = middle(roots[k].at);
    const double across = a[0] * b[1] - a[1] * b[0];
    if (across > 0 || (across == 0 && a.dot(b) >= 0)) continue;
    roots[k].at = -roots[k].at;
    if (auto& x = roots[k].refined) *x = {-(*x)[0], -(*x)[1]};
  }
}

/// 4 I^3 - J^2, 27 times the discriminant of a quartic form.
template <class T>
T quartic_discriminant(const BinaryForm<T>& f) {
  const T &a = f.c[0], &b = f.c[1], &m = f.c[2], &d = f.c[3], &e = f.c[4];
  const T i = 12 * a * e - 3 * b * d + m * m;
  const T j = 72 * a * m * e + 9 * b * m * d - 27 * (a * d * d + b * b * e) - 2 * m * m * m;
  return 4 * i * i * i - j * j;
}

/// The sign behind each root from the sign behind the first one: it changes at roots of odd multiplicity.
void propagate_signs(std::vector<CubicScene::Root>& roots, std::size_t from, int sign) {
  for (std::size_t n = 0, k = from; n < roots.size(); ++n) {
    roots[k].sign_behind = sign;
    k = (k + 1) % roots.size();
    if (roots[k].multiplicity % 2 == 1) sign = -sign;
  }
}

/// The sign of D between roots that lie well apart.
std::optional<int> sign_in_widest_gap(const BinaryForm<Interval>& d, const std::vector<CubicScene::Root>& roots,
                                      std::size_t& gap) {
  Point1<double> best{1, 0};
  double widest = -1;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const Point1<double> a = middle(roots[k].at).normalized();
    Point1<double> b = middle(roots[(k + 1) % roots.size()].at).normalized();
    if (k + 1 == roots.size()) b = -b;  // once round
    if (const double width = (a - b).norm(); width > widest) widest = width, gap = k, best = a + b;
  }
  return known_sign(d(Interval(best[0]), Interval(best[1])));
}

/// D = S^2 G from the multiplicities of its roots.
void split_discriminant(CubicScene& scene) {
  scene.factor = BinaryForm<Interval>::constant(Interval(1));
  scene.rest = scene.discriminant;
  for (const CubicScene::Root& root : scene.roots)
    for (int k = 1; k < root.multiplicity; k += 2) {
      scene.factor = scene.factor * BinaryForm<Interval>::vanishing_at(root.at);
      for (int twice = 0; twice < 2; ++twice) {
        scene.rest = scene.rest.divided_by_root(root.at);
        divide_by_root(scene.dips, root.at);
      }
    }
}

/// The same where D has no real root but is the square of a form with complex ones, or zero.
void split_exactly(const BinaryForm<Rational>& d, CubicScene& scene) {
  if (d.is_zero()) {
    scene.factor = BinaryForm<Interval>::constant(Interval(1)),
    scene.rest = BinaryForm<Interval>::constant(Interval(0));
    return;
  }
  if (d.degree < 4 || quartic_discriminant(d) != 0) return;
  scene.dips.clear();
  const Rational p = d.c[1] / (2 * d.c[0]), r = (d.c[2] / d.c[0] - p * p) / 2;
  scene.factor = enclosure(BinaryForm<Rational>({Rational(1), p, r}));
  scene.rest = BinaryForm<Interval>::constant(enclosure(d.c[0]));
}

/// Numbers times a power of two that brings the largest near 1, so that none of size matters overflows as a double.
template <class Numbers>
void bring_near_one(Numbers& x) {
  bool some = false;
  int exponent = 0;
  for (const Rational& value : x) {
    if (value == 0) continue;
    const int size = static_cast<int>(msb(abs(numerator(value)))) - static_cast<int>(msb(denominator(value)));
    exponent = some ? std::max(exponent, size) : size, some = true;
  }
  const Rational power(Integer(1) << static_cast<unsigned>(std::abs(exponent)));
  for (Rational& value : x) value = exponent > 0 ? Rational(value / power) : Rational(value * power);
}

/// A cubic divided by the line through the base that splits off, if one does.
template <class T>
std::optional<Point1<T>> divide_by_line(CubicPencil<T>& pencil) {
  const Point1<T> u{pencil.a.c[1], T(-pencil.a.c[0])};
  if (known_sign(pencil.b(u)) != 0 || known_sign(pencil.c(u)) != 0) return std::nullopt;
  pencil.a = pencil.a.divided_by_root(u);
  pencil.b = pencil.b.divided_by_root(u);
  pencil.c = pencil.c.divided_by_root(u);
  return u;
}

Polynomial<Rational> polynomial(const BinaryForm<Rational>& f) { return Polynomial<Rational>(f.coefficients()); }

/// (1 : x), in the chart where it is small
Point1<Interval> point(const RealRoot& x) {
  const Range range = x.enclosure();
  const Interval at(range.low, range.high);
  return std::abs(approximate(at)) > 1 ? Point1<Interval>(1 / at, Interval(1)) : Point1<Interval>(Interval(1), at);
}

/// The same, so narrow that roots which doubles can hardly tell apart have a difference.
CubicScene::Root refined_root(RealRoot x) {
  CubicScene::Root out{point(x), x.multiplicity(), 0, std::nullopt};
  const bool large = std::abs(approximate(out.at[0])) < 1;  // then (1 / x : 1)
  if (!x.is_point()) x.refine(std::ldexp(std::max(1.0, std::abs(x.approximate())), -133));
  const RationalInterval at = x.bounds();
  out.refined = large ? std::array{RationalInterval(1) / at, RationalInterval(1)} : std::array{RationalInterval(1), at};
  return out;
}

/// The different roots of a form that is not zero, (0 : 1) included, and the signs between them.
std::vector<CubicScene::Root> exact_roots(const BinaryForm<Rational>& f) {
  const Polynomial<Rational> p = polynomial(f);
  std::vector<CubicScene::Root> roots;
  for (const RealRoot& root : real_roots(p)) roots.push_back(refined_root(root));
  const std::size_t finite = roots.size();
  const int sign = known_sign(p.leading()).value();  // for large x, that is, behind the last finite root
  const int at_infinity = static_cast<int>(f.degree) - p.degree();
  if (at_infinity > 0)
    roots.push_back({{Interval(0), Interval(1)}, at_infinity, 0, std::array<RationalInterval, 2>{0, 1}});
  if (finite > 0)
    propagate_signs(roots, finite - 1, sign);
  else if (at_infinity > 0)
    propagate_signs(roots, 0, sign);  // no finite root: both degrees are even
  orient(roots);
  return roots;
}

/// D about its flat places, if it nearly vanishes there: where the square root of its rounding errors would be seen.
std::vector<LocalForm<Interval>> dips(const BinaryForm<Rational>& d) {
  std::vector<LocalForm<Interval>> out;
  const auto add = [&](const Polynomial<Rational>& p, auto place) {
    if (p.degree() < 2) return;
    for (const RealRoot& flat : real_roots(p.derivative())) {
      const double at = flat.approximate();
      if (std::abs(at) > 1) continue;
      const BinaryForm<Rational> seen = seen_from(place(at), d);
      if (abs(seen.c[0]) * Rational(1 << 20) < abs(seen.c[2])) out.push_back({place(at), enclosure(seen)});
    }
  };
  add(polynomial(d), [](double x) { return Point1<double>(1, x); });
  add(polynomial(d).reversed(), [](double x) { return Point1<double>(x, 1); });
  return out;
}

}  // namespace

void divide_by_root(std::vector<LocalForm<Interval>>& dips, const Point1<Interval>& u) {
  std::erase_if(dips, [&](const auto& dip) { return dip.is_near(u); });
  for (auto& dip : dips) dip.divide_by_root(u);
}

std::optional<CubicScene> cubic_scene(const Cubic<Interval>& f, const Point2<Interval>& on_curve) {
  const CubicPencil<Interval> pencil(f, on_curve);
  CubicScene out(pencil);
  const auto& d = out.discriminant.c;
  const auto roots = simple_roots<4>({d[0], d[1], d[2], d[3], d[4]});
  if (!roots) return std::nullopt;
  for (int k = 0; k < roots->count; ++k)
    out.roots.push_back({point(roots->at[static_cast<std::size_t>(k)]), 1, 0, std::nullopt});
  orient(out.roots);
  std::size_t gap = 0;
  const std::optional<int> sign = sign_in_widest_gap(out.discriminant, out.roots, gap);
  if (!sign) return std::nullopt;
  if (roots->count == 0) {
    if (contains_zero(quartic_discriminant(out.discriminant))) return std::nullopt;
    out.sign = *sign;
  } else {
    propagate_signs(out.roots, gap, *sign);
  }
  split_discriminant(out);
  return out;
}

std::optional<CubicScene> cubic_scene(const Cubic<Rational>& given, const Point2<Rational>& given_point) {
  Cubic<Rational> f = given;
  Point2<Rational> on_curve = given_point;
  bring_near_one(f.c);
  bring_near_one(on_curve);
  CubicPencil<Rational> pencil(f, on_curve);
  if (pencil.a.is_zero()) return std::nullopt;
  const auto line = divide_by_line(pencil);
  const BinaryForm<Rational> d = pencil.discriminant();
  const Point2<Interval> base{enclosure(on_curve[0]), enclosure(on_curve[1]), enclosure(on_curve[2])};
  CubicScene out(CubicPencil<Interval>(enclosure(f), base));
  out.base = on_curve;
  out.discriminant = enclosure(d);
  out.pencil.k = pencil.k, out.pencil.i = pencil.i, out.pencil.j = pencil.j;
  out.pencil.a = enclosure(pencil.a), out.pencil.b = enclosure(pencil.b), out.pencil.c = enclosure(pencil.c);
  if (!d.is_zero()) {
    out.roots = exact_roots(d);
    out.dips = dips(d);
    if (out.roots.empty()) out.sign = known_sign(d.c[0]).value();
  }
  split_discriminant(out);
  if (out.roots.empty()) split_exactly(d, out);
  if (line) {
    out.line = Point1<Interval>(enclosure((*line)[0]), enclosure((*line)[1]));
    out.sign_on_line = known_sign(d(*line)).value();
  }
  return out;
}

namespace {

PointAtInfinity point_at_infinity(const Cubic<double>& f, const Point1<double>& u) {
  const Point2<double> direction(u[0], u[1], 0), at = direction / direction.cwiseAbs().maxCoeff();
  const LinearForm<double> tangent = f.gradient(at);
  const double size = tangent.cwiseAbs().maxCoeff();
  return {at, size > 0 ? LinearForm<double>(tangent / size) : LinearForm<double>(0, 0, 1)};  // 0: rounded away
}
Cubic<double> rounded(const Cubic<Interval>& f) {
  Cubic<double> out;
  for (std::size_t k = 0; k < 10; ++k) out.c[k] = middle(f.c[k]);
  return out;
}

}  // namespace

std::optional<std::vector<PointAtInfinity>> points_at_infinity(const Cubic<Interval>& f) {
  const auto roots = simple_roots<3>({f.c[0], f.c[1], f.c[3], f.c[6]});
  if (!roots) return std::nullopt;
  std::vector<PointAtInfinity> out;
  for (int k = 0; k < roots->count; ++k)
    out.push_back(point_at_infinity(rounded(f), middle(point(roots->at[static_cast<std::size_t>(k)]))));
  return out;
}

std::vector<PointAtInfinity> points_at_infinity(const Cubic<Rational>& given) {
  Cubic<Rational> f = given;
  bring_near_one(f.c);
  const BinaryForm<Rational> top({f.c[0], f.c[1], f.c[3], f.c[6]}), dz({f.c[2], f.c[4], f.c[7]});
  std::vector<PointAtInfinity> out;
  if (top.is_zero()) return out;
  Cubic<double> rounded;
  for (std::size_t k = 0; k < 10; ++k) rounded.c[k] = approximate(f.c[k]);
  const auto add = [&](const Point1<double>& u, bool singular) {
    out.push_back(point_at_infinity(rounded, u));
    if (singular) out.back().tangent.setZero();
  };
  const Polynomial<Rational> p = polynomial(top), pz = polynomial(dz);
  for (RealRoot& root : real_roots(p)) add(middle(point(root)), root.multiplicity() > 1 && sign_at(pz, root) == 0);
  if (p.degree() < 3) add({0, 1}, p.degree() < 2 && known_sign(f.c[7]) == 0);
  return out;
}

}  // namespace burmester::detail
