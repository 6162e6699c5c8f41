#include "burmester/spherical/exact_axes.hpp"

#include <algorithm>
#include <functional>

namespace burmester::spherical {
namespace {

using Box = Vector<RationalInterval, 3>;
using P = Polynomial<Rational>;

/// C as polynomials in t = u1 / u0.
using MinorPolynomials = std::array<std::array<P, 4>, 4>;

/// The largest coordinate of the middle: doubles may be too short for it.
Rational size_of(const Box& a) {
  Rational size(0);
  for (const RationalInterval& x : a) size = std::max(size, Rational(abs(Rational(x.low() + x.high())) / 2));
  return size;
}

bool is_narrow(const Box& a) {
  static const Rational narrow(0x1p-60);
  Rational width(0);
  for (const RationalInterval& x : a) width = std::max(width, Rational(x.high() - x.low()));
  return width < narrow * size_of(a);
}

/// An interval around x whose ends are multiples of 2^-bits: short numbers again.
RationalInterval rounded(const RationalInterval& x, int bits) {
  const Integer unit = Integer(1) << bits;
  const auto truncated = [&](const Rational& end) -> Integer { return (numerator(end) << bits) / denominator(end); };
  return {Rational(truncated(x.low()) - 1, unit), Rational(truncated(x.high()) + 1, unit)};
}

/// The same axis of size 1, with short numbers.
Box unit(const Box& a, int bits) {
  const Rational size = size_of(a);
  if (size == 0) return a;
  const auto scaled = [&](const RationalInterval& x) {
    return rounded(RationalInterval(x.low() / size, x.high() / size), bits);
  };
  return {scaled(a[0]), scaled(a[1]), scaled(a[2])};
}

/// (1 : s) of the kernel (1, s, s^2, s^3) of C, which is unique where some 3 x 3 minor is not zero.
std::optional<std::array<RationalInterval, 2>> kernel(const MinorPolynomials& forms, const RationalInterval& t,
                                                      int bits) {
  std::array<std::array<RationalInterval, 4>, 4> c;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k) c[j][k] = rounded(forms[j][k](t), bits);
  std::optional<std::array<RationalInterval, 2>> best;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const auto column = [&](std::size_t k) -> Box {
      return {c[(left_out + 1) % 4][k], c[(left_out + 2) % 4][k], c[(left_out + 3) % 4][k]};
    };
    const Box last = column(2).cross(column(3));
    const RationalInterval one = column(1).dot(last);
    if (contains_zero(one)) continue;
    if (!best || std::abs(approximate(one)) > std::abs(approximate((*best)[0]))) best = {one, -column(0).dot(last)};
  }
  return best;
}

/// b' with a^T N_j b' = 0 for all j: orthogonal to two of the rows.
Box kernel(const Bilinear<Rational>& n, const Box& a) {
  std::array<Box, 4> row;
  for (std::size_t j = 0; j < 4; ++j)
    for (int k = 0; k < 3; ++k)
      row[j][k] = a.dot(Box(RationalInterval(n[j](0, k)), RationalInterval(n[j](1, k)), RationalInterval(n[j](2, k))));
  Box best = row[0].cross(row[1]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (const Box b = row[i].cross(row[j]); size_of(b) > size_of(best)) best = b;
  return best;
}

/// The moving axis given t within 2^-bits; nothing where that is too wide.
using MovingAxisAt = std::function<std::optional<Box>(const RationalInterval& t, int bits)>;

std::optional<EnclosedAxes> narrowed(RealRoot& t, const Bilinear<Rational>& n, const MovingAxisAt& moving) {
  for (int bits = 128; bits <= 1024; bits *= 2) {
    t.refine(Rational(1, Integer(1) << bits));
    const auto a = moving(rounded(t.bounds(), bits), bits);
    if (!a) continue;
    EnclosedAxes out{unit(*a, 2 * bits), {}, t.multiplicity()};
    out.fixed = unit(kernel(n, out.moving), 2 * bits);
    if (is_narrow(out.moving) && is_narrow(out.fixed)) return out;
  }
  return std::nullopt;
}

/// What lies over t where C has rank two, its rows spanned by some r and s r (docs/certificates.md): r has no s^3.
AxesOnLine axes_behind(const MinorPolynomials& c, RealRoot& t) {
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const auto column = [&](std::size_t k) -> std::array<P, 3> {
      return {c[(left_out + 1) % 4][k], c[(left_out + 2) % 4][k], c[(left_out + 3) % 4][k]};
    };
    if (!vanishes(dot(column(1), cross(column(2), column(3))), t)) return {};  // of rank three
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto without_cube = [&](std::size_t k) -> P { return c[i][k] * c[j][3] - c[j][k] * c[i][3]; };
      const std::array<P, 3> r{without_cube(0), without_cube(1), without_cube(2)};
      if (!vanishes(r[2], t)) return roots_on_line(r, t);
    }
  return {};
}

/// Nothing where the boxes do not become narrow: two solutions lie behind each other in this chart.
std::optional<EnclosedAxes> axes_at(RealRoot& t, const Chart& chart, const MinorPolynomials& forms,
                                    const Bilinear<Rational>& n) {
  return narrowed(t, n, [&](const RationalInterval& at, int bits) -> std::optional<Box> {
    const auto k = kernel(forms, at, bits);
    if (!k) return std::nullopt;
    const auto& [one, s] = *k;
    return from_chart<RationalInterval>(chart, {one, one * at, s});
  });
}

/// Nothing where the chart hides something: a root at infinity, a solution at its centre, two solutions behind each
/// other.
std::optional<std::vector<EnclosedAxes>> axes_in(const Chart& chart, const Bilinear<Rational>& n) {
  const MinorForms<Rational> forms = minor_forms(in_chart(n, chart));
  const Polynomial<Rational> f(sextic(forms).coefficients());
  if (f.degree() < 6) return std::nullopt;
  MinorPolynomials polynomials;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k) polynomials[j][k] = Polynomial<Rational>(forms[j][k].coefficients());
  std::vector<EnclosedAxes> out;
  for (RealRoot& root : real_roots_exactly(f)) {
    auto axes = axes_at(root, chart, polynomials, n);
    if (!axes) {
      const AxesOnLine behind = axes_behind(polynomials, root);
      if (behind.axes == AxesOnLine::none) continue;
      if (behind.axes == AxesOnLine::one) axes = enclosed_axes(root, chart, behind.place, n);
    }
    if (!axes) return std::nullopt;
    out.push_back(*axes);
  }
  return out;
}

}  // namespace

AxesOnLine roots_on_line(const std::array<P, 3>& r, RealRoot& t) {
  const int discriminant = sign_at(r[1] * r[1] - r[0] * r[2] * Rational(4), t);
  if (discriminant != 0) return {discriminant < 0 ? AxesOnLine::none : AxesOnLine::hidden, {}};
  return {AxesOnLine::one, {r[2] * Rational(2), -r[1]}};
}

std::optional<EnclosedAxes> enclosed_axes(RealRoot& t, const Chart& chart, const std::array<P, 2>& place,
                                          const Bilinear<Rational>& equations) {
  return narrowed(t, equations, [&](const RationalInterval& at, int) {
    const RationalInterval one = place[0](at);
    return std::optional(from_chart<RationalInterval>(chart, {one, one * at, place[1](at)}));
  });
}

std::optional<std::vector<EnclosedAxes>> exact_axes(const Bilinear<Rational>& equations) {
  for (const Chart& chart : charts)
    if (auto axes = axes_in(chart, equations)) return axes;
  return std::nullopt;
}

}  // namespace burmester::spherical
