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

/// What it takes to evaluate a branch.
template <class T>
struct BranchForms {
  Point2<T> base;
  int i = 0, j = 1;
  BinaryForm<T> a, b, c;             ///< of degree n, n + 1, n + 2
  BinaryForm<T> factor, under_root;  ///< S and G, or S and H
  std::vector<LocalForm<T>> dips;    ///< under_root where it nearly vanishes twice: the curve nearly meets itself
  std::array<Point1<T>, 3> u;        ///< u(s) = u[0] + u[1] s + u[2] s^2
  std::array<T, 3> turn;             ///< the same for u0 u1' - u1 u0', exact where u nearly stands still
  bool turns = false;                ///< the sheets meet at s = -1 and s = 1
  std::array<double, 3> sizes{1, 1, 1};  ///< of a, b, c where a is small beside b: the curve is small about the base
  bool line = false;                 ///< a line through the base: X = (1 - s^2) P + 2 s q(u[0])

  Point2<T> operator()(const T& s, int sheet) const;
  /// X: T or, over intervals, a jet of them. To the line:
  template <class X>
  Point2<X> on_line(const X& s) const;
  /// Elsewhere: u(s) and 1 - s^2, both over the same positive number.
  template <class X>
  Point2<X> on_sheet(const Point1<X>& u_of_s, const X& rest, int sheet) const;

 private:
  /// p P + q (along[0] Qi + along[1] Qj)
  template <class X>
  Point2<X> sum(const X& p, const Point1<X>& along, const X& q) const;
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
