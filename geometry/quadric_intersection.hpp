// The curve in which two quadrics A, B of P^3 meet, parametrised by a pencil of planes.
//
// Plane (s : t) holds the axis, the line U V, and W = s W0 + t W1. Its points are x = alpha U + beta V +
// gamma W, and a quadric meets it in the conic (A(.,.) polar)
//   A(U) alpha^2 + A(V) beta^2 + A(W) gamma^2 + A(V,W) beta gamma + A(U,W) alpha gamma + A(U,V) alpha beta,
// whose coefficients are forms of degree 0, 1 or 2 in (s : t). Two cases:
//
// - The axis is a chord: both quadrics cut the same two points from it (real, complex, or one twice), or one holds it.
//   Then a combination of the two conics is gamma l, where l = 0 is the radical line of the sections, and the
//   curve is the two points of l on either conic, real and different where -l^T adj(2 A) l > 0, a form of
//   degree 4. Planar dyads: with the axis X3 = X4 = 0 and t : s = X3 : X4 the sections are circles (RR) and
//   straight lines (PR, RP).
// - Any other axis: up to four points in each plane (common_points.hpp), two of which coincide at the zeros of the
//   discriminant of det(lambda A + mu B), a form of degree 8.
//
// The turning points, where the number of real points in a plane changes by two, lie in planes of odd real
// zeros. (J. Levin, Comm. ACM 19, 1976, and CGIP 11, 1979, parametrises by a ruled member of the pencil instead.)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "burmester/geometry/binary_form.hpp"
#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/error_free.hpp"
#include "burmester/geometry/quadric.hpp"

namespace burmester {

template <class T>
struct PlanePencil {
  Point3<T> U, V;              ///< span the axis
  std::array<Point3<T>, 2> W;  ///< span the space with them

  Point3<T> point(const Point2<T>& x, const T& s, const T& t) const {
    return x[0] * U + x[1] * V + x[2] * (s * W[0] + t * W[1]);
  }
};

/// The planes through the line U V; W0 and W1 are unit points, W0 the earlier one. Precondition: U and V differ.
template <class T>
PlanePencil<T> planes_through(const Point3<T>& U, const Point3<T>& V) {
  using std::abs;
  constexpr int pair[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                              {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  const auto minor = [&](int k) {
    return T(abs(difference_of_products<T>(U[pair[k][0]], V[pair[k][1]], U[pair[k][1]], V[pair[k][0]])));
  };
  int best = 0;
  for (int k = 1; k < 6; ++k)
    if (minor(k) > minor(best)) best = k;
  PlanePencil<T> out{U, V, {}};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 4; ++k) out.W[i][k] = T(k == pair[best][2 + i] ? 1 : 0);
  return out;
}

/// The conics of two quadrics in the planes of a pencil, in coordinates alpha : beta : gamma. Over exact
/// types all of it is exact.
template <class T>
class QuadricSections {
 public:
  using Form = BinaryForm<T>;

  /// Precondition: neither quadric is zero.
  QuadricSections(const Quadric<T>& a, const Quadric<T>& b, const PlanePencil<T>& planes)
      : planes_(planes), conic_{sections(a), sections(b)} {
    chord_ = true;
    for (const auto& [i, k] : {std::pair(0, 1), std::pair(0, 5), std::pair(1, 5)})
      chord_ = chord_ &&
               difference_of_products<T>(on_axis(0, i), on_axis(1, k), on_axis(0, k), on_axis(1, i)) == 0;
    if (chord_) find_radical_line(size_of(a), size_of(b));
  }

  const PlanePencil<T>& planes() const { return planes_; }
  /// Of the numbers as they were computed: for doubles with rounding unless U and V are unit points.
  bool axis_is_chord() const { return chord_; }
  bool axis_is_common() const { return common_; }  ///< both quadrics hold it

  /// Of A (which = 0) or B (1).
  Conic<T> conic(int which, const T& s, const T& t) const {
    Conic<T> out;
    for (int k = 0; k < 6; ++k) out.q[k] = conic_[which].q[k](s, t);
    return out;
  }
  /// Which of the two conics the radical line belongs to: the one with the larger form on the
  /// axis, relative to its quadric.
  int leading() const { return leading_; }
  /// Precondition: the axis is a chord.
  LinearForm<T> radical_line(const T& s, const T& t) const {
    return {line_[0](s, t), line_[1](s, t), line_[2](s, t)};
  }

  /// Degree 4 where the axis is a chord: positive where the plane holds two real points (a square where both
  /// quadrics hold the axis, and there is always one point beside it). Else degree 8: positive for none or
  /// four real points, negative for two.
  Form discriminant() const {
    if (chord_) {
      const auto& [l, m, n] = line_;
      const Adjugate<Form> adj(conic_[leading_]);
      return -1 * (l * l * adj.xx + m * m * adj.yy + n * n * adj.zz +
                   2 * (m * n * adj.yz + l * n * adj.xz + l * m * adj.xy));
    }
    const auto [a, b, c, d] = pencil_determinant(conic_[0], conic_[1]);
    return b * b * c * c - 4 * (a * c * c * c + b * b * b * d) - 27 * (a * a * d * d) + 18 * (a * b * c * d);
  }

 private:
  Conic<Form> sections(const Quadric<T>& a) const {
    const auto& [U, V, W] = planes_;
    const auto form = [](std::initializer_list<T> c) { return Form(std::vector<T>(c)); };
    return Conic<Form>({form({a(U)}), form({a(V)}), form({a(W[0]), a.polar(W[0], W[1]), a(W[1])}),
                        form({a.polar(V, W[0]), a.polar(V, W[1])}),
                        form({a.polar(U, W[0]), a.polar(U, W[1])}), form({a.polar(U, V)})});
  }
  const T& on_axis(int which, int k) const { return conic_[which].q[k].c[0]; }

  /// With A = a f and B = b f on the axis: a B - b A = gamma l. Where A leads, its points on l
  /// are points of B up to the roundings of l over a.
  void find_radical_line(double size_a, double size_b) {
    std::array<double, 2> largest{};
    std::array<int, 2> at{};
    for (int which = 0; which < 2; ++which)
      for (const int k : {0, 1, 5})
        if (const double size = std::abs(approximate(on_axis(which, k))); size > largest[which])
          largest[which] = size, at[which] = k;
    leading_ = largest[1] * size_a > largest[0] * size_b;
    const int k = at[leading_];
    common_ = on_axis(leading_, k) == 0;
    const Form own = common_ ? Form(1) : conic_[leading_].q[k], other = conic_[1 - leading_].q[k];
    for (int i = 0; i < 3; ++i)
      line_[i] = own * conic_[1 - leading_].q[4 - i] - other * conic_[leading_].q[4 - i];
  }

  PlanePencil<T> planes_;
  std::array<Conic<Form>, 2> conic_;
  std::array<Form, 3> line_;
  bool chord_ = false, common_ = false;
  int leading_ = 0;
};

struct SectionPoints {
  int count = 0;
  std::array<Point3<double>, 4> point;
  bool holds_curve = false;  ///< to rounding, a line or a conic of the curve lies in the plane
};

/// The real common points of two quadrics in the plane (s : t): at most two where the axis is a chord, else
/// four. Those on the axis are left out where both quadrics hold it. Precondition: s, t not both zero,
/// coefficients of order 1.
SectionPoints points_in_plane(const QuadricSections<double>& sections, double s, double t);

}  // namespace burmester
