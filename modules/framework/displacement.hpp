// Displacements as dual quaternions, restricted to some of the eight basis elements.
//
// A displacement with rotation p (unit quaternion) and translation t is x = p + e q, q = t p / 2, with e^2 = 0;
// points move by a -> (p a + 2 q) p* (W. Blaschke, "Kinematik und Quaternionen", 1960). Closed under products:
//   {1, k, ei, ej}   SE(2): points of P^3, Blaschke-Gruenwald coordinates
//   {1, i, j, k}     SO(3): points of P^3, quaternions
//   all eight        SE(3): points of the Study quadric in P^7
// Basis elements are numbered 1 i j k e ei ej ek = 0..7; Axes lists which of 1, 2, 3 (i, j, k) carry a feature.
// Everything is a polynomial in its arguments, so it runs over any number type.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

template <class T>
using Quaternion = Vector<T, 4>;  ///< (w, x, y, z)

template <class T>
Quaternion<T> quaternion_product(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {T(a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3]),
          T(a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2]),
          T(a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1]),
          T(a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])};
}

template <std::array Basis, std::array Axes>
struct Displacement {
  static constexpr int ambient = static_cast<int>(Basis.size()) - 1;
  static constexpr int feature_size = static_cast<int>(Axes.size());
  template <class T>
  using Point = Vector<T, ambient + 1>;
  template <class T>
  using Feature = Vector<T, feature_size>;

  template <class T>
  static Point<T> product(const Point<T>& x, const Point<T>& y) {
    const Dual<T> a = lift<T>(x), b = lift<T>(y);
    const Quaternion<T> dual = quaternion_product<T>(a.real, b.dual) + quaternion_product<T>(a.dual, b.real);
    return restrict<T>({quaternion_product<T>(a.real, b.real), dual});
  }
  template <class T>
  static Point<T> conjugate(const Point<T>& x) {
    const Dual<T> a = lift<T>(x);
    return restrict<T>({conjugated<T>(a.real), conjugated<T>(a.dual)});
  }
  template <class T>
  static T norm(const Point<T>& x) {
    const Quaternion<T> p = lift<T>(x).real;
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
  }
  /// norm(x) times the moved feature
  template <class T>
  static Feature<T> act(const Point<T>& x, const Feature<T>& a) {
    const Dual<T> d = lift<T>(x);
    Quaternion<T> v = Quaternion<T>::Zero();
    for (std::size_t i = 0; i < Axes.size(); ++i) v[Axes[i]] = a[static_cast<int>(i)];
    const Quaternion<T> moved =
        quaternion_product<T>(quaternion_product<T>(d.real, v) + T(2) * d.dual, conjugated<T>(d.real));
    Feature<T> out;
    for (std::size_t i = 0; i < Axes.size(); ++i) out[static_cast<int>(i)] = moved[Axes[i]];
    return out;
  }
  /// Sine of the angle between x and y as lines through the origin: 0 for the same point of the space.
  static double gap(const Point<double>& x, const Point<double>& y) {
    const Point<double> a = x.normalized(), b = y.normalized();
    return std::min((a - b).norm(), (a + b).norm()) < 1e-3 ? std::min((a - b).norm(), (a + b).norm())
                                                          : std::sqrt(std::max(0.0, 1 - std::pow(a.dot(b), 2)));
  }

 private:
  template <class T>
  struct Dual {
    Quaternion<T> real = Quaternion<T>::Zero(), dual = Quaternion<T>::Zero();
  };
  template <class T>
  static Quaternion<T> conjugated(const Quaternion<T>& q) {
    return {q[0], T(-q[1]), T(-q[2]), T(-q[3])};
  }
  template <class T>
  static Dual<T> lift(const Point<T>& x) {
    Dual<T> out;
    for (std::size_t i = 0; i < Basis.size(); ++i)
      (Basis[i] < 4 ? out.real[Basis[i]] : out.dual[Basis[i] - 4]) = x[static_cast<int>(i)];
    return out;
  }
  template <class T>
  static Point<T> restrict(const Dual<T>& d) {
    Point<T> out;
    for (std::size_t i = 0; i < Basis.size(); ++i)
      out[static_cast<int>(i)] = Basis[i] < 4 ? d.real[Basis[i]] : d.dual[Basis[i] - 4];
    return out;
  }
};

}  // namespace burmester
