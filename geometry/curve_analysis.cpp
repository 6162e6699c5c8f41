#include "burmester/geometry/curve_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "burmester/geometry/curve_arcs.hpp"

#ifdef BURMESTER_WITHOUT_GMP

namespace burmester {

CurveTopology analyse_curve(const TernaryForm<Rational>&) {
  CurveTopology out;
  out.reason = "not available: this library was built without GMP";
  return out;
}
CurveTopology analyse_curve(const PlaneCurve&) { return analyse_curve(TernaryForm<Rational>()); }
CurveArcs arcs_of(const TernaryForm<Rational>&) {
  CurveArcs out;
  out.reason = analyse_curve(TernaryForm<Rational>()).reason;
  return out;
}

}  // namespace burmester

#else

#include "burmester/geometry/cgal_polynomial.hpp"  // first: it configures CGAL

#include <CGAL/Algebraic_kernel_d_2.h>

#include "burmester/geometry/curve_factors.hpp"
#include "burmester/geometry/random.hpp"
#include "burmester/geometry/union_find.hpp"

namespace burmester {
namespace {

using namespace exact_curve;
// Over Gmpz: the kernel over CORE numbers has global state and hangs in threads.
using Kernel = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using Bivariate = Kernel::Polynomial_2;  // coefficients in x of the powers of y
using Form = TernaryForm<Integer>;
using Frame = Matrix<Integer, 3, 3>;

/// F(x, y, 1)
Bivariate bivariate(const Form& f) {
  std::vector<CgalPolynomial> rows;
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
  Frame frame, inverse;  ///< plane coordinates = frame * coordinates here; inverse: up to a factor
  Form form;             ///< square-free, in the coordinates here
};

/// frame_of(random, range) makes a frame of integers up to `range` or so.
template <class FrameOf>
Chart generic_chart(const Form& f, FrameOf frame_of) {
  Random random("analyse_curve");
  for (int range = 1;; ++range) {
    Chart out;
    out.frame = frame_of(random, range);
    for (int i = 0; i < 3; ++i)
      out.inverse.row(i) =
          Vector<Integer, 3>(out.frame.col((i + 1) % 3)).cross(Vector<Integer, 3>(out.frame.col((i + 2) % 3)));
    const Form seen = f.substituted(out.frame);
    if (seen(0, f.degree) == 0) continue;
    out.form = homogeneous(CGAL::Polynomial_traits_d<Bivariate>::Make_square_free()(bivariate(seen)));
    if (CGAL::gcd(at_infinity(out.form, 0, 0), at_infinity(out.form, 1, 0)).degree() == 0) return out;
  }
}

Frame unimodular_frame(Random& random, int range) {
  Frame lower = Frame::Identity(), upper = Frame::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j) {
      lower(i, j) = random.below(2 * range + 1) - range;
      upper(j, i) = random.below(2 * range + 1) - range;
    }
  return lower * upper;
}

// ---- Arcs and how they meet ----

SingularPoint singular_point(const Kernel& kernel, const Chart& chart, const Kernel::Algebraic_real_2& p,
                             int half_branches) {
  const auto x = kernel.approximate_absolute_x_2_object()(p, approximation_bits);
  const auto y = kernel.approximate_absolute_y_2_object()(p, approximation_bits);
  const Point2<Rational> here(from_cgal(x.first), from_cgal(y.first), Rational(1));
  return {rounded(Point2<Rational>(chart.frame.cast<Rational>() * here)), half_branches == 0 ? SingularKind::isolated
                                                                          : half_branches == 2
                                                                              ? SingularKind::cusp
                                                                              : SingularKind::crossing};
}

/// Arcs and points as nodes: the arcs of each interval from below, then the points of each event line.
struct ArcGraph {
  explicit ArcGraph(const Kernel::Curve_analysis_2& analysis);
  std::size_t arc(int interval, int k) const { return first[index(interval)] + index(k); }
  std::size_t point(int event, int k) const { return first[index(events + 1 + event)] + index(k); }
  int arcs(int interval) const { return static_cast<int>(first[index(interval + 1)] - first[index(interval)]); }
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  int events;
  std::vector<std::size_t> first{0};  ///< node of each interval and event line, and the number of nodes
  UnionFind joined;                   ///< those that meet, at infinity too
};

ArcGraph::ArcGraph(const Kernel::Curve_analysis_2& analysis)
    : events(analysis.number_of_status_lines_with_event()), joined(0) {
  const auto add_nodes = [this](int n) { first.push_back(first.back() + index(n)); };
  for (int i = 0; i <= events; ++i) add_nodes(analysis.status_line_of_interval(i).number_of_events());
  for (int i = 0; i < events; ++i) add_nodes(analysis.status_line_at_event(i).number_of_events());
  joined = UnionFind(first.back());
  for (int i = 0; i < events; ++i) {
    const auto line = analysis.status_line_at_event(i);
    int left = 0, right = 0;
    for (int j = 0; j < line.number_of_events(); ++j) {
      const auto [from_left, to_right] = line.number_of_incident_branches(j);
      for (int k = 0; k < from_left; ++k) joined.unite(arc(i, left++), point(i, j));
      for (int k = 0; k < to_right; ++k) joined.unite(arc(i + 1, right++), point(i, j));
    }
  }
  for (int k = 0, ends = arcs(0); k < ends; ++k) joined.unite(arc(events, k), arc(0, ends - 1 - k));
}

void count_components(const Kernel& kernel, const Chart& chart, CurveTopology& out) {
  const Bivariate f = bivariate(chart.form), f_x = CGAL::differentiate(f, 0), f_y = CGAL::differentiate(f, 1);
  const CgalPolynomial discriminant = CGAL::resultant(f, f_y);
  const CgalPolynomial multiple = CGAL::gcd(discriminant, CGAL::differentiate(discriminant));
  const auto analysis = kernel.construct_curve_2_object()(f);
  ArcGraph graph(analysis);
  const std::size_t nodes = graph.first.back();
  std::vector<bool> singular(nodes), odd(nodes);
  for (int i = 0; i < graph.events; ++i) {
    const auto line = analysis.status_line_at_event(i);
    const bool may_be_singular = kernel.is_zero_at_1_object()(multiple, line.x());
    for (int j = 0; j < line.number_of_events(); ++j) {
      const auto [from_left, to_right] = line.number_of_incident_branches(j);
      const auto p = line.algebraic_real_2(j);
      const int half_branches = from_left + to_right;
      if (half_branches == 0) ++out.isolated;
      if (half_branches == 2 &&
          !(may_be_singular && kernel.is_zero_at_2_object()(f_y, p) && kernel.is_zero_at_2_object()(f_x, p)))
        continue;
      singular[graph.joined.find(graph.point(i, j))] = true;
      out.singular.push_back(singular_point(kernel, chart, p, half_branches));
    }
  }
  for (int k = 0; k < graph.arcs(0); ++k) odd[graph.joined.find(graph.arc(0, k))].flip();  // met by a line far left
  for (std::size_t node = 0; node < nodes; ++node) {
    if (graph.joined.find(node) != node) continue;
    ++out.components;
    if (!odd[node] && !singular[node]) ++out.ovals;
  }
}

// ---- Arcs in the plane ----

/// Plane coordinates (x : y : z) from those here, (z : v : u - c z), with (x, y) = (a u - b v, b u + a v).
Frame turned_frame(int a, int b, int c) {
  Frame out;
  out << a * c, -b, a, b * c, a, b, 1, 0, 0;
  return out;
}

/// An enclosure that is not zero, about 2^-bits wide. Precondition: the number is not zero.
template <class Approximate>
RationalInterval enclosure(Approximate approximate, bool not_zero) {
  for (int bits = approximation_bits;; bits *= 2) {
    const auto [low, high] = approximate(bits);
    if (!not_zero || low > 0 || high < 0) return {from_cgal(low), from_cgal(high)};
  }
}

/// The chart's intervals and event lines, one after the other as u ascends: x = 1 / (u - c) descends from 0 to the
/// least one, and from the largest one to 0.
class ArcsInPlane {
 public:
  ArcsInPlane(const Form& f, CurveArcs& out)
      : out_(out),
        chart_(generic_chart(f,
                             [&](Random& random, int range) {
                               out.a = 1 + random.below(range + 1), out.b = 1 + random.below(range + 2);
                               return turned_frame(out.a, out.b, c_ = random.below(2 * range + 1) - range);
                             })),
        analysis_(kernel_.construct_curve_2_object()(bivariate(chart_.form))),
        graph_(analysis_),
        number_(graph_.first.back(), -1) {
    while (upper_ < graph_.events && sign_of(upper_) <= 0) negative_ += sign_of(upper_++) < 0;
  }

