#include "burmester/geometry/cubic_branches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "burmester/geometry/cubic_scene.hpp"
#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/jet.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester {
namespace {

using detail::CubicScene, detail::positive_root;

Interval positive_root(const Interval& x) {
  const double high = std::isnan(x.sup()) ? std::numeric_limits<double>::infinity() : std::max(0.0, x.sup());
  return CGAL::sqrt(Interval(std::max(0.0, x.inf()), high));
}

template <class X>
double size(const X& x) {
  return std::abs(approximate(x));
}

Jet<Interval, 1> positive_root(const Jet<Interval, 1>& x) {
  const Interval root = positive_root(x.value);
  return {root, x.slope / (2 * root)};
}

BranchFrame<Interval> frame_of(const CubicScene& scene) { return {scene.pencil.base, scene.pencil.i, scene.pencil.j}; }

/// p P + q (along[0] Qi + along[1] Qj), in the frame.
template <class X>
Point2<X> sum(const X& p, const Point1<X>& along, const X& q) {
  return {p, X(q * along[0]), X(q * along[1])};
}

CubicBranch branch(int component, std::vector<CubicBranch::Passage> passages, const BranchForms<Interval>& f) {
  BranchForms<double> a;
  a.frame.i = f.frame.i, a.frame.j = f.frame.j;
  for (int k = 0; k < 3; ++k)
    a.frame.base[k] = approximate(f.frame.base[k]),
    a.u[static_cast<std::size_t>(k)] = detail::middle(f.u[static_cast<std::size_t>(k)]);
  a.turns = f.turns, a.line = f.line, a.sizes = f.sizes;
  a.a = detail::middle(f.a), a.b = detail::middle(f.b), a.c = detail::middle(f.c);
  a.factor = detail::middle(f.factor), a.under_root = detail::middle(f.under_root);
  for (const LocalForm<Interval>& dip : f.dips) a.dips.push_back({dip.from, detail::middle(dip.form)});
  return {component, std::move(passages), a, f};
}

/// The branches of a scene.
class Builder {
 public:
  explicit Builder(const CubicScene& scene) : s_(scene) {
    for (const auto& root : s_.roots)
      if (root.multiplicity % 2 == 1) turning_.push_back(&root);
    for (std::size_t k = 0; k < turning_.size(); ++k) {
      if (turning_[k]->sign_behind <= 0) continue;
      const bool last = k + 1 == turning_.size();  // the roots are oriented one after the other; once round, u is -u
      add_between(*turning_[k], *turning_[last ? 0 : k + 1], last);
    }
    if (turning_.empty()) add_unbroken(s_.roots.empty() ? s_.sign : s_.roots[0].sign_behind);
    if (s_.line) add_line();
  }
  std::vector<CubicBranch> result() && { return std::move(out_); }

 private:
  static double size_of(const BinaryForm<Interval>& f) {
    double out = 0;
    for (std::size_t k = 0; k <= f.degree; ++k) out += size(f.c[k]);
    return out;
  }
  BranchForms<Interval> forms() const {
    BranchForms<Interval> f;
    f.frame = frame_of(s_);
    f.a = s_.pencil.a, f.b = s_.pencil.b, f.c = s_.pencil.c;
    f.sizes = {size_of(f.a), size_of(f.b), size_of(f.c) + 0x1p-10 * size_of(f.b)};
    f.factor = s_.factor, f.under_root = s_.rest, f.dips = s_.dips;
    f.u.fill({Interval(0), Interval(0)});
    return f;
  }

  void add(const BranchForms<Interval>& f, std::vector<CubicBranch::Passage> passages) {
    out_.push_back(branch(static_cast<int>(out_.size()), std::move(passages), f));
  }

  /// Where no real root turns the branches back: u goes once round the projective line.
  void add_unbroken(int sign) {
    if (sign < 0) return;
    BranchForms<Interval> f = forms();
    if (sign == 0) return add(f, {{1, false}});  // a double line
    // After one turn u is -u, and the root keeps or changes its sign against B: the sheets change places or do not.
    if ((f.a.degree + f.factor.degree) % 2 == 0) return add(f, {{1, false}, {-1, false}});
    add(f, {{1, false}});
    add(f, {{-1, false}});
  }

