#include "burmester/spherical/five_pose_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "burmester/geometry/real_roots.hpp"

namespace burmester::spherical {
namespace {

using Poly = IntegerPolynomial;
template <class T>
using Triple = std::array<T, 3>;
using Integers = Triple<Integer>;

template <class A, class B>
auto dot(const Triple<A>& a, const Triple<B>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}
template <class T>
T determinant(const Triple<T>& a, const Triple<T>& b, const Triple<T>& c) {
  return dot(a, cross(b, c));
}
template <class T>
bool is_zero(const Triple<T>& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

struct IntegerQuaternion {
  Integer w;
  Integers v;
};

/// The quaternion times a power of two.
IntegerQuaternion integers(const Pose& pose) {
  const double q[4] = {pose.w, pose.x, pose.y, pose.z};
  int least = std::numeric_limits<int>::max();
  for (const double x : q)
    if (int e = 0; x != 0) std::frexp(x, &e), least = std::min(least, e);
  const auto whole = [&](double x) {
    int e = 0;
    const double digits = std::ldexp(std::frexp(x, &e), 53);
    return x == 0 ? Integer(0) : Integer(Integer(digits) << (e - least));
  };
  return {whole(q[0]), {whole(q[1]), whole(q[2]), whole(q[3])}};
}

/// q conj(p)
IntegerQuaternion turn(const IntegerQuaternion& p, const IntegerQuaternion& q) {
  const Integers across = cross(p.v, q.v);
  IntegerQuaternion out{p.w * q.w + dot(p.v, q.v), {}};
  for (std::size_t i = 0; i < 3; ++i) out.v[i] = p.w * q.v[i] - q.w * p.v[i] + across[i];
  return out;
}

/// Moving axes are a = frame (x, 1, t): so that no axis is special, neither of a task nor of the coordinates.
constexpr int frame[3][3] = {{3, 1, -2}, {1, 4, 1}, {-1, 2, 5}};

/// a^T N b = 0 as (x, 1, t) . (row[0] . b, row[1] . b, row[2] . b): row[0] x + row[1] + row[2] t = displacement of a.
using Condition = Triple<Integers>;

Condition condition_of(const IntegerQuaternion& r) {
  const auto& [c, s] = r;
  const Integer ss = dot(s, s);
  Condition N;  // c s . (a x b) + (a . s) (b . s) - s . s (a . b)
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    N[i][i] = s[i] * s[i] - ss;
    N[i][j] = c * s[k] + s[i] * s[j];
    N[i][k] = s[i] * s[k] - c * s[j];
  }
  Condition out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out[i][k] = frame[0][i] * N[0][k] + frame[1][i] * N[1][k] + frame[2][i] * N[2][k];
  return out;
}

struct Task {
  std::array<IntegerQuaternion, 4> turns;  ///< from the first pose
  std::array<Condition, 4> N;
  explicit Task(FivePoses poses) {
    const IntegerQuaternion first = integers(poses[0]);
    for (std::size_t j = 0; j < 4; ++j) turns[j] = turn(first, integers(poses[j + 1])), N[j] = condition_of(turns[j]);
  }
};

Poly linear(const Integer& constant, const Integer& slope) { return Poly({constant, slope}); }

/// row[1] + row[2] t
Triple<Poly> constant_part(const Condition& N) {
  return {linear(N[1][0], N[2][0]), linear(N[1][1], N[2][1]), linear(N[1][2], N[2][2])};
}
Triple<Poly> polynomials(const Integers& v) { return {Poly({v[0]}), Poly({v[1]}), Poly({v[2]})}; }

Triple<Rational> value(const Triple<Poly>& p, const Rational& t) { return {p[0](t), p[1](t), p[2](t)}; }

Vector<Quad, 3> unit_vector(const Triple<Rational>& v) {
  Rational size = 0;
  for (const Rational& x : v) size = std::max(size, Rational(abs(x)));
  Vector<Quad, 3> out;
  for (int i = 0; i < 3; ++i) {
    const Rational scaled = v[static_cast<std::size_t>(i)] / size;
    out[i] = static_cast<Quad>(Integer((numerator(scaled) << 200) / denominator(scaled)));
  }
  return out / sqrt(out.squaredNorm());
}

/// A moving axis given by (x, 1, t), in the first pose, and its fixed axis.
ExactDyad dyad(const Rational& x, const Rational& t, const Triple<Rational>& b, const Pose& first) {
  Triple<Rational> a;
  for (std::size_t i = 0; i < 3; ++i) a[i] = frame[i][0] * x + frame[i][1] + frame[i][2] * t;
  ExactDyad out;
  const Vector<Quad, 3> in_S = unit_vector(a);
  out.fixed = unit_vector(b);
  out.arc = atan2(sqrt(in_S.cross(out.fixed).squaredNorm()), in_S.dot(out.fixed));
  const Vector<Quad, 3> in_E = Space::act<Quad>(Space::conjugate<Quad>(Space::point<Quad>(first)), in_S);
  out.moving = in_E / sqrt(in_E.squaredNorm());
  return out;
}

Polynomial<Rational> rational(const Poly& p) {
  return Polynomial<Rational>(std::vector<Rational>(p.coefficients().begin(), p.coefficients().end()));
}

/// dyad_at(t): the dyad of a root known to 200 bits.
template <class DyadAt>
void add_real_dyads(ExactFivePoses& out, DyadAt dyad_at) {
  if (out.eliminant.degree() < 1) return;
  for (RealRoot& root : real_roots_exactly(rational(out.eliminant))) {
    root.refine(Rational(Integer(1), Integer(1) << 240));
    const RationalInterval box = root.bounds();
    ExactDyad found = dyad_at(Rational((box.low() + box.high()) / 2));
    found.multiplicity = root.multiplicity();
    out.real.push_back(found);
  }
}

/// x b = P b / det, c . b = 0.
struct Elimination {
  Triple<Poly> c;
  Triple<Triple<Poly>> P;
  Integer det;

