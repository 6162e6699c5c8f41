#include "burmester/geometry/curve_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#ifdef BURMESTER_WITHOUT_GMP

namespace burmester {

CurveTopology analyse_curve(const TernaryForm<Rational>&) {
  CurveTopology out;
  out.reason = "not available: this library was built without GMP";
  return out;
}
CurveTopology analyse_curve(const PlaneCurve&) { return analyse_curve(TernaryForm<Rational>()); }

}  // namespace burmester

#else

#include "burmester/geometry/cgal_polynomial.hpp"  // first: it configures CGAL

#include <CGAL/Algebraic_kernel_d_2.h>

#include <numeric>

#include "burmester/geometry/curve_factors.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using namespace exact_curve;
// Over Gmpz: the kernel over CORE numbers has global state and hangs in threads.
using Kernel = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using Bivariate = Kernel::Polynomial_2;  // coefficients in x of the powers of y
using Form = TernaryForm<Integer>;
using Frame = Matrix<Integer, 3, 3>;

/// The multiple whose coefficients are integers without a common factor. Precondition: not zero.
Form integer_form(const TernaryForm<Rational>& f) {
  Integer denominators = 1, content = 0;
  for (const Rational& c : f.coefficients) denominators = lcm(denominators, Integer(denominator(c)));
  Form out(f.degree);
  for (std::size_t k = 0; k < out.coefficients.size(); ++k) {
    out.coefficients[k] = numerator(f.coefficients[k]) * (denominators / denominator(f.coefficients[k]));
    content = gcd(content, out.coefficients[k]);
  }
  for (Integer& c : out.coefficients) c /= content;
  return out;
}

/// F(x, y, 1)
Bivariate bivariate(const Form& f) {
  std::vector<Polynomial> rows;
  for (int j = 0; j <= f.degree; ++j) {
    std::vector<CGAL::Gmpz> row;
    for (int i = 0; i + j <= f.degree; ++i) row.push_back(to_cgal(f(i, j)));
    rows.emplace_back(row.begin(), row.end());
  }
  return Bivariate(rows.begin(), rows.end());
}

/// Inverse of bivariate(); the degree is the one in y.
Form homogeneous(const Bivariate& f) {
  Form out(f.degree());
  for (int j = 0; j <= f.degree(); ++j)
    for (int i = 0; i <= f[j].degree(); ++i) out(i, j) = from_cgal(f[j][i]);
  return out;
}

/// Divided by the entry of largest magnitude (its magnitude), rounded; zero stays zero.
template <std::size_t n>
std::array<double, n> rounded(const std::array<Rational, n>& x) {
  Rational largest = 0;
  for (const Rational& c : x) largest = std::max(largest, Rational(abs(c)));
  std::array<double, n> out{};
  if (largest != 0)
    for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<double>(Rational(x[i] / largest));
  return out;
}
Vector<double, 3> rounded(const Vector<Rational, 3>& x) {
  const auto r = rounded(std::array<Rational, 3>{x[0], x[1], x[2]});
  return {r[0], r[1], r[2]};
}

// ---- Generic coordinates ----

/// Coordinates in which the square-free curve has as many complex points at infinity as its degree, none of
/// them (0:1:0).
struct Chart {
  Frame frame, inverse;  ///< plane coordinates = frame * coordinates here
  Form form;             ///< square-free, in the coordinates here
};

Chart generic_chart(const Form& f) {
  Random random("analyse_curve");
  for (int range = 1;; ++range) {
    Frame lower = Frame::Identity(), upper = Frame::Identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) {
        lower(i, j) = random.below(2 * range + 1) - range;
        upper(j, i) = random.below(2 * range + 1) - range;
      }
    Chart out;
    out.frame = lower * upper;
    for (int i = 0; i < 3; ++i)
      out.inverse.row(i) = Vector<Integer, 3>(out.frame.col((i + 1) % 3))
                               .cross(Vector<Integer, 3>(out.frame.col((i + 2) % 3)));
    const Form seen = f.substituted(out.frame);
    if (seen(0, f.degree) == 0) continue;
    out.form = homogeneous(CGAL::Polynomial_traits_d<Bivariate>::Make_square_free()(bivariate(seen)));
    if (CGAL::gcd(at_infinity(out.form, 0, 0), at_infinity(out.form, 1, 0)).degree() == 0) return out;
  }
}

// ---- Arcs and how they meet ----

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

SingularPoint singular_point(const Kernel& kernel, const Chart& chart, const Kernel::Algebraic_real_2& p,
                             int half_branches) {
  const auto x = kernel.approximate_absolute_x_2_object()(p, approximation_bits);
  const auto y = kernel.approximate_absolute_y_2_object()(p, approximation_bits);
  const Point2<Rational> here(from_cgal(x.first), from_cgal(y.first), Rational(1));
  return {rounded(Point2<Rational>(chart.frame.cast<Rational>() * here)),
          half_branches == 0   ? SingularKind::isolated
          : half_branches == 2 ? SingularKind::cusp
                               : SingularKind::crossing};
}

