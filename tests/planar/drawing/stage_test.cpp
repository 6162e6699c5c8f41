#include "burmester/planar/drawing/stage.hpp"

#include <gtest/gtest.h>

namespace burmester::planar {
namespace {

const std::vector<Pose> square{{1, 1, 0, 1}, {-1, 1, 0, 1}, {-1, -1, 0, 1}, {1, -1, 0, 1}};

TEST(Stage, DesignsAreMetByTheSamePoses) {
  Random random("Stage.DesignsAreMetByTheSamePoses");
  const Stage stage{{300, -20}, 7};
  Dyads::for_each([&]<class D>() {
    for (int i = 0; i < 20; ++i) {
      const auto d = D::random_design(random);
      const Pose x = Space::random_pose(random);
      const double there = D::residual(std::get<typename D::Design>(stage.design(d)), stage.pose(x));
      const double scale = std::is_same_v<D, PP> ? 1 : stage.unit;
      EXPECT_NEAR(scale * there, D::residual(d, x), 1e-12) << D::name;
    }
  });
  EXPECT_LT((stage.in_problem(Vector2(2, 1)) - Vector2(314, -13)).norm(), 1e-12);
}

TEST(StageOf, HoldsPosesAndPivots) {
  const RR::Design a{{3, 0}, {0, 0}, 3}, b{{0, -5}, {1, 0}, 3};
  const Stage stage = stage_of(square, a, b);
  EXPECT_EQ(stage.centre, Vector2(0, 0));
  EXPECT_NEAR(stage.unit, 5, 1e-15);
}

TEST(StageOf, LeavesOutAbsurdlyFarPivots) {
  const RR::Design a{{3, 0}, {0, 0}, 3}, almost_slider{{0, -1e4}, {0, 0}, 1e4};
  EXPECT_NEAR(stage_of(square, a, almost_slider).unit, 3, 1e-15);
}

TEST(StageOf, ShowsAWholeLinkageOfASmallTask) {
  std::vector<Pose> small = square;
  for (Pose& p : small) p.x *= 1e-4, p.y *= 1e-4;
  const RR::Design a{{3, 0}, {0, 0}, 3}, b{{0, -5}, {0, 0}, 5};
  EXPECT_NEAR(stage_of(small, a, b).unit, 5, 1e-3);
}

TEST(StageOf, HasAUnitEvenForOnePoint) {
  const RR::Design nothing{{0, 0}, {0, 0}, 0};
  EXPECT_EQ(stage_of({{0, 0, 0, 1}}, nothing, nothing).unit, 1);
  EXPECT_EQ(stage_of({{0, 0, 0, 1}}, PP::Design{0}, PP::Design{0}).unit, 1);
}

}  // namespace
}  // namespace burmester::planar
