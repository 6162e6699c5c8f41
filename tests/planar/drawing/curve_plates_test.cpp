// The plates of four poses show what they say: poles on the centre-point curve, a linkage with its pivots on the
// curves.
#include "burmester/planar/drawing/curve_plates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "burmester/planar/curve_linkages.hpp"
#include "burmester/planar/dyad_form.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

Vector2 vector_of(const std::array<double, 2>& p) { return {p[0], p[1]}; }

/// The lines of all parts of a role, with the label if one is asked for.
std::vector<Polyline> lines(const Plate& plate, const std::string& role, const std::string& label = "") {
  std::vector<Polyline> out;
  for (std::size_t k = 0; k < plate.parts.size(); ++k)
    if (plate.parts[k].role == role && (label.empty() || plate.parts[k].label == label)) out.push_back(plate.lines[k]);
  return out;
}

TEST(CurvePlates, ShowPolesAndPivotsOnTheCurves) {
  Random random("CurvePlates.ShowPolesAndPivotsOnTheCurves");
  for (int i = 0; i < 50; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const auto curves = four_pose_curves(task).pieces;
    const auto candidates = candidates_of(task, curves);
    const auto plates = four_pose_plates(task, curves, candidates);
    const bool far = curve_scale(task) > 2 * task_size(task) && !candidates.empty();
    ASSERT_EQ(plates.size(), far ? 5u : 4u) << i;
    for (const Plate& plate : plates) {
      ASSERT_EQ(plate.parts.size(), plate.lines.size()) << i;
      EXPECT_LT(plate.window[0], plate.window[2]) << i;
      EXPECT_LT(plate.window[1], plate.window[3]) << i;
    }
    const ExactCubics cubics(task);
    const auto poles = lines(plates[0], "pole");
    ASSERT_EQ(poles.size(), 6u) << i;
    for (const Polyline& pole : poles) EXPECT_LT(cubics.distance_of_fixed(vector_of(pole[0])), 1e-10) << i;
    if (candidates.empty()) continue;
    const Plate& with_linkage = plates[far ? 1 : 0];
    const Vector2 a0 = vector_of(lines(with_linkage, "fixed_pivot", "A0").at(0)[0]),
                  a = to_moving(task[0], vector_of(lines(with_linkage, "moving_pivot", "A").at(0)[0]));
    EXPECT_LT(concyclicity(task, a, a0), 1e-12) << i;
    EXPECT_LT(cubics.distance_of_moving(a), 1e-10) << i;
  }
}

bool shows(const Plate& plate, const std::array<double, 2>& p) {
  return plate.window[0] < p[0] && p[0] < plate.window[2] && plate.window[1] < p[1] && p[1] < plate.window[3];
}

TEST(CurvePlates, SmallTurnsAreShownFromFarAndNear) {
  const FourPoseTask task = four_poses({{{0, 0, 0}, {3, 1, 2}, {5, -1, 3.5}, {4, -4, 5}}});
  const auto curves = four_pose_curves(task).pieces;
  const auto candidates = candidates_of(task, curves);
  ASSERT_FALSE(candidates.empty());
  const auto plates = four_pose_plates(task, curves, candidates);
  ASSERT_EQ(plates.size(), 5u);
  EXPECT_EQ(plates[0].name, "curves");
  EXPECT_EQ(plates[1].name, "curves_near");
  const auto poles = lines(plates[0], "pole");
  EXPECT_GE(std::ranges::count_if(poles, [&](const Polyline& pole) { return shows(plates[0], pole[0]); }), 3);
  EXPECT_EQ(std::ranges::count_if(poles, [&](const Polyline& pole) { return shows(plates[1], pole[0]); }), 0);
  EXPECT_TRUE(lines(plates[0], "link").empty());
  for (const char* role : {"fixed_pivot", "moving_pivot", "frame"})
    for (const Polyline& line : lines(plates[1], role))
      for (const auto& p : line) EXPECT_TRUE(shows(plates[1], p)) << role;
  // Curves that are followed near the poses are as fine as a figure of them needs: the pivots drawn lie on them.
  const Vector2 pivot = vector_of(lines(plates[1], "fixed_pivot", "A0").at(0)[0]);
  const auto off = [&](const Plate& plate) {
    double best = std::numeric_limits<double>::infinity();
    for (const Polyline& line : lines(plate, "centre_points"))
      best = std::min(
          best, distance_to_polyline(pivot, line.size(), false, [&](std::size_t k) { return vector_of(line[k]); }));
    return best;
  };
  EXPECT_LT(off(plates[1]), 1e-4 * task_size(task));
}

