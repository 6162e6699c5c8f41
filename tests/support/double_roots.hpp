// Five poses at a known distance from poses with a double dyad, in 50 digits: an oracle for the merge distance that
// shares nothing with the solver but the family's equations.
//
// The 20 data (x, y, X3, X4 per pose) as 50-digit numbers; the absolute 5 x 8 system of planar/family.hpp, its null
// space, the resultant quartic of the two relations in fixed random coordinates, and the quartic's discriminant 4 I^3 -
// J^2 (positive: 0 or 4 real roots, negative: 2). Derivatives by central differences.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <string>

#include "burmester/planar/five_pose_solver.hpp"
#include "exact_five_pose.hpp"

namespace burmester::planar::double_roots {

using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Data = std::array<Float, 20>;
using Lifted = std::array<Float, 8>;

inline Data data_of(const FivePoseTask& task) {
  Data x;
  for (std::size_t j = 0; j < 5; ++j)
    x[4 * j] = task[j].x, x[4 * j + 1] = task[j].y, x[4 * j + 2] = task[j].X3, x[4 * j + 3] = task[j].X4;
  return x;
}
inline FivePoseTask rounded(const Data& x) {
  FivePoseTask task;
  const auto at = [&](std::size_t i) { return static_cast<double>(x[i]); };
  for (std::size_t j = 0; j < 5; ++j) task[j] = {at(4 * j), at(4 * j + 1), at(4 * j + 2), at(4 * j + 3)};
  return task;
}
/// x + t y
inline Data moved(Data x, const Float& t, const Data& y) {
  for (std::size_t i = 0; i < 20; ++i) x[i] += t * y[i];
  return x;
}
inline Data between(const Data& a, const Data& b) { return moved(b, Float(-1), a); }

/// The largest coordinate for places, the norm of the image point for X3 and X4.
inline Data scales(const Data& x) {
  Float reach = 0;
  for (std::size_t j = 0; j < 20; j += 4) reach = std::max({reach, Float(abs(x[j])), Float(abs(x[j + 1]))});
  Data s;
  for (std::size_t j = 0; j < 20; j += 4) {
    s[j] = s[j + 1] = reach;
    s[j + 2] = s[j + 3] = sqrt(Float(x[j + 2] * x[j + 2] + x[j + 3] * x[j + 3]));
  }
  return s;
}

inline Lifted row(const Float* pose) {
  const Float &a = pose[0], &b = pose[1], &s = pose[2], &c = pose[3];
  const Float n = s * s + c * c, cosine = c * c - s * s, sine = 2 * s * c;
  return {n * (a * a + b * b),         2 * n * a, 2 * n * b,  2 * (a * cosine + b * sine),
          2 * (b * cosine - a * sine), n,         2 * cosine, 2 * sine};
}

/// By Gauss-Jordan elimination with complete pivoting.
inline std::array<Lifted, 3> null_basis(const Data& x) {
  std::array<Lifted, 5> m;
  for (std::size_t j = 0; j < 5; ++j) m[j] = row(&x[4 * j]);
  std::array<std::size_t, 8> order{0, 1, 2, 3, 4, 5, 6, 7};  // columns; the first five are pivots
  for (std::size_t k = 0; k < 5; ++k) {
    std::size_t r = k, c = k;
    for (std::size_t i = k; i < 5; ++i)
      for (std::size_t l = k; l < 8; ++l)
        if (abs(m[i][order[l]]) > abs(m[r][order[c]])) r = i, c = l;
    std::swap(m[r], m[k]);
    std::swap(order[c], order[k]);
    const Float pivot = m[k][order[k]];
    for (Float& entry : m[k]) entry /= pivot;
    for (std::size_t i = 0; i < 5; ++i) {
      if (i == k) continue;
      const Float factor = m[i][order[k]];
      for (std::size_t l = 0; l < 8; ++l) m[i][l] -= factor * m[k][l];
    }
  }
  std::array<Lifted, 3> basis;
  for (std::size_t f = 0; f < 3; ++f) {
    basis[f].fill(Float(0));
    basis[f][order[5 + f]] = 1;
    for (std::size_t k = 0; k < 5; ++k) basis[f][order[k]] = -m[k][order[5 + f]];
  }
  return basis;
}

inline std::array<Float, 2> relations(const Lifted& k) {
  return {k[0] * k[6] - k[1] * k[3] - k[2] * k[4], k[0] * k[7] - k[2] * k[3] + k[1] * k[4]};
}

/// Positive where 0 or 4 of the dyads are real, negative where 2 are.
inline Float discriminant(const Data& x) {
  const std::array<Lifted, 3> basis = null_basis(x);
  static constexpr int mix[3][3] = {{7, -3, 5}, {2, 11, -4}, {-6, 1, 9}};
  std::array<Lifted, 3> u;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 8; ++k)
      u[i][k] = mix[i][0] * basis[0][k] + mix[i][1] * basis[1][k] + mix[i][2] * basis[2][k];
  const auto sum = [](const Lifted& p, const Lifted& q) {
    Lifted out = p;
    for (std::size_t k = 0; k < 8; ++k) out[k] += q[k];
    return out;
  };
  // f(x u0 + u1 + z u2) = a z^2 + (b0 + b1 x) z + c0 + c1 x + c2 x^2 for both relations
  const auto f0 = relations(u[0]), f1 = relations(u[1]), f2 = relations(u[2]), f01 = relations(sum(u[0], u[1])),
             f02 = relations(sum(u[0], u[2])), f12 = relations(sum(u[1], u[2]));
  using Poly = std::vector<Float>;
  const auto product = [](const Poly& p, const Poly& q) {
    Poly out(p.size() + q.size() - 1);
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
    return out;
  };
  const auto minor = [&](const Poly& p, const Poly& q, const Poly& r, const Poly& s) {
    Poly out = product(p, q);
    const Poly other = product(r, s);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] -= other[i];
    return out;
  };
  Poly a[2], b[2], c[2];
  for (std::size_t i = 0; i < 2; ++i) {
    a[i] = {f2[i]};
    b[i] = {f12[i] - f1[i] - f2[i], f02[i] - f0[i] - f2[i]};
    c[i] = {f1[i], f01[i] - f0[i] - f1[i], f0[i]};
  }
  const Poly ac = minor(a[0], c[1], a[1], c[0]), ab = minor(a[0], b[1], a[1], b[0]), bc = minor(b[0], c[1], b[1], c[0]);
  Poly q = minor(ac, ac, ab, bc);
  Float largest = 0;
  for (const Float& coefficient : q) largest = std::max(largest, Float(abs(coefficient)));
  for (Float& coefficient : q) coefficient /= largest;
  const Float I = 12 * q[4] * q[0] - 3 * q[3] * q[1] + q[2] * q[2];
  const Float J = 72 * q[4] * q[2] * q[0] + 9 * q[3] * q[2] * q[1] - 27 * q[4] * q[1] * q[1] - 27 * q[0] * q[3] * q[3] -
                  2 * q[2] * q[2] * q[2];
  return 4 * I * I * I - J * J;
}

