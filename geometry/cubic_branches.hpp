// The real branches of a plane cubic through a known point: their number, how they hang together, and a smooth
// parametrisation of each. Only for targets that compile intervals.
//
// In the notation of cubic_pencil.hpp let D = S^2 G, S and G binary forms, the roots of G simple. Then
//     X(u) = (-B +- S sqrt(G)) P + 2 A q(u) = 2 C P - (B +- S sqrt(G)) q(u),     q(u) = u0 Qi + u1 Qj,
// are the two points on the line u. Between two neighbouring roots a, b of G with G > 0 between them,
//     u(s) = (1 - s)^2 a + (1 + s)^2 b,   sqrt(G) = (1 - s^2) sqrt(H(u)),   -1 <= s <= 1,
// so that both sheets together are one closed branch, smooth where they meet, through nodes and cusps too. Where G has
// no real root u runs once round the line. Which of these there are, and the multiplicities of the roots of D, decide
// the topology (docs/curves.md has the cases).
#pragma once

#include <optional>
#include <vector>

#include "burmester/geometry/cubic_pencil.hpp"
#include "burmester/geometry/curve.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/local_form.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

/// Points as x P + y Qi + z Qj. Beside P these coordinates keep the digits that x P + .. loses.
template <class T>
struct BranchFrame {
  Point2<T> base;
  int i = 0, j = 1;

  template <class X>
  Point2<X> placed(const Point2<X>& seen) const {
    Point2<X> out(seen[0] * X(base[0]), seen[0] * X(base[1]), seen[0] * X(base[2]));
    out[i] += seen[1], out[j] += seen[2];
    return out;
  }
  /// N between such points and their partners.
  Matrix<T, 3, 3> seen(const Matrix<T, 3, 3>& n) const {
    Matrix<T, 3, 3> out;
    for (int m = 0; m < 3; ++m) {
      out(0, m) = base[0] * n(0, m) + base[1] * n(1, m) + base[2] * n(2, m);
      out(1, m) = n(i, m), out(2, m) = n(j, m);
    }
    return out;
  }
};

/// What it takes to evaluate a branch.
template <class T>
struct BranchForms {
  BranchFrame<T> frame;
  BinaryForm<T> a, b, c;             ///< of degree n, n + 1, n + 2
  BinaryForm<T> factor, under_root;  ///< S and G, or S and H
  std::vector<LocalForm<T>> dips;    ///< under_root where it nearly vanishes twice: the curve nearly meets itself
  std::array<Point1<T>, 3> u;        ///< where the sheets meet a, b and a + b; of a line its direction
  std::array<double, 3> sizes{};     ///< of a, b, c: sums of |coefficients|, that of c not far below that of b
  T across{};                        ///< the determinant of b and a, exact where they nearly are the same or opposite
  bool turns = false;                ///< the sheets meet at s = -1 and s = 1
  bool line = false;                 ///< a line through the base: X = (1 - s^2) P + 2 s q(u[0])

  Point2<T> operator()(const T& s, int sheet) const { return frame.placed(seen(s, sheet)); }
  /// u(s), to all digits of each coordinate: no term cancels another.
  Point1<T> line_at(const T& s) const;
  /// In the frame.
  Point2<T> seen(const T& s, int sheet) const;
  /// The same; X: T or, over intervals, a jet of them. To the line:
  template <class X>
  Point2<X> on_line(const X& s) const;
  /// Elsewhere: u(s) and 1 - s^2, both over the same positive number.
  template <class X>
  Point2<X> on_sheet(const Point1<X>& u_of_s, const X& rest, int sheet) const;
};

/// A closed branch: up to two passages over -1 <= s <= 1, each on one sheet.
struct CubicBranch {
  struct Passage {
    int sheet = 1;
    bool backwards = false;
  };
  int component = 0;
  std::vector<Passage> passages;  ///< none: its turning points are the same in doubles, and it cannot be traced
  BranchForms<double> approximate;
  BranchForms<Interval> enclosing;
};

struct CubicBranches {
  CurveTopology topology;
  std::vector<CubicBranch> branches;
  BranchFrame<Interval> frame;           ///< of all branches
  std::optional<Point2<Rational>> base;  ///< of the frame, where it comes from rationals
};

/// For curves without singular points; nothing where the intervals cannot prove that there are none, or tell the rest.
/// Below an UpwardRounding. on_curve: encloses a point of the curve.
std::optional<CubicBranches> branches_by_intervals(const Cubic<Interval>& f, const Point2<Interval>& on_curve);

/// For all cubics but those that are singular at on_curve (rung none, with that reason) and the zero form (the same).
CubicBranches branches_by_rationals(const Cubic<Rational>& f, const Point2<Rational>& on_curve);

/// A line for itself. Below an UpwardRounding.
CubicBranch line_branch(const LinearForm<Rational>& line, int component);

/// By intervals where they can tell, else by rationals.
CubicBranches branches_of(const Cubic<Rational>& f, const Point2<Rational>& on_curve);

}  // namespace burmester
