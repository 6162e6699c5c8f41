// Five poses in rational arithmetic: an oracle that shares nothing with the direct solver but the family's
// equations.
//
// From the exact data (x, y, X3, X4 of each pose as rationals): the absolute 5 x 8 system Family::row, its
// null space, the two relations on it as conics, their resultant after a random integer change of
// coordinates, and the real roots of that quartic by Sturm's theorem.
#pragma once

#include <optional>
#include <vector>

#include "burmester/geometry/random.hpp"
#include "burmester/planar/family.hpp"
#include "burmester/planar/tasks.hpp"
#include "exact_roots.hpp"

namespace burmester::planar::exact {

using namespace burmester::exact;
using Lifted = Vector<Rational, 8>;  ///< k of planar/family.hpp
using Coefficients = std::vector<Rational>;

/// A multiple of k in coprime integers: fractions of large numbers are slow.
inline Lifted cleared(const Lifted& k) {
  Integer common = 1, content = 0;
  for (int i = 0; i < 8; ++i) common = lcm(common, Integer(denominator(k[i])));
  Lifted out = k * Rational(common);
  for (int i = 0; i < 8; ++i) content = gcd(content, Integer(numerator(out[i])));
  return out / Rational(content);
}

/// Basis of the solutions of rows . k = 0, by elimination, in integers.
inline std::vector<Lifted> null_basis(std::vector<Lifted> rows) {
  std::vector<int> pivot;  // pivot[r]: the column of row r
  for (int c = 0; c < 8; ++c) {
    const std::size_t done = pivot.size();
    std::size_t r = done;
    while (r < rows.size() && rows[r][c] == 0) ++r;
    if (r == rows.size()) continue;
    std::swap(rows[r], rows[done]);
    rows[done] /= Rational(rows[done][c]);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (i != done && rows[i][c] != 0) rows[i] -= Rational(rows[i][c]) * rows[done];
    pivot.push_back(c);
  }
  std::vector<Lifted> basis;
  for (int c = 0; c < 8; ++c) {
    if (std::find(pivot.begin(), pivot.end(), c) != pivot.end()) continue;
    Lifted k = Lifted::Zero();
    k[c] = 1;
    for (std::size_t r = 0; r < pivot.size(); ++r) k[pivot[r]] = -rows[r][c];
    basis.push_back(cleared(k));
  }
  return basis;
}

inline std::vector<Lifted> null_basis(const FivePoseTask& task) {
  std::vector<Lifted> rows;
  for (const Pose& pose : task) rows.push_back(Family::row<Rational>(pose));
  return null_basis(rows);
}

/// A conic a z^2 + b(x) z + c(x) of the plane y = 1: b of degree 1, c of degree 2, constant terms first.
struct PlaneConic {
  Rational a;
  Coefficients b, c;
};

/// Relation number i on x u + v + z w.
inline PlaneConic conic(int i, const Lifted& u, const Lifted& v, const Lifted& w) {
  const auto f = [&](const Lifted& k) { return Rational(Family::relations<Rational>(k)[i]); };
  const auto mixed = [&](const Lifted& k, const Lifted& l) { return Rational(f(k + l) - f(k) - f(l)); };
  return {f(w), {mixed(v, w), mixed(u, w)}, {f(v), mixed(u, v), f(u)}};
}

inline Coefficients product(const Coefficients& p, const Coefficients& q) {
  Coefficients out(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
  return out;
}
/// p q - r s
inline Coefficients minor(const Coefficients& p, const Coefficients& q, const Coefficients& r,
                          const Coefficients& s) {
  Coefficients out = product(p, q);
  const Coefficients other = product(r, s);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] -= other[i];
  return out;
}

/// Both conics vanish at (x, z) only where resultant(x) = 0, and there z = -u(x) / v(x).
struct Eliminated {
  Coefficients u, v, resultant;
};

inline Eliminated eliminate(const PlaneConic& f, const PlaneConic& g) {
  Eliminated out;
  out.u = minor({f.a}, g.c, {g.a}, f.c);
  out.v = minor({f.a}, g.b, {g.a}, f.b);
  out.resultant = minor(out.u, out.u, out.v, minor(f.b, g.c, g.b, f.c));
  return out;
}

struct Plane {
  Lifted u, v, w;  ///< spans the null space; points are x u + v + z w
  Eliminated on;
};

/// The null space in random integer coordinates.
inline Plane random_plane(const std::vector<Lifted>& basis, Random& random) {
  const auto mixed = [&] {
    Lifted k = Lifted::Zero();
    for (const Lifted& b : basis) k += Rational(random.below(1999) - 999) * b;
    return k;
  };
  Plane plane{mixed(), mixed(), mixed(), {}};
  plane.on = eliminate(conic(0, plane.u, plane.v, plane.w), conic(1, plane.u, plane.v, plane.w));
  return plane;
}

/// Number of different roots of the resultant over the complex numbers; 0 where coordinates or resultant are
/// no good.
inline std::size_t different_roots(const Plane& plane) {
  const Polynomial p = polynomial(plane.on.resultant);
  if (p.size() != 5 || p.front() == 0) return 0;
  return p.size() - sturm_chain(p).back().size();
}

/// Of six random planes the first with four different roots, or else the one with most of them: no two common
/// points are seen as one.
inline Plane generic_plane(const std::vector<Lifted>& basis, Random& random) {
  Plane best = random_plane(basis, random);
  std::size_t most = different_roots(best);
  for (int i = 1; i < 6 && most < 4; ++i) {
    Plane plane = random_plane(basis, random);
    if (const std::size_t n = different_roots(plane); n > most) best = std::move(plane), most = n;
  }
  return best;
}

struct Solutions {
  std::size_t dimension = 0;  ///< of the null space
  bool finite = false;        ///< finitely many common points
  RootCount real;             ///< where finite
};

inline Solutions count_solutions(const FivePoseTask& task, Random& random) {
  const std::vector<Lifted> basis = null_basis(task);
  Solutions out{basis.size(), false, {}};
  if (basis.size() != 3) return out;
  const Polynomial p = polynomial(generic_plane(basis, random).on.resultant);
  out.finite = !p.empty();
  if (out.finite) out.real = count_real_roots(p);
  return out;
}

/// The real solutions k, with a relative error of about 2^-bits. Precondition: dimension 3, finitely many,
/// simple.
inline std::vector<Lifted> real_solutions(const FivePoseTask& task, Random& random, int bits) {
  const Plane plane = generic_plane(null_basis(task), random);
  const auto value = [](const Coefficients& p, const Rational& x) {
    Rational sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
    return sum;
  };
  std::vector<Lifted> out;
  for (const Rational& x : real_roots(polynomial(plane.on.resultant), bits))
    out.push_back(value(plane.on.v, x) * (x * plane.u + plane.v) - value(plane.on.u, x) * plane.w);
  return out;
}

}  // namespace burmester::planar::exact
