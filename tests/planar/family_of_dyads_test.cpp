// Two and three poses without given pivots: the family of dyads, its poles and its samples.
#include <gtest/gtest.h>

#include <cmath>

#include "burmester/planar/pivots.hpp"

namespace burmester::planar {
namespace {

using Poses = std::vector<Pose>;

TEST(FamilyOfDyads, IsSampled) {
  Random random("FamilyOfDyads.IsSampled");
  for (const int count : {2, 3}) {
    Poses poses;
    for (int i = 0; i < count; ++i) poses.push_back(Space::random_pose(random));
    const PlanarReport report = FamilySolver().solve(poses);
    EXPECT_EQ(report.status, Status::family);
    EXPECT_EQ(report.counts.dimension, 5 - count);
    EXPECT_EQ(report.family.poles.size(), count == 2 ? 1u : 3u);
    EXPECT_GE(report.family.samples.size(), 49u);
    for (const DyadRecord& d : report.family.samples) EXPECT_LT(d.residual, 1e-11 * (1 + d.length.value_or(0)));
  }
  EXPECT_NE(FamilySolver().solve(Poses{{0, 0, 0, 1}, {2, 4, 1, 0}}).message.find("by 180 deg about the pole (1, 2)"),
            std::string::npos);
  const auto shifted = FamilySolver().solve(Poses{{0, 0, 0, 1}, {0, 4, 0, 1}});
  EXPECT_NE(shifted.message.find("at infinity in the direction of 0 deg"), std::string::npos) << shifted.message;
}

TEST(FamilyOfDyads, ShowsZerosThatRoundingHides) {
  const auto about = [](double angle) {
    return pose_from_radians(0.3 - 0.3 * std::cos(angle), -0.3 * std::sin(angle), angle);
  };
  int hidden = 0;
  for (int k = 1; k <= 20; ++k) {
    const PlanarReport report = FamilySolver().solve(Poses{about(0.2), about(0.2 + 0.13 * k)});
    hidden += report.family.poles[0].fixed[1] != 0;
    EXPECT_NE(report.message.find("about the pole (0.3, 0)"), std::string::npos) << report.message;
  }
  EXPECT_GT(hidden, 0);
}

}  // namespace
}  // namespace burmester::planar
