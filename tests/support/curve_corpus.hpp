// Plane curves whose topology is known by construction: what every route to a curve's topology is tested with.
//
// The numbers follow from the equations, as the comments say; nothing here was found by the code under test.
// Moved copies (`moved`) are the same curves in other coordinates of the projective plane, integer ones of
// determinant 1, so that all numbers but those at infinity stay.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "burmester/geometry/plane_curve.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester::corpus {

struct CorpusCurve {
  std::string name;
  PlaneCurve curve;
  int components = 0, ovals = 0, isolated = 0;  ///< as in CurveTopology
  int crossings = 0, cusps = 0, points = 0;     ///< singular points by kind; points: isolated ones
  int lines = 0, conics = 0;                    ///< real ones that split off
  /// A smooth point with integer coordinates: each cubic that has a rational one.
  std::optional<Point2<double>> on_curve = std::nullopt;
  bool repeated = false;  ///< a factor occurs more than once
};

// ---- Building blocks ----

inline PlaneCurve line(double a, double b, double c) { return PlaneCurve(LinearForm<double>(a, b, c)); }
/// xx x^2 + yy y^2 + zz z^2 + yz y z + xz x z + xy x y
inline PlaneCurve conic(double xx, double yy, double zz, double yz = 0, double xz = 0, double xy = 0) {
  return PlaneCurve(Conic<double>({xx, yy, zz, yz, xz, xy}));
}
inline PlaneCurve circle(double x, double y, double radius) {
  return conic(1, 1, x * x + y * y - radius * radius, -2 * y, -2 * x);
}
inline PlaneCurve power(const PlaneCurve& f, int n) { return n == 1 ? f : f * power(f, n - 1); }

/// y^2 z = x^3 + a x^2 z + b x z^2 + c z^3. One branch; besides it an oval where the cubic in x has three real roots.
inline PlaneCurve weierstrass(double a, double b, double c) {
  PlaneCurve f(3);
  f(0, 2) = 1, f(3, 0) = -1, f(2, 0) = -a, f(1, 0) = -b, f(0, 0) = -c;
  return f;
}
/// (x^2 + y^2) (p x + q y) + z (xx x^2 + xy x y + yy y^2) + z^2 (u x + v y) + w z^3; (q : -p : 0) is on it.
inline PlaneCurve circular_cubic(double p, double q, double xx, double xy, double yy, double u, double v,
                                 double w) {
  return conic(1, 1, 0) * line(p, q, 0) + line(0, 0, 1) * conic(xx, yy, w, v, u, xy);
}

/// A four-bar linkage. Ground pivots (0, 0) and (ground, 0), cranks of these lengths; in the coupler's own
/// coordinates its pins are (0, 0) and (coupler, 0), and (s, t) is the point that draws the curve.
struct FourBar {
  double ground, crank, coupler, rocker, s, t;
};

/// The sextic of the coupler point: both cranks have their lengths, two equations A cos + B sin = K for the
/// coupler's angle, and cos^2 + sin^2 = 1 (S. Roberts, "On three-bar motion in plane space", 1875). Exact for
/// small integer data.
template <class T = double>
TernaryForm<T> coupler_curve(const FourBar& l) {
  const auto linear = [](double a, double b, double c) {
    return TernaryForm<T>(LinearForm<T>(T(a), T(b), T(c)));
  };
  const auto quadratic = [](double zz, double xz) {
    return TernaryForm<T>(Conic<T>({T(1), T(1), T(zz), T(0), T(xz), T(0)}));
  };
  const double g = l.ground, s = l.s, t = l.t, r = l.s - l.coupler;
  const TernaryForm<T> a1 = linear(s, t, 0), b1 = linear(-t, s, 0), a2 = linear(r, t, -r * g),
                       b2 = linear(-t, r, t * g);
  const TernaryForm<T> k1 = quadratic(s * s + t * t - l.crank * l.crank, 0);
  const TernaryForm<T> k2 = quadratic(g * g + r * r + t * t - l.rocker * l.rocker, -2 * g);
  const TernaryForm<T> u = k1 * b2 + k2 * b1 * T(-1), v = a1 * k2 + a2 * k1 * T(-1);
  const TernaryForm<T> d = (a1 * b2 + a2 * b1 * T(-1)) * linear(0, 0, 1) * T(2);
  return u * u + v * v + d * d * T(-1);
}