  /// a + b and the determinant of (b, a): small where a and b nearly are the same or opposite.
  struct Ends {
    Point1<Interval> sum;
    Interval across;
  };
  static Ends ends_of(const CubicScene::Root& from, const CubicScene::Root& to, bool once_round) {
    if (!from.refined || !to.refined) {
      const Point1<Interval> a = from.at, b = once_round ? Point1<Interval>(-to.at) : to.at;
      return {a + b, a[1] * b[0] - a[0] * b[1]};
    }
    const auto& a = *from.refined;
    auto b = *to.refined;
    if (once_round) b = {-b[0], -b[1]};
    return {{enclosure(a[0] + b[0]), enclosure(a[1] + b[1])}, enclosure(a[1] * b[0] - a[0] * b[1])};
  }

  void add_between(const CubicScene::Root& from, const CubicScene::Root& to, bool once_round) {
    BranchForms<Interval> f = forms();
    const Ends ends = ends_of(from, to, once_round);
    // G = l_a l_b E with l_a(u(s)) = (1 + s)^2 l_a(b) and l_b(u(s)) = -(1 - s)^2 l_a(b), so H = -l_a(b)^2 E.
    const auto factor = BinaryForm<Interval>::constant(-CGAL::square(ends.across));
    const Point1<Interval> a = from.at, b = once_round ? Point1<Interval>(-to.at) : to.at;
    f.u = {a, b, ends.sum}, f.across = ends.across;
    f.under_root = factor * f.under_root.divided_by_root(a).divided_by_root(b);
    for (const Point1<Interval>& end : {a, b}) detail::divide_by_root(f.dips, end);
    for (LocalForm<Interval>& dip : f.dips) dip.form = factor * dip.form;
    f.turns = true;
    if (contains_zero(ends.across)) return add(f, {});  // cannot tell a from b: counted, but not parametrised
    add(f, {{1, false}, {-1, true}});
  }

  void add_line() {
    BranchForms<Interval> f = forms();
    f.line = true;
    f.u[0] = *s_.line;
    add(f, {{1, false}});
  }

  const CubicScene& s_;
  std::vector<const CubicScene::Root*> turning_;
  std::vector<CubicBranch> out_;
};

/// Components and ovals. Every crossing joins all the branches there are: two of them meet at most in such points.
void count_components(CubicBranches& out) {
  CurveTopology& t = out.topology;
  bool joined = false;
  for (const SingularPoint& p : t.singular) {
    joined = joined || p.kind == SingularKind::crossing;
    t.isolated += p.kind == SingularKind::isolated;
  }
  if (joined)
    for (CubicBranch& branch : out.branches) branch.component = 0;
  const int branches = static_cast<int>(out.branches.size());
  t.components = (joined ? 1 : branches) + t.isolated;
  t.ovals = joined ? 0 : branches - 1;
}

CubicBranches branches_of(const CubicScene& scene, std::vector<PointAtInfinity> at_infinity, Rung rung) {
  CubicBranches out{detail::singular_points_and_factors(scene), Builder(scene).result(), frame_of(scene), scene.base};
  out.topology.rung = rung;
  out.topology.at_infinity = std::move(at_infinity);
  count_components(out);
  return out;
}

}  // namespace

template <class T>
Point1<T> BranchForms<T>::line_at(const T& s) const {
  if (!turns) return {T((T(1) - s) * (T(1) + s)), T(T(2) * s)};
  const bool first = approximate(s) < 0;  // (1 - s)^2 a + (1 + s)^2 b
  const Point1<T>& end = first ? u[0] : u[1];
  const T t = first ? T(-s) : s, rest = T(1) - t, of_sum = rest * rest, of_end = T(4) * t;
  return {T(of_sum * u[2][0] + of_end * end[0]), T(of_sum * u[2][1] + of_end * end[1])};
}