void count_components(const Kernel& kernel, const Chart& chart, CurveTopology& out) {
  const Bivariate f = bivariate(chart.form), f_x = CGAL::differentiate(f, 0), f_y = CGAL::differentiate(f, 1);
  const Polynomial discriminant = CGAL::resultant(f, f_y);
  const Polynomial multiple = CGAL::gcd(discriminant, CGAL::differentiate(discriminant));
  const auto analysis = kernel.construct_curve_2_object()(f);
  const int events = analysis.number_of_status_lines_with_event();

  // Nodes: the arcs of each interval from below, then the points of each event line.
  std::vector<std::size_t> first{0};
  const auto add_nodes = [&first](int n) { first.push_back(first.back() + static_cast<std::size_t>(n)); };
  for (int i = 0; i <= events; ++i) add_nodes(analysis.status_line_of_interval(i).number_of_events());
  std::size_t point = first.back(), left = 0, right = first[1];
  for (int i = 0; i < events; ++i) add_nodes(analysis.status_line_at_event(i).number_of_events());
  const std::size_t nodes = first.back(), ends = first[1], last = first[static_cast<std::size_t>(events)];

  UnionFind joined(nodes);
  std::vector<bool> singular(nodes), odd(nodes);
  for (int i = 0; i < events; ++i) {
    const auto line = analysis.status_line_at_event(i);
    const bool may_be_singular = kernel.is_zero_at_1_object()(multiple, line.x());
    for (int j = 0; j < line.number_of_events(); ++j, ++point) {
      const auto [from_left, to_right] = line.number_of_incident_branches(j);
      for (int k = 0; k < from_left; ++k) joined.unite(left++, point);
      for (int k = 0; k < to_right; ++k) joined.unite(right++, point);
      const auto p = line.algebraic_real_2(j);
      const int half_branches = from_left + to_right;
      singular[point] = half_branches != 2 || (may_be_singular && kernel.is_zero_at_2_object()(f_y, p) &&
                                               kernel.is_zero_at_2_object()(f_x, p));
      if (half_branches == 0) ++out.isolated;
      if (singular[point]) out.singular.push_back(singular_point(kernel, chart, p, half_branches));
    }
  }
  for (std::size_t i = 0; i < ends; ++i) joined.unite(last + i, ends - 1 - i);

  for (std::size_t i = 0; i < ends; ++i) odd[joined.find(i)].flip();  // how a vertical line far left meets it
  for (std::size_t node = 0; node < nodes; ++node)
    if (singular[node]) singular[joined.find(node)] = true;
  for (std::size_t node = 0; node < nodes; ++node) {
    if (joined.find(node) != node) continue;
    ++out.components;
    if (!odd[node] && !singular[node]) ++out.ovals;
  }
}

// ---- Points at infinity of the plane ----

/// f: the square-free curve in plane coordinates. A singular point found before gets its exact zero.
void find_points_at_infinity(const Form& f, CurveTopology& out) {
  const Polynomial top = at_infinity(f, 0, 0), below = at_infinity(f, 0, 1);
  const Polynomial singular_slopes = CGAL::gcd(CGAL::gcd(top, at_infinity(f, 1, 0)), below);
  const TernaryForm<Rational> over_rationals = f.cast<Rational>();
  const auto add = [&](const Point2<Rational>& p, bool singular) {
    PointAtInfinity point{rounded(p), LinearForm<double>::Zero()};
    if (!singular) point.tangent = rounded(over_rationals.gradient(p));
    const auto distance = [&point](const SingularPoint& s) { return point.at.cross(s.at).norm(); };
    if (singular)
      std::min_element(out.singular.begin(), out.singular.end(), [&](const auto& s, const auto& t) {
        return distance(s) < distance(t);
      })->at = point.at;
    if (!top.is_zero()) out.at_infinity.push_back(point);
  };
  for (const Root& root : real_roots(top.is_zero() ? singular_slopes : top))
    add({Rational(1), rational_value(root), Rational(0)},
        RootKernel().is_zero_at_1_object()(singular_slopes, root));
  const bool singular = f(1, f.degree - 1) == 0 && f(0, f.degree - 1) == 0;
  if (f(0, f.degree) == 0 && (singular || !top.is_zero()))
    add({Rational(0), Rational(1), Rational(0)}, singular);
}

void analyse(const Form& form, CurveTopology& out) {
  const Kernel kernel;
  const Chart chart = generic_chart(form);
  out.repeated = chart.form.degree < form.degree;
  count_components(kernel, chart, out);
  const Matrix<Rational, 3, 3> inverse = chart.inverse.cast<Rational>();
  const CurveFactors factors = lines_and_conics(chart.form);
  for (const LinearForm<Rational>& line : factors.lines)
    out.lines.push_back(rounded(LinearForm<Rational>(inverse.transpose() * line)));
  for (const TernaryForm<Rational>& conic : factors.conics) {
    const TernaryForm<Rational> c = conic.substituted(inverse);
    out.conics.emplace_back(rounded(std::array{c(2, 0), c(0, 2), c(0, 0), c(0, 1), c(1, 0), c(1, 1)}));
  }
  find_points_at_infinity(chart.form.substituted(chart.inverse), out);
  out.rung = Rung::exact;
}

}  // namespace

CurveTopology analyse_curve(const TernaryForm<Rational>& curve) {
  CurveTopology out;
  const bool zero = std::all_of(curve.coefficients.begin(), curve.coefficients.end(),
                                [](const Rational& c) { return c == 0; });
  if (zero || curve.degree == 0) {
    out.reason = "not a curve: the form is zero or constant";
    return out;
  }
  try {
    analyse(integer_form(curve), out);
  } catch (const std::exception& e) {
    out.reason = e.what();
  } catch (...) {  // some exceptions of CGAL's curve analysis have no base class
    out.reason = "CGAL's curve analysis gave up";
  }
  return out;
}

CurveTopology analyse_curve(const PlaneCurve& curve) {
  const auto finite = [](double c) { return std::isfinite(c); };
  if (std::all_of(curve.coefficients.begin(), curve.coefficients.end(), finite))
    return analyse_curve(curve.cast<Rational>());
  CurveTopology out;
  out.reason = "not a curve: a coefficient is not finite";
  return out;
}

}  // namespace burmester
#endif