/// F. Grashof: the shortest bar can turn fully, and the linkage has two circuits, iff it and the longest are
/// together shorter than the other two.
inline bool grashof(const FourBar& l) {
  const double longest = std::max({l.ground, l.crank, l.coupler, l.rocker});
  const double shortest = std::min({l.ground, l.crank, l.coupler, l.rocker});
  return 2 * (longest + shortest) < l.ground + l.crank + l.coupler + l.rocker;
}

// ---- Other coordinates ----

struct ProjectiveMap {
  Matrix<double, 3, 3> matrix, inverse;
};
/// Determinant 1, integer entries up to 3.
inline ProjectiveMap random_projective_map(Random& random) {
  Matrix<double, 3, 3> lower = Matrix<double, 3, 3>::Identity(), upper = lower;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j) lower(i, j) = random.below(3) - 1, upper(j, i) = random.below(3) - 1;
  ProjectiveMap out{lower * upper, {}};
  for (int i = 0; i < 3; ++i) {
    const Vector<double, 3> a = out.matrix.col((i + 1) % 3), b = out.matrix.col((i + 2) % 3);
    out.inverse.row(i) = a.cross(b);
  }
  return out;
}
inline CorpusCurve moved(CorpusCurve c, const ProjectiveMap& map) {
  c.curve = c.curve.substituted(map.matrix);
  if (c.on_curve) c.on_curve = map.inverse * *c.on_curve;
  c.name += ", moved";
  return c;
}

// ---- The curves ----

