#include "burmester/geometry/curve_factors.hpp"

#ifdef BURMESTER_WITHOUT_GMP

namespace burmester {

CurveFactors lines_and_conics(const TernaryForm<Integer>&) { return {}; }

}  // namespace burmester

#else

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfi.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <optional>

#include "burmester/geometry/cgal_polynomial.hpp"
#include "burmester/geometry/rational_interval.hpp"

namespace burmester {
namespace {

using namespace exact_curve;
using Form = TernaryForm<Integer>;

/// Roots of it are the slopes of the lines, real and complex.
CgalPolynomial line_slopes(const Form& curve, const CgalPolynomial& top, const CgalPolynomial& slope,
                           const CgalPolynomial& below) {
  CgalPolynomial out = top;
  for (int k = 2; k <= curve.degree && out.degree() > 0; ++k) {
    CgalPolynomial vanishing(0);  // at z^k of F on (1, m, 0) + z (0, -below, slope)
    for (int a = 0; a <= k; ++a)
      vanishing += at_infinity(curve, a, k - a) * CGAL::ipower(-below, a) * CGAL::ipower(slope, k - a);
    out = CGAL::gcd(out, vanishing);
  }
  return out;
}

using Float =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Intervals of such numbers.
using Real =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<120>, boost::multiprecision::et_off>;

RationalInterval bounds(const Real& x) {
  Rational low, high;
  mpfr_get_q(low.backend().data(), &x.backend().data()->left);
  mpfr_get_q(high.backend().data(), &x.backend().data()->right);
  return {low, high};
}
bool is_finite(const Real& x) { return mpfi_bounded_p(x.backend().data()) != 0; }

template <class T>
T from_integer(const Integer& x);
template <>
Float from_integer(const Integer& x) {
  return Float(x);
}
template <>
Real from_integer(const Integer& x) {
  Real out;
  mpfi_set_z(out.backend().data(), x.backend().data());
  return out;
}
Real point(const Float& x) {
  Real out;
  mpfi_set_fr(out.backend().data(), x.backend().data());
  return out;
}

/// re + i im
template <class T>
struct Complex {
  T re, im;
  explicit Complex(const T& x = T(0), const T& y = T(0)) : re(x), im(y) {}

  Complex operator-() const { return Complex(-re, -im); }
  friend Complex operator+(const Complex& a, const Complex& b) { return Complex(a.re + b.re, a.im + b.im); }
  friend Complex operator-(const Complex& a, const Complex& b) { return Complex(a.re - b.re, a.im - b.im); }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return Complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
  }
  friend Complex operator/(const Complex& a, const Complex& b) {
    const T size = b.re * b.re + b.im * b.im;
    const Complex c = a * Complex(b.re, -b.im);
    return Complex(c.re / size, c.im / size);
  }
};
using Box = Complex<Real>;

template <class T>
Complex<T> value(const CgalPolynomial& p, const Complex<T>& x) {
  Complex<T> out;
  for (int i = p.degree(); i >= 0; --i) out = out * x + Complex<T>(from_integer<T>(from_cgal(p[i])));
  return out;
}

/// W = p(x) / (c product of the differences to the other points), c the leading coefficient.
template <class T>
Complex<T> weierstrass_correction(const CgalPolynomial& p, const std::vector<Complex<T>>& points, std::size_t k) {
  Complex<T> others(from_integer<T>(from_cgal(p.lcoeff())));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i != k) others = others * (points[k] - points[i]);
  return value(p, points[k]) / others;
}

/// Boxes with one root in each: the discs of radius n |W| about n points hold all roots, and one each if they are
/// disjoint (B. T. Smith, "Error bounds for zeros of a polynomial based upon Gerschgorin's theorems", J. ACM 17
/// (1970)). Nothing where they are not.
std::optional<std::vector<Box>> boxes_about(const CgalPolynomial& p, const std::vector<Box>& points) {
  std::vector<Box> out;
  const Real both_sides(-1, 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Box w = weierstrass_correction(p, points, k);
    if (!is_finite(w.re) || !is_finite(w.im)) return std::nullopt;
    const Real around = p.degree() * (w.re * both_sides + w.im * both_sides);
    out.emplace_back(points[k].re + around, points[k].im + around);
    for (std::size_t i = 0; i < k; ++i)
      if (overlap(out[i].re, out[k].re) && overlap(out[i].im, out[k].im)) return std::nullopt;
  }
  return out;
}

/// All roots of a square-free polynomial, by K. Weierstrass' iteration; nothing where it did not come close to them.
std::optional<std::vector<Box>> complex_roots(const CgalPolynomial& p) {
  std::vector<Complex<Float>> roots;
  const Complex<Float> ratio(Float(0.4), Float(0.9));
  for (int i = 0; i < p.degree(); ++i) roots.push_back(i == 0 ? ratio : roots.back() * ratio);
  for (int step = 0; step < 200; ++step) {
    double largest = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const Complex<Float> change = weierstrass_correction(p, roots, k);
      roots[k] = roots[k] - change;
      largest = std::max(largest, static_cast<double>(change.re * change.re + change.im * change.im));
    }
    if (largest < 0x1p-600) break;
  }
  std::vector<Box> points;
  for (const Complex<Float>& root : roots) points.emplace_back(point(root.re), point(root.im));
  return boxes_about(p, points);
}

/// An asymptote y = m x + b + e / x + ..
struct Asymptote {
  Box m, b, e;
};

using Enclosure = std::array<RationalInterval, 6>;  // of a conic's coefficients, as Conic orders them

