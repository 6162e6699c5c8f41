// The real common points of two conics.
//
// Method: a degenerate member of the pencil s A + t B is a pair of lines through the common points, so the
// problem is one binary cubic, one splitting and two quadratics, with no chart and no quartic. Of the (one or
// three) real degenerate members take the real pair of lines that separates best.
// Source of the splitting: J. Richter-Gebert, "Perspectives on Projective Geometry" (2011), section 11.
// Two real conics always have a real degenerate member that is a pair of real lines, unless the pencil is
// degenerate throughout; then `kind` says how.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "burmester/geometry/binary_cubic.hpp"
#include "burmester/geometry/conic.hpp"

namespace burmester {

enum class PencilKind {
  regular,       ///< four common points over the complex numbers, counted with multiplicity
  common_line,   ///< the conics share a line; `point` holds the one common point off it, if there is one
  common_vertex, ///< every member is singular at the same point, which is the only common point (multiplicity 4)
  same_conic     ///< the conics are proportional, or one of them is zero
};

template <class T>
struct CommonPoints {
  PencilKind kind = PencilKind::regular;
  int count = 0;
  std::array<Point2<T>, 4> point;  ///< largest coordinate of order 1
  Point2<T> line;                  ///< common_line: the shared line
};

template <class T>
struct LinePair {
  LinearForm<T> first, second;
  T separation;  ///< |l x m|^2 / |Q|^2; negative for a pair of complex lines, 0 for a double line
};

namespace detail {

/// Q, singular to rounding, as a product of two real lines (unscaled); no lines where separation <= 0.
template <class T>
LinePair<T> split(const Conic<T>& q) {
  using std::abs, std::sqrt;
  const Adjugate<T> adj(q);
  const T diagonal[3] = {adj.xx, adj.yy, adj.zz};
  const T column[3][3] = {{adj.xx, adj.xy, adj.xz}, {adj.xy, adj.yy, adj.yz}, {adj.xz, adj.yz, adj.zz}};
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (diagonal[i] < diagonal[k]) k = i;
  LinePair<T> out{LinearForm<T>::Zero(), LinearForm<T>::Zero(), T(-adj.trace())};
  if (!(diagonal[k] < 0)) {
    if (out.separation > 0) out.separation = T(0);
    return out;
  }
  const T scale = T(-1) / sqrt(-diagonal[k]);
  const T p[3] = {column[k][0] * scale, column[k][1] * scale, column[k][2] * scale};  // l x m
  // 2 l m^T = 2 M - [p]x has rank one: any row is m, any column is l.
  const T n[3][3] = {{2 * q.q[0], q.q[5] + p[2], q.q[4] - p[1]},
                     {q.q[5] - p[2], 2 * q.q[1], q.q[3] + p[0]},
                     {q.q[4] + p[1], q.q[3] - p[0], 2 * q.q[2]}};
  int row = 0, col = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (abs(n[i][j]) > abs(n[row][col])) row = i, col = j;
  out.first = {n[0][col], n[1][col], n[2][col]};
  out.second = {n[row][0], n[row][1], n[row][2]};
  return out;
}

/// Two points that span the line l, of the same size as l.
template <class T>
void span_line(const LinearForm<T>& l, Point2<T>& u, Point2<T>& v) {
  using std::abs;
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(l[i]) > abs(l[k])) k = i;
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  u[i] = l[k], u[k] = -l[i], u[j] = T(0);
  v[j] = l[k], v[k] = -l[j], v[i] = T(0);
}

/// Scales the largest coordinate into [1, 2) by a power of two.
template <class T>
void normalise(Point2<T>& p) {
  const double size =
      std::max({std::abs(approximate(p[0])), std::abs(approximate(p[1])), std::abs(approximate(p[2]))});
  if (size > 0) p *= T(unit_scale(size));
}

template <class T>
void intersect_line(LinearForm<T> l, const Conic<T>& q, CommonPoints<T>& out) {
  normalise(l);
  Point2<T> u, v;
  span_line(l, u, v);
  const T a = q(u), b = q.polar(u, v), c = q(v);
  std::array<std::array<T, 2>, 2> root;
  T discriminant;
  const int n = binary_quadratic_roots(a, b, c, root, discriminant);
  for (int i = 0; i < n; ++i) {
    Point2<T> p = root[i][0] * u + root[i][1] * v;
    normalise(p);
    out.point[out.count++] = p;
  }
}

}  // namespace detail

/// |l x m|^2 / |Q|^2 of the degenerate member Q = l m = s A + t B, as a function of (s, t): both are quadratic forms.
template <class T>
class PencilSeparation {
 public:
  PencilSeparation(const Conic<T>& a, const Conic<T>& b) {
    const auto minors = [](const Conic<T>& u, const Conic<T>& v) {  // -trace of the adjugate, polarised
      return T(u.q[3] * v.q[3] + u.q[4] * v.q[4] + u.q[5] * v.q[5]) -
             2 * (u.q[0] * (v.q[1] + v.q[2]) + u.q[1] * (v.q[0] + v.q[2]) + u.q[2] * (v.q[0] + v.q[1]));
    };
    const auto dot = [](const Conic<T>& u, const Conic<T>& v) {
      T sum = u.q[0] * v.q[0];
      for (int i = 1; i < 6; ++i) sum += u.q[i] * v.q[i];
      return sum;
    };
    top_ = {minors(a, a), 2 * minors(a, b), minors(b, b)};
    bottom_ = {dot(a, a), 2 * dot(a, b), dot(b, b)};
  }
  /// -trace of the adjugate of s A + t B: coefficients of s^2, s t, t^2
  const std::array<T, 3>& top() const { return top_; }
  T operator()(const T& s, const T& t) const {
    return (s * (top_[0] * s + top_[1] * t) + top_[2] * t * t) /
           (s * (bottom_[0] * s + bottom_[1] * t) + bottom_[2] * t * t);
  }