inline std::vector<CorpusCurve> corpus_cubics() {
  const Point2<double> up(0, 1, 0);
  const double tiny = 0x1p-40;
  const PlaneCurve x = line(1, 0, 0), y = line(0, 1, 0), z = line(0, 0, 1);
  return {
      {"oval and branch: y^2 = x (x - 1) (x + 1)", weierstrass(0, -1, 0), 2, 1, 0, 0, 0, 0, 0, 0, up},
      {"branch: y^2 = x (x^2 + 1)", weierstrass(0, 1, 0), 1, 0, 0, 0, 0, 0, 0, 0, up},
      {"node: y^2 = x^2 (x + 1)", weierstrass(1, 0, 0), 1, 0, 0, 1, 0, 0, 0, 0, up},
      {"isolated point: y^2 = x^2 (x - 1)", weierstrass(-1, 0, 0), 2, 0, 1, 0, 0, 1, 0, 0, up},
      {"cusp: y^2 = x^3", weierstrass(0, 0, 0), 1, 0, 0, 0, 1, 0, 0, 0, up},
      // The double root of the cubic in x splits into two real ones (oval) or two complex ones.
      {"node opened to an oval", weierstrass(1, 0, -tiny), 2, 1, 0, 0, 0, 0, 0, 0, up},
      {"node opened to a branch", weierstrass(1, 0, tiny), 1, 0, 0, 0, 0, 0, 0, 0, up},
      {"isolated point grown to an oval", weierstrass(-1, 0, tiny), 2, 1, 0, 0, 0, 0, 0, 0, up},
      {"isolated point vanished", weierstrass(-1, 0, -tiny), 1, 0, 0, 0, 0, 0, 0, 0, up},
      {"cusp opened to an oval", weierstrass(0, -tiny, 0), 2, 1, 0, 0, 0, 0, 0, 0, up},
      {"cusp opened to a branch", weierstrass(0, tiny, 0), 1, 0, 0, 0, 0, 0, 0, 0, up},
      // Circular cubics x (x^2 + y^2) = quadratic form: its two lines are the tangents at the origin, real
      // and distinct, equal, or complex.
      {"strophoid", circular_cubic(1, 0, 1, 0, -1, 0, 0, 0), 1, 0, 0, 1, 0, 0, 0, 0, Point2<double>(0, 1, 0)},
      {"cissoid", circular_cubic(1, 0, 0, 0, -1, 0, 0, 0), 1, 0, 0, 0, 1, 0, 0, 0, Point2<double>(0, 1, 0)},
      {"conchoid with isolated point", circular_cubic(1, 0, -2, 0, -1, 0, 0, 0), 2, 0, 1, 0, 0, 1, 0, 0,
       Point2<double>(0, 1, 0)},
      // y^2 = -(x - 1) (x - 2) (x + 3) / x and y^2 = -(x^3 + x + 1) / x: positive from -3 to 0 and from 1 to
      // 2; from the only real root to 0.
      {"circular, oval and branch", circular_cubic(1, 0, 0, 0, 0, -7, 0, 6), 2, 1, 0, 0, 0, 0, 0, 0,
       Point2<double>(0, 1, 0)},
      {"circular, branch", circular_cubic(1, 0, 0, 0, 0, 1, 0, 1), 1, 0, 0, 0, 0, 0, 0, 0,
       Point2<double>(0, 1, 0)},
      {"line and circle, secant", y * circle(0, 0, 1), 1, 0, 0, 2, 0, 0, 1, 1, Point2<double>(2, 0, 1)},
      {"line and circle, tangent", line(0, 1, -1) * circle(0, 0, 1), 1, 0, 0, 1, 0, 0, 1, 1,
       Point2<double>(1, 1, 1)},
      {"line and circle, apart", line(0, 1, -2) * circle(0, 0, 1), 2, 1, 0, 0, 0, 0, 1, 1,
       Point2<double>(1, 2, 1)},
      {"line and circle, almost tangent", line(0, 1, -1 + tiny) * circle(0, 0, 1), 1, 0, 0, 2, 0, 0, 1, 1,
       Point2<double>(1, 0, 0)},
      {"line at infinity and circle", z * circle(1, 2, 3), 2, 1, 0, 0, 0, 0, 1, 1, Point2<double>(1, 0, 0)},
      {"line and imaginary conic", x * conic(1, 1, 1), 1, 0, 0, 0, 0, 0, 1, 1, Point2<double>(0, 1, 0)},
      {"line and complex lines, point off the line", line(1, 0, -1) * conic(1, 1, 0), 2, 0, 1, 0, 0, 1, 1, 1,
       Point2<double>(1, 0, 1)},
      // Both derivatives vanish where the two complex lines meet on the real one: two half-branches.
      {"line and complex lines, concurrent", x * conic(1, 1, 0), 1, 0, 0, 0, 1, 0, 1, 1,
       Point2<double>(0, 1, 0)},
      {"triangle", x * y * line(1, 1, -1), 1, 0, 0, 3, 0, 0, 3, 0, Point2<double>(0, 2, 1)},
      {"three lines, concurrent", x * y * line(1, 1, 0), 1, 0, 0, 1, 0, 0, 3, 0, Point2<double>(0, 1, 0)},
      {"irrational lines and a line", conic(1, -2, 0) * line(1, 2, 3), 1, 0, 0, 3, 0, 0, 3, 0,
       Point2<double>(-3, 0, 1)},
      // x^3 - 3 x y^2 + y^3: three real slopes, none rational; x^3 - 2 y^3: one real slope, irrational.
      {"three conjugate lines",
       power(x, 3) + x * power(y, 2) * -3.0 + power(y, 3),
       1,
       0,
       0,
       1,
       0,
       0,
       3,
       0,
       {}},
      {"a real and two complex lines, conjugate",
       power(x, 3) + power(y, 3) * -2.0,
       1,
       0,
       0,
       0,
       1,
       0,
       1,
       1,
       {}},
      {"double line", power(x, 2) * y, 1, 0, 0, 1, 0, 0, 2, 0, Point2<double>(1, 0, 0), true},
      {"triple line", power(line(1, 2, 3), 3), 1, 0, 0, 0, 0, 0, 1, 0, {}, true},
  };
}

