// The constructions of MECH 576, section 5.2: what is drawn has the properties that it is drawn for.
#include "burmester/planar/drawing/construction.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "burmester/planar/pivots.hpp"

namespace burmester::planar {
namespace {

const std::vector<Pose> poses{pose_from_degrees(-1.221, 22.394, 36.868), pose_from_degrees(12.779, 28.394, -45),
                              pose_from_degrees(8.154, 12.519, 67.38)};

Dyads::Design dyad_of(const std::vector<Pose>& task, const std::vector<double>& fixed) {
  Problem problem;
  problem.fixed = {fixed};
  return GivenPivots<Pivots>(problem, task).solve().dyads.at(0).design;
}

std::vector<std::vector<Vector2>> lines_of(const Plate& drawing, const std::string& role) {
  std::vector<std::vector<Vector2>> out;
  for (std::size_t k = 0; k < drawing.parts.size(); ++k) {
    if (drawing.parts[k].role != role) continue;
    out.emplace_back();
    for (const auto& p : drawing.lines[k]) out.back().push_back({p[0], p[1]});
  }
  return out;
}

double distance_to_line(const Vector2& p, const std::vector<Vector2>& line) {
  const Vector2 d = (line[1] - line[0]).normalized(), off = p - line[0];
  return std::abs(off[0] * d[1] - off[1] * d[0]);
}

TEST(Construction, InversionLeadsToTheMovingPivot) {
  for (const std::vector<double>& fixed : {std::vector<double>{0, 0}, {16, 0}}) {
    const auto design = dyad_of(poses, fixed);
    const auto drawings = three_pose_constructions(poses, design, 1);
    ASSERT_EQ(drawings.size(), 3u);
    const Plate& inversion = drawings[0];
    EXPECT_EQ(inversion.name, "construction_1_inversion");
    ASSERT_EQ(inversion.parts.size(), inversion.lines.size());
    const auto pivots = lines_of(inversion, "constructed"), bisectors = lines_of(inversion, "bisector");
    ASSERT_EQ(pivots.size(), 3u);
    EXPECT_EQ(pivots[0][0], to_fixed(poses[0], std::get<RR::Design>(design).moving));
    ASSERT_EQ(bisectors.size(), 3u);
    for (const auto& line : bisectors) EXPECT_LT(distance_to_line(pivots[0][0], line), 1e-12);
    const auto images = lines_of(inversion, "image"), links = lines_of(inversion, "link");
    ASSERT_EQ(images.size(), 2u);
    for (const auto& image : images)
      EXPECT_NEAR((image[0] - pivots[0][0]).norm(), (Vector2(fixed[0], fixed[1]) - pivots[0][0]).norm(), 1e-12);
    for (const auto& link : links) EXPECT_NEAR((link[1] - link[0]).norm(), std::get<RR::Design>(design).length, 1e-12);
  }
}

TEST(Construction, PolesLeadToTheSamePivot) {
  const auto drawing = three_pose_constructions(poses, dyad_of(poses, {0, 0}), 2).at(1);
  EXPECT_EQ(drawing.name, "construction_2_poles");
  const auto poles = lines_of(drawing, "pole"), bisectors = lines_of(drawing, "bisector"),
             arcs = lines_of(drawing, "arc");
  const Vector2 pivot = lines_of(drawing, "constructed").at(0)[0];
  ASSERT_EQ(poles.size(), 3u);
  ASSERT_EQ(bisectors.size(), 7u);
  ASSERT_EQ(arcs.size(), 3u);
  const auto images = lines_of(drawing, "image");
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LT(distance_to_line(poles[j][0], bisectors[3 * j + k]), 1e-11);  // tail, tip, M
    EXPECT_LT(distance_to_line(pivot, bisectors[3 * j + 2]), 1e-12);
    EXPECT_LT((arcs[j].back() - images[j][0]).norm(), 1e-12);  // M turned back about the pole
  }
  EXPECT_LT(distance_to_line(poles[2][0], bisectors[6]), 1e-11);  // the image pole
  EXPECT_LT(distance_to_line(pivot, bisectors[6]), 1e-12);
  EXPECT_LT((arcs[2].front() - images[0][0]).norm() + (arcs[2].back() - images[1][0]).norm(), 1e-12);
}

TEST(Construction, SixPanelsShowTheStepsToOneDyad) {
  const Vector2 fixed(16, 0);
  const auto design = std::get<RR::Design>(dyad_of(poses, {16, 0}));
  const Plate steps = three_pose_constructions(poses, design, 2).at(2);
  EXPECT_EQ(steps.name, "construction_2_steps");
  EXPECT_TRUE(steps.parts.empty());
  ASSERT_EQ(steps.panels.size(), 6u);
  for (const Plate& panel : steps.panels) {
    EXPECT_EQ(panel.window, steps.window);
    EXPECT_EQ(lines_of(panel, "frame").size(), 3u);
    for (const auto& p : lines_of(panel, "constructed")) EXPECT_NEAR((p[0] - fixed).norm(), design.length, 1e-12);
  }
  for (std::size_t k = 0; k < 3; ++k) {  // by inversion, each pose in turn
    const Vector2 pivot = lines_of(steps.panels[k], "constructed").at(0)[0];
    EXPECT_LT((pivot - to_fixed(poses[k], design.moving)).norm(), 1e-12);
    const auto images = lines_of(steps.panels[k], "image"), bisectors = lines_of(steps.panels[k], "bisector");
    ASSERT_EQ(images.size(), 2u);
    for (const auto& image : images) EXPECT_NEAR((image[0] - pivot).norm(), design.length, 1e-12);
    for (const auto& line : bisectors) EXPECT_LT(distance_to_line(pivot, line), 1e-12);
  }
  const Vector2 pole = lines_of(steps.panels[3], "pole").at(0)[0];
  for (const auto& line : lines_of(steps.panels[3], "bisector")) EXPECT_LT(distance_to_line(pole, line), 1e-11);
  EXPECT_EQ(lines_of(steps.panels[4], "constructed").size(), 3u);
  const auto links = lines_of(steps.panels[5], "link");
  ASSERT_EQ(links.size(), 3u);
  for (const auto& link : links) EXPECT_NEAR((link[2] - link[1]).norm(), design.moving.norm(), 1e-12);
}

TEST(Construction, ParallelPosesAndSlidersAreDrawnWithoutPolesOrPivots) {
  const std::vector<Pose> shifted{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  const auto without_poles = three_pose_constructions(shifted, dyad_of(shifted, {2, 2}), 1);
  ASSERT_EQ(without_poles.size(), 3u);
  for (const auto& drawing : {without_poles[0], without_poles[1], without_poles[2].panels.at(3)}) {
    EXPECT_FALSE(lines_of(drawing, "constructed").empty());
    EXPECT_TRUE(lines_of(drawing, "pole").empty());
  }
  const std::vector<Pose> straight{{0, 0, 0, 1}, {1, 0, 0, 1}, {3, 0, 0, 1}};
  const auto slider = dyad_of(straight, {2, 2});
  ASSERT_TRUE(std::holds_alternative<RP::Design>(slider));
  const auto without_pivots = three_pose_constructions(straight, slider, 1);
  ASSERT_EQ(without_pivots.size(), 2u);
  for (const auto& drawing : without_pivots) {
    EXPECT_TRUE(lines_of(drawing, "constructed").empty());
    EXPECT_FALSE(lines_of(drawing, "bisector").empty());
    EXPECT_NE(drawing.caption.find("at infinity"), std::string::npos);
  }
}

}  // namespace
}  // namespace burmester::planar
