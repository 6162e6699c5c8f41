#include "burmester/spherical/five_pose_certificate.hpp"

#include <cmath>
#include <numbers>

#include "burmester/geometry/enclosure.hpp"
#include "burmester/geometry/krawczyk.hpp"
#include "burmester/geometry/simple_roots.hpp"
#include "burmester/spherical/family.hpp"

namespace burmester::spherical {
namespace {

using Box3 = Vector<Interval, 3>;

/// Half widths of boxes above this, radians, are sharpened over rationals.
constexpr double largest_width = 1e-10;

const Pose& at(FivePoses poses, int i) { return poses[static_cast<std::size_t>(i)]; }

/// norm(q) Q
template <class T>
Matrix<T, 3, 3> rotation(const Pose& pose) {
  const Vector<T, Family::dimension> row = Family::row<T>(pose);
  Matrix<T, 3, 3> out;
  for (int i = 0; i < 9; ++i) out(i / 3, i % 3) = row[i];
  return out;
}

/// a^T N_j b' = 0 in the coordinates of a and b' but the largest, which stay 1.
struct DyadEquations {
  static constexpr int size = 4;
  const Bilinear<Interval>& n;
  int of_moving, of_fixed;  ///< which coordinates are 1

  Box3 moving(const Vector<Interval, 4>& x) const { return with_one(of_moving, x[0], x[1]); }
  Box3 fixed(const Vector<Interval, 4>& x) const { return with_one(of_fixed, x[2], x[3]); }

  Vector<Interval, 4> value(const Vector<Interval, 4>& x) const {
    const Box3 a = moving(x), b = fixed(x);
    Vector<Interval, 4> f;
    for (int j = 0; j < 4; ++j) {
      const LinearForm<Interval> row = line_of_partners(n[static_cast<std::size_t>(j)], a);
      f[j] = row[0] * b[0] + row[1] * b[1] + row[2] * b[2];
    }
    return f;
  }
  Matrix<Interval, 4, 4> jacobian(const Vector<Interval, 4>& x) const {
    const Box3 a = moving(x), b = fixed(x);
    const int a0 = (of_moving + 1) % 3, a1 = (of_moving + 2) % 3, b0 = (of_fixed + 1) % 3, b1 = (of_fixed + 2) % 3;
    Matrix<Interval, 4, 4> J;
    for (int j = 0; j < 4; ++j) {
      const Correlation<Interval>& m = n[static_cast<std::size_t>(j)];
      const auto by_a = [&](int i) -> Interval { return m(i, 0) * b[0] + m(i, 1) * b[1] + m(i, 2) * b[2]; };
      const auto by_b = [&](int i) -> Interval { return a[0] * m(0, i) + a[1] * m(1, i) + a[2] * m(2, i); };
      J(j, 0) = by_a(a0), J(j, 1) = by_a(a1), J(j, 2) = by_b(b0), J(j, 3) = by_b(b1);
    }
    return J;
  }

