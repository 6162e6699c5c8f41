// Orientations close to each other about axes near one point of the sphere look planar from there: as the radius grows
// in units of the task, the dyads near that point converge to those of the planar poses in the tangent plane, with an
// error that falls with the square of the curvature. The planar dyads come from a search of its own: Newton's method on
//   |R_j p + t_j - c|^2 = |R_0 p + t_0 - c|^2,  j = 1..4,
// from many starts.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "burmester/spherical/tangent_plane.hpp"
#include "burmester/spherical/tasks.hpp"
#include "five_orientations.hpp"

namespace burmester::spherical {
namespace {

using Vector2 = Eigen::Vector2d;

struct PlanarPose {
  double x, y, angle;
  Vector2 place(const Vector2& p) const { return Eigen::Rotation2Dd(angle) * p + Vector2(x, y); }
};
struct PlanarDyad {
  Vector2 moving, fixed;
};
using PlanarTask = std::array<PlanarPose, 5>;

std::optional<PlanarDyad> newton(const PlanarTask& task, PlanarDyad d) {
  for (int i = 0; i < 60; ++i) {
    Eigen::Vector4d value;
    Eigen::Matrix4d J;
    const auto row = [&](const PlanarPose& pose) {
      const Vector2 arm = pose.place(d.moving) - d.fixed, back = Eigen::Rotation2Dd(-pose.angle) * arm;
      return Eigen::RowVector4d(2 * back[0], 2 * back[1], -2 * arm[0], -2 * arm[1]);
    };
    for (int j = 0; j < 4; ++j) {
      const PlanarPose& pose = task[static_cast<std::size_t>(j + 1)];
      value[j] = (pose.place(d.moving) - d.fixed).squaredNorm() - (task[0].place(d.moving) - d.fixed).squaredNorm();
      J.row(j) = row(pose) - row(task[0]);
    }
    const Eigen::Vector4d step = J.partialPivLu().solve(-value);
    if (!step.allFinite()) return std::nullopt;
    d.moving += step.head<2>(), d.fixed += step.tail<2>();
    if (d.moving.norm() > 50 || d.fixed.norm() > 50) return std::nullopt;
    if (step.norm() < 1e-13) return d;
  }
  return std::nullopt;
}

std::vector<PlanarDyad> planar_dyads(Random& random, const PlanarTask& task) {
  std::vector<PlanarDyad> out;
  for (int start = 0; start < 600; ++start) {
    const auto found =
        newton(task, {{3 * random.normal(), 3 * random.normal()}, {3 * random.normal(), 3 * random.normal()}});
    if (!found) continue;
    const bool known = std::any_of(out.begin(), out.end(), [&](const PlanarDyad& d) {
      return (d.moving - found->moving).norm() + (d.fixed - found->fixed).norm() < 1e-6;
    });
    if (!known) out.push_back(*found);
  }
  return out;
}

/// The planar task on the sphere of radius 1 / curvature, in the tangent plane at the z axis.
FivePoseTask on_sphere(const PlanarTask& task, double curvature) {
  FivePoseTask out;
  for (std::size_t j = 0; j < 5; ++j) {
    const auto& [x, y, angle] = task[j];
    out[j] = wrapped_pose(x, y, angle, curvature);
  }
  return out;
}

/// Largest distance of a planar dyad from the nearest spherical one, in the plane.
double error(const std::vector<PlanarDyad>& planar, const SphericalReport& report, double curvature) {
  double worst = 0;
  for (const PlanarDyad& d : planar) {
    double least = 1e9;
    for (const auto& found : report.dyads) {
      const RR::Design s = support::as_RR(found.design);
      least = std::min(least, (in_tangent_plane(s.moving, curvature) - d.moving).norm() +
                                  (in_tangent_plane(s.fixed, curvature) - d.fixed).norm());
    }
    worst = std::max(worst, least);
  }
  return worst;
}

TEST(PlanarLimit, FourOfTheSixDyadsConvergeToThePlanarOnes) {
  Random random("PlanarLimit.FourOfTheSixDyadsConvergeToThePlanarOnes");
  int with_four = 0;
  for (int i = 0; i < 200 && with_four < 5; ++i) {
    PlanarTask task;
    for (PlanarPose& p : task) p = {random.normal(), random.normal(), random.uniform(-1, 1)};
    const std::vector<PlanarDyad> planar = planar_dyads(random, task);
    if (planar.size() != 4) continue;
    ++with_four;
    const SphericalReport wide = FivePoseSolver().solve(on_sphere(task, 1e-4)),
                          narrow = FivePoseSolver().solve(on_sphere(task, 1e-5));
    EXPECT_EQ(wide.dyads.size(), 4u) << "task " << i << ": the other two are complex";
    EXPECT_EQ(narrow.dyads.size(), 4u) << "task " << i;
    const double coarse = error(planar, wide, 1e-4), fine = error(planar, narrow, 1e-5);
    EXPECT_LT(coarse, 1e-2) << "task " << i;
    EXPECT_LT(fine, coarse / 50) << "task " << i;
  }
  EXPECT_EQ(with_four, 5);
}

}  // namespace
}  // namespace burmester::spherical
