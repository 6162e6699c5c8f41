// The constraint surfaces of the dyads as quadrics of P^3, and the curve in which two of them meet: the
// motion of a linkage's coupler.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "burmester/planar/constraint_curve.hpp"
#include "moved_forms.hpp"

namespace burmester::planar {
namespace {

using Sections = QuadricSections<double>;

/// A whole number of 64ths.
double dyadic(Random& random) { return (random.below(513) - 256) / 64.0; }
Vector2 dyadic_point(Random& random) {
  const double x = dyadic(random);
  return {x, dyadic(random)};
}
RR::Design dyadic_RR(Random& random) {
  const Vector2 fixed = dyadic_point(random), moving = dyadic_point(random);
  return {fixed, moving, (1 + random.below(256)) / 64.0};
}
/// The normal is not of length 1, as the equation does not mind.
Line dyadic_line(Random& random) {
  const double a = (1 + random.below(64)) / 64.0, b = dyadic(random);
  return {{a, b}, dyadic(random)};
}

QuadricType type_of(const Vector<double, 8>& k) {
  const Quadric<double> surface = constraint_quadric(k);
  const QuadricType type = classify(surface, half_turns).type;
  EXPECT_EQ(classify(in_rationals(surface), half_turns.cast<Rational>()).type, type);
  return type;
}

/// M. J. D. Hayes, P. J. Zsombor-Murray, "Solving the Burmester problem using kinematic mapping", ASME DETC 2002.
TEST(ConstraintSurface, IsAHyperboloidOrAParaboloid) {
  Random random("ConstraintSurface.IsAHyperboloidOrAParaboloid");
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(type_of(RR::encode(dyadic_RR(random))), QuadricType::hyperboloid_of_one_sheet) << i;
    const Vector2 pivot = dyadic_point(random);
    const Line line = dyadic_line(random);
    EXPECT_EQ(type_of(PR::encode({pivot, line})), QuadricType::hyperbolic_paraboloid) << i;
    EXPECT_EQ(type_of(RP::encode({pivot, line})), QuadricType::hyperbolic_paraboloid) << i;
    const double c = line.normal[0], s = line.normal[1];  // PP: (c X3 - s X4)^2 = 0
    const Vector<double, 8> constant_angle{{0, 0, 0, 0, 0, 2 * (c * c + s * s), s * s - c * c, -2 * c * s}};
    EXPECT_EQ(type_of(constant_angle), QuadricType::coincident_planes) << i;
  }
}

TEST(ConstraintSurface, TypeIsTheSignOfTheSquaredLength) {
  Random random("ConstraintSurface.TypeIsTheSignOfTheSquaredLength");
  for (int i = 0; i < 100; ++i) {
    RR::Design d = dyadic_RR(random);
    d.length = 0;
    Vector<double, 8> k = RR::encode(d);
    EXPECT_EQ(type_of(k), QuadricType::line) << i;  // rotations about a point
    k[5] += 0x1p-30;                                // length^2 = -2^-30
    EXPECT_EQ(type_of(k), QuadricType::imaginary_ellipsoid) << i;
    k[5] -= 0x1p-29;
    EXPECT_EQ(type_of(k), QuadricType::hyperboloid_of_one_sheet) << i;
  }
}

/// Both families of lines consist of poses that meet the dyad.
TEST(ConstraintSurface, IsRuledByLinesOfPoses) {
  Random random("ConstraintSurface.IsRuledByLinesOfPoses");
  const auto expect_ruled = [&random]<class D>(const typename D::Design& d) {
    const Rulings X = rulings_of(constraint_quadric(D::encode(d)));
    for (int k = 0; k < 20; ++k) {
      const double a = random.uniform(0, 3.14), b = random.uniform(0, 3.14);
      const Point3<double> x = X({std::cos(a), std::sin(a)}, {std::cos(b), std::sin(b)}).normalized();
      if (Space::norm<double>(x) < 0.01) continue;
      EXPECT_NEAR(D::residual(d, Space::pose(x)), 0, 1e-9) << D::name;
    }
  };
  for (int i = 0; i < 50; ++i) {
    expect_ruled.operator()<RR>(RR::random_design(random));
    expect_ruled.operator()<PR>(PR::random_design(random));
    expect_ruled.operator()<RP>(RP::random_design(random));
  }
}

template <class D>
Vector<Rational, 8> exact_form(const typename D::Design& d) {
  return D::encode(d).template cast<Rational>();
}

/// The coupler can take an angle where the circles of the two pivots meet: with d the distance of their
/// centres, shifted by the coupler, (a + b)^2 > d^2 > (a - b)^2. Times X3^2 + X4^2 both differences are of degree 2.
TEST(ConstraintCurve, OfAFourBarTurnsWhereTheCirclesTouch) {
  Random random("ConstraintCurve.OfAFourBarTurnsWhereTheCirclesTouch");
  for (int i = 0; i < 50; ++i) {
    const RR::Design one = dyadic_RR(random), two = dyadic_RR(random);
    const QuadricSections<Rational> sections(constraint_quadric(exact_form<RR>(one)),
                                             constraint_quadric(exact_form<RR>(two)),
                                             planes_of_constant_angle<Rational>());
    ASSERT_TRUE(sections.axis_is_chord());
    const auto D = sections.discriminant();
    const auto touching = [&](const Rational& s, const Rational& t) {
      const Vector<Rational, 2> g = (one.fixed - two.fixed).cast<Rational>(),
                                c = (one.moving - two.moving).cast<Rational>();
      const Rational n = s * s + t * t, cosine = s * s - t * t, sine = 2 * s * t;
      const Rational turned = g[0] * (cosine * c[0] - sine * c[1]) + g[1] * (sine * c[0] + cosine * c[1]);
      const Rational d2 = (g.squaredNorm() + c.squaredNorm()) * n - 2 * turned;
      const Rational a(one.length), b(two.length);
      return Rational(((a + b) * (a + b) * n - d2) * (d2 - (a - b) * (a - b) * n));
    };
    const Rational factor = D(Rational(1), Rational(0)) / touching(Rational(1), Rational(0));
    EXPECT_GT(factor, 0) << i;
    for (const auto& [s, t] :
         {std::pair(0, 1), std::pair(1, 1), std::pair(1, -2), std::pair(3, 1), std::pair(-5, 7)})
      EXPECT_EQ(D(Rational(s), Rational(t)), factor * touching(Rational(s), Rational(t))) << i;
  }
}

/// Every point of every plane is a pose that meets both dyads.
TEST(ConstraintCurve, ConsistsOfPosesThatMeetBothDyads) {
  Random random("ConstraintCurve.ConsistsOfPosesThatMeetBothDyads");
  int found = 0;
  const auto check = [&]<class D, class E>() {
    for (int i = 0; i < 100; ++i) {
      const typename D::Design d = D::random_design(random);
      const typename E::Design e = E::random_design(random);
      const Sections sections(constraint_quadric(D::encode(d)), constraint_quadric(E::encode(e)),
                              planes_of_constant_angle<double>());
      const double angle = random.uniform(-3.14, 3.14), s = std::cos(angle / 2), t = std::sin(angle / 2);
      const SectionPoints points = points_in_plane(sections, s, t);
      const bool sliders = D::encode(d)[0] == 0 && E::encode(e)[0] == 0;
      EXPECT_EQ(sections.axis_is_common(), sliders) << D::name << E::name;
      EXPECT_TRUE(points.count == (sliders ? 1 : 2) || (!sliders && points.count == 0)) << D::name << E::name;
      for (int k = 0; k < points.count; ++k, ++found) {
        const Pose x = Space::pose(points.point[static_cast<std::size_t>(k)]);
        EXPECT_NEAR(std::remainder(angle_of(x) - angle, 2 * std::numbers::pi), 0, 1e-14)
            << D::name << E::name;
        const double size = 1 + x.x * x.x + x.y * x.y;  // far away where guides are nearly parallel
        EXPECT_NEAR(D::residual(d, x), 0, 1e-12 * size) << D::name << E::name << " case " << i;
        EXPECT_NEAR(E::residual(e, x), 0, 1e-12 * size) << D::name << E::name << " case " << i;
      }
    }
  };
  check.operator()<RR, RR>();
  check.operator()<RR, PR>();
  check.operator()<RP, RR>();
  check.operator()<PR, PR>();
  check.operator()<RP, RP>();
  check.operator()<PR, RP>();
  EXPECT_GT(found, 400);
}

/// The four-bar of the published five-pose example (Hayes, Zsombor-Murray 2002, table 1): fixed pivots (-8,
/// 0), (8, 0), links 8, 10, 14; E has its origin at (2, 3) in the coupler frame and its x axis along (6, 7).
class PublishedFourBar {
 public:
  static Vector2 in_E(const Vector2& coupler_point) {
    const Vector2 d = coupler_point - Vector2(2, 3);
    return Vector2(6 * d[0] + 7 * d[1], -7 * d[0] + 6 * d[1]) / std::sqrt(85.0);
  }
  static RR::Design crank() { return {{-8, 0}, in_E({0, 0}), 8}; }
  static RR::Design follower() { return {{8, 0}, in_E({10, 0}), 14}; }