/// A zero of f between a and b, where f has different signs: bisection, because the resultant also touches zero where
/// two points of the plane have one abscissa, then the Illinois method (G. Dahlquist, A. Bjoerck,
/// "Numerical Methods", 1974).
template <class F>
Float zero_between(Float a, Float b, const F& f) {
  Float fa = f(a), fb = f(b);
  for (int i = 0; i < 300 && fb != 0 && abs(Float(b - a)) > 1e-45; ++i) {
    const Float c = i < 50 ? Float((a + b) / 2) : Float(b - fb * (b - a) / (fb - fa)), fc = f(c);
    if ((fc > 0) != (fb > 0))
      a = b, fa = fb;
    else if (i >= 50)
      fa /= 2;
    const bool still = abs(Float(c - b)) < 1e-45;
    b = c, fb = fc;
    if (still) break;
  }
  return b;
}

/// Poses with a double dyad on the way from one task to another, and how to leave them.
struct DoubleRoot {
  Data at, along;  ///< along: the way through
  Data steepest;   ///< s_i times the sign of the derivative by x_i
  Float rate;      ///< change of the distance to the double root per unit of the way

  DoubleRoot(const FivePoseTask& from, const FivePoseTask& to) : along(between(data_of(from), data_of(to))) {
    const Data start = data_of(from);
    at = moved(start, zero_between(0, 1, [&](const Float& t) { return discriminant(moved(start, t, along)); }), along);
    const Data s = scales(at);
    const Float h = 1e-18;
    Float sum = 0, through = 0;
    for (std::size_t i = 0; i < 20; ++i) {
      Data up = at, down = at;
      up[i] += h * s[i], down[i] -= h * s[i];
      const Float slope = (discriminant(up) - discriminant(down)) / (2 * h);  // by x_i / s_i
      steepest[i] = slope < 0 ? Float(-s[i]) : s[i];
      sum += abs(slope), through += slope * along[i] / s[i];
    }
    rate = through / sum;
  }

