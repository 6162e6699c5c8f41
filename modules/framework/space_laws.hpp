// The laws of modules/framework/pose_space.hpp, by number.
#pragma once

#include <Eigen/SVD>

#include "burmester/modules/framework/laws.hpp"

namespace burmester::laws {

template <PoseSpace S>
PointOf<S> times(const PointOf<S>& x, const PointOf<S>& y) {
  return S::template product<double>(x, y);
}

/// The exact unit of the product: the identity's point over the factor that it carries.
template <PoseSpace S>
PointOf<S> unit() {
  const PointOf<S> e = S::template point<double>(typename S::Pose{});
  return e * (e.squaredNorm() / e.dot(times<S>(e, e)));
}

template <PoseSpace S>
void norm_is_multiplicative(Findings& f) {  // 1
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw(), y = pool.draw();
    const auto inputs = [&] { return x.text("x") + "\n  " + y.text("y"); };
    f.expect(x.norm() > 0, "norm(x) > 0 for a displacement", inputs);
    f.expect_near(S::template norm<double>(times<S>(x.x, y.x)), x.norm() * y.norm(),
                  rounding<S> * x.x.squaredNorm() * y.x.squaredNorm(), "norm(x y) = norm(x) norm(y)", inputs);
  }
  f.expect(S::template norm<double>(PointOf<S>::Zero()) == 0, "norm(0) = 0", [] { return ""; });
}

template <PoseSpace S>
void product_is_associative(Findings& f) {  // 2
  Pool<S> pool(f.random);
  const PointOf<S> e = unit<S>();
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw(), y = pool.draw(), z = pool.draw();
    const auto inputs = [&] { return x.text("x") + "\n  " + y.text("y") + "\n  " + z.text("z"); };
    f.expect_near(times<S>(times<S>(x.x, y.x), z.x), times<S>(x.x, times<S>(y.x, z.x)),
                  rounding<S> * x.x.norm() * y.x.norm() * z.x.norm(), "(x y) z = x (y z)", inputs);
    f.expect_near(times<S>(e, x.x), x.x, rounding<S> * x.x.norm(), "unit x = x", inputs);
    f.expect_near(times<S>(x.x, e), x.x, rounding<S> * x.x.norm(), "x unit = x", inputs);
  }
}

template <PoseSpace S>
void conjugate_is_inverse(Findings& f) {  // 3
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw();
    const PointOf<S> conjugate = S::template conjugate<double>(x.x), expected = x.norm() * unit<S>();
    const auto inputs = [&] { return x.text(); };
    const double tolerance = rounding<S> * x.x.squaredNorm();
    f.expect_near(times<S>(x.x, conjugate), expected, tolerance, "x conjugate(x) = norm(x) unit", inputs);
    f.expect_near(times<S>(conjugate, x.x), expected, tolerance, "conjugate(x) x = norm(x) unit", inputs);
  }
}

template <PoseSpace S>
void acts_from_the_left(Findings& f) {  // 4
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw(), y = pool.draw(), xy{"x y", times<S>(x.x, y.x)};
    const FeatureOf<S> a = S::random_feature(f.random);
    const auto inputs = [&] { return x.text("x") + "\n  " + y.text("y") + "\n  a = " + Findings::show(a); };
    const double size = rounding<S> * (1 + a.norm()), spread = x.size() * y.size();
    f.expect_near(xy(a), x(y(a)), size * spread * spread, "(x y)(a) = x(y(a))", inputs);
    f.expect_near(S::template act<double>(2 * x.x, a), 4 * S::template act<double>(x.x, a),
                  size * 16 * x.x.squaredNorm(), "act is quadratic in x", inputs);
    f.expect_near(S::template act<double>(unit<S>(), a), a, size, "the identity leaves a", inputs);
  }
}

template <PoseSpace S>
void different_displacements_differ(Findings& f) {  // 4, last sentence
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw(), y = pool.draw();
    if (S::gap(x.x, y.x) < 0.05) continue;
    double moved_apart = 0;
    for (int j = 0; j < 2 * S::feature_size + 2; ++j) {
      const FeatureOf<S> a = S::random_feature(f.random);
      moved_apart = std::max(moved_apart, S::distance(x(a), y(a)));
    }
    f.expect(moved_apart > 1e-6, "displacements that differ move some feature differently",
             [&] { return x.text("x") + "\n  " + y.text("y"); });
  }
}