  void find(bool line_at_infinity) {
    const std::vector<std::size_t> at_infinity = nodes_at_infinity();
    if (line_at_infinity)
      for (const std::size_t node : at_infinity) graph_.joined.unite(node, at_infinity[0]);
    add_interval(negative_, true);
    for (int i = negative_; i-- > 0;) add_line(i, true), add_interval(i, true);
    for (int i = graph_.events; i-- > upper_;) add_line(i, false), add_interval(i, false);
    for (const std::size_t node : at_infinity) component_of(node);
    out_.components += line_at_infinity && at_infinity.empty();
    Frame back;  // (x : y : z) here from (u : v : 1)
    back << 0, 0, 1, 0, 1, 0, 1, 0, -c_;
    out_.form = chart_.form.substituted(back).cast<Rational>();
    Rational largest = 0;
    for (const Rational& c : out_.form.coefficients) largest = std::max(largest, Rational(abs(c)));
    out_.form *= Rational(1 / largest);
  }

 private:
  int sign_of(int event) const {
    return kernel_.sign_at_1_object()(CGAL::shift(CgalPolynomial(1), 1), analysis_.status_line_at_event(event).x());
  }

  /// Points on x = 0, or arcs that cross it.
  std::vector<std::size_t> nodes_at_infinity() const {
    std::vector<std::size_t> out;
    if (negative_ == upper_)
      for (int k = 0; k < graph_.arcs(negative_); ++k) out.push_back(graph_.arc(negative_, k));
    else
      for (int k = 0; k < analysis_.status_line_at_event(negative_).number_of_events(); ++k)
        out.push_back(graph_.point(negative_, k));
    return out;
  }

