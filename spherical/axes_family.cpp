#include "burmester/spherical/axes_family.hpp"

#include <algorithm>
#include <utility>

#include "burmester/geometry/curve_topology.hpp"
#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/real_roots.hpp"

namespace burmester::spherical {
namespace {

using Form = TernaryForm<Rational>;
using Forms = std::array<Form, 4>;
using P = Polynomial<Rational>;
using Row = std::vector<Rational>;

constexpr int every_axis = 4;

bool is_zero(const Form& f) {
  return std::all_of(f.coefficients.begin(), f.coefficients.end(), [](const Rational& c) { return c == 0; });
}

Form monomial(int degree, int k) {
  Form out(degree);
  out.coefficients[static_cast<std::size_t>(k)] = 1;
  return out;
}

/// The vector x with sum x_c columns[c] = 0, where it is unique; nothing where there is none, or more.
std::optional<Row> dependence(std::vector<Row> columns) {
  const std::size_t n = columns.size();
  std::vector<Row> how(n, Row(n));  // column c now = sum how[c][k] times column k as given
  for (std::size_t c = 0; c < n; ++c) how[c][c] = 1;
  std::optional<Row> out;
  for (std::size_t c = 0; c < n; ++c) {
    const auto pivot = std::find_if(columns[c].begin(), columns[c].end(), [](const Rational& x) { return x != 0; });
    if (pivot == columns[c].end()) {
      if (out) return std::nullopt;
      out = how[c];
      continue;
    }
    const auto r = static_cast<std::size_t>(pivot - columns[c].begin());
    for (std::size_t d = c + 1; d < n; ++d) {
      if (columns[d][r] == 0) continue;
      const Rational factor = columns[d][r] / columns[c][r];
      for (std::size_t k = 0; k < columns[d].size(); ++k) columns[d][k] -= factor * columns[c][k];
      for (std::size_t k = 0; k <= c; ++k) how[d][k] -= factor * how[c][k];
    }
  }
  return out;
}

void append(Row& column, const Form& f) {
  column.insert(column.end(), f.coefficients.begin(), f.coefficients.begin() + f.size());
}

/// h_j of degree k with m_i h_j = m_j h_i. Precondition: m[0] not zero.
std::optional<Forms> proportional_forms(const Forms& m, int k) {
  const int size = Form(k).size();
  std::vector<Row> columns;
  for (std::size_t j = 0; j < 4; ++j)
    for (int c = 0; c < size; ++c) {
      const Form x = monomial(k, c);
      Row& column = columns.emplace_back();
      for (std::size_t i = 1; i < 4; ++i)
        append(column, j == 0 ? m[i] * x * Rational(-1) : i == j ? m[0] * x : Form(3 + k));
    }
  const auto x = dependence(std::move(columns));
  if (!x) return std::nullopt;
  Forms h;
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = Form(k);
    std::copy_n(x->begin() + static_cast<std::ptrdiff_t>(j) * size, size, h[j].coefficients.begin());
  }
  return h;
}

/// f / g. Precondition: g divides f, neither is zero.
Form quotient(const Form& f, const Form& g) {
  Form out(f.degree - g.degree);
  std::vector<Row> columns;
  for (int c = 0; c < out.size(); ++c) append(columns.emplace_back(), g * monomial(out.degree, c));
  append(columns.emplace_back(), f);
  const Row x = *dependence(std::move(columns));
  for (int c = 0; c < out.size(); ++c)
    out.coefficients[static_cast<std::size_t>(c)] = -x[static_cast<std::size_t>(c)] / x.back();
  return out;
}

/// The minors of M, G times h, in one chart.
struct Minors {
  Form common;  ///< G; of degree 0 where the minors have no common factor
  Forms rest;   ///< h
};

/// Nothing where all are zero: every axis has a partner.
std::optional<Minors> minors_of(const Bilinear<Rational>& n) {
  const std::array<Cubic<Rational>, 4> cubics = minors(n);
  Forms m;
  for (std::size_t j = 0; j < 4; ++j) m[j] = Form(cubics[j]);
  const auto first = std::find_if_not(m.begin(), m.end(), is_zero);
  if (first == m.end()) return std::nullopt;
  std::swap(m[0], *first);
  for (int k = 0; k < 3; ++k)
    if (const auto h = proportional_forms(m, k)) return Minors{quotient(m[0], (*h)[0]), *h};
  return Minors{Form(0), m};
}

/// Degree of the cone that its real points fill: without single lines of it, and a multiple part once.
int real_degree(const Form& g) {
  const CurveTopology found = topology_of(g);
  if (found.rung == Rung::none) return 0;
  const int lines = static_cast<int>(found.lines.size());
  if (g.degree == 3 && lines == 0) return 3;
  const bool crossing = std::any_of(found.singular.begin(), found.singular.end(),
                                    [](const SingularPoint& p) { return p.kind == SingularKind::crossing; });
  return lines + (!found.conics.empty() && (found.ovals > 0 || crossing) ? 2 : 0);
}

// ---- The common points of the h ----

/// f(x, y, z)
P composed(const Form& f, const std::array<P, 3>& at) {
  P out;
  for (int j = 0; j <= f.degree; ++j)
    for (int i = 0; i + j <= f.degree; ++i) {
      P term({f(i, j)});
      for (int k = 0; k < f.degree; ++k) term = term * at[k < i ? 0 : k < i + j ? 1 : 2];
      out = out + term;
    }
  return out;
}

/// The coefficients of 1, z, .. in h(1, t, z).
std::vector<P> seen_from_centre(const Form& h) {
  std::vector<P> out;
  for (int c = 0; c <= h.degree; ++c) {
    Row coefficients;
    for (int j = 0; j + c <= h.degree; ++j) coefficients.push_back(h(h.degree - c - j, j));
    out.emplace_back(std::move(coefficients));
  }
  return out;
}

using Rows = std::array<std::vector<P>, 4>;

P determinant(const Rows& h, std::size_t i, std::size_t j) { return h[i][0] * h[j][1] - h[i][1] * h[j][0]; }

/// What vanishes where the line t holds a common point.
std::vector<P> conditions_on_lines(const Rows& h) {
  std::vector<P> out;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (h[0].size() == 2) out.push_back(determinant(h, i, j));
      for (std::size_t k = 0; k < j && h[0].size() == 3; ++k) out.push_back(dot(h[k], cross(h[i], h[j])));
    }
  return out;
}