  explicit Elimination(const Task& task) {
    std::array<Integer, 4> minor;  // of the coefficients of x b, without row i, with its sign
    std::size_t best = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto row = [&](std::size_t k) -> const Integers& { return task.N[k < i ? k : k + 1][0]; };
      minor[i] = determinant(row(0), row(1), row(2));
      if (i % 2 == 1) minor[i] = -minor[i];
      if (abs(minor[i]) > abs(minor[best])) best = i;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Triple<Poly> rest = constant_part(task.N[i]);
      for (std::size_t k = 0; k < 3; ++k) c[k] = c[k] + rest[k] * minor[i];
    }
    const auto kept = [&](std::size_t k) -> const Condition& { return task.N[k < best ? k : k + 1]; };
    det = determinant(kept(0)[0], kept(1)[0], kept(2)[0]);
    for (std::size_t j = 0; j < 3; ++j) {  // column j of the adjugate times row j of the rest
      const Integers column = cross(kept((j + 1) % 3)[0], kept((j + 2) % 3)[0]);
      const Triple<Poly> rest = constant_part(kept(j));
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t k = 0; k < 3; ++k) P[r][k] = P[r][k] - rest[k] * column[r];
    }
  }

  Triple<Poly> times(const Triple<Poly>& f) const {  // f P
    Triple<Poly> out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = f[0] * P[0][k] + f[1] * P[1][k] + f[2] * P[2][k];
    return out;
  }
  Poly eliminant() const {
    const Poly sextic = determinant(c, times(c), times(times(c)));
    return sextic.is_zero() ? sextic : primitive_part(sextic);
  }
};

/// A cubic in x whose coefficient of x^i is a polynomial in t.
using Cubic = std::array<Poly, 4>;

/// det of the displacements of a in three poses: zero where a is a circle axis of these and the first pose.
Cubic cone(const Condition& first, const Condition& second, const Condition& third) {
  Cubic out;
  const Condition* const N[3] = {&first, &second, &third};
  for (unsigned choice = 0; choice < 8; ++choice) {  // the part with x or the other, of each
    Triple<Poly> row[3];
    std::size_t power = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const bool with_x = choice >> i & 1u;
      row[i] = with_x ? polynomials((*N[i])[0]) : constant_part(*N[i]);
      power += with_x;
    }
    out[power] = out[power] + determinant(row[0], row[1], row[2]);
  }
  return out;
}

/// Bezout's matrix of two cubics: its null vector is (1, x, x^2) at a common root x.
Triple<Triple<Poly>> bezout(const Cubic& f, const Cubic& g) {
  const auto m = [&](std::size_t i, std::size_t j) { return f[i] * g[j] - f[j] * g[i]; };
  const Poly corner = m(2, 0);
  return {{{m(1, 0), corner, m(3, 0)}, {corner, m(3, 0) + m(2, 1), m(3, 1)}, {m(3, 0), m(3, 1), m(3, 2)}}};
}

