#include "burmester/geometry/cubic_branches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "burmester/geometry/cubic_scene.hpp"
#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester {
namespace {

using detail::positive_root;

Interval positive_root(const Interval& x) { return CGAL::sqrt(Interval(std::max(0.0, x.inf()), std::max(0.0, x.sup()))); }

/// The branches of a scene.
class Builder {
 public:
  explicit Builder(const detail::CubicScene& scene) : s_(scene) {
    for (const auto& root : s_.roots)
      if (root.multiplicity % 2 == 1) turning_.push_back(&root);
    for (std::size_t k = 0; k < turning_.size(); ++k) {
      if (turning_[k]->sign_behind <= 0) continue;
      const bool last = k + 1 == turning_.size();  // the roots are oriented one after the other; once round, u is -u
      add_between(turning_[k]->at, last ? Point1<Interval>(-turning_[0]->at) : turning_[k + 1]->at);
    }
    if (turning_.empty()) add_unbroken(s_.roots.empty() ? s_.sign : s_.roots[0].sign_behind);
    if (s_.line) add_line();
  }
  std::vector<CubicBranch> result() && { return std::move(out_); }

 private:
  BranchForms<Interval> forms() const {
    BranchForms<Interval> f;
    f.base = s_.pencil.base, f.i = s_.pencil.i, f.j = s_.pencil.j;
    f.a = s_.pencil.a, f.b = s_.pencil.b, f.c = s_.pencil.c;
    f.factor = s_.factor, f.under_root = s_.rest;
    f.u.fill({Interval(0), Interval(0)});
    return f;
  }

  void add(const BranchForms<Interval>& f, std::vector<CubicBranch::Passage> passages) {
    BranchForms<double> a;
    for (int k = 0; k < 3; ++k)
      a.base[k] = approximate(f.base[k]),
      a.u[static_cast<std::size_t>(k)] = detail::middle(f.u[static_cast<std::size_t>(k)]);
    a.i = f.i, a.j = f.j, a.turns = f.turns, a.line = f.line;
    a.a = detail::middle(f.a), a.b = detail::middle(f.b), a.c = detail::middle(f.c);
    a.factor = detail::middle(f.factor), a.under_root = detail::middle(f.under_root);
    out_.push_back({static_cast<int>(out_.size()), std::move(passages), a, f});
  }

  /// Where no real root turns the branches back: u goes once round the projective line.
  void add_unbroken(int sign) {
    if (sign < 0) return;
    BranchForms<Interval> f = forms();
    f.u = {Point1<Interval>(Interval(1), Interval(0)), Point1<Interval>(Interval(0), Interval(2)),
           Point1<Interval>(Interval(-1), Interval(0))};
    if (sign == 0) return add(f, {{1, false}});  // a double line
    // After one turn u is -u, and the root keeps or changes its sign against B: the sheets change places or do not.
    if ((f.a.degree + f.factor.degree) % 2 == 0) return add(f, {{1, false}, {-1, false}});
    add(f, {{1, false}});
    add(f, {{-1, false}});
  }

  void add_between(const Point1<Interval>& a, const Point1<Interval>& b) {
    BranchForms<Interval> f = forms();
    const Point1<Interval> sum = a + b;
    f.u = {sum, Point1<Interval>((b[0] - a[0]) * 2, (b[1] - a[1]) * 2), sum};
    // G = l_a l_b E with l_a(u(s)) = (1 + s)^2 l_a(b) and l_b(u(s)) = -(1 - s)^2 l_a(b), so H = -l_a(b)^2 E.
    const Interval across = a[1] * b[0] - a[0] * b[1];
    f.under_root =
        BinaryForm<Interval>::constant(-CGAL::square(across)) * f.under_root.divided_by_root(a).divided_by_root(b);
    f.turns = true;
    if (contains_zero(across)) return add(f, {});  // doubles cannot tell a from b: counted, but not parametrised
    add(f, {{1, false}, {-1, true}});
  }

  void add_line() {
    BranchForms<Interval> f = forms();
    f.line = true;
    f.u[0] = *s_.line;
    add(f, {{1, false}});
  }

  const detail::CubicScene& s_;
  std::vector<const detail::CubicScene::Root*> turning_;
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

CubicBranches branches_of(const detail::CubicScene& scene, std::vector<PointAtInfinity> at_infinity, Rung rung) {
  CubicBranches out{detail::singular_points_and_factors(scene), Builder(scene).result()};
  out.topology.rung = rung;
  out.topology.at_infinity = std::move(at_infinity);
  count_components(out);
  return out;
}

}  // namespace

template <class T>
Point2<T> BranchForms<T>::operator()(const T& s, int sheet) const {
  const auto q = [this](const Point1<T>& at, const T& scale) {
    Point2<T> out(T(0), T(0), T(0));
    out[i] = scale * at[0], out[j] = scale * at[1];
    return out;
  };
  const T rest = T(1) - s * s;
  if (line) return rest * base + q(u[0], T(2) * s);
  const Point1<T> at(T(u[0][0] + s * (u[1][0] + s * u[2][0])), T(u[0][1] + s * (u[1][1] + s * u[2][1])));
  T root = factor(at) * positive_root(under_root(at));
  if (turns) root = root * rest;
  if (sheet < 0) root = -root;
  // Two vectors of the same direction, of which one may vanish.
  const T twice_a = T(2) * a(at), twice_c = T(2) * c(at), minus_b = -b(at), plus = minus_b + root,
          minus = minus_b - root;
  const auto size = [](const T& x) { return std::abs(approximate(x)); };
  if (size(plus) + size(twice_a) >= size(twice_c) + size(minus)) return plus * base + q(at, twice_a);
  return twice_c * base + q(at, minus);
}
template struct BranchForms<double>;
template struct BranchForms<Interval>;

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
