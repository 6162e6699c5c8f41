#include "burmester/planar/motion_rank.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>
#include <vector>

#include "burmester/planar/constraint_curve.hpp"

namespace burmester::planar {
namespace {

/// Poses of a linkage, spread over the orientations that it takes, far ones (parallel guides) left out.
std::vector<Pose> motion_of(const Family::Design& a, const Family::Design& b) {
  const ConstraintCurve curve((ConstraintManifold(a)), (ConstraintManifold(b)));
  std::vector<Pose> out;
  for (const Range& r : curve.orientations())
    for (int i = 1; i < 60; ++i) {
      const double angle = r.low + (r.high - r.low) * i / 60;
      for (const Pose& x : curve.at(std::sin(angle / 2), std::cos(angle / 2)).poses)
        if (std::hypot(x.x, x.y) < 20) out.push_back(x);
    }
  return out;
}

std::vector<Pose> moved(const std::vector<Pose>& poses, const Pose& g, const Pose& h, double scale) {
  std::vector<Pose> out;
  for (const Pose& x : poses) {
    const auto y = Space::product<double>(Space::product<double>(Space::point<double>(g), Space::point<double>(x)),
                                          Space::point<double>(h));
    out.push_back(Space::pose(y));
    out.back().x *= scale, out.back().y *= scale;
  }
  return out;
}

/// M. J. D. Hayes, T. Luu, X.-W. Chang, ARK 2004: 8 general motion, 6 two RR, 6 PR and RR, 5 two PR; 6 for RR and RP,
/// which is not printed. Neither frame nor unit matters.
TEST(MotionRank, PublishedTable) {
  Random random("MotionRank.PublishedTable");
  const auto check = [&]<class D, class E>(int rank) {
    int motions = 0;
    for (int i = 0; i < 20; ++i) {
      const std::vector<Pose> poses = motion_of(D::random_design(random), E::random_design(random));
      if (poses.size() < 24) continue;
      ++motions;
      const Pose g = Space::random_pose(random), h = Space::random_pose(random);
      for (const double scale : {1e-3, 1.0, 1e3})
        EXPECT_EQ(motion_rank(moved(poses, g, h, scale), 1e-13).rank, rank) << D::name << E::name << i;
    }
    EXPECT_GT(motions, 5) << D::name << E::name;
  };
  check.operator()<RR, RR>(6);
  check.operator()<PR, RR>(6);
  check.operator()<RR, RP>(6);
  check.operator()<PR, PR>(5);
  check.operator()<RP, RP>(5);
  check.operator()<PR, RP>(6);
  std::vector<Pose> general;
  for (int i = 0; i < 24; ++i) general.push_back(Space::random_pose(random));
  EXPECT_EQ(motion_rank(general).rank, 8);
  general.resize(5);
  EXPECT_EQ(motion_rank(general).rank, 5);
  EXPECT_EQ(motion_rank({}).rank, 0);
}

/// Noise fills the rank up; told of it, the rank is that of the motion.
TEST(MotionRank, SeesThroughErrorsItIsToldOf) {
  Random random("MotionRank.SeesThroughErrorsItIsToldOf");
  std::vector<Pose> poses = motion_of(RR::Design{{0, 0}, {0, 0}, 1}, RR::Design{{4, 0}, {3, 0}, 3});
  ASSERT_GE(poses.size(), 24u);
  for (Pose& x : poses) x = Space::nudged(x, {1e-7 * random.normal(), 1e-7 * random.normal(), 1e-7 * random.normal()});
  EXPECT_EQ(motion_rank(poses).rank, 8);
  EXPECT_EQ(motion_rank(poses, 5e-7).rank, 6);
}

}  // namespace
}  // namespace burmester::planar