/// p divided by the linear factor that vanishes where the line of `axis` is (x, 1, t). Precondition: it divides p.
Poly without(const Poly& p, const Integers& axis) {
  const Integers column[3] = {{frame[0][0], frame[1][0], frame[2][0]},
                              {frame[0][1], frame[1][1], frame[2][1]},
                              {frame[0][2], frame[1][2], frame[2][2]}};
  const Integer one = determinant(column[0], axis, column[2]), t = determinant(column[0], column[1], axis);
  std::vector<Rational> quotient(static_cast<std::size_t>(p.degree()));
  const Rational root(t, one);
  Rational carry = 0;
  for (int k = p.degree(); k > 0; --k) quotient[static_cast<std::size_t>(k - 1)] = carry = carry * root + p[k];
  return integer_multiple(Polynomial<Rational>(quotient));
}

template <class Solve>
SphericalReport report_by(std::span<const Pose> poses, Solve solve) {
  const ExactFivePoses exact = solve(poses.first<5>());
  if (exact.eliminant.is_zero()) {
    SphericalReport report;
    report.status = Status::degenerate;
    report.message = "infinitely many dyads";
    return report;
  }
  std::vector<RR::Design> real;
  for (const ExactDyad& found : exact.real) real.push_back(found.rounded());
  return report_of(real, poses);
}

}  // namespace

RR::Design ExactDyad::rounded() const {
  const auto near = [](const Vector<Quad, 3>& v) {
    return Axis(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  return {near(fixed), near(moving), static_cast<double>(arc)};
}

ExactFivePoses exact_by_elimination(FivePoses poses) {
  const Elimination elimination{Task(poses)};
  ExactFivePoses out{elimination.eliminant(), {}};
  add_real_dyads(out, [&](const Rational& t) {
    const Triple<Rational> c = value(elimination.c, t);
    const Triple<Triple<Rational>> P{value(elimination.P[0], t), value(elimination.P[1], t),
                                     value(elimination.P[2], t)};
    Triple<Rational> cP, Pb;
    for (std::size_t k = 0; k < 3; ++k) cP[k] = c[0] * P[0][k] + c[1] * P[1][k] + c[2] * P[2][k];
    const Triple<Rational> b = cross(c, cP);
    for (std::size_t k = 0; k < 3; ++k) Pb[k] = dot(P[k], b);
    return dyad(dot(b, Pb) / (dot(b, b) * elimination.det), t, b, poses[0]);
  });
  return out;
}

std::optional<int> exact_count(FivePoses poses) {
  const Poly eliminant = Elimination(Task(poses)).eliminant();
  if (eliminant.is_zero()) return std::nullopt;
  return static_cast<int>(real_roots(rational(eliminant)).size());
}

ExactFivePoses exact_by_cones(FivePoses poses) {
  const Task task(poses);
  const auto& N = task.N;
  const auto B = bezout(cone(N[0], N[1], N[2]), cone(N[0], N[1], N[3]));
  ExactFivePoses out{determinant(B[0], B[1], B[2]), {}};
  if (out.eliminant.is_zero()) return out;
  const IntegerQuaternion& first = task.turns[0];
  const IntegerQuaternion back{first.w, {-first.v[0], -first.v[1], -first.v[2]}}, &second = task.turns[1];
  const IntegerQuaternion inverse_second{second.w, {-second.v[0], -second.v[1], -second.v[2]}};
  for (const Integers& axis : {first.v, second.v, turn(inverse_second, back).v})
    out.eliminant = without(out.eliminant, axis);
  add_real_dyads(out, [&](const Rational& t) {
    Triple<Rational> powers = cross(value(B[0], t), value(B[1], t));
    if (is_zero(powers)) powers = cross(value(B[0], t), value(B[2], t));
    const Rational x = powers[1] / powers[0];
    const auto displacement = [&](const Condition& n) {
      Triple<Rational> d;
      for (std::size_t k = 0; k < 3; ++k) d[k] = n[0][k] * x + n[1][k] + n[2][k] * t;
      return d;
    };
    return dyad(x, t, cross(displacement(N[0]), displacement(N[1])), poses[0]);
  });
  return out;
}

SphericalReport EliminationOracle::solve(std::span<const Pose> poses) const {
  return report_by(poses, exact_by_elimination);
}
SphericalReport ConesOracle::solve(std::span<const Pose> poses) const { return report_by(poses, exact_by_cones); }

static_assert(Solver<EliminationOracle> && Solver<ConesOracle>);

}  // namespace burmester::spherical