/// The rows (h0, h1) vanish on (1, z).
AxesOnLine on_line_of_linear_forms(const Rows& h) {
  for (const auto& row : h)
    if (!row[1].is_zero()) return {AxesOnLine::one, {row[1], -row[0]}};
  return {};
}

/// The rows (h0, h1, h2) vanish on (1, z, z^2). Of rank two they have one kernel, of rank one they are one quadratic.
AxesOnLine on_line_of_conics(const Rows& h, RealRoot& t) {
  const auto row = std::find_if(h.begin(), h.end(), [](const auto& r) { return !r[2].is_zero(); });
  if (row == h.end()) return {};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto k = cross(h[i], h[j]);
      if (std::all_of(k.begin(), k.end(), [&](const P& x) { return vanishes(x, t); })) continue;
      if (vanishes(k[0], t) || !vanishes(k[1] * k[1] - k[0] * k[2], t)) return {AxesOnLine::none, {}};
      return {AxesOnLine::one, {k[0], k[1]}};
    }
  return roots_on_line({(*row)[0], (*row)[1], (*row)[2]}, t);
}

/// Whether M(a) has rank one or less: the sum of squares of its 2 x 2 minors.
P rank_one(const Bilinear<Rational>& n, const std::array<P, 3>& a) {
  std::array<std::vector<P>, 4> rows;
  for (std::size_t j = 0; j < 4; ++j)
    for (int c = 0; c < 3; ++c) rows[j].push_back(a[0] * n[j](0, c) + a[1] * n[j](1, c) + a[2] * n[j](2, c));
  P out;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const P& x : cross(rows[i], rows[j])) out = out + x * x;
  return out;
}

/// Nothing where the chart hides something.
std::optional<std::vector<EnclosedAxes>> isolated_in(const Chart& chart, const Bilinear<Rational>& equations) {
  const Bilinear<Rational> n = in_chart(equations, chart);
  const Minors minors = *minors_of(n);
  const int degree = minors.rest[0].degree;
  if (degree == 0) return std::vector<EnclosedAxes>();
  Rows h;
  for (std::size_t j = 0; j < 4; ++j) h[j] = seen_from_centre(minors.rest[j]);
  IntegerPolynomial lines;
  bool at_infinity = true;
  for (const P& condition : conditions_on_lines(h)) {
    if (condition.is_zero()) continue;
    at_infinity = at_infinity && condition.degree() < degree * (degree + 1) / 2;
    const IntegerPolynomial f = integer_multiple(condition);
    lines = lines.is_zero() ? f : common_divisor(lines, f);
  }
  if (at_infinity) return std::nullopt;
  std::vector<EnclosedAxes> out;
  if (lines.degree() == 0) return out;
  P on_lines(Row(lines.coefficients().begin(), lines.coefficients().end()));
  for (RealRoot& t : real_roots_exactly(on_lines)) {
    const AxesOnLine found = degree == 1 ? on_line_of_linear_forms(h) : on_line_of_conics(h, t);
    if (found.axes == AxesOnLine::hidden) return std::nullopt;
    if (found.axes == AxesOnLine::none) continue;
    const auto& [one, z] = found.place;
    const std::array<P, 3> a{one, one * P({Rational(0), Rational(1)}), z};
    if (vanishes(composed(minors.common, a), t) || vanishes(rank_one(n, a), t)) continue;  // in a family
    const auto axes = enclosed_axes(t, chart, found.place, equations);
    if (!axes) return std::nullopt;
    out.push_back({axes->moving, axes->fixed, 1});
  }
  return out;
}

std::optional<std::vector<EnclosedAxes>> isolated(const Bilinear<Rational>& n) {
  for (const Chart& chart : charts)
    if (auto out = isolated_in(chart, n)) return out;
  return std::nullopt;
}

/// Degree of the real cone of axes that have a partner.
int degree_of_cone(const Bilinear<Rational>& n) {
  const auto minors = minors_of(n);
  return !minors ? every_axis : minors->common.degree == 0 ? 0 : real_degree(minors->common);
}

}  // namespace

std::optional<AxesFamily> axes_family(const Bilinear<Rational>& n) {
  Bilinear<Rational> back;
  for (std::size_t j = 0; j < 4; ++j) back[j] = n[j].transpose();
  AxesFamily out{degree_of_cone(n), degree_of_cone(back), {}};
  const int largest = std::max(out.moving, out.fixed);
  if (largest == 0) return std::nullopt;
  if (largest == every_axis) {
    out.isolated.emplace();
  } else if (out.moving >= out.fixed) {
    out.isolated = isolated(n);
  } else if ((out.isolated = isolated(back))) {
    for (EnclosedAxes& axes : *out.isolated) std::swap(axes.moving, axes.fixed);
  }
  return out;
}

}  // namespace burmester::spherical
