// PP: two sliders in series; the moving plane keeps its orientation and translates freely.
#pragma once

#include "burmester/planar/dyads/line.hpp"

namespace burmester::planar {

struct Family;

struct PP {
  using Space = planar::Space;
  using Family = planar::Family;
  using Inverse = PP;
  static constexpr const char* name = "PP";
  static constexpr int parameters = 1;  ///< the orientation

  struct Design {
    double angle = 0;  ///< radians
  };

  /// Radians, in (-pi, pi].
  static double residual(const Design& d, const Pose& x) {
    return std::remainder(angle_of(x) - d.angle, 2 * std::numbers::pi);
  }
  static Design moved(const Design& d, const Vector<double, 4>& g, const Vector<double, 4>& h) {
    return {d.angle + angle_of(Space::pose(g)) - angle_of(Space::pose(h))};
  }
  static Design inverse(const Design& d) { return {-d.angle}; }
  static Design nudged(const Design& d, const Vector<double, parameters>& u) { return {d.angle + u[0]}; }
  static Design random_design(Random& random) { return {random.uniform(-std::numbers::pi, std::numbers::pi)}; }
  /// The double plane 2 (1 - cos(theta - angle)) = 0: only k5, k6, k7, with k5^2 = 4 (k6^2 + k7^2).
  static Vector<double, 8> encode(const Design& d) {
    return Vector<double, 8>{{0, 0, 0, 0, 0, 2, -std::cos(d.angle), -std::sin(d.angle)}};
  }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.angle = std::remainder(d.angle, 2 * std::numbers::pi);
    return out;
  }
};

}  // namespace burmester::planar