/// (y - m x - b z) (y - m' x - b' z) + c z^2, real parts: the conic with two asymptotes of the curve and its next term.
Enclosure conic_between(const Asymptote& s, const Asymptote& t) {
  return {bounds((s.m * t.m).re),
          RationalInterval(1),
          bounds((s.b * t.b - s.e * (s.m - t.m)).re),
          bounds(-(s.b + t.b).re),
          bounds((s.m * t.b + s.b * t.m).re),
          bounds(-(s.m + t.m).re)};
}

/// Nothing where the slopes could not be told apart.
std::optional<std::vector<Asymptote>> asymptotes(const Form& f, const CgalPolynomial& slopes) {
  const auto roots = complex_roots(slopes);
  if (!roots) return std::nullopt;
  std::vector<Asymptote> out;
  const CgalPolynomial f_s = at_infinity(f, 1, 0), f_z = at_infinity(f, 0, 1), f_ss = at_infinity(f, 2, 0),
                       f_sz = at_infinity(f, 1, 1), f_zz = at_infinity(f, 0, 2);
  for (const Box& m : *roots) {
    const Box slope = value(f_s, m);
    const Box b = -value(f_z, m) / slope, e = -((value(f_ss, m) * b + value(f_sz, m)) * b + value(f_zz, m)) / slope;
    if (!is_finite(e.re) || !is_finite(e.im)) return std::nullopt;
    out.push_back({m, b, e});
  }
  return out;
}

/// f / g; empty where g does not divide f. Precondition: g's term in y alone has coefficient 1.
std::optional<TernaryForm<Rational>> quotient(TernaryForm<Rational> f, const TernaryForm<Rational>& g) {
  if (f.degree < g.degree) return std::nullopt;
  TernaryForm<Rational> out(f.degree - g.degree);
  for (int j = out.degree; j >= 0; --j)
    for (int i = 0; i + j <= out.degree; ++i) {
      out(i, j) = f(i, j + g.degree);
      for (int l = 0; l <= g.degree; ++l)
        for (int k = 0; k + l <= g.degree; ++k) f(i + k, j + l) -= out(i, j) * g(k, l);
    }
  if (std::any_of(f.coefficients.begin(), f.coefficients.end(), [](const Rational& c) { return c != 0; }))
    return std::nullopt;
  return out;
}

/// The conic whose coefficients are multiples of 1 / unit, if there can be at most one: it is this one then.
std::optional<TernaryForm<Rational>> only_multiple(const Enclosure& c, const Integer& unit) {
  Conic<Rational> out;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!((c[k].high() - c[k].low()) * unit < 1)) return std::nullopt;
    out.q[k] = Rational(nearest_integer(Rational((c[k].low() + c[k].high()) / 2 * unit)), unit);
  }
  return TernaryForm<Rational>(out);
}

TernaryForm<Rational> middle(const Enclosure& c) {
  Conic<Rational> out;
  for (std::size_t k = 0; k < 6; ++k) out.q[k] = (c[k].low() + c[k].high()) / 2;
  return TernaryForm<Rational>(out);
}

}  // namespace

CurveFactors lines_and_conics(const Form& curve) {
  CurveFactors out;
  const CgalPolynomial top = at_infinity(curve, 0, 0), slope = at_infinity(curve, 1, 0),
                       below = at_infinity(curve, 0, 1);
  const CgalPolynomial slopes = line_slopes(curve, top, slope, below);
  const std::vector<Root> real_slopes = cgal_roots(slopes);
  TernaryForm<Rational> rest = curve.cast<Rational>();
  std::size_t rational_lines = 0;
  for (const Root& root : real_slopes) {
    const Rational m = rational_value(root);
    const LinearForm<Rational> line(-m, Rational(1), value(below, m) / value(slope, m));
    out.lines.push_back(line);
    if (const auto divided = quotient(rest, TernaryForm<Rational>(line))) rest = *divided, ++rational_lines;
  }
  if (rest.degree == 2 && rational_lines == real_slopes.size()) {
    out.conics.push_back(rest);
    return out;
  }

  const Integer unit = abs(curve(0, curve.degree));  // a rational factor has multiples of 1 / unit: Gauss
  const auto lines = asymptotes(curve, slopes),
             curved = asymptotes(curve, CGAL::integral_division_up_to_constant_factor(top, slopes));
  if (!lines || !curved) {
    out.proved = false;
    return out;
  }
  const auto above = std::count_if(lines->begin(), lines->end(), [](const auto& line) { return lower(line.m.im) > 0; });
  out.proved = 2 * static_cast<std::size_t>(above) + real_slopes.size() == lines->size();
  for (const Asymptote& line : *lines) {
    if (!(lower(line.m.im) > 0)) continue;  // real, or the conjugate of one that is not
    const Asymptote conjugate{Box(line.m.re, -line.m.im), Box(line.b.re, -line.b.im), Box()};
    Enclosure pair = conic_between(line, conjugate);
    const auto near = only_multiple(pair, unit);
    out.conics.push_back(near && quotient(rest, *near) ? *near : middle(pair));
  }
  if (rest.degree < 4) return out;
  for (std::size_t i = 0; i < curved->size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto conic = only_multiple(conic_between((*curved)[i], (*curved)[j]), unit);
      if (!conic) out.proved = false;
      const auto divided = conic ? quotient(rest, *conic) : std::nullopt;
      if (!divided) continue;
      rest = *divided;
      out.conics.push_back(*conic);
    }
  return out;
}

}  // namespace burmester

#endif
