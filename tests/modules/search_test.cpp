#include "burmester/modules/framework/search.hpp"

#include <gtest/gtest.h>

#include "spatial.hpp"
#include "toy_geometry.hpp"

namespace burmester {
namespace {

/// Poses that a design meets.
template <class D>
std::vector<typename D::Space::Pose> planted(const typename D::Design& d, Random& random, int count) {
  std::vector<typename D::Space::Pose> out;
  while (static_cast<int>(out.size()) < count)
    if (const auto pose = pose_with_residual<D>(d, D::Space::random_pose(random))) out.push_back(*pose);
  return out;
}

template <class D>
double nearest(const typename D::Design& d, const std::vector<Found<typename D::Design>>& found) {
  Random random("search_test.nearest");
  std::vector<typename D::Space::Pose> probes;
  for (int i = 0; i < 20; ++i) probes.push_back(D::Space::random_pose(random));
  double smallest = HUGE_VAL;
  for (const auto& other : found) smallest = std::min(smallest, disagreement<D>(d, other.design, probes));
  return smallest;
}

using toy::Circle;

TEST(Search, FindsThePlantedCircle) {
  Random random("Search.FindsThePlantedCircle");
  for (int i = 0; i < 20; ++i) {
    const Circle::Design d = Circle::random_design(random);
    const auto poses = planted<Circle>(d, random, 5);
    const auto found = search<Circle>(poses);
    EXPECT_LT(nearest<Circle>(d, found), 1e-5) << "task " << i;
    EXPECT_LE(found.size(), 4u) << "task " << i;  // Burmester: at most four
    for (const auto& f : found) EXPECT_LE(f.residual, 1e-9 * extent<toy::Plane>(poses));
  }
}

TEST(Search, FindsTheSpatialRod) {
  Random random("Search.FindsTheSpatialRod");
  const toy::SS::Design d = toy::SS::random_design(random);
  const auto found = search<toy::SS>(planted<toy::SS>(d, random, 7), {.starts = 400});
  EXPECT_LT(nearest<toy::SS>(d, found), 1e-5);
  EXPECT_LE(found.size(), 20u);
}

TEST(Search, FindsTheOnlyStop) {
  const std::vector<toy::Turns::Pose> poses{{0.3}, {0.5}};  // two poses, one parameter: the mean
  const auto found = search<toy::Stop>(poses, {.starts = 20});
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(std::remainder(found[0].design.angle, 2 * std::numbers::pi), 0.4, 1e-9);
  EXPECT_NEAR(found[0].residual, 0.1, 1e-9);
}

TEST(Search, FitsMorePosesThanParameters) {
  Random random("Search.FitsMorePosesThanParameters");
  const Circle::Design d = Circle::random_design(random);
  auto poses = planted<Circle>(d, random, 12);
  for (auto& pose : poses) pose.x += 1e-4 * random.normal();
  const auto found = search<Circle>(poses);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(nearest<Circle>(d, found), 1e-2);
  EXPECT_LT(found[0].residual, 1e-3);
}

TEST(Search, ReachesFarAndLargeTasks) {
  Random random("Search.ReachesFarAndLargeTasks");
  const Circle::Design unit = Circle::random_design(random);
  auto poses = planted<Circle>(unit, random, 5);
  for (auto& pose : poses) pose.x = 300 * pose.x + 1e4, pose.y *= 300;
  const Circle::Design d{300 * unit.fixed + Circle::Place(1e4, 0), 300 * unit.moving, 300 * unit.length};
  EXPECT_LT(nearest<Circle>(d, search<Circle>(poses)), 1e-3);
}

TEST(Search, SameSeedSameAnswer) {
  Random random("Search.SameSeedSameAnswer");
  const auto poses = planted<Circle>(Circle::random_design(random), random, 5);
  const auto first = search<Circle>(poses), again = search<Circle>(poses);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].design.length, again[i].design.length);
}

}  // namespace
}  // namespace burmester