template <PoseSpace S>
void displacements_are_isometries(Findings& f) {  // 5
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw();
    const FeatureOf<S> a = S::random_feature(f.random), b = S::random_feature(f.random);
    const auto inputs = [&] {
      return x.text() + "\n  a = " + Findings::show(a) + ", b = " + Findings::show(b);
    };
    const double size = rounding<S> * (1 + a.norm() + b.norm());
    f.expect_near(S::distance(x(a), x(b)), S::distance(a, b), size * x.size() * x.size(),
                  "distance(x(a), x(b)) = distance(a, b)", inputs);
    f.expect_near(S::distance(b, a), S::distance(a, b), size, "distance is symmetric", inputs);
    f.expect(S::distance(a, b) > 0, "distance > 0 for different features", inputs);
    f.expect_near(S::distance(a, a), 0.0, size, "distance(a, a) = 0", inputs);
  }
}

template <PoseSpace S>
void gap_tells_points_apart(Findings& f) {  // 6
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw(), y = pool.draw();
    const auto inputs = [&] { return x.text("x") + "\n  " + y.text("y"); };
    for (const double factor : {1.0, -1.0, 2.0, -0.3})
      f.expect_near(S::gap(x.x, PointOf<S>(factor * x.x)), 0.0, rounding<S>, "gap(x, multiple of x) = 0",
                    inputs);
    const double gap = S::gap(x.x, y.x), back = S::gap(y.x, x.x);
    f.expect(gap >= 0 && gap <= 1 + rounding<S>, "0 <= gap <= 1", inputs);
    f.expect_near(back, gap, rounding<S>, "gap is symmetric", inputs);
    // Linear in small changes: a formula like sqrt(1 - cos^2) sees nothing below 1e-8.
    const auto nudged = [&](double h) {
      const Vector<double, S::dof> u = h * Vector<double, S::dof>::Unit(i % S::dof);
      return S::gap(x.x, S::template point<double>(S::nudged(x.pose(), u)));
    };
    const double near = nudged(1e-9) / 1e-9, far = nudged(1e-4) / 1e-4;
    f.expect(near > 1e-5, "gap > 0 for different points", inputs);
    f.expect_near(near, far, 1e-2 * far + rounding<S> / 1e-9, "gap grows linearly", inputs);
  }
}

template <PoseSpace S>
void poses_are_points(Findings& f) {  // 7
  Pool<S> pool(f.random);
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw();
    const PointOf<S> again = S::template point<double>(x.pose());
    const double tolerance = rounding<S> * x.size() * x.size();
    f.expect_near(S::gap(again, x.x), 0.0, tolerance, "point(pose(x)) is x up to scale",
                  [&] { return x.text(); });
    const FeatureOf<S> a = S::random_feature(f.random);
    const Element<S> same{"point(pose(x))", again};
    f.expect_near(same(a), x(a), tolerance * (1 + a.norm()), "pose(x) moves features like x",
                  [&] { return x.text(); });
  }
}

template <PoseSpace S>
void nudges_are_local_coordinates(Findings& f) {  // 8
  Pool<S> pool(f.random);
  using Local = Vector<double, S::dof>;
  constexpr double h = 1e-4;
  for (int i = 0; i < trials; ++i) {
    const Element<S> x = pool.draw();
    const auto inputs = [&] { return x.text(); };
    const auto moved = [&](const Local& u) {
      const PointOf<S> y = S::template point<double>(S::nudged(x.pose(), u));
      return times<S>(S::template conjugate<double>(x.x), y);  // the small displacement, seen from x
    };
    f.expect_near(S::gap(unit<S>(), moved(Local::Zero())), 0.0, rounding<S> * x.size() * x.size(),
                  "nudged(p, 0) is p", inputs);
    Matrix<double, S::ambient + 1, S::dof> tangents;
    for (int j = 0; j < S::dof; ++j) {
      PointOf<S> y = moved(h * Local::Unit(j)).normalized();
      if (y.dot(unit<S>()) < 0) y = -y;
      tangents.col(j) = (y - unit<S>().normalized()) / h;
    }
    const auto stretch = Eigen::JacobiSVD<Eigen::MatrixXd>(tangents).singularValues();
    f.expect(stretch[S::dof - 1] > 1e-2 && stretch[0] < 1e2,
             "local coordinates are independent, lengths and radians", inputs);
  }
}

template <PoseSpace S>
std::vector<Law> space_laws() {
  return {{"norm_is_multiplicative", &norm_is_multiplicative<S>},
          {"product_is_associative", &product_is_associative<S>},
          {"conjugate_is_inverse", &conjugate_is_inverse<S>},
          {"acts_from_the_left", &acts_from_the_left<S>},
          {"different_displacements_differ", &different_displacements_differ<S>},
          {"displacements_are_isometries", &displacements_are_isometries<S>},
          {"gap_tells_points_apart", &gap_tells_points_apart<S>},
          {"poses_are_points", &poses_are_points<S>},
          {"nudges_are_local_coordinates", &nudges_are_local_coordinates<S>}};
}

/// Empty if S keeps every law.
template <PoseSpace S>
Violations space_violations() {
  return violations(space_laws<S>(), std::string_view(S::name));
}

}  // namespace burmester::laws