  int component_of(std::size_t node) {
    int& n = number_[graph_.joined.find(node)];
    if (n < 0) n = out_.components++;
    return n;
  }

  /// For u < c the order of v is the opposite of that of y = v / (u - c).
  void add_interval(int interval, bool upside_down) {
    std::vector<int>& arcs = out_.component.emplace_back();
    const int n = graph_.arcs(interval);
    for (int k = 0; k < n; ++k) arcs.push_back(component_of(graph_.arc(interval, upside_down ? n - 1 - k : k)));
  }

  void add_line(int event, bool upside_down) {
    const auto line = analysis_.status_line_at_event(event);
    const RationalInterval x =
        enclosure([&](int bits) { return kernel_.approximate_absolute_1_object()(line.x(), bits); }, true);
    CriticalLine& out = out_.lines.emplace_back();
    out.u = RationalInterval(c_) + 1 / x;
    int left = 0, right = 0;
    for (int k = 0, n = line.number_of_events(); k < n; ++k) {
      const int j = upside_down ? n - 1 - k : k;
      const auto [to_right, from_left] = line.number_of_incident_branches(j);  // x descends
      ArcEnds& ends = out.points.emplace_back();
      ends.component = component_of(graph_.point(event, j));
      ends.first_left = left, ends.left = from_left, left += from_left;
      ends.first_right = right, ends.right = to_right, right += to_right;
      ends.known_place = from_left != 1 || to_right != 1;
      if (!ends.known_place) continue;
      const auto p = line.algebraic_real_2(j);
      ends.v = enclosure([&](int bits) { return kernel_.approximate_absolute_y_2_object()(p, bits); }, false) / x;
    }
  }