  /// Position analysis from the crank angle, radians; nothing where the linkage cannot take it.
  static std::optional<Pose> pose(double crank_angle, int mode) {
    const Vector2 C = Vector2(-8, 0) + 8 * Vector2(std::cos(crank_angle), std::sin(crank_angle));
    const Vector2 diagonal = Vector2(8, 0) - C;
    const double length = diagonal.norm(), cosine = (100 + length * length - 196) / (20 * length);
    if (std::abs(cosine) > 1) return std::nullopt;
    const double coupler = std::atan2(diagonal[1], diagonal[0]) + mode * std::acos(cosine);
    const double c = std::cos(coupler), s = std::sin(coupler);
    return pose_from_radians(C[0] + 2 * c - 3 * s, C[1] + 2 * s + 3 * c, coupler + std::atan2(7, 6));
  }
};

TEST(PublishedFourBar, TakesThePublishedPoses) {
  const double printed[5][4] = {{0, -3.339, 1.360, 150.94},
                                {30, -2.975, 7.063, 114.94},
                                {45, -3.405, 9.102, 100.22},
                                {90, -7.435, 11.561, 74.07},
                                {105, -9.171, 11.219, 68.65}};
  for (const auto& [crank, x, y, degrees] : printed) {
    const auto pose = PublishedFourBar::pose(crank * std::numbers::pi / 180, 1);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->x, x, 6e-4);
    EXPECT_NEAR(pose->y, y, 6e-4);
    EXPECT_NEAR(angle_of(*pose) * 180 / std::numbers::pi, degrees, 6e-3);
  }
}

