#include "burmester/geometry/quadric_axes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Q = Quadric<double>;
using Vector3 = Vector<double, 3>;

/// x = scale rotation (coordinates of the normal form) + shift
struct Similarity {
  Matrix<double, 3, 3> rotation;
  Vector3 shift;
  double scale;
};

Similarity random_similarity(Random& random) {
  const auto number = [&random] { return random.uniform(-3, 3); };
  const Vector3 axis(number(), number(), number());
  return {Eigen::AngleAxisd(number(), axis.normalized()).toRotationMatrix(),
          {number(), number(), number()},
          std::exp(number())};
}

/// sum q_i y_i^2 + 2 g y_2 + c at y = rotation^T (x - shift) / scale, times a factor.
Q moved(const Vector3& q, double g, double c, const Similarity& s, double factor) {
  std::array<Point3<double>, 4> y;  // linear forms
  for (int i = 0; i < 3; ++i) {
    const Vector3 r = s.rotation.col(i) / s.scale;
    y[static_cast<std::size_t>(i)] = {r[0], r[1], r[2], -r.dot(s.shift)};
  }
  y[3] = {0, 0, 0, 1};
  Q out;
  for (int i = 0; i < 3; ++i)
    out.add_product(y[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(i)], factor * q[i]);
  out.add_product(y[2], y[3], 2 * factor * g);
  out.add_product(y[3], y[3], factor * c);
  return out;
}

/// Parallel or antiparallel unit vectors.
void expect_same_line(const Vector3& a, const Vector3& b, const std::string& what) {
  EXPECT_NEAR(std::abs(a.dot(b)), 1, 1e-10) << what;
}

TEST(QuadricAxes, OfNormalFormsTurnedScaledAndShifted) {
  const Vector3 squares[] = {{9, 4, 1}, {9, 4, -1}, {4, -1, -9}, {-1, -4, -9}};  // of semi-axes 3, 2, 1
  Random random("QuadricAxes.OfNormalFormsTurnedScaledAndShifted");
  for (const Vector3& square : squares)
    for (int n = 0; n < 50; ++n) {
      const Similarity s = random_similarity(random);
      const double factor = (n % 2 == 0 ? 1 : -1) * std::exp(random.uniform(-200, 200));
      const QuadricAxes axes = axes_of(moved(square.cwiseInverse(), 0, -1, s, factor));
      EXPECT_LT((axes.centre - s.shift).norm(), 1e-9) << n;
      for (std::size_t i = 0; i < 3; ++i) {
        const int k = static_cast<int>(i);
        EXPECT_NEAR(axes.square[i] / (s.scale * s.scale), square[k], 1e-9) << n;
        expect_same_line(axes.axis[i], s.rotation.col(k), "axis " + std::to_string(i));
      }
      EXPECT_NEAR(axes.axis[0].cross(axes.axis[1]).dot(axes.axis[2]), 1, 1e-12);
    }
}

TEST(QuadricAxes, SpheresAndCoordinateForms) {
  const QuadricAxes sphere = axes_of({{1, 1, 1, -4, 0, 0, -2, 0, 0, -4}});  // (x - 1)^2 + y^2 + (z - 2)^2 = 9
  EXPECT_LT((sphere.centre - Vector3(1, 0, 2)).norm(), 1e-15);
  for (const double square : sphere.square) EXPECT_NEAR(square, 9, 1e-14);
  const QuadricAxes hyperboloid = axes_of({{0, 0, 1, -2, 2, 0, 0, 0, 0, 0}});  // 2 x y + z^2 = 2
  EXPECT_NEAR(hyperboloid.square[0], 2, 1e-14);
  EXPECT_NEAR(hyperboloid.square[1], 2, 1e-14);
  EXPECT_NEAR(hyperboloid.square[2], -2, 1e-14);
  expect_same_line(hyperboloid.axis[2], Vector3(1, -1, 0).normalized(), "x = -y");
}

TEST(QuadricAxes, ParaboloidsTurnedScaledAndShifted) {
  Random random("QuadricAxes.ParaboloidsTurnedScaledAndShifted");
  for (const auto& [p, q] : {std::pair{3.0, 2.0}, std::pair{3.0, -2.0}})
    for (int n = 0; n < 50; ++n) {
      const Similarity s = random_similarity(random);
      const double factor = (n % 2 == 0 ? 1 : -1) * std::exp(random.uniform(-200, 200));
      const ParaboloidFrame frame = paraboloid_frame(moved({1 / p, 1 / q, 0}, -1, 0, s, factor));
      EXPECT_LT((frame.vertex - s.shift).norm(), 1e-8) << n;
      EXPECT_LT((frame.axis - s.rotation.col(2)).norm(), 1e-9) << n;
      EXPECT_NEAR(frame.parameter[0] / s.scale, p, 1e-9) << n;
      EXPECT_NEAR(frame.parameter[1] / s.scale, q, 1e-9) << n;
      expect_same_line(frame.principal[0], s.rotation.col(0), "principal 0");
      expect_same_line(frame.principal[1], s.rotation.col(1), "principal 1");
      EXPECT_NEAR(frame.principal[0].cross(frame.principal[1]).dot(frame.axis), 1, 1e-12);
    }
}

/// z = x y: in the frame of its bisectors u^2 - v^2 = 2 z.
TEST(QuadricAxes, TheSaddle) {
  const ParaboloidFrame frame = paraboloid_frame({{0, 0, 0, 0, 1, 0, 0, 0, 0, -1}});
  EXPECT_LT(frame.vertex.norm(), 1e-15);
  expect_same_line(frame.axis, {0, 0, 1}, "axis");
  EXPECT_NEAR(frame.parameter[0], 1, 1e-15);
  EXPECT_NEAR(frame.parameter[1], -1, 1e-15);
}

}  // namespace
}  // namespace burmester
