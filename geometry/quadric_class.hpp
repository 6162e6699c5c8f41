// Affine class of a real quadric of P^3, proved, its centre, and the two families of lines of a doubly ruled one.
//
// Which plane counts as infinity is a parameter: the same quadric is a hyperboloid of one sheet in one chart
// and a hyperbolic paraboloid in another. The class is read off the ranks and signatures of the form and of
// its restriction to that plane (affine_inertia.hpp). A regular quadric carries real lines exactly when its
// signature is 0.
#pragma once

#include <array>
#include <string_view>

#include "burmester/geometry/quadric.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

enum class QuadricType {
  ellipsoid,
  imaginary_ellipsoid,
  hyperboloid_of_one_sheet,
  hyperboloid_of_two_sheets,
  elliptic_paraboloid,
  hyperbolic_paraboloid,
  cone,
  point,  ///< a complex cone
  elliptic_cylinder,
  imaginary_cylinder,
  hyperbolic_cylinder,
  parabolic_cylinder,
  crossing_planes,
  line,  ///< complex planes that cross in a real line
  parallel_planes,
  complex_parallel_planes,
  coincident_planes,
  plane_and_infinity,  ///< a plane and the plane at infinity
  infinity_twice,
  everything  ///< the zero form
};

struct QuadricClass {
  QuadricType type = QuadricType::everything;
  Rung rung = Rung::none;
};

/// `infinity`: coordinates of the plane at infinity. Preconditions: finite numbers, doubles below 2^1023;
/// infinity not zero.
QuadricClass classify(const Quadric<double>& quadric, const Point3<double>& infinity = {0, 0, 0, 1});
QuadricClass classify(const Quadric<Rational>& quadric,
                      const Point3<Rational>& infinity = {Rational(0), Rational(0), Rational(0),
                                                          Rational(1)});

/// "ellipsoid", "hyperboloid of one sheet", ..
std::string_view name_of(QuadricType type);

/// The pole of the plane at infinity: the centre, for paraboloids their point at infinity. Of norm 1.
/// Precondition: a regular quadric.
Point3<double> centre_of(const Quadric<double>& quadric, const Point3<double>& infinity = {0, 0, 0, 1});

/// A quadric of signature 0 as the product of two projective lines: X(u, v) = sum of u_i v_j corner[i][j].
/// For a fixed u it is a line of one family, for a fixed v one of the other.
struct Rulings {
  std::array<std::array<Point3<double>, 2>, 2> corner;

  Point3<double> operator()(const Vector<double, 2>& u, const Vector<double, 2>& v) const {
    return u[0] * (v[0] * corner[0][0] + v[1] * corner[0][1]) +
           u[1] * (v[0] * corner[1][0] + v[1] * corner[1][1]);
  }
};
/// Precondition: a regular quadric of signature 0 (hyperboloid of one sheet, hyperbolic paraboloid).
Rulings rulings_of(const Quadric<double>& quadric);

}  // namespace burmester
