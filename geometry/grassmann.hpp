// Curves and surfaces through given points: the forms whose coefficients are the maximal minors of the
// points' monomials (Grassmann's determinants; H. Grassmann, "Ausdehnungslehre", 1862; F. Klein,
// "Elementarmathematik vom hoeheren Standpunkte aus II", 1925). For the circle, for instance, in homogeneous
// coordinates (the last column is w^2):
//   | x^2 + y^2    x w      y w     w^2   |
//   | x_i^2+y_i^2  x_i w_i  y_i w_i w_i^2 | = 0,   i = 1, 2, 3
//
// Points are read as exact; whether they determine the form is decided exactly. T is double or Rational.
// Results are scaled, the largest coefficient of double ones to 1. Nothing: the points do not determine the
// form (fewer different ones than it takes, three on a line for a plane, four on a line for a conic, ..; a
// point without coordinates). Precondition: finite coordinates.
#pragma once

#include <array>
#include <optional>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/quadric.hpp"
#include "burmester/geometry/rational.hpp"

namespace burmester {

template <class T>
std::optional<LinearForm<T>> line_through(const std::array<Point2<T>, 2>& points);

/// (K0, K1, K2, K3): K0 (x^2 + y^2) + 2 K1 x w + 2 K2 y w + K3 w^2 = 0; K0 = 0 is a straight line. Centre and radius:
/// (-K1, -K2) / K0, r^2 = (K1^2 + K2^2 - K0 K3) / K0^2.
template <class T>
std::optional<Vector<T, 4>> circle_through(const std::array<Point2<T>, 3>& points);

template <class T>
std::optional<Conic<T>> conic_through(const std::array<Point2<T>, 5>& points);

template <class T>
std::optional<Point3<T>> plane_through(const std::array<Point3<T>, 3>& points);

template <class T>
std::optional<Quadric<T>> quadric_through(const std::array<Point3<T>, 9>& points);

}  // namespace burmester
