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

/// Moving axes are a = frame (x, 1, t): no axis of the coordinates is special. The first column is, a centre of
/// projection: behind it dyads hide, so there is more than one frame.
using Frame = std::array<std::array<int, 3>, 3>;
constexpr std::array<Frame, 3> frames{{{{{3, 1, -2}, {1, 4, 1}, {-1, 2, 5}}},
                                       {{{1, -3, 7}, {5, 2, -1}, {2, 6, 3}}},
                                       {{{-4, 5, 1}, {3, 1, 6}, {7, -2, 2}}}}};

/// a^T N b = 0 as (x, 1, t) . (row[0] . b, row[1] . b, row[2] . b): row[0] x + row[1] + row[2] t = displacement of a.
using Condition = Triple<Integers>;

Condition condition_of(const IntegerQuaternion& r, const Frame& frame) {
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
  Frame frame;
  Pose first;
  std::array<IntegerQuaternion, 4> turns;  ///< from the first pose
  std::array<Condition, 4> N;
  Task(FivePoses poses, const Frame& axes) : frame(axes), first(poses[0]) {
    for (std::size_t j = 0; j < 4; ++j) {
      turns[j] = turn(integers(first), integers(poses[j + 1]));
      N[j] = condition_of(turns[j], frame);
    }
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
ExactDyad dyad(const Rational& x, const Rational& t, const Triple<Rational>& b, const Task& task) {
  Triple<Rational> a;
  for (std::size_t i = 0; i < 3; ++i) a[i] = task.frame[i][0] * x + task.frame[i][1] + task.frame[i][2] * t;
  ExactDyad out;
  const Vector<Quad, 3> in_S = unit_vector(a);
  out.fixed = unit_vector(b);
  out.arc = atan2(sqrt(in_S.cross(out.fixed).squaredNorm()), in_S.dot(out.fixed));
  const Vector<Quad, 3> in_E = Space::act<Quad>(Space::conjugate<Quad>(Space::point<Quad>(task.first)), in_S);
  out.moving = in_E / sqrt(in_E.squaredNorm());
  return out;
}

Polynomial<Rational> rational(const Poly& p) {
  return Polynomial<Rational>(std::vector<Rational>(p.coefficients().begin(), p.coefficients().end()));
}

bool is_zero_at(const Triple<Poly>& v, RealRoot& t) {
  return std::all_of(v.begin(), v.end(), [&](const Poly& p) { return sign_at(rational(p), t) == 0; });
}

template <class T>
Rational size_of(const Triple<T>& v) {
  return std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
}

/// x b = P b / det, c . b = 0.
struct Elimination {
  Task task;
  Triple<Poly> c;
  Triple<Triple<Poly>> P;
  Integer det;

  Elimination(FivePoses poses, const Frame& frame) : task(poses, frame) {
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
  /// Whether b is determined, and with it x.
  bool shows(RealRoot& t) const { return !is_zero_at(cross(c, times(c)), t); }
  ExactDyad dyad_at(const Rational& t) const {
    const Triple<Rational> at = value(c, t), b = cross(at, value(times(c), t));
    const Triple<Rational> Pb{dot(value(P[0], t), b), dot(value(P[1], t), b), dot(value(P[2], t), b)};
    return dyad(dot(b, Pb) / (dot(b, b) * det), t, b, task);
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
Poly without(const Poly& p, const Integers& axis, const Frame& frame) {
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

struct Cones {
  Task task;
  Triple<Triple<Poly>> B;

  Cones(FivePoses poses, const Frame& frame) : task(poses, frame) {
    const auto& N = task.N;
    B = bezout(cone(N[0], N[1], N[2]), cone(N[0], N[1], N[3]));
  }

  Poly eliminant() const {
    Poly out = determinant(B[0], B[1], B[2]);
    if (out.degree() < 9) return {};  // one of the nine lines is at infinity, or all are common
    const IntegerQuaternion &first = task.turns[0], &second = task.turns[1];
    const IntegerQuaternion back{first.w, {-first.v[0], -first.v[1], -first.v[2]}};
    const IntegerQuaternion inverse_second{second.w, {-second.v[0], -second.v[1], -second.v[2]}};
    for (const Integers& axis : {first.v, second.v, turn(inverse_second, back).v}) out = without(out, axis, task.frame);
    return out;
  }
  /// Multiples of (1, x, x^2); not all zero where x is determined.
  template <class T>
  static Triple<Triple<T>> powers(const Triple<Triple<T>>& b) {
    return {cross(b[0], b[1]), cross(b[0], b[2]), cross(b[1], b[2])};
  }
  /// Displacement of (x : 1 : t) = (p1 : p0 : p0 t).
  static Triple<Poly> displacement(const Condition& n, const Triple<Poly>& p) {
    const Triple<Poly> rest = constant_part(n);
    return {p[1] * n[0][0] + p[0] * rest[0], p[1] * n[0][1] + p[0] * rest[1], p[1] * n[0][2] + p[0] * rest[2]};
  }
  /// Whether x is determined, and two displacements differ.
  bool shows(RealRoot& t) const {
    for (const Triple<Poly>& p : powers(B))
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
          if (!is_zero_at(cross(displacement(task.N[i], p), displacement(task.N[j], p)), t)) return true;
    return false;
  }
  ExactDyad dyad_at(const Rational& t) const {
    Triple<Rational> best{};
    for (const Triple<Rational>& p : powers<Rational>({value(B[0], t), value(B[1], t), value(B[2], t)}))
      if (size_of(p) > size_of(best)) best = p;
    const Rational x = best[1] / best[0];
    const auto displacement_at = [&](const Condition& n) {
      Triple<Rational> d;
      for (std::size_t k = 0; k < 3; ++k) d[k] = n[0][k] * x + n[1][k] + n[2][k] * t;
      return d;
    };
    Triple<Rational> b{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (const auto across = cross(displacement_at(task.N[i]), displacement_at(task.N[j]));
            size_of(across) > size_of(b))
          b = across;
    return dyad(x, t, b, task);
  }
};

/// One of the two ways, in a frame in which every real root shows one dyad.
template <class Way>
struct Shown {
  Way way;
  Poly eliminant;
  std::vector<RealRoot> roots;
};

template <class Way>
std::optional<Shown<Way>> shown_by(FivePoses poses) {
  for (const Frame& frame : frames) {
    Shown<Way> out{Way(poses, frame), {}, {}};
    out.eliminant = out.way.eliminant();
    if (out.eliminant.degree() < 6) continue;
    out.roots = real_roots(rational(out.eliminant));
    if (std::all_of(out.roots.begin(), out.roots.end(), [&](RealRoot& t) { return out.way.shows(t); })) return out;
  }
  return std::nullopt;
}

/// Roots to 240 bits.
template <class Way>
ExactFivePoses exact_by(FivePoses poses) {
  auto shown = shown_by<Way>(poses);
  if (!shown) return {};
  ExactFivePoses out{shown->eliminant, {}};
  for (RealRoot& root : shown->roots) {
    root.refine(Rational(Integer(1), Integer(1) << 240));
    const RationalInterval box = root.bounds();
    out.real.push_back(shown->way.dyad_at(Rational((box.low() + box.high()) / 2)));
    out.real.back().multiplicity = root.multiplicity();
  }
  return out;
}

template <class Solve>
SphericalReport report_by(std::span<const Pose> poses, Solve solve) {
  const ExactFivePoses exact = solve(poses.first<5>());
  if (exact.eliminant.is_zero()) {
    SphericalReport report;
    report.status = Status::degenerate;
    report.message = "infinitely many dyads, or some that coincide in too many directions";
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

ExactFivePoses exact_by_elimination(FivePoses poses) { return exact_by<Elimination>(poses); }
ExactFivePoses exact_by_cones(FivePoses poses) { return exact_by<Cones>(poses); }

std::optional<int> exact_count(FivePoses poses) {
  const auto shown = shown_by<Elimination>(poses);
  return shown ? std::optional(static_cast<int>(shown->roots.size())) : std::nullopt;
}

SphericalReport EliminationOracle::solve(std::span<const Pose> poses) const {
  return report_by(poses, exact_by_elimination);
}
SphericalReport ConesOracle::solve(std::span<const Pose> poses) const { return report_by(poses, exact_by_cones); }

static_assert(Solver<EliminationOracle> && Solver<ConesOracle>);

}  // namespace burmester::spherical
