// Fits to orientations close to each other: derivatives against quad precision, minima against many random starts, the
// laws and one set as it was found elsewhere.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burmester/geometry/quad.hpp"
#include "burmester/spherical/angle_fit.hpp"
#include "burmester/spherical/least_squares.hpp"

namespace burmester::spherical {
namespace {

constexpr double spreads[] = {1, 0.03, 1e-3, 1e-5, 1e-7};

/// Quaternions of different lengths about a common one.
std::vector<Pose> close_poses(Random& random, int count, double spread) {
  const Pose p = Space::random_pose(random);
  const auto beside = [&](double x) { return x + spread * random.normal(); };
  std::vector<Pose> out;
  for (int i = 0; i < count; ++i) {
    const double length = random.uniform(0.5, 2);
    Space::Point<double> q;
    q << beside(p.w), beside(p.x), beside(p.y), beside(p.z);
    out.push_back(Space::pose(length * q));
  }
  return out;
}

TurnedTask equal_weights(std::span<const Pose> poses) {
  return turned_task(poses, std::vector<double>(poses.size(), 1));
}

AxesAt random_axes(Random& random, const TurnedTask& task) {
  const Axis b = Space::random_feature(random), to = Space::random_feature(random);
  const double away = random.below(2) ? 1 : task.e * std::pow(10, random.uniform(-1, 2));
  return axes_at(b, b + away * to);
}

// ---- The same in quad precision, from the definition ----

using Vector3Q = Vector<Quad, 3>;

Vector3Q unit(const Vector3Q& v) { return v / sqrt(v.dot(v)); }

struct QuadAxes {
  Vector3Q fixed, moving;  ///< seen in the reference orientation
};

/// Orthogonal to all digits, with neighbours along the four variables of angle_errors.
QuadAxes at(const AxesAt& x, const Vector<Quad, 4>& u, Quad length) {
  const Vector3Q b = unit(x.frame.col(0).cast<Quad>()), n = unit(b.cross(Vector3Q(x.frame.col(1).cast<Quad>()))),
                 p = n.cross(b);
  const Quad size = sqrt(Quad(x.cosine) * x.cosine + Quad(x.sine) * x.sine), C = x.cosine / size, S = x.sine / size;
  const Vector3Q a = unit(C * b + S * p + length * u[0] * (C * p - S * b) + length * u[1] * n), r = u[2] * p + u[3] * n;
  const Quad angle = sqrt(r.dot(r));
  if (angle == 0) return {b, a};
  const auto turned = [&](const Vector3Q& v) -> Vector3Q {
    return v + sin(angle) / angle * r.cross(v) + (1 - cos(angle)) / (angle * angle) * r.cross(r.cross(v));
  };
  return {turned(b), turned(a)};
}

template <class D>
Quad half_sum(std::span<const Pose> poses, const QuadAxes& x) {
  const auto reference = Space::conjugate<Quad>(Space::point<Quad>(poses[0]));
  Vector<Quad, Eigen::Dynamic> angle(static_cast<Eigen::Index>(poses.size()));
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const auto turn = Space::product<Quad>(reference, Space::point<Quad>(poses[j]));
    const Vector3Q place = Space::act<Quad>(turn, x.moving), across = x.fixed.cross(place);
    angle[static_cast<Eigen::Index>(j)] = atan2(sqrt(across.dot(across)), x.fixed.dot(place));
  }
  Quad arc = atan2(Quad(1), Quad(0));
  if (std::is_same_v<D, RR>) arc = angle.sum() / Quad(static_cast<double>(poses.size()));
  Quad sum = 0;
  for (const Quad& theta : angle) sum += (theta - arc) * (theta - arc) / 2;
  return sum;
}

/// Half the sum of squares with its derivatives.
struct ErrorSum {
  double value = 0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
};

template <class D>
ErrorSum error_sum(const TurnedTask& task, const AxesAt& x) {
  const AngleErrors at = angle_errors<D>(task, x);
  const Eigen::VectorXd weighted = task.weights.cwiseProduct(at.values);
  return {weighted.dot(at.values) / 2, at.slopes * weighted,
          at.slopes * task.weights.asDiagonal() * at.slopes.transpose() + (at.bends * weighted).reshaped(4, 4)};
}

/// Gradient and Hessian by central differences: 1e-33 of the sum over the step, and over its square.
template <class D>
ErrorSum by_differences(std::span<const Pose> poses, const TurnedTask& task, const AxesAt& x, Quad h = 1e-6) {
  const Quad length = length_of_alpha(task, x);
  const auto f = [&](int i, int s, int j, int t) {
    Vector<Quad, 4> u = Vector<Quad, 4>::Zero();
    u[i] += h * s, u[j] += h * t;
    return half_sum<D>(poses, at(x, u, length));
  };
  ErrorSum out;
  out.value = static_cast<double>(f(0, 0, 0, 0));
  for (int i = 0; i < 4; ++i) {
    out.gradient[i] = static_cast<double>(Quad((f(i, 1, i, 0) - f(i, -1, i, 0)) / (2 * h)));
    for (int j = 0; j < 4; ++j)
      out.hessian(i, j) =
          static_cast<double>(Quad((f(i, 1, j, 1) - f(i, 1, j, -1) - f(i, -1, j, 1) + f(i, -1, j, -1)) / (4 * h * h)));
  }
  return out;
}

template <class D>
void expect_derivatives(const char* name) {
  Random random(name);
  for (const double spread : spreads)
    for (int i = 0; i < 4; ++i) {
      const std::vector<Pose> poses = close_poses(random, 7, spread);
      const TurnedTask task = equal_weights(poses);
      AxesAt x = random_axes(random, task);
      if (std::is_same_v<D, PR> && i < 2)  // nearly a slider
        x.cosine = task.e * random.normal(), x.sine = std::sqrt(1 - x.cosine * x.cosine);
      const ErrorSum got = error_sum<D>(task, x), expected = by_differences<D>(poses, task, x);
      SCOPED_TRACE(testing::Message() << name << ", spread " << spread << ", " << i);
      // differences leave h^2 times the third derivatives
      const double large = 1e-9 * (std::sqrt(expected.value) * spread + spread * spread);
      EXPECT_NEAR(got.value, expected.value, 1e-12 * expected.value);
      EXPECT_LT((got.gradient - expected.gradient).norm(), large + 1e-9 * expected.gradient.norm());
      EXPECT_LT((got.hessian - expected.hessian).norm(), large + 1e-9 * expected.hessian.norm());
    }
}

TEST(CloseFits, DerivativesAreThoseOfTheDefinition) {
  expect_derivatives<RR>("CloseFits.DerivativesAreThoseOfTheDefinition, RR");
  expect_derivatives<PR>("CloseFits.DerivativesAreThoseOfTheDefinition, PR");
}

// ---- Minima ----

template <class D>
std::vector<AngleFit<D>> from_random_starts(Random& random, const TurnedTask& task, int starts) {
  std::vector<AngleFit<D>> out;
  for (int i = 0; i < starts; ++i) {
    const auto fit = nearest_fit<D>(task, random_axes(random, task), 500);
    if (fit.least && std::none_of(out.begin(), out.end(), [&](const auto& f) { return same_fit(task, f, fit, 1e-5); }))
      out.push_back(fit);
  }
  return out;
}

/// A listed design where the sum is least within its last digits.
template <class D>
AngleFit<D> listed_fit(const TurnedTask& task, const typename D::Design& d) {
  const auto back = Space::conjugate<double>(Space::point<double>(task.reference));
  return nearest_fit<D>(task, axes_at(Space::act<double>(back, d.fixed), d.moving), 20);
}

/// The part of the sum that a Newton step in quad precision's derivatives still takes away, and the least eigenvalue
/// of the Hessian relative to the largest.
template <class D>
void expect_minimum(std::span<const Pose> poses, const TurnedTask& task, const AngleFit<D>& fit, Quad h = 1e-6) {
  const ErrorSum at = by_differences<D>(poses, task, fit.axes, h);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> modes(at.hessian);
  EXPECT_GT(modes.eigenvalues()[0], 0);
  EXPECT_LT(at.gradient.dot(at.hessian.ldlt().solve(at.gradient)), 1e-12 * at.value);
}

TEST(CloseFits, AllMinimaThatManyRandomStartsFindAreListed) {
  Random random("CloseFits.AllMinimaThatManyRandomStartsFindAreListed");
  int minima = 0, missed = 0;
  for (const double spread : spreads)
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(testing::Message() << "spread " << spread << ", " << i);
      const std::vector<Pose> poses = close_poses(random, 6 + i % 4, spread);
      const TurnedTask task = equal_weights(poses);
      std::vector<AngleFit<RR>> listed;
      for (const auto& f : best_dyads(poses)) {
        listed.push_back(listed_fit<RR>(task, f.design));
        EXPECT_LT(f.residual, 4 * spread);
        expect_minimum<RR>(poses, task, listed.back());
      }
      for (const auto& fit : from_random_starts<RR>(random, task, 60)) {
        ++minima;
        missed +=
            std::none_of(listed.begin(), listed.end(), [&](const auto& f) { return same_fit(task, f, fit, 1e-4); });
      }
      const auto slider = best_slider(poses);
      ASSERT_TRUE(slider);
      const auto best = listed_fit<PR>(task, slider->design);
      expect_minimum<PR>(poses, task, best);
      for (const auto& fit : from_random_starts<PR>(random, task, 30)) EXPECT_GE(fit.sum, (1 - 1e-9) * best.sum);
    }
  EXPECT_GT(minima, 60);
  EXPECT_EQ(missed, 0);
}