inline std::vector<CorpusCurve> corpus_conics_and_lines() {
  return {
      {"line", line(1, 2, 3), 1, 0, 0, 0, 0, 0, 1, 0},
      {"circle", circle(1, 2, 3), 1, 1, 0, 0, 0, 0, 0, 1},
      {"hyperbola", conic(0, 0, -1, 0, 0, 1), 1, 1, 0, 0, 0, 0, 0, 1},
      {"parabola", conic(1, 0, 0, -1), 1, 1, 0, 0, 0, 0, 0, 1},
      {"imaginary conic", conic(1, 2, 3), 0, 0, 0, 0, 0, 0, 0, 1},
      {"complex lines", conic(1, 2, 0), 1, 0, 1, 0, 0, 1, 0, 1},
      {"two lines", conic(1, -1, 0), 1, 0, 0, 1, 0, 0, 2, 0},
      {"two irrational lines", conic(1, -2, 0), 1, 0, 0, 1, 0, 0, 2, 0},
      {"double line", power(line(1, 2, 3), 2), 1, 0, 0, 0, 0, 0, 1, 0, {}, true},
  };
}

inline std::vector<CorpusCurve> corpus_quartics() {
  const PlaneCurve x = line(1, 0, 0), y = line(0, 1, 0), z = line(0, 0, 1), z4 = power(z, 4);
  const PlaneCurve ellipses = conic(1, 4, -4) * conic(4, 1, -4);
  const auto cassini = [&](double b4) { return circle(1, 0, 0) * circle(-1, 0, 0) + z4 * -b4; };
  return {
      // Two ellipses with four crossings; the product is -1/8 within the four lenses, 1/8 within both and around both.
      {"two ellipses", ellipses, 1, 0, 0, 4, 0, 0, 0, 2},
      {"four ovals", ellipses + z4 * 0.125, 4, 4},
      {"nested ovals", ellipses + z4 * -0.125, 2, 2},
      {"Trott's curve", conic(144, 144, -225) * conic(1, 1, 0) + z4 * 81.0 + power(x * y, 2) * 62.0, 4, 4},
      {"no real point", power(x, 4) + power(y, 4) + z4},
      {"Klein's quartic", power(x, 3) * y + power(y, 3) * z + power(z, 3) * x, 1, 1},
      {"isolated point", power(x, 4) + power(y, 4) + conic(1, 1, 0) * power(z, 2), 1, 0, 1, 0, 0, 1},
      // Product of the distances to (1, 0) and (-1, 0) is b^2.
      {"Cassini's ovals, b < 1", cassini(0.75), 2, 2},
      {"Cassini's oval, b > 1", cassini(1.25), 1, 1},
      {"Cassini's ovals, 1 - b^4 = 2^-40", cassini(1 - 0x1p-40), 2, 2},
      {"lemniscate", cassini(1), 1, 0, 0, 1},
      {"deltoid", power(conic(1, 1, 9), 2) + z4 * -108.0 + x * conic(1, -3, 0) * z * -8.0, 1, 0, 0, 0, 3},
      {"cardioid", power(conic(1, 1, 0, 0, -2), 2) + conic(1, 1, 0) * power(z, 2) * -4.0, 1, 0, 0, 0, 1},
      {"two circles, tangent", circle(0, 0, 1) * circle(2, 0, 1), 1, 0, 0, 1, 0, 0, 0, 2},
      {"two circles, concentric", circle(0, 0, 1) * circle(0, 0, 2), 2, 2, 0, 0, 0, 0, 0, 2},
      {"conic and two complex lines", conic(1, 4, 0) * conic(4, 1, -4), 2, 1, 1, 0, 0, 1, 0, 2},
      {"conic and two irrational lines", conic(1, 1, -1) * conic(1, -2, 0), 1, 0, 0, 5, 0, 0, 2, 1},
      {"double circle", power(circle(1, 2, 3), 2), 1, 1, 0, 0, 0, 0, 0, 1, {}, true},
      {"singular but smooth to the eye: y^3 = x^4", power(y, 3) * z + power(x, 4) * -1.0, 1, 0, 0, 0, 1},
      // y z = +-i x^2: two complex conics that touch in two real points.
      {"two complex conics", power(y * z, 2) + power(x, 4), 2, 0, 2, 0, 0, 2},
      // (x^2 - z^2)^2 = 2 y^4: x^2 - z^2 = +-sqrt(2) y^2, two hyperbola-like conics that touch at (1 : 0 : +-1).
      {"two irrational conics", power(conic(1, 0, -1), 2) + power(y, 4) * -2.0, 1, 0, 0, 2},
  };
}