 private:
  static Box3 with_one(int k, const Interval& u, const Interval& v) {
    Box3 out;
    out[k] = Interval(1), out[(k + 1) % 3] = u, out[(k + 2) % 3] = v;
    return out;
  }
};

int largest(const Axis& a) {
  int k = 0;
  a.cwiseAbs().maxCoeff(&k);
  return k;
}

AxesBox box_of(const Box3& moving, const Box3& fixed, Rung rung) {
  AxesBox out;
  for (std::size_t i = 0; i < 3; ++i)
    out.moving[i] = range_of(moving[static_cast<int>(i)]), out.fixed[i] = range_of(fixed[static_cast<int>(i)]);
  out.rung = rung;
  return out;
}
Box3 box_of(const std::array<Range, 3>& r) {
  return {Interval(r[0].low, r[0].high), Interval(r[1].low, r[1].high), Interval(r[2].low, r[2].high)};
}

/// Whether no direction is in both: some 2 x 2 minor is not 0.
bool different(const std::array<Range, 3>& of_a, const std::array<Range, 3>& of_b) {
  const Box3 a = box_of(of_a), b = box_of(of_b);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (!contains_zero(Interval(a[i] * b[j] - a[j] * b[i]))) return true;
  }
  return false;
}

/// Krawczyk's box around a dyad; nothing where none is proved, or it is wide.
std::optional<AxesBox> enclose(const Bilinear<Interval>& n, const Axis& a, const Axis& b) {
  const DyadEquations equations{n, largest(a), largest(b)};
  const auto beside = [](const Axis& v, int k) {
    return Vector<double, 2>(v[(k + 1) % 3] / v[k], v[(k + 2) % 3] / v[k]);
  };
  const Vector<double, 2> u = beside(a, equations.of_moving), v = beside(b, equations.of_fixed);
  const Vector<double, 4> start(u[0], u[1], v[0], v[1]);
  if (!start.allFinite()) return std::nullopt;
  const auto box = krawczyk<Interval>(equations, start);
  if (!box || !(box->radius.maxCoeff() <= largest_width)) return std::nullopt;
  const Vector<Interval, 4> x = box->hull<Interval>();
  return box_of(equations.moving(x), equations.fixed(x), Rung::intervals);
}

/// The number of real dyads, -1 where intervals cannot tell.
int count_roots(const Bilinear<Interval>& n) {
  for (std::size_t chart = 0; chart < 2; ++chart) {
    const BinaryForm<Interval> f = sextic(minor_forms(in_chart(n, charts[chart])));
    std::array<Interval, 7> c;
    std::copy_n(f.c.begin(), 7, c.begin());
    if (const auto roots = simple_roots<6>(c)) return roots->count;
  }
  return -1;
}

void prove_by_intervals(FivePoses poses, std::span<const AxisPair> found, CertifiedAxes& out) {
  const UpwardRounding upward;
  const Bilinear<Interval> n = bilinear_equations<Interval>(poses, out.reference);
  out.count = count_roots(n);
  if (out.count < 0) return;
  out.count_rung = Rung::intervals;
  if (out.count != static_cast<int>(found.size())) return;
  const Matrix<double, 3, 3> back = rotation<double>(at(poses, out.reference)).transpose();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto box = enclose(n, found[i].moving, back * found[i].fixed);
    if (!box) return;
    for (std::size_t j = 0; j < i; ++j)
      if (!different(box->moving, out.boxes[j].moving) && !different(box->fixed, out.boxes[j].fixed)) return;
    out.axes[i] = {found[i].moving.normalized(), found[i].fixed.normalized()};
    out.boxes[i] = *box;
  }
  out.complete = true;
}

Box3 enclosure_of(const Vector<RationalInterval, 3>& x) {
  Box3 out;
  for (int i = 0; i < 3; ++i) out[i] = Interval(lower(x[i]), upper(x[i]));
  return out;
}
Axis middle(const Vector<RationalInterval, 3>& x) {
  return Axis(approximate(x[0]), approximate(x[1]), approximate(x[2])).stableNormalized();
}

void prove_degenerate(FivePoses poses, CertifiedAxes& out) {
  const ExactDegeneracy proved = exact_degeneracy(poses);
  out.degeneracy = proved.kind;
  if (!proved.isolated) return;
  const CertifiedAxes isolated = certified_axes({&*proved.isolated, 1}, poses[0], 0);
  out.reference = 0, out.isolated = 1;
  out.axes[0] = isolated.axes[0], out.boxes[0] = isolated.boxes[0];
}

void prove_exactly(FivePoses poses, CertifiedAxes& out) {
  if (const auto all = exact_axes(bilinear_equations<Rational>(poses, out.reference)))
    out = certified_axes(*all, at(poses, out.reference), out.reference);
  else
    prove_degenerate(poses, out);
}

/// The angle whose sine is at most e, or a little more.
double angle_of_sine(double e) { return e < 0.5 ? e * (1 + e) : std::numeric_limits<double>::infinity(); }

