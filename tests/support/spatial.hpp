// SE(3) as all eight basis elements: points of the Study quadric in P^7. It keeps the framework honest.
#pragma once

#include "burmester/modules/framework/displacement.hpp"
#include "burmester/modules/framework/dyad_type.hpp"

namespace burmester::toy {

struct Spatial : Displacement<std::array{0, 1, 2, 3, 4, 5, 6, 7}, std::array{1, 2, 3}> {
  static constexpr const char* name = "toy_spatial";
  static constexpr int dof = 6;
  struct Pose {
    std::array<double, 8> x{1, 0, 0, 0, 0, 0, 0, 0};
  };
  template <class T>
  static Point<T> point(const Pose& p) {
    Point<T> out;
    for (int i = 0; i < 8; ++i) out[i] = T(p.x[static_cast<std::size_t>(i)]);
    return out;
  }
  static Pose pose(const Point<double>& x) { return {{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]}}; }
  /// Shift by (u0, u1, u2) and turn by the rotation vector (u3, u4, u5), in the moving frame.
  static Pose nudged(const Pose& p, const Vector<double, 6>& u) {
    const double half = u.tail<3>().norm() / 2, s = half > 0 ? std::sin(half) / (2 * half) : 0.5;
    const Point<double> shift{1, 0, 0, 0, 0, u[0] / 2, u[1] / 2, u[2] / 2};
    const Point<double> turn{std::cos(half), s * u[3], s * u[4], s * u[5], 0, 0, 0, 0};
    return pose(product<double>(point<double>(p), product<double>(shift, turn)));
  }
  static double distance(const Feature<double>& a, const Feature<double>& b) { return (a - b).norm(); }
  static Pose random_pose(Random& random) {
    Quaternion<double> p, t{0, 0, 0, 0};
    for (int i = 0; i < 4; ++i) p[i] = random.normal();
    p.normalize();
    for (int i = 1; i < 4; ++i) t[i] = random.normal();
    const Quaternion<double> q = quaternion_product<double>(t, p) / 2;
    return {{p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]}};
  }
  static Feature<double> random_feature(Random& random) {
    Feature<double> out;
    for (int i = 0; i < 3; ++i) out[i] = random.normal();
    return out;
  }
};

/// A point of the moving body on a sphere of the fixed one: two ball joints and a rod.
struct SS {
  using Space = Spatial;
  using Inverse = SS;
  using Image = Spatial::Point<double>;
  using Place = Spatial::Feature<double>;
  static constexpr const char* name = "SS";
  static constexpr int parameters = 7;
  struct Design {
    Place fixed, moving;
    double length = 0;
  };
  static Place placed(const Image& x, const Place& a) {
    return Spatial::act<double>(x, a) / Spatial::norm<double>(x);
  }
  static double residual(const Design& d, const Spatial::Pose& x) {
    return (placed(Spatial::point<double>(x), d.moving) - d.fixed).norm() - d.length;
  }
  static Design moved(const Design& d, const Image& g, const Image& h) {
    return {placed(g, d.fixed), placed(h, d.moving), d.length};
  }
  static Design inverse(const Design& d) { return {d.moving, d.fixed, d.length}; }
  static Design nudged(const Design& d, const Vector<double, 7>& u) {
    return {d.fixed + u.head<3>(), d.moving + u.segment<3>(3), d.length + u[6]};
  }
  static Design random_design(Random& random) {
    const Place fixed = Spatial::random_feature(random), moving = Spatial::random_feature(random);
    return {fixed, moving, random.uniform(0.1, 2)};
  }
  static DyadRecord record(const Design& d) {
    DyadRecord out;
    out.type = name;
    out.fixed = {d.fixed[0], d.fixed[1], d.fixed[2]};
    out.moving = {d.moving[0], d.moving[1], d.moving[2]};
    out.length = d.length;
    return out;
  }
};

}  // namespace burmester::toy
