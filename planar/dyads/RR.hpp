// RR: a point of the moving plane stays on a circle of the fixed plane. |P - F| = length.
#pragma once

#include "burmester/planar/dyads/circle.hpp"
#include "burmester/planar/dyads/forms.hpp"

namespace burmester::planar {

struct Family;

struct RR {
  using Space = planar::Space;
  using Family = planar::Family;
  using Inverse = RR;
  static constexpr const char* name = "RR";
  static constexpr int parameters = 5;  ///< fixed pivot, moving pivot, length

  struct Design {
    Vector2 fixed, moving;  ///< F in S (centre point), p in E (circle point)
    double length = 0;
  };

  static double residual(const Design& d, const Pose& x) {
    return (to_fixed(x, d.moving) - d.fixed).norm() - d.length;
  }
  static Design moved(const Design& d, const Vector<double, 4>& g, const Vector<double, 4>& h) {
    return {to_fixed(Space::pose(g), d.fixed), to_fixed(Space::pose(h), d.moving), d.length};
  }
  static Design inverse(const Design& d) { return {d.moving, d.fixed, d.length}; }
  static Design nudged(const Design& d, const Vector<double, parameters>& u) {
    return {d.fixed + u.head<2>(), d.moving + u.segment<2>(2), d.length + u[4]};
  }
  static Design random_design(Random& random) {
    const Vector2 fixed = Space::random_feature(random), moving = Space::random_feature(random);
    return {fixed, moving, 0.1 + std::abs(random.normal())};
  }
  static Vector<double, 8> encode(const Design& d) {
    return form_of_moving_point<double>(coordinates_of(Circle{d.fixed, d.length}), d.moving);
  }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.fixed = {d.fixed[0], d.fixed[1]};
    out.moving = {d.moving[0], d.moving[1]};
    out.length = d.length;
    return out;
  }
};

}  // namespace burmester::planar