  /// The poses at about this distance, rounded to doubles.
  FivePoseTask poses_at(double distance) const { return rounded(moved(at, Float(distance) / rate, along)); }

  /// How far every datum, in its scale, must change along the steepest way until two dyads coincide.
  Float distance(const FivePoseTask& task) const {
    const Data x = data_of(task);
    const auto f = [&](const Float& t) { return discriminant(moved(x, t, steepest)); };
    Float a = 0, b = 1e-17, fa = f(a), fb = f(b);
    for (int i = 0; i < 40 && fb != fa && abs(Float(b - a)) > 1e-32; ++i) {  // secant
      const Float c = b - fb * (b - a) / (fb - fa);
      a = b, fa = fb, b = c, fb = f(c);
    }
    return abs(b);
  }
};

struct Outcome {
  long problems = 0, poses = 0, uncertified = 0, wrong_count = 0, missing = 0, needless = 0, wrong_kind = 0,
       not_bracketed = 0;
  double largest_error = 0;  ///< of the distance stated, relative, where a warning is due

  bool good() const {
    return wrong_count + missing + needless + wrong_kind + uncertified + not_bracketed == 0 && largest_error < 0.01;
  }
  void add(const Outcome& o) {
    problems += o.problems, poses += o.poses, uncertified += o.uncertified, wrong_count += o.wrong_count;
    missing += o.missing, needless += o.needless, wrong_kind += o.wrong_kind, not_bracketed += o.not_bracketed;
    largest_error = std::max(largest_error, o.largest_error);
  }
};

/// One problem: a double root between two random tasks, and poses 1e-6 to 1e-15 from it on both sides.
inline void walk(Random& random, Random& coordinates, Outcome& out) {
  const TaskClass& generic = *find_task_class("generic");
  FivePoseTask from = generic.make(random), to = generic.make(random);
  while ((discriminant(data_of(from)) > 0) == (discriminant(data_of(to)) > 0)) to = generic.make(random);
  const DoubleRoot root(from, to);
  ++out.problems;
  for (const double step : {1e-6, 1e-10, 1e-13, 1e-15}) {
    int count[2];
    PlanarReport report[2];
    double distance[2];
    for (const std::size_t side : {0u, 1u}) {
      const FivePoseTask task = root.poses_at(side ? step : -step);
      distance[side] = static_cast<double>(root.distance(task));
      const exact::Solutions truth = exact::count_solutions(task, coordinates);
      count[side] = truth.real.distinct;
      report[side] = FivePoseSolver().solve(task);
      ++out.poses;
      const bool on_it = truth.real.distinct != truth.real.counted;
      out.uncertified += !report[side].counts.certified && !on_it;
      out.wrong_count += report[side].counts.certified && report[side].counts.real != count[side];
    }
    const bool crossed = count[0] + count[1] == 2 || count[0] + count[1] == 6;
    out.not_bracketed += !crossed && step > 1e-15;  // rounding may cross at the last step
    for (const std::size_t side : {0u, 1u}) {
      const auto& warnings = report[side].warnings;
      const auto says = [&](const char* what) {
        return std::any_of(warnings.begin(), warnings.end(), [&](const auto& w) { return w.find(what) != w.npos; });
      };
      const bool merge = says("two dyads nearly merge"), appear = says("two more dyads nearly exist");
      out.missing += distance[side] < 10 * unit_roundoff && !merge && !appear;
      out.needless += distance[side] > 1000 * unit_roundoff && (merge || appear);
      if (crossed) out.wrong_kind += count[side] < count[1 - side] ? merge : appear;
      if (const auto stated = report[side].counts.merge_distance; stated && distance[side] < 1000 * unit_roundoff)
        out.largest_error = std::max(out.largest_error, std::abs(*stated / distance[side] - 1));
    }
  }
}

}  // namespace burmester::planar::double_roots