 private:
  std::array<T, 3> top_, bottom_;
};

/// Common points of a pencil in which not every member is singular (`determinant`: its pencil_determinant).
/// Preconditions: both conics of size about 1, not proportional. The points are good enough for one Newton step of
/// the caller on its own equations to leave a few unit roundoffs times the condition of each point; before it, errors
/// of 1e-8 were seen at conditions of 1e3.
template <class T>
CommonPoints<T> regular_common_points(const Conic<T>& a, const Conic<T>& b, const std::array<T, 4>& determinant) {
  const BinaryCubicRoots<T> roots = binary_cubic_roots(determinant);
  const PencilSeparation<T> separation(a, b);
  T best = T(0);
  int chosen = -1;
  for (int i = 0; i < roots.count; ++i)
    if (const T apart = separation(roots.at[i][0], roots.at[i][1]); apart > best) best = apart, chosen = i;
  CommonPoints<T> out;
  if (chosen < 0) return out;
  const auto [s, t] = roots.at[chosen];
  const LinePair<T> lines = detail::split(pencil_member(a, s, b, t));
  if (!(lines.separation > 0)) return out;
  const Conic<T> other = pencil_member(a, T(-t), b, s);
  detail::intersect_line(lines.first, other, out);
  detail::intersect_line(lines.second, other, out);
  return out;
}

/// The coefficients of Q on the line l, relative to those of Q.
template <class T>
double size_on_line(const LinearForm<T>& l, const Conic<T>& q) {
  Point2<T> unit = l, u, v;
  detail::normalise(unit);
  detail::span_line(unit, u, v);
  return std::max({std::abs(approximate(q(u))), std::abs(approximate(q.polar(u, v))), std::abs(approximate(q(v)))});
}

/// Whether the conics, of size about 1 or zero, are proportional: all their 2 x 2 minors are below `tolerance`.
template <class T>
bool proportional(const Conic<T>& a, const Conic<T>& b, double tolerance) {
  double minors = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j) minors = std::max(minors, std::abs(approximate(T(a.q[i] * b.q[j] - a.q[j] * b.q[i]))));
  return minors < tolerance;
}

namespace detail {

/// Two members of a degenerate pencil whose lines separate best: at most two of all are double lines, so of A, B, A + B
/// and A - B at most two.
template <class T>
std::array<Conic<T>, 2> separated_members(const Conic<T>& a, const Conic<T>& b) {
  std::array<Conic<T>, 4> member{a, b, pencil_member(a, T(1), b, T(1)), pencil_member(a, T(1), b, T(-1))};
  std::array<double, 4> apart;
  for (int i = 0; i < 4; ++i) apart[i] = std::abs(approximate(Adjugate<T>(member[i]).trace()));
  for (int i = 0; i < 2; ++i) {
    const auto best = std::max_element(apart.begin() + i, apart.end()) - apart.begin();
    std::swap(apart[i], apart[best]), std::swap(member[i], member[best]);
  }
  return {member[0], member[1]};
}

/// The common point of all lines of a conic of rank two.
template <class T>
Point2<T> vertex_of(const Conic<T>& q) {
  const Adjugate<T> adj(q);
  Point2<T> vertex{adj.xx, adj.xy, adj.xz};
  if (adj.yy * adj.yy > adj.xx * adj.xx) vertex = {adj.xy, adj.yy, adj.yz};
  if (adj.zz * adj.zz > adj.xx * adj.xx && adj.zz * adj.zz > adj.yy * adj.yy) vertex = {adj.xz, adj.yz, adj.zz};
  normalise(vertex);
  return vertex;
}

}  // namespace detail

/// Common points of a pencil whose members are all singular, or of proportional conics: a shared line, a shared vertex
/// or one conic only. Both conics of size about 1 or zero; coefficients below `tolerance` count as zero.
template <class T>
CommonPoints<T> degenerate_common_points(const Conic<T>& a, const Conic<T>& b, double tolerance) {
  using std::abs;
  CommonPoints<T> out;
  out.kind = PencilKind::same_conic;
  if (proportional(a, b, tolerance)) return out;
  const auto [first, second] = detail::separated_members(a, b);
  const LinePair<T> l = detail::split(first), m = detail::split(second);
  for (const LinearForm<T>* shared : {&l.first, &l.second}) {
    if (!(l.separation > tolerance) || size_on_line(*shared, second) > tolerance) continue;
    out.kind = PencilKind::common_line;
    out.line = *shared;
    const bool first_is_shared = m.first.cross(*shared).squaredNorm() * m.second.squaredNorm() <
                                 m.second.cross(*shared).squaredNorm() * m.first.squaredNorm();
    Point2<T> p = (shared == &l.first ? l.second : l.first).cross(first_is_shared ? m.second : m.first);
    detail::normalise(p);
    if (abs(shared->dot(p)) > T(tolerance) * shared->norm()) out.point[out.count++] = p;
    return out;
  }
  out.kind = PencilKind::common_vertex;
  out.point[out.count++] = detail::vertex_of(first);
  return out;
}

}  // namespace burmester