template <class T>
Point2<T> BranchForms<T>::seen(const T& s, int sheet) const {
  if (line) return on_line(s);
  return on_sheet(line_at(s), T((T(1) - s) * (T(1) + s)), sheet);
}

template <class T>
template <class X>
Point2<X> BranchForms<T>::on_line(const X& s) const {
  return sum(X(X(1) - s * s), Point1<X>(X(u[0][0]), X(u[0][1])), X(X(2) * s));
}

template <class T>
template <class X>
Point2<X> BranchForms<T>::on_sheet(const Point1<X>& q, const X& rest, int sheet) const {
  const LocalForm<T>* dip = nullptr;
  for (const LocalForm<T>& each : dips)
    if (each.is_near(q) && (!dip || each.distance(q) < dip->distance(q))) dip = &each;
  X root = factor(q) * positive_root(dip ? (*dip)(q) : under_root(q));
  if (turns) root = root * rest;
  if (sheet < 0) root = -root;
  // Two vectors of the same direction, of which one may vanish. Errors and widths of a, b, c go with their sizes; those
  // of a turn the first by its |plus| over its square, those of b by |2 a| over that, and the second likewise.
  const X twice_a = X(2) * a(q), twice_c = X(2) * c(q), minus_b = -b(q), plus = minus_b + root, minus = minus_b - root;
  if (sizes[1] * size(plus) + sizes[2] * size(twice_a) >= sizes[0] * size(twice_c) + sizes[1] * size(minus))
    return sum(plus, q, twice_a);
  return sum(twice_c, q, minus);
}

template struct BranchForms<double>;
template struct BranchForms<Interval>;
using Moving = Jet<Interval, 1>;
template Point2<Interval> BranchForms<Interval>::on_line(const Interval&) const;
template Point2<Moving> BranchForms<Interval>::on_line(const Moving&) const;
template Point2<Moving> BranchForms<Interval>::on_sheet(const Point1<Moving>&, const Moving&, int) const;

CubicBranch line_branch(const LinearForm<Rational>& line, int component) {
  Eigen::Index k = 0;
  line.cwiseAbs().minCoeff(&k);  // the line meets that side of the triangle of reference in one point
  const Point2<Rational> to = Point2<Rational>::Unit(k).cross(line), base = line.cross(to);
  BranchForms<Interval> f;
  f.line = true, f.frame.i = (static_cast<int>(k) + 1) % 3, f.frame.j = (static_cast<int>(k) + 2) % 3;
  for (int n = 0; n < 3; ++n) f.frame.base[n] = enclosure(base[n]);
  f.u.fill({Interval(0), Interval(0)});
  f.u[0] = {enclosure(to[f.frame.i]), enclosure(to[f.frame.j])};
  return branch(component, {{1, false}}, f);
}

std::optional<CubicBranches> branches_by_intervals(const Cubic<Interval>& f, const Point2<Interval>& on_curve) {
  const auto scene = detail::cubic_scene(f, on_curve);
  if (!scene) return std::nullopt;
  auto at_infinity = detail::points_at_infinity(f);
  if (!at_infinity) return std::nullopt;
  return branches_of(*scene, std::move(*at_infinity), Rung::intervals);
}

CubicBranches branches_by_rationals(const Cubic<Rational>& f, const Point2<Rational>& on_curve) {
  const UpwardRounding upward;
  if (const auto scene = detail::cubic_scene(f, on_curve))
    return branches_of(*scene, detail::points_at_infinity(f), Rung::exact);
  CubicBranches out;
  out.topology.reason = "the given point is a singular point of the cubic";
  return out;
}

CubicBranches branches_of(const Cubic<Rational>& f, const Point2<Rational>& on_curve) {
  {
    const UpwardRounding upward;
    const Point2<Interval> base{enclosure(on_curve[0]), enclosure(on_curve[1]), enclosure(on_curve[2])};
    if (auto branches = branches_by_intervals(enclosure(f), base)) return std::move(*branches);
  }
  return branches_by_rationals(f, on_curve);
}

}  // namespace burmester
