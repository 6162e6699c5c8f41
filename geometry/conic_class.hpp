// Affine and metric geometry of one real conic: its class, proved, and centre, axes, asymptotes, lines, a
// parametrisation, computed.
//
// Chart z = 1: Q = q0 x^2 + q1 y^2 + q2 + q3 y + q4 x + q5 x y (conic.hpp). The class is read off the ranks
// and signatures of Q and of its part of degree two (affine_inertia.hpp). In terms of the discriminant 4 q0
// q1 - q5^2 of that part: positive for ellipses and points, 0 for parabolas and parallel lines, negative for
// hyperbolas and crossing lines.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "burmester/geometry/common_points.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

enum class ConicType {
  ellipse,
  imaginary_ellipse,
  hyperbola,
  parabola,
  crossing_lines,
  point,  ///< complex lines that cross in a real point
  parallel_lines,
  complex_parallel_lines,
  coincident_lines,
  line_and_infinity,  ///< a line and the line at infinity
  infinity_twice,
  everything  ///< the zero form
};

struct ConicClass {
  ConicType type = ConicType::everything;
  bool circular = false;  ///< q0 = q1, q5 = 0, not all zero: a circle, an imaginary circle, or a point circle
  bool rectangular = false;  ///< q0 = -q1, not all of the three zero: perpendicular asymptotes or lines
  Rung rung = Rung::none;
};

/// Preconditions: finite coefficients; doubles below 2^1023.
ConicClass classify(const Conic<double>& conic);
ConicClass classify(const Conic<Rational>& conic);

/// "circle", "rectangular hyperbola", "parallel lines", ..
std::string_view name_of(const ConicClass& c);

/// The centre of an ellipse (imaginary too) or hyperbola, the common point of crossing lines (complex too).
Vector<double, 2> centre_of(const Conic<double>& conic);

/// With u_i = axis[i] . (x - centre): u_0^2 / square[0] + u_1^2 / square[1] = 1, square[0] >= square[1].
/// Ellipse: squared semi-axes, the longer first. Hyperbola: transverse axis first, the other square negative.
/// Imaginary ellipse: both negative. The axes are orthonormal, right-handed.
struct ConicAxes {
  Vector<double, 2> centre;
  std::array<Vector<double, 2>, 2> axis;
  std::array<double, 2> square;
};
/// Precondition: an ellipse (imaginary too) or a hyperbola.
ConicAxes axes_of(const Conic<double>& conic);

/// Unit vectors along the asymptotes, which pass through the centre. Precondition: a hyperbola or crossing lines.
std::array<Vector<double, 2>, 2> asymptote_directions(const Conic<double>& conic);

/// v^2 = 2 parameter u in the frame (vertex; axis, its normal): the axis points into the parabola, parameter > 0.
struct ParabolaFrame {
  Vector<double, 2> vertex, axis;
  double parameter = 0;
};
/// Precondition: a parabola.
ParabolaFrame parabola_frame(const Conic<double>& conic);

/// The real lines of a conic of this type, two, one (coincident lines) or none: the line at infinity among
/// them, double lines once. The product of two is Q up to a factor.
std::vector<LinearForm<double>> lines_of(const Conic<double>& conic, ConicType type);

/// A real point, of norm about 1. Precondition: the form takes both signs (regular: ellipse, hyperbola, parabola).
Point2<double> real_point(const Conic<double>& conic);

/// X(s, t) = s^2 c[0] + s t c[1] + t^2 c[2].
template <class T>
struct ConicParametrisation {
  std::array<Point2<T>, 3> c;
  Point2<T> operator()(const T& s, const T& t) const { return s * s * c[0] + s * t * c[1] + t * t * c[2]; }
};

/// The second intersections of the lines through a point P of the conic: X = polar(P, D) D - Q(D) P, where D
/// runs through the line with the coordinates of P. Q(X) = Q(D)^2 Q(P), for any P. Precondition: a regular
/// conic, P on it.
template <class T>
ConicParametrisation<T> parametrisation(const Conic<T>& conic, const Point2<T>& p) {
  Point2<T> u, v;
  detail::span_line<T>(p, u, v);
  const T pu = conic.polar(p, u), pv = conic.polar(p, v);
  return {{Point2<T>(pu * u - conic(u) * p), Point2<T>(pv * u + pu * v - conic.polar(u, v) * p),
           Point2<T>(pv * v - conic(v) * p)}};
}

}  // namespace burmester