/// Two points of a plane that are `apart` are the roots of a quadratic equation; its rounding moves them by
/// about the roundoff over `apart` (unit vectors).
TEST(PublishedFourBar, MovesAlongTheCurveOfItsTwoSurfaces) {
  const Sections sections(constraint_quadric(RR::encode(PublishedFourBar::crank())),
                          constraint_quadric(RR::encode(PublishedFourBar::follower())),
                          planes_of_constant_angle<double>());
  int poses = 0;
  for (const int mode : {-1, 1})
    for (int degrees = 0; degrees < 360; ++degrees) {
      const auto pose = PublishedFourBar::pose(degrees * std::numbers::pi / 180, mode);
      if (!pose) continue;
      ++poses;
      const SectionPoints found = points_in_plane(sections, pose->X4, pose->X3);
      ASSERT_EQ(found.count, 2) << degrees;
      const Point3<double> x = Space::point<double>(*pose).normalized();
      double nearest = 2;
      std::array<Point3<double>, 2> y;
      for (std::size_t k = 0; k < 2; ++k) {
        y[k] = found.point[k].normalized();
        if (y[k].dot(x) < 0) y[k] = -y[k];
        nearest = std::min(nearest, (y[k] - x).norm());
      }
      EXPECT_LT(nearest * (y[0] - y[1]).norm(), 256 * unit_roundoff) << degrees << " mode " << mode;
    }
  EXPECT_GT(poses, 300);
}

}  // namespace
}  // namespace burmester::planar