  CurveArcs& out_;
  int c_ = 0;
  const Kernel kernel_;
  const Chart chart_;
  const Kernel::Curve_analysis_2 analysis_;
  ArcGraph graph_;
  std::vector<int> number_;  ///< of the component, at its node of `joined`
  int negative_ = 0;         ///< events with x < 0
  int upper_ = 0;            ///< events with x <= 0
};

// ---- Points at infinity of the plane ----

/// f: the square-free curve in plane coordinates. A singular point found before gets its exact zero.
void find_points_at_infinity(const Form& f, CurveTopology& out) {
  const CgalPolynomial top = at_infinity(f, 0, 0), below = at_infinity(f, 0, 1);
  const CgalPolynomial singular_slopes = CGAL::gcd(CGAL::gcd(top, at_infinity(f, 1, 0)), below);
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
  for (const Root& root : cgal_roots(top.is_zero() ? singular_slopes : top))
    add({Rational(1), rational_value(root), Rational(0)}, RootKernel().is_zero_at_1_object()(singular_slopes, root));
  const bool singular = f(1, f.degree - 1) == 0 && f(0, f.degree - 1) == 0;
  if (f(0, f.degree) == 0 && (singular || !top.is_zero())) add({Rational(0), Rational(1), Rational(0)}, singular);
}

void analyse(const Form& form, CurveTopology& out) {
  const Kernel kernel;
  const Chart chart = generic_chart(form, unimodular_frame);
  out.repeated = chart.form.degree < form.degree;
  count_components(kernel, chart, out);
  const Matrix<Rational, 3, 3> inverse = chart.inverse.cast<Rational>();
  const CurveFactors factors = lines_and_conics(chart.form);
  out.factors_proved = factors.proved;
  for (const LinearForm<Rational>& line : factors.lines)
    out.lines.push_back(rounded(LinearForm<Rational>(inverse.transpose() * line)));
  for (const TernaryForm<Rational>& conic : factors.conics) {
    const TernaryForm<Rational> c = conic.substituted(inverse);
    out.conics.emplace_back(rounded(std::array{c(2, 0), c(0, 2), c(0, 0), c(0, 1), c(1, 0), c(1, 1)}));
  }
  find_points_at_infinity(chart.form.substituted(chart.inverse), out);
}

void find_arcs(const Form& form, CurveArcs& out) {
  Form finite = form;
  while (finite.degree > 0 && at_infinity(finite, 0, 0).is_zero()) {  // z divides it
    Form quotient(finite.degree - 1);
    for (int j = 0; j <= quotient.degree; ++j)
      for (int i = 0; i + j <= quotient.degree; ++i) quotient(i, j) = finite(i, j);
    finite = quotient;
  }
  const bool line_at_infinity = finite.degree < form.degree;
  if (finite.degree == 0) {
    out.component.emplace_back();
    out.components = 1;
    out.form = finite.cast<Rational>();
  } else {
    ArcsInPlane(finite, out).find(line_at_infinity);
  }
}

/// Runs `analyse` on the curve with integer coefficients; `out` gets the rung or the reason.
template <class Out, class Analyse>
Out checked(const TernaryForm<Rational>& curve, Analyse analyse) {
  Out out;
  const bool zero =
      std::all_of(curve.coefficients.begin(), curve.coefficients.end(), [](const Rational& c) { return c == 0; });
  if (zero || curve.degree == 0) {
    out.reason = "not a curve: the form is zero or constant";
    return out;
  }
  try {
    analyse(integer_form(curve), out);
    out.rung = Rung::exact;
  } catch (const std::exception& e) {
    out.reason = e.what();
  } catch (...) {  // some exceptions of CGAL's curve analysis have no base class
    out.reason = "CGAL's curve analysis gave up";
  }
  return out;
}

}  // namespace

CurveTopology analyse_curve(const TernaryForm<Rational>& curve) { return checked<CurveTopology>(curve, analyse); }

CurveArcs arcs_of(const TernaryForm<Rational>& curve) { return checked<CurveArcs>(curve, find_arcs); }

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
