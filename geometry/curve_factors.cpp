#include "burmester/geometry/curve_factors.hpp"

#ifdef BURMESTER_WITHOUT_GMP

namespace burmester {

CurveFactors lines_and_conics(const TernaryForm<Integer>&) { return {}; }

}  // namespace burmester

#else

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <complex>
#include <optional>

#include "burmester/geometry/cgal_polynomial.hpp"

namespace burmester {
namespace {

using namespace exact_curve;
using Form = TernaryForm<Integer>;

/// Roots of it are the slopes of the lines, real and complex.
Polynomial line_slopes(const Form& curve, const Polynomial& top, const Polynomial& slope,
                       const Polynomial& below) {
  Polynomial out = top;
  for (int k = 2; k <= curve.degree && out.degree() > 0; ++k) {
    Polynomial vanishing(0);  // at z^k of F on (1, m, 0) + z (0, -below, slope)
    for (int a = 0; a <= k; ++a)
      vanishing += at_infinity(curve, a, k - a) * CGAL::ipower(-below, a) * CGAL::ipower(slope, k - a);
    out = CGAL::gcd(out, vanishing);
  }
  return out;
}

using Float = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<120, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Complex = std::complex<Float>;

Rational exactly(const Float& x) {
  Rational out;
  mpfr_get_q(out.backend().data(), x.backend().data());
  return out;
}

Complex value(const Polynomial& p, const Complex& x) {
  Complex out;
  for (int i = p.degree(); i >= 0; --i) out = out * x + Complex(Float(from_cgal(p[i])));
  return out;
}

/// Approximations of all roots of a square-free polynomial (K. Weierstrass' iteration). They prove nothing.
std::vector<Complex> complex_roots(const Polynomial& p) {
  std::vector<Complex> roots;
  const Complex ratio(Float(0.4), Float(0.9));
  for (int i = 0; i < p.degree(); ++i) roots.push_back(i == 0 ? ratio : roots.back() * ratio);
  for (int step = 0; step < 200; ++step) {
    double largest = 0;
    for (Complex& root : roots) {
      Complex others(Float(from_cgal(p.lcoeff())));
      for (const Complex& other : roots)
        if (&other != &root) others *= root - other;
      const Complex change = value(p, root) / others;
      root -= change;
      largest = std::max(largest, static_cast<double>(norm(change)));
    }
    if (largest < 0x1p-600) break;
  }
  return roots;
}

/// An asymptote y = m x + b + e / x + ..
struct Asymptote {
  Complex m, b, e;
};
/// (y - m x - b z) (y - m' x - b' z) + c z^2, real parts: the conic with two asymptotes of the curve and its next term.
TernaryForm<Rational> conic_between(const Asymptote& s, const Asymptote& t) {
  const auto real = [](const Complex& x) { return exactly(x.real()); };
  TernaryForm<Rational> out(2);
  out(0, 2) = 1, out(1, 1) = -real(s.m + t.m), out(2, 0) = real(s.m * t.m);
  out(0, 1) = -real(s.b + t.b), out(1, 0) = real(s.m * t.b + s.b * t.m);
  out(0, 0) = real(s.b * t.b - s.e * (s.m - t.m));
  return out;
}

std::vector<Asymptote> asymptotes(const Form& f, const Polynomial& slopes) {
  std::vector<Asymptote> out;
  const Polynomial f_s = at_infinity(f, 1, 0), f_z = at_infinity(f, 0, 1), f_ss = at_infinity(f, 2, 0),
                   f_sz = at_infinity(f, 1, 1), f_zz = at_infinity(f, 0, 2);
  for (const Complex& m : complex_roots(slopes)) {
    const Complex slope = value(f_s, m), b = -value(f_z, m) / slope;
    out.push_back({m, b, -((value(f_ss, m) * b + value(f_sz, m)) * b + value(f_zz, m)) / slope});
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

/// Each coefficient replaced by the nearest multiple of 1 / unit.
TernaryForm<Rational> nearest_multiple(TernaryForm<Rational> f, const Integer& unit) {
  for (Rational& c : f.coefficients) c = Rational(nearest_integer(c * unit), unit);
  return f;
}

}  // namespace

CurveFactors lines_and_conics(const Form& curve) {
  CurveFactors out;
  const Polynomial top = at_infinity(curve, 0, 0), slope = at_infinity(curve, 1, 0),
                   below = at_infinity(curve, 0, 1);
  const Polynomial slopes = line_slopes(curve, top, slope, below);
  const std::vector<Root> real_slopes = real_roots(slopes);
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
  std::vector<Asymptote> lines = asymptotes(curve, slopes);
  std::sort(lines.begin(), lines.end(), [](const auto& s, const auto& t) { return s.m.imag() > t.m.imag(); });
  lines.resize((lines.size() - real_slopes.size()) / 2);
  for (const Asymptote& line : lines) {
    const TernaryForm<Rational> pair = conic_between(line, {conj(line.m), conj(line.b), Complex()}),
                                near = nearest_multiple(pair, unit);
    out.conics.push_back(quotient(rest, near) ? near : pair);
  }
  if (rest.degree < 4) return out;
  const std::vector<Asymptote> curved =
      asymptotes(curve, CGAL::integral_division_up_to_constant_factor(top, slopes));
  for (std::size_t i = 0; i < curved.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const TernaryForm<Rational> conic = nearest_multiple(conic_between(curved[i], curved[j]), unit);
      const auto divided = quotient(rest, conic);
      if (!divided) continue;
      rest = *divided;
      out.conics.push_back(conic);
    }
  return out;
}

}  // namespace burmester

#endif