inline std::vector<CorpusCurve> corpus_quintics_and_sextics() {
  const PlaneCurve x = line(1, 0, 0), y = line(0, 1, 0), z = line(0, 0, 1);
  return {
      {"Fermat's quintic", power(x, 5) + power(y, 5) + power(z, 5) * -1.0, 1, 0},
      // The circle crosses the branch twice and not the oval, which lies inside.
      {"cubic with oval, and a circle", weierstrass(0, -1, 0) * circle(0, 0, 3), 2, 1, 0, 2, 0, 0, 0, 1},
      {"Fermat's sextic", power(x, 6) + power(y, 6) + power(z, 6) * -1.0, 1, 1},
      {"three circles, two nested", circle(0, 0, 2) * circle(0, 0, 1) * circle(5, 0, 1), 3, 3, 0, 0, 0, 0, 0,
       3},
      // r = |sin 2 phi|: four leaves, eight half-branches at the origin.
      {"four-leaved rose", power(conic(1, 1, 0), 3) + power(x * y * z, 2) * -4.0, 1, 0, 0, 1},
      {"astroid", power(conic(1, 1, -1), 3) + power(x * y * z, 2) * 27.0, 1, 0, 0, 0, 4},
  };
}

/// Cubics with their numbers of real roots chosen, moved at random; the name tells the curve.
inline CorpusCurve random_cubic(const std::string& name) {
  Random random(name);
  const auto integer = [&random] { return random.below(21) - 10; };
  CorpusCurve c{name, PlaneCurve(3), 1, 0, 0, 0, 0, 0, 0, 0, Point2<double>(0, 1, 0)};
  const double p = integer(), q = p + 1 + random.below(5), r = q + 1 + random.below(5),
               s = 1 + random.below(9);
  if (random.below(2) == 0) {  // (x - p) (x - q) (x - r)
    c.curve = weierstrass(-p - q - r, p * q + q * r + r * p, -p * q * r);
    c.components = 2, c.ovals = 1;
  } else {  // (x - p) ((x - q)^2 + s)
    c.curve = weierstrass(-p - 2 * q, q * q + s + 2 * p * q, -p * (q * q + s));
  }
  return moved(c, random_projective_map(random));
}

/// A circular cubic with random integer coefficients and its real point at infinity. Its topology is not known.
inline CorpusCurve random_circular_cubic(const std::string& name) {
  Random random(name);
  double c[8];
  for (double& k : c) k = random.below(201) - 100;
  if (c[0] == 0) c[0] = 1;
  return {name,
          circular_cubic(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]),
          0,
          0,
          0,
          0,
          0,
          0,
          0,
          0,
          Point2<double>(c[1], -c[0], 0)};
}

/// A form with random integer coefficients up to 100: almost surely smooth. Its topology is not known.
inline PlaneCurve random_form(Random& random, int degree) {
  PlaneCurve f(degree);
  for (int k = 0; k < f.size(); ++k) f.coefficients[static_cast<std::size_t>(k)] = random.below(201) - 100;
  return f;
}

/// Everything with known topology.
inline std::vector<CorpusCurve> curve_corpus() {
  std::vector<CorpusCurve> out = corpus_cubics();
  for (const auto& more : {corpus_conics_and_lines(), corpus_quartics(), corpus_quintics_and_sextics()})
    out.insert(out.end(), more.begin(), more.end());
  for (int i = 0; i < 10; ++i) out.push_back(random_cubic("curve_corpus.random_cubic." + std::to_string(i)));
  return out;
}

}  // namespace burmester::corpus
