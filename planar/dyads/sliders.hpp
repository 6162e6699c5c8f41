// The two dyads with one slider, PR and RP: a point of one plane stays on a straight line of the other.
#pragma once

#include "burmester/planar/dyads/circle.hpp"
#include "burmester/planar/dyads/forms.hpp"

namespace burmester::planar {

struct Family;
struct RP;

/// A point of the moving plane stays on a straight line of the fixed plane: slider on a fixed guide, then a revolute
/// joint.
struct PR {
  using Space = planar::Space;
  using Family = planar::Family;
  using Inverse = RP;
  static constexpr const char* name = "PR";
  static constexpr int parameters = 4;  ///< moving pivot, direction and offset of the line

  struct Design {
    Vector2 moving;  ///< in E
    Line line;       ///< in S
  };

  static double residual(const Design& d, const Pose& x) { return d.line.signed_distance(to_fixed(x, d.moving)); }
  static Design moved(const Design& d, const Vector<double, 4>& g, const Vector<double, 4>& h) {
    return {to_fixed(Space::pose(h), d.moving), d.line.moved(Space::pose(g))};
  }
  static auto inverse(const Design& d);  // an RP::Design
  static Design nudged(const Design& d, const Vector<double, parameters>& u) {
    Line line = d.line.turned(u[2]);
    line.offset += u[3];
    return {d.moving + u.head<2>(), line};
  }
  static Design random_design(Random& random) {
    const Vector2 moving = Space::random_feature(random);
    return {moving, Line::random(random)};
  }
  static Vector<double, 8> encode(const Design& d) {
    return form_of_moving_point<double>(coordinates_of(d.line), d.moving);
  }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.moving = {d.moving[0], d.moving[1]};
    out.line = d.line.record();
    return out;
  }
};

/// A straight line of the moving plane passes through a fixed pivot: revolute joint, then a slider on a guide that
/// the body carries. The inverse motion's PR.
struct RP {
  using Space = planar::Space;
  using Family = planar::Family;
  using Inverse = PR;
  static constexpr const char* name = "RP";
  static constexpr int parameters = 4;  ///< fixed pivot, direction and offset of the line

  struct Design {
    Vector2 fixed;  ///< in S
    Line line;      ///< in E
  };

  static double residual(const Design& d, const Pose& x) { return d.line.signed_distance(to_moving(x, d.fixed)); }
  static Design moved(const Design& d, const Vector<double, 4>& g, const Vector<double, 4>& h) {
    return {to_fixed(Space::pose(g), d.fixed), d.line.moved(Space::pose(h))};
  }
  static PR::Design inverse(const Design& d) { return {d.fixed, d.line}; }
  static Design nudged(const Design& d, const Vector<double, parameters>& u) {
    Line line = d.line.turned(u[2]);
    line.offset += u[3];
    return {d.fixed + u.head<2>(), line};
  }
  static Design random_design(Random& random) {
    const Vector2 fixed = Space::random_feature(random);
    return {fixed, Line::random(random)};
  }
  static Vector<double, 8> encode(const Design& d) {
    return form_of_fixed_point<double>(coordinates_of(d.line), d.fixed);
  }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.fixed = {d.fixed[0], d.fixed[1]};
    out.line = d.line.record();
    return out;
  }
};

inline auto PR::inverse(const Design& d) { return RP::Design{d.moving, d.line}; }

}  // namespace burmester::planar
