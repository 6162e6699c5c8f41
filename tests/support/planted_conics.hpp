// Pairs of conics with known common points, built in quad precision.
#pragma once

#include <cmath>
#include <vector>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/random.hpp"

namespace burmester {

using QuadPoint = Point2<Quad>;

struct ConicPair {
  Conic<double> a, b;             ///< of size 1, rounded once
  std::vector<QuadPoint> common;  ///< the real common points that were planted
};

inline QuadPoint random_point(Random& random) {
  return {Quad(random.normal()), Quad(random.normal()), Quad(random.normal())};
}

inline Conic<Quad> line_pair(const QuadPoint& l, const QuadPoint& m) {
  Conic<Quad> c;
  c.add_product(l, m, 1);
  return c;
}
inline Conic<Quad> sum(const Conic<Quad>& a, const Conic<Quad>& b) {
  return pencil_member(a, Quad(1), b, Quad(1));
}
inline Conic<Quad> difference(const Conic<Quad>& a, const Conic<Quad>& b) {
  return pencil_member(a, Quad(1), b, Quad(-1));
}

inline Conic<double> rounded(const Conic<Quad>& c) {
  Conic<double> out;
  const Quad scale = unit_scale(size_of(c));
  for (int i = 0; i < 6; ++i) out.q[i] = approximate(Quad(c.q[i] * scale));
  return out;
}

/// Two random members of the pencil of a and b, of different proportions.
inline ConicPair random_members(const Conic<Quad>& a, const Conic<Quad>& b, std::vector<QuadPoint> common,
                                Random& random) {
  const double angle = random.uniform(0, 6), other = angle + random.uniform(0.3, 2.8);
  const Quad s = std::cos(angle), t = std::sin(angle), u = std::cos(other), v = std::sin(other);
  const Quad per_a = 1 / Quad(size_of(a)), per_b = 1 / Quad(size_of(b));
  return {rounded(pencil_member(a, Quad(s * per_a), b, Quad(t * per_b))),
          rounded(pencil_member(a, Quad(u * per_a), b, Quad(v * per_b))), std::move(common)};
}

inline ConicPair through(const QuadPoint& p, const QuadPoint& q, const QuadPoint& r, const QuadPoint& s,
                         Random& random) {
  return random_members(line_pair(p.cross(q), r.cross(s)), line_pair(p.cross(r), q.cross(s)), {p, q, r, s},
                        random);
}

/// Through p, q and the complex points x + i y, x - i y: the real and the imaginary part of
/// (p x (x + i y)) (q x (x - i y)).
inline ConicPair through_two_real(const QuadPoint& p, const QuadPoint& q, const QuadPoint& x,
                                  const QuadPoint& y, Random& random) {
  const QuadPoint px = p.cross(x), py = p.cross(y), qx = q.cross(x), qy = q.cross(y);
  return random_members(sum(line_pair(px, qx), line_pair(py, qy)),
                        difference(line_pair(py, qx), line_pair(px, qy)), {p, q}, random);
}

/// Through x + i y, v + i w and their conjugates: the product of the two real lines, and |(x + i y) x (v + i
/// w)|^2.
inline ConicPair through_none_real(const QuadPoint& x, const QuadPoint& y, const QuadPoint& v,
                                   const QuadPoint& w, Random& random) {
  const QuadPoint real = x.cross(v) - y.cross(w), imaginary = x.cross(w) + y.cross(v);
  return random_members(line_pair(x.cross(y), v.cross(w)),
                        sum(line_pair(real, real), line_pair(imaginary, imaginary)), {}, random);
}

}  // namespace burmester
