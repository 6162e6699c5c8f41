#include "burmester/planar/constraint_manifold.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <complex>
#include <numbers>

namespace burmester::planar {
namespace {

constexpr double pi = std::numbers::pi;

Vector2 on_unit_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A pose of this orientation that meets the design, by its mechanism: the joints are set to `at`.
Pose shifted(const Pose& turn, const Vector2& t) { return {t[0], t[1], turn.X3, turn.X4}; }
Pose assembled(const RR::Design& d, const Pose& turn, double at) {
  return shifted(turn, d.fixed + d.length * on_unit_circle(at) - rotated(turn, d.moving));
}
Pose assembled(const PR::Design& d, const Pose& turn, double at) {
  const Vector2& n = d.line.normal;
  return shifted(turn, d.line.offset * n + at * Vector2(n[1], -n[0]) - rotated(turn, d.moving));
}
Pose assembled(const RP::Design& d, const Pose& turn, double at) {
  const Vector2& n = d.line.normal;
  return shifted(turn, d.fixed - rotated(turn, d.line.offset * n + at * Vector2(n[1], -n[0])));
}
Pose assembled(const PP::Design& d, const Pose&, double at) {
  return shifted(pose_from_radians(0, 0, d.angle), Vector2(at, 1 - at));
}

/// Orientations with half turns among them.
Pose random_turn(Random& random) {
  return random.below(5) == 0 ? pose_from_degrees(0, 0, 180) : pose_from_radians(0, 0, random.uniform(-pi, pi));
}

template <class Check>
void for_random_designs(const char* name, Check check) {
  Random random(name);
  SCOPED_TRACE(name);
  Dyads::for_each([&]<class D>() {
    for (int i = 0; i < 50; ++i) check.template operator()<D>(D::random_design(random), random);
  });
}

TEST(ConstraintManifold, HoldsThePosesThatMeetTheDyad) {
  for_random_designs(
      "ConstraintManifold.HoldsThePosesThatMeetTheDyad", []<class D>(const typename D::Design& d, Random& random) {
        const Pose pose = assembled(d, random_turn(random), random.uniform(-3, 3));
        const ConstraintManifold m{Family::Design(d)};
        const Point3<double> x = Space::point<double>(pose);
        EXPECT_NEAR(m.quadric()(x), 0, 64 * unit_roundoff * size_of(m.quadric()) * x.squaredNorm()) << D::name;
        EXPECT_NEAR(m.distance(pose), 0, 1e-14) << D::name;
      });
}

/// Both ways: parametrised points meet the dyad, and a pose that meets it is reached, by the joint's place.
TEST(ConstraintManifold, IsParametrised) {
  const auto gamma = [](const Circle& c, const Vector2& X) {
    return std::atan2(X[1] - c.centre[1], X[0] - c.centre[0]);
  };
  for_random_designs("ConstraintManifold.IsParametrised", [&]<class D>(const typename D::Design& d, Random& random) {
    const ConstraintManifold m{Family::Design(d)};
    const double t = random.normal(), w = random.below(5) == 0 ? 0 : random.normal(), at = random.uniform(-3, 3);
    const auto x = m.point(t, w, at);
    ASSERT_EQ(x.has_value(), (!std::is_same_v<D, PP>));
    if (!x) return;
    EXPECT_EQ((*x)[1], t);
    EXPECT_EQ((*x)[0], w);
    EXPECT_NEAR(D::residual(d, Space::pose(*x)), 0, 1e-13 * (1 + std::abs(at))) << D::name;

    const Pose pose = assembled(d, random_turn(random), random.uniform(-3, 3));
    const Vector<double, 4> X = image_point(pose);
    const auto curve = m.section(X[2], X[3]);
    double there = 0;
    if (const auto* circle = std::get_if<Circle>(&*curve)) there = gamma(*circle, X.head<2>());
    if (const auto* line = std::get_if<Line>(&*curve))
      there = Vector2(-line->normal[1], line->normal[0]).dot(X.head<2>()) / (std::hypot(X[2], X[3]) / 2);
    const Vector<double, 4> back = image_coordinates(*m.point(X[2], X[3], there));
    EXPECT_LT((back - X).norm(), 1e-14 * (10 + X.norm())) << D::name;
  });
}

/// Q of the moved design at g x h^-1 is Q of the design at x, up to one factor for all x of P^3.
TEST(ConstraintManifold, MovesWithBothFrames) {
  for_random_designs(
      "ConstraintManifold.MovesWithBothFrames", []<class D>(const typename D::Design& d, Random& random) {
        const auto g = Space::point<double>(Space::random_pose(random)),
                   h = Space::point<double>(Space::random_pose(random));
        const Quadric<double> here = constraint_quadric(Family::Design(d)),
                              there = constraint_quadric(Family::Design(D::moved(d, g, h)));
        const double factor = Space::norm<double>(g) * Space::norm<double>(h);
        for (int i = 0; i < 10; ++i) {
          const Point3<double> x(random.normal(), random.normal(), random.normal(), random.normal());
          const Point3<double> y = Space::product<double>(Space::product<double>(g, x), Space::conjugate<double>(h));
          EXPECT_NEAR(there(y), factor * here(x), 1e-13 * size_of(there) * y.squaredNorm()) << D::name;
        }
      });
}

/// PR and RP change places, RR keeps its type: the point set is the inverse poses.
TEST(ConstraintManifold, OfTheInverseMotionIsTheConjugateSurface) {
  for_random_designs("ConstraintManifold.OfTheInverseMotionIsTheConjugateSurface",
                     []<class D>(const typename D::Design& d, Random& random) {
                       const auto inverse = D::inverse(d);
                       const Quadric<double> here = constraint_quadric(Family::Design(d)),
                                             there = constraint_quadric(Family::Design(inverse));
                       const Point3<double> x(random.normal(), random.normal(), random.normal(), random.normal());
                       EXPECT_NEAR(there(Space::conjugate<double>(x)), here(x), 1e-13 * size_of(here) * x.squaredNorm())
                           << D::name;
                     });
  EXPECT_TRUE((std::is_same_v<PR::Inverse, RP> && std::is_same_v<RP::Inverse, PR>));
}

TEST(ConstraintManifold, GivesItsDyadBack) {
  for_random_designs("ConstraintManifold.GivesItsDyadBack", []<class D>(const typename D::Design& d, Random& random) {
    Quadric<double> surface = constraint_quadric(Family::Design(d));
    const Vector<double, 8> k = D::encode(d), again = *lifted_form(surface);
    EXPECT_LT((again - k).norm(), 1e-14 * k.norm()) << D::name;
    const double factor = random.normal();
    for (double& q : surface.q) q *= factor;
    const auto back = design_of(surface);
    ASSERT_TRUE(back && std::holds_alternative<typename D::Design>(*back)) << D::name;
    const Pose probe = Space::random_pose(random);
    EXPECT_NEAR(ConstraintManifold(*back).distance(probe), ConstraintManifold(Family::Design(d)).distance(probe), 1e-12)
        << D::name;
  });
}

TEST(DesignOfQuadric, IsEmptyForOtherSurfaces) {
  EXPECT_FALSE(design_of({{-1, 1, 1, 1, 0, 0, 0, 0, 0, 0}}));  // X1^2 + X2^2 + X3^2 = X4^2: not a constraint surface
  EXPECT_FALSE(design_of({{1, 1, 1, 1, 0, 0, 0, 0, 0, 0}}));   // an imaginary circle
  EXPECT_FALSE(design_of({{-1, 1, 1, 2, 0, 0, 0, 0, 0, 0}}));  // not through J1, J2
  EXPECT_FALSE(design_of({{-1, 1, 1, 1, 0, 0, 0, 0, 0, 0.001}}));
  EXPECT_FALSE(design_of(Quadric<double>{}));
  Quadric<double> four_bar = constraint_quadric(RR::Design{{1, 2}, {3, -1}, 2});
  EXPECT_TRUE(design_of(four_bar));
  four_bar.q[4] += 1e-6;  // leaves the tangent planes V1, V2
  EXPECT_FALSE(design_of(four_bar));
}

/// Exact signs, on designs whose coefficients are doubles.
TEST(ConstraintManifold, TypeIsThatOfTheCoefficients) {
  Random random("ConstraintManifold.TypeIsThatOfTheCoefficients");
  const auto whole = [&random] { return random.below(65) - 32.0; };
  for (int i = 0; i < 100; ++i) {
    const Vector2 p(whole(), whole()), F(whole(), whole());
    const Line line{{1 + std::abs(whole()), whole()}, whole()};  // of any scale: the equation does not mind
    for (const Family::Design& d :
         {Family::Design(RR::Design{F, p, 1 + std::abs(whole())}), Family::Design(RR::Design{F, p, 0}),
          Family::Design(PR::Design{p, line}), Family::Design(RP::Design{F, line}), Family::Design(PP::Design{0})}) {
      const Quadric<double> surface = Family::Types::visit(  // whole numbers: encoded without rounding
          d, []<class D>(const typename D::Design& x) { return constraint_quadric(D::encode(x)); });
      EXPECT_EQ(surface_class(surface).type, ConstraintManifold(d).type()) << i << ", " << d.index();
      EXPECT_NE(surface_class(surface).rung, Rung::none);
    }
  }
}

/// J1 on every surface, touched there by V1 (PR) or V2 (RP); V1 touches the RR surfaces too; l on PR and RP.
TEST(ConstraintManifold, HoldsTheSpecialElements) {
  using C = std::complex<double>;
  using ComplexVector = Eigen::Vector4cd;
  const ComplexVector J1(0, 0, C(0, 1), -1), V1(C(0, 1), 1, 0, 0), V2(C(0, -1), 1, 0, 0);  // (X4, X3, X2, -X1)
  const auto proportional = [](const ComplexVector& a, const ComplexVector& b) {
    return std::abs(std::abs(a.dot(b)) - a.norm() * b.norm()) < 1e-12 * a.norm() * b.norm();
  };
  for_random_designs("ConstraintManifold.HoldsTheSpecialElements",
                     [&]<class D>(const typename D::Design& d, Random& random) {
                       const Quadric<double> Q = constraint_quadric(Family::Design(d));
                       if (std::is_same_v<D, PP>) return;
                       Eigen::Matrix4cd M;
                       for (int i = 0; i < 4; ++i) M.col(i) = Q.gradient(Point3<double>::Unit(i)).cast<C>();
                       const ComplexVector tangent = M * J1;
                       EXPECT_LT(std::abs(J1.cwiseProduct(tangent).sum()), 1e-15);
                       const ComplexVector inverse = M.inverse() * V1;  // a plane touches where V^T M^-1 V = 0
                       EXPECT_LT(std::abs(V1.cwiseProduct(inverse).sum()), 1e-12 * inverse.norm()) << D::name;
                       EXPECT_EQ(proportional(tangent, V1), (std::is_same_v<D, PR>)) << D::name;
                       EXPECT_EQ(proportional(tangent, V2), (std::is_same_v<D, RP>)) << D::name;
                       const bool holds_l = Q(Point3<double>(0, 0, random.normal(), random.normal())) == 0;
                       EXPECT_EQ(holds_l, (!std::is_same_v<D, RR>)) << D::name;
                     });
}

TEST(ConstraintManifold, GeneratorsLieOnIt) {
  for_random_designs("ConstraintManifold.GeneratorsLieOnIt", []<class D>(const typename D::Design& d, Random& random) {
    const ConstraintManifold m{Family::Design(d)};
    const Pose pose = assembled(d, random_turn(random), random.uniform(-3, 3));
    const auto lines = m.generators(pose);
    ASSERT_EQ(lines.size(), (std::is_same_v<D, PP> ? 0u : 2u));
    for (const auto& [a, b] : lines) {
      Eigen::Matrix<double, 4, 3> span;  // the pose is on the line
      span << a.normalized(), b.normalized(), Space::point<double>(pose).normalized();
      EXPECT_NEAR((span.transpose() * span).determinant(), 0, 1e-14) << D::name;
      for (int i = 0; i < 5; ++i) {
        const Point3<double> x = std::cos(i) * a + std::sin(i) * b;
        EXPECT_NEAR(m.quadric()(x), 0, 1e-14 * size_of(m.quadric()) * (1 + x.squaredNorm())) << D::name;
      }
    }
  });
}

/// A shift along the residual's gradient by the distance meets the dyad; the notes' spacing is that of the image
/// points.
TEST(ConstraintManifold, DistanceIsTheLeastShiftAndSpacingItsImage) {
  for_random_designs("ConstraintManifold.DistanceIsTheLeastShiftAndSpacingItsImage",
                     []<class D>(const typename D::Design& d, Random& random) {
                       const ConstraintManifold m{Family::Design(d)};
                       const Pose pose = Space::random_pose(random);
                       if (std::is_same_v<D, PP>) {
                         EXPECT_FALSE(m.spacing(pose));
                         return;
                       }
                       const double distance = m.distance(pose);
                       double least = 1e9;
                       for (int degrees = 0; degrees < 360; ++degrees) {
                         const Vector2 u = distance * on_unit_circle(degrees * pi / 180);
                         least = std::min(least, m.distance({pose.x + u[0], pose.y + u[1], pose.X3, pose.X4}));
                       }
                       EXPECT_LT(least, 1e-2 * distance) << D::name;  // a degree off: 1 - cos, and a circle's curvature
                       const Vector<double, 4> X = image_point(pose) / image_point(pose)[3];
                       const auto curve = m.section(X[2], 1);
                       const double spacing =
                           std::visit([&](const auto& c) { return std::abs(c.signed_distance(X.head<2>())); }, *curve);
                       EXPECT_NEAR(*m.spacing(pose), spacing, 1e-12 * (1 + X.squaredNorm())) << D::name;
                     });
  const ConstraintManifold m(RR::Design{{1, 0}, {0, 0}, 1});
  EXPECT_TRUE(std::isinf(*m.spacing(pose_from_degrees(5, 0, 180))));
  EXPECT_NEAR(m.distance(pose_from_degrees(5, 0, 180)), 3, 1e-15);
  const ConstraintManifold met(RR::Design{{0, 0}, {1, 0}, 1});
  EXPECT_EQ(met.distance(pose_from_degrees(0, 0, 180)), 0);
  EXPECT_TRUE(std::isinf(*met.spacing(pose_from_degrees(0, 0, 180))));
}

}  // namespace
}  // namespace burmester::planar