TEST(CurvePlates, TheCompatibilityLinkageCloses) {
  Random random("CurvePlates.TheCompatibilityLinkageCloses");
  for (int i = 0; i < 50; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const Plate plate = four_pose_plates(task, {}, {}).at(1);
    ASSERT_EQ(plate.name, "compatibility_linkage");
    ASSERT_EQ(lines(plate, "frame_link").size(), 2u) << i;  // one for each mode
    ASSERT_EQ(lines(plate, "bar").size(), 6u) << i;
    const DyadForm form(task);
    for (int j = 1; j <= 4; ++j)
      for (const Polyline& bar : lines(plate, j == 1 ? "frame_link" : "bar", "Δ" + std::to_string(j)))
        EXPECT_NEAR((vector_of(bar[1]) - vector_of(bar[0])).norm(),
                    std::abs(form.delta()[static_cast<std::size_t>(j - 1)]), 1e-12 * (1 + std::abs(form.delta()[0])))
            << i;
    for (const std::size_t mode : {0u, 1u})  // frame, then three bars, the last back at the origin
      EXPECT_LT(vector_of(lines(plate, "bar")[3 * mode + 2][1]).norm(), 1e-12 * (1 + std::abs(form.delta()[0]))) << i;
  }
}

TEST(CurvePlates, TheVectorsOfADyadLeadToEachPose) {
  Random random("CurvePlates.TheVectorsOfADyadLeadToEachPose");
  int with_linkage = 0;
  for (int i = 0; i < 50; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const auto curves = four_pose_curves(task).pieces;
    const auto candidates = i % 2 == 0 ? candidates_of(task, curves) : std::vector<CandidateRecord>();
    const auto plates = four_pose_plates(task, curves, candidates);
    if (plates.back().name != "vector_diagram") continue;  // no linkage, nor a dyad at the angle tried
    with_linkage += !candidates.empty();
    const Plate& plate = plates.back();
    const auto vectors = lines(plate, "vector");
    ASSERT_EQ(vectors.size(), 11u) << i;
    const auto length = [](const Polyline& v) { return (vector_of(v[1]) - vector_of(v[0])).norm(); };
    const Polyline first = lines(plate, "vector", "Z1").at(0), second = lines(plate, "vector", "Z2").at(0);
    const double size = length(first) + length(second);
    for (std::size_t k = 0, j = 0; j < 4; k += j == 0 ? 2 : 3, ++j) {
      EXPECT_EQ(vectors[k][0], lines(plate, "fixed_pivot", "M").at(0)[0]) << i;
      EXPECT_EQ(vectors[k][1], vectors[k + 1][0]) << i;
      EXPECT_EQ(vectors[k + 1][1], (std::array{task[j].x, task[j].y})) << i;
      EXPECT_NEAR(length(vectors[k]), length(first), 1e-12 * size) << i;
      EXPECT_NEAR(length(vectors[k + 1]), length(second), 1e-12 * size) << i;
    }
    const char* displacement[] = {"", "δ2", "δ3", "δ4"};
    for (std::size_t j = 1; j < 4; ++j)
      EXPECT_EQ(lines(plate, "vector", displacement[j]).at(0),
                (Polyline{{task[0].x, task[0].y}, {task[j].x, task[j].y}}))
          << i;
  }
  EXPECT_GT(with_linkage, 15);
}

TEST(CurvePlates, DegeneratePosesHaveNone) {
  EXPECT_TRUE(four_pose_plates(four_poses({{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}}), {}, {}).empty());
}

}  // namespace
}  // namespace burmester::planar