Interval norm_of(const Box3& v) { return sqrt(square(v[0]) + square(v[1]) + square(v[2])); }

/// The unit vector of v on the side of `shown`.
Box3 unit_towards(const Axis& shown, const Box3& v) {
  const Box3 unit = v / norm_of(v);
  const Interval along = unit[0] * shown[0] + unit[1] * shown[1] + unit[2] * shown[2];
  return approximate(along) < 0 ? Box3(-unit) : unit;
}

double length(const Vector<double, 3>& v) { return std::sqrt(v.squaredNorm()) * (1 + 0x1p-40); }

/// Distance of the unit vector shown from the true one, at least the sine of their angle.
double distance(const Axis& shown, const Box3& unit) {
  Vector<double, 3> off;
  for (int i = 0; i < 3; ++i) off[i] = magnitude(Interval(unit[i] - Interval(shown[i])));
  return length(off);
}

/// Sine and cosine within a unit in the last place of 1.
struct Shown {
  Axis fixed, moving;
  double sine, cosine;
};

}  // namespace

CertifiedAxes certified_axes(FivePoses poses, std::span<const AxisPair> found) {
  CertifiedAxes out;
  out.reference = reference_of(poses);
  prove_by_intervals(poses, found, out);
  if (!out.complete) prove_exactly(poses, out);
  return out;
}

CertifiedAxes certified_axes(std::span<const EnclosedAxes> all, const Pose& reference, int number) {
  CertifiedAxes out;
  out.reference = number;
  const Matrix<double, 3, 3> turn = rotation<double>(reference);
  out.count = static_cast<int>(all.size());
  out.count_rung = Rung::exact;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const EnclosedAxes& dyad = all[i];
    out.axes[i] = {middle(dyad.moving), (turn * middle(dyad.fixed)).normalized()};
    out.boxes[i] = box_of(enclosure_of(dyad.moving), enclosure_of(dyad.fixed), Rung::exact);
    out.boxes[i].multiplicity = dyad.multiplicity;
  }
  out.complete = true;
  return out;
}

double error_bound(const Dyads::Design& shown, const AxesBox& box, const Pose& reference) {
  const Shown s = Dyads::visit(shown, []<class D>(const typename D::Design& d) -> Shown {
    if constexpr (std::is_same_v<D, RR>)
      return {d.fixed, d.moving, std::sin(d.arc), std::cos(d.arc)};
    else
      return {d.fixed, d.moving, 1, 0};
  });
  const UpwardRounding upward;
  const Box3 in_S = rotation<Interval>(reference) * box_of(box.fixed);
  const Box3 a = unit_towards(s.moving, box_of(box.moving)), b = unit_towards(s.fixed, in_S);
  const Box3 at_reference =
      rotation<Interval>(reference) * a / Interval(Space::norm<Interval>(Space::point<Interval>(reference)));
  const Interval cosine = at_reference.dot(b), sine = norm_of(at_reference.cross(b));
  const Interval rounding(-0x1p-52, 0x1p-52);
  const Interval shown_cosine = Interval(s.cosine) + rounding, shown_sine = Interval(s.sine) + rounding;
  const Interval same = cosine * shown_cosine + sine * shown_sine, off = sine * shown_cosine - cosine * shown_sine;
  if (!(same.inf() > 0)) return std::numeric_limits<double>::infinity();
  return length(
      {angle_of_sine(distance(s.moving, a)), angle_of_sine(distance(s.fixed, b)), angle_of_sine(magnitude(off))});
}

int count_by_intervals(FivePoses poses) {
  const int reference = reference_of(poses);
  const UpwardRounding upward;
  return count_roots(bilinear_equations<Interval>(poses, reference));
}

int count_exactly(FivePoses poses) {
  const auto all = exact_axes(bilinear_equations<Rational>(poses, 0));
  return all ? static_cast<int>(all->size()) : -1;
}

}  // namespace burmester::spherical