// ---- Valleys ----

/// Quaternions of turns about one axis, each off it by about `off`.
std::vector<Pose> nearly_coaxial(Random& random, double off) {
  const Axis axis = Space::random_feature(random);
  const auto at = Space::point<double>(Space::random_pose(random));
  std::vector<Pose> out;
  for (int i = 0; i < 6; ++i) {
    const double angle = random.uniform(-1, 1);
    Space::Point<double> turn(std::cos(angle), 0, 0, 0), beside(1, 0, 0, 0);
    turn.tail<3>() = std::sin(angle) * axis;
    for (int k = 1; k < 4; ++k) beside[k] = off * random.normal();
    out.push_back(Space::pose(Space::product<double>(at, Space::product<double>(turn, beside))));
  }
  return out;
}

std::vector<Pose> two_clusters(Random& random, double width) {
  std::vector<Pose> out = close_poses(random, 3, width);
  for (const Pose& p : close_poses(random, 3, width)) out.push_back(p);
  return out;
}

void expect_isolated_minima(std::span<const Pose> poses) {
  const TurnedTask task = equal_weights(poses);
  std::vector<AngleFit<RR>> listed;
  for (const auto& f : best_dyads(poses)) {
    EXPECT_TRUE(std::isfinite(*f.condition));
    listed.push_back(listed_fit<RR>(task, f.design));
    expect_minimum<RR>(poses, task, listed.back(), 1e-12);  // third derivatives are those across
  }
  EXPECT_FALSE(listed.empty());
  for (std::size_t i = 0; i < listed.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(same_fit(task, listed[i], listed[k], 1e-7)) << i << ", " << k;
}

TEST(CloseFits, ValleysListTheirMinimaOnceAndNothingElse) {
  Random random("CloseFits.ValleysListTheirMinimaOnceAndNothingElse");
  for (const double flat : {1e-4, 1e-6})  // the sum changes along a valley by its square, relative to across
    for (int i = 0; i < 2; ++i) {
      SCOPED_TRACE(testing::Message() << "flat " << flat << ", " << i);
      expect_isolated_minima(nearly_coaxial(random, flat));
      expect_isolated_minima(two_clusters(random, flat));
    }
}

TEST(CloseFits, NearlyCoaxialOrientationsHaveDyadsNearTheAxis) {
  Random random("CloseFits.NearlyCoaxialOrientationsHaveDyadsNearTheAxis");
  for (const double off : {1e-3, 1e-6, 1e-9}) {
    SCOPED_TRACE(testing::Message() << "off " << off);
    const auto dyads = best_dyads(nearly_coaxial(random, off));
    EXPECT_TRUE(std::any_of(dyads.begin(), dyads.end(), [&](const auto& f) {  // as in the plane, in that scale
      return f.residual < 4 * off && f.design.arc < 100 * off;
    }));
  }
}

TEST(CloseFits, TheSliderOfSixAboutTheIdentity) {
  const std::vector<Pose> poses{{1.006, .015, .011, -.014}, {.987, -.047, -.023, -.015}, {1.033, -.041, .058, .028},
                                {.984, -.019, .007, .012},  {1.022, -.054, -.011, .015}, {1.028, .014, -.003, .009}};
  const auto slider = best_slider(poses);
  ASSERT_TRUE(slider);
  const Axis moving(.7546946, .6365498, .1588721), fixed(.6282332, -.6406018, -.4415341);  // from random starts
  EXPECT_LT(slider->design.moving.cross(moving).norm(), 1e-6);
  EXPECT_LT(slider->design.fixed.cross(fixed).norm(), 1e-6);
}

TEST(CloseFits, InversionExchangesTheAxes) {
  Random random("CloseFits.InversionExchangesTheAxes");
  for (const double spread : {0.1, 1e-4, 1e-7}) {
    SCOPED_TRACE(testing::Message() << "spread " << spread);
    const std::vector<Pose> poses = close_poses(random, 8, spread);
    std::vector<Pose> inverse;
    for (const Pose& p : poses) inverse.push_back(Space::pose(Space::conjugate<double>(Space::point<double>(p))));
    const auto slider = best_slider(poses), back = best_slider(inverse);
    ASSERT_TRUE(slider && back);
    EXPECT_LT(slider->design.fixed.cross(back->design.moving).norm(), 1e-6);
    EXPECT_LT(slider->design.moving.cross(back->design.fixed).norm(), 1e-6);
    const auto dyads = best_dyads(poses), exchanged = best_dyads(inverse);
    ASSERT_FALSE(dyads.empty());
    EXPECT_NEAR(dyads[0].residual / spread, exchanged[0].residual / spread, 1e-6);
  }
}

TEST(CloseFits, PlantedDyadsAreFoundExactly) {
  Random random("CloseFits.PlantedDyadsAreFoundExactly");
  for (const double spread : {0.1, 1e-4, 1e-7}) {
    SCOPED_TRACE(testing::Message() << "spread " << spread);
    // small turns about both axes of a dyad whose arc is of their size
    const Axis b = Space::random_feature(random), a = (b + spread * Space::random_feature(random)).normalized();
    const auto about = [](const Axis& axis, double angle) -> Space::Point<double> {
      const double s = std::sin(angle / 2);
      return {std::cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
    };
    // half a turn about b moves a by its arc: the rest of the turn about a brings the orientation back
    std::vector<Pose> poses;
    for (int i = 0; i < 8; ++i) {
      const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      poses.push_back(Space::pose(Space::product<double>(about(b, angle), about(a, spread * random.normal() - angle))));
    }
    const SphericalReport report = LeastSquaresSolver().solve(poses);
    ASSERT_EQ(report.status, Status::exact) << report.message;
    EXPECT_TRUE(std::any_of(report.dyads.begin(), report.dyads.end(), [&](const auto& f) {
      const auto* rr = std::get_if<RR::Design>(&f.design);
      return rr && rr->fixed.cross(b).norm() < 1e-15 * (1 + 10 * *f.condition) &&
             rr->moving.cross(a).norm() < 1e-15 * (1 + 10 * *f.condition);
    }));
  }
}

}  // namespace
}  // namespace burmester::spherical
