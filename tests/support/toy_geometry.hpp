// Small correct geometries for tests of the framework, which may not know planar/ and spherical/.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "burmester/modules/framework/displacement.hpp"
#include "burmester/modules/framework/dyad_type.hpp"

namespace burmester::toy {

/// The plane, with angles for poses.
struct Plane : Displacement<std::array{0, 3, 5, 6}, std::array{1, 2}> {
  static constexpr const char* name = "toy_plane";
  static constexpr int dof = 3;
  struct Pose {
    double x = 0, y = 0, angle = 0;
  };
  template <class T>
  static Point<T> point(const Pose& p) {
    const T x(p.x), y(p.y), c(std::cos(p.angle / 2)), s(std::sin(p.angle / 2));
    return {T(2 * c), T(2 * s), T(c * x + s * y), T(c * y - s * x)};
  }
  static Pose pose(const Point<double>& p) {
    const double n = norm<double>(p) / 2;
    return {(p[0] * p[2] - p[1] * p[3]) / n, (p[1] * p[2] + p[0] * p[3]) / n, 2 * std::atan2(p[1], p[0])};
  }
  static Pose nudged(const Pose& p, const Vector<double, 3>& u) {
    return {p.x + u[0], p.y + u[1], p.angle + u[2]};
  }
  static double distance(const Feature<double>& a, const Feature<double>& b) { return (a - b).norm(); }
  static Pose random_pose(Random& random) {
    const double x = random.normal(), y = random.normal();
    return {x, y, random.uniform(-std::numbers::pi, std::numbers::pi)};
  }
  static Feature<double> random_feature(Random& random) {
    const double x = random.normal();
    return {x, random.normal()};
  }
};

/// A point of the moving plane on a circle of the fixed plane; no lifted form.
struct Circle {
  using Space = Plane;
  using Inverse = Circle;
  using Image = Plane::Point<double>;
  using Place = Plane::Feature<double>;
  static constexpr const char* name = "RR";
  static constexpr int parameters = 5;
  struct Design {
    Place fixed, moving;
    double length = 0;
  };
  static Place placed(const Image& x, const Place& a) {
    return Plane::act<double>(x, a) / Plane::norm<double>(x);
  }
  static double residual(const Design& d, const Plane::Pose& x) {
    return (placed(Plane::point<double>(x), d.moving) - d.fixed).norm() - d.length;
  }
  static Design moved(const Design& d, const Image& g, const Image& h) {
    return {placed(g, d.fixed), placed(h, d.moving), d.length};
  }
  static Design inverse(const Design& d) { return {d.moving, d.fixed, d.length}; }
  static Design nudged(const Design& d, const Vector<double, 5>& u) {
    return {d.fixed + u.head<2>(), d.moving + u.segment<2>(2), d.length + u[4]};
  }
  static Design random_design(Random& random) {
    const Place fixed = Plane::random_feature(random), moving = Plane::random_feature(random);
    return {fixed, moving, random.uniform(0.1, 2)};
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

/// Turns about one point: points (cos, sin) of the half angle on a line.
struct Turns : Displacement<std::array{0, 3}, std::array{1, 2}> {
  static constexpr const char* name = "toy_turns";
  static constexpr int dof = 1;
  struct Pose {
    double angle = 0;
  };
  template <class T>
  static Point<T> point(const Pose& p) {
    return {T(std::cos(p.angle / 2)), T(std::sin(p.angle / 2))};
  }
  static Pose pose(const Point<double>& x) { return {2 * std::atan2(x[1], x[0])}; }
  static Pose nudged(const Pose& p, const Vector<double, 1>& u) { return {p.angle + u[0]}; }
  static double distance(const Feature<double>& a, const Feature<double>& b) { return (a - b).norm(); }
  static Pose random_pose(Random& random) { return {random.uniform(-std::numbers::pi, std::numbers::pi)}; }
  static Feature<double> random_feature(Random& random) {
    const double x = random.normal();
    return {x, random.normal()};
  }
};

struct StopDesign {
  double angle = 0;
};

/// N (cos(turn - angle) - 1) = row . k with k = [cos(angle), sin(angle), -1] on the cone k0^2 + k1^2 = k2^2.
struct StopFamily {
  using Space = Turns;
  static constexpr int dimension = 3, relation_count = 1;
  template <class T>
  static Vector<T, 3> row(const Turns::Pose& pose) {
    const Vector<T, 2> x = Turns::point<T>(pose);
    return {T(x[0] * x[0] - x[1] * x[1]), T(2 * x[0] * x[1]), T(x[0] * x[0] + x[1] * x[1])};
  }
  template <class T>
  static Vector<T, 1> relations(const Vector<T, 3>& k) {
    return Vector<T, 1>{T(k[0] * k[0] + k[1] * k[1] - k[2] * k[2])};
  }
  static std::optional<std::variant<StopDesign>> decode(const Vector<double, 3>& k) {
    if (k[2] == 0) return std::nullopt;
    return StopDesign{std::atan2(-k[1] / k[2], -k[0] / k[2])};
  }
};

/// The body stands at one angle.
struct Stop {
  using Space = Turns;
  using Inverse = Stop;
  using Family = StopFamily;
  using Design = StopDesign;
  static constexpr const char* name = "stop";
  static constexpr int parameters = 1;
  static double residual(const Design& d, const Turns::Pose& x) {
    return std::remainder(x.angle - d.angle, 2 * std::numbers::pi);
  }
  static Design moved(const Design& d, const Turns::Point<double>& g, const Turns::Point<double>& h) {
    return {d.angle + Turns::pose(g).angle - Turns::pose(h).angle};
  }
  static Design inverse(const Design& d) { return {-d.angle}; }
  static Design nudged(const Design& d, const Vector<double, 1>& u) { return {d.angle + u[0]}; }
  static Design random_design(Random& random) {
    return {random.uniform(-std::numbers::pi, std::numbers::pi)};
  }
  static Vector<double, 3> encode(const Design& d) { return {std::cos(d.angle), std::sin(d.angle), -1}; }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.angle = d.angle;
    return out;
  }
};

}  // namespace burmester::toy
