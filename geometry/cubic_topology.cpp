// The singular points of a cubic, and the lines and conics that split off.
#include <algorithm>
#include <cmath>

#include "burmester/geometry/cubic_scene.hpp"
#include "burmester/geometry/range.hpp"

namespace burmester::detail {
namespace {

class Topologist {
 public:
  explicit Topologist(const CubicScene& scene)
      : s_(scene), a_(middle(scene.pencil.a)), b_(middle(scene.pencil.b)), c_(middle(scene.pencil.c)) {
    const CubicPencil<Interval>& p = s_.pencil;
    const auto coordinate = [&](int k) { return middle(p.base[k]) / middle(p.base[p.k]); };
    v_ = u0_ = u1_ = LinearForm<double>::Zero();
    v_[p.k] = 1 / middle(p.base[p.k]);
    u0_[p.i] = 1, u0_[p.k] = -coordinate(p.i);
    u1_[p.j] = 1, u1_[p.k] = -coordinate(p.j);
  }

  CurveTopology result() {
    for (const CubicScene::Root& root : s_.roots)
      if (root.multiplicity > 1) add_point(middle(root.at), 0, kind_of(root));
    if (s_.line)
      add_line_and_conic(middle(*s_.line));
    else if (s_.rest.degree == 0)
      add_line_and_conic_through_base();
    return std::move(out_);
  }

 private:
  SingularKind kind_of(const CubicScene::Root& root) const {
    if (root.multiplicity % 2 == 1) return SingularKind::cusp;
    if (root.sign_behind > 0) return SingularKind::crossing;
    return lies_on_line(root) ? SingularKind::cusp : SingularKind::isolated;  // on the line: a smooth branch through it
  }
  /// Precondition for an answer: D = 0 on the line exactly where one of its roots lies on it.
  bool lies_on_line(const CubicScene::Root& root) const {
    return s_.line && s_.sign_on_line == 0 &&
           contains_zero(Interval(root.at[0] * (*s_.line)[1] - root.at[1] * (*s_.line)[0]));
  }
  void add_point(const Point1<double>& u, double root, SingularKind kind) {
    const double v = (root - b_(u)) / (2 * a_(u));
    Point2<double> p =
        v * Point2<double>(middle(s_.pencil.base[0]), middle(s_.pencil.base[1]), middle(s_.pencil.base[2]));
    p[s_.pencil.i] += u[0], p[s_.pencil.j] += u[1];
    out_.singular.push_back({p / p.cwiseAbs().maxCoeff(), kind});
  }

  LinearForm<double> linear(const BinaryForm<double>& f) const { return f.c[0] * u0_ + f.c[1] * u1_; }
  /// a v^2 + b v + c with forms of degree 0, 1, 2
  Conic<double> conic(double a, const BinaryForm<double>& b, const BinaryForm<double>& c) const {
    Conic<double> q;
    q.add_product(LinearForm<double>(a * v_ + linear(b)), v_, 1);
    q.add_product(linear(c), u0_, 1);
    q.add_product(LinearForm<double>(c.c[2] * u1_), u1_, 1);
    return q;
  }
  /// sqrt(G) S
  BinaryForm<double> root_of_discriminant() const {
    return BinaryForm<double>::constant(positive_root(middle(s_.rest.c[0]))) * middle(s_.factor);
  }

  void add_line_and_conic(const Point1<double>& u) {
    add_points_on_line(u);
    out_.lines.push_back(linear(BinaryForm<double>::vanishing_at(u)));
    const int sign = s_.roots.empty() ? s_.sign : s_.roots[0].sign_behind;  // of G, if it is a constant
    if (s_.rest.degree > 0 || sign < 0) {
      out_.conics.push_back(conic(a_.c[0], b_, c_));
      return;
    }
    const LinearForm<double> mean = 2 * a_.c[0] * v_ + linear(b_), half = linear(root_of_discriminant());
    out_.lines.push_back(mean + half);
    out_.repeated = s_.discriminant.is_zero();
    if (!out_.repeated) out_.lines.push_back(mean - half);
  }

  void add_points_on_line(const Point1<double>& u) {
    if (s_.sign_on_line < 0) return;
    const bool known = std::any_of(s_.roots.begin(), s_.roots.end(),
                                   [&](const auto& root) { return root.multiplicity > 1 && lies_on_line(root); });
    const double root = positive_root(middle(s_.discriminant)(u));
    if (s_.sign_on_line > 0) add_point(u, -root, SingularKind::crossing);
    if (!known) add_point(u, root, SingularKind::crossing);
  }

  /// 4 A F = (2 A v + B - R)(2 A v + B + R) with R = sqrt(G) S, and A divides B - R or B + R.
  void add_line_and_conic_through_base() {
    const Point1<double> u{a_.c[1], -a_.c[0]};
    BinaryForm<double> r = root_of_discriminant();
    if (std::abs(b_(u) - r(u)) > std::abs(b_(u) + r(u))) r = -1 * r;
    // vanishing_at(u) = -A, so (B - R) / A is minus the quotient.
    out_.lines.push_back(2 * v_ - linear((b_ - r).divided_by_root(u)));
    out_.conics.push_back(conic(0, 2 * a_, b_ + r));
  }

  const CubicScene& s_;
  BinaryForm<double> a_, b_, c_;
  LinearForm<double> v_, u0_, u1_;  ///< v, u0 and u1 of a point X
  CurveTopology out_;
};

}  // namespace

CurveTopology singular_points_and_factors(const CubicScene& scene) { return Topologist(scene).result(); }

}  // namespace burmester::detail
