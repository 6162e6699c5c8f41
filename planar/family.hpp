// The lifted family of the planar dyads: all four types in one projective space, the constraint manifold.
//
// A point p of E on the circle or line K0 (X^2 + Y^2) + 2 K1 X + 2 K2 Y + K3 = 0 of S: the condition is linear in
//   k = [K0, K1, K2, K0 x, K0 y, K0 (x^2 + y^2) + K3, K1 x + K2 y, K2 x - K1 y]
// (Hayes, Luu, Chang, "Kinematic mapping application to approximate type and dimension synthesis of planar
// mechanisms", ARK 2004), whose points satisfy two relations: k0 k6 = k1 k3 + k2 k4, k0 k7 = k2 k3 - k1 k4.
//   RR: k0 != 0.  PR: k0 = k3 = k4 = 0.  RP: k0 = k1 = k2 = 0.  PP: only k5, k6, k7, with k5^2 = 4 (k6^2 + k7^2).
// A k with k0 = .. = k4 = 0 off that cone is a pair of orientations, or nothing: no dyad.
#pragma once

#include <optional>
#include <variant>

#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

struct Family {
  using Space = planar::Space;
  using Types = DyadList<RR, PR, RP, PP>;  ///< those that are linear here; the module's list may have more
  using Design = Types::Design;
  static constexpr int dimension = 8, relation_count = 2;

  /// norm(pose) times [|t|^2, 2a, 2b, 2 R^T t, 1, 2 cos, 2 sin], t = (a, b) the origin of E: a polynomial.
  template <class T>
  static Vector<T, 8> row(const Pose& pose) {
    const T a(pose.x), b(pose.y), s(pose.X3), c(pose.X4);
    const T n = s * s + c * c, cosine = c * c - s * s, sine = 2 * s * c;
    return Vector<T, 8>{{T(n * (a * a + b * b)), T(2 * n * a), T(2 * n * b), T(2 * (a * cosine + b * sine)),
             T(2 * (b * cosine - a * sine)), n, T(2 * cosine), T(2 * sine)}};
  }
  template <class T>
  static Vector<T, 2> relations(const Vector<T, 8>& k) {
    return {T(k[0] * k[6] - k[1] * k[3] - k[2] * k[4]), T(k[0] * k[7] - k[2] * k[3] + k[1] * k[4])};
  }
  /// The dyad of k, of the type whose coordinates vanish to 1e-12 of the rest; empty where k is no dyad.
  static std::optional<Design> decode(const Vector<double, 8>& k);
};

}  // namespace burmester::planar
