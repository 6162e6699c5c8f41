#include "burmester/planar/drawing/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "burmester/planar/constraint_curve.hpp"

namespace burmester::planar {
namespace {

/// Five poses of the linkage, in the stage as it is: lengths of order 1.
std::vector<Pose> poses_of(const Family::Design& a, const Family::Design& b) {
  const ConstraintCurve curve((ConstraintManifold(a)), (ConstraintManifold(b)));
  std::vector<Pose> out;
  for (const Range& r : curve.orientations())
    for (int i = 1; i < 6 && out.size() < 5; ++i) {
      const double angle = r.low + (r.high - r.low) * (0.3 + 0.05 * i);
      const auto found = curve.at(std::sin(angle / 2), std::cos(angle / 2)).poses;
      if (!found.empty()) out.push_back(found[0]);
    }
  return out;
}

SurfaceDrawing drawn(const Family::Design& a, const Family::Design& b, const std::vector<Pose>& poses) {
  return draw_surfaces(3, {{{1, a}, {2, b}}}, poses, motions_through(poses, a, b).stretches);
}

const Family::Design crank = RR::Design{{0, 0}, {0, 0}, 0.3}, rocker = RR::Design{{0.9, 0}, {0.7, 0.1}, 0.6};
const Family::Design slider = PR::Design{{0.8, 0}, Line::through({0, 0.1}, 0)};
const Family::Design swinging = RP::Design{{0.7, 0.1}, Line::through({0, 0.05}, 0.2)};

std::vector<std::size_t> of_role(const SurfaceDrawing& s, std::string_view role, int dyad = 0) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < s.parts.size(); ++k)
    if (s.parts[k].role == role && s.parts[k].dyad == dyad) out.push_back(k);
  return out;
}

bool is_straight(const Polyline& line) {
  const auto &a = line.front(), &b = line[line.size() / 2];  // a closed one ends where it begins
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  return std::all_of(line.begin(), line.end(), [&](const auto& p) {
    return std::abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) < 1e-12 * (1 + length);
  });
}

TEST(DrawSurfaces, TheCurvePassesThroughThePoses) {
  for (const Family::Design& other : {rocker, slider, swinging}) {
    const std::vector<Pose> poses = poses_of(crank, other);
    ASSERT_EQ(poses.size(), 5u);
    const SurfaceDrawing s = drawn(crank, other, poses);
    EXPECT_EQ(s.linkage, 3);
    ASSERT_EQ(s.parts.size(), s.lines.size());
    const auto points = of_role(s, "pose");
    ASSERT_EQ(points.size(), 5u);
    for (const std::size_t k : points) {
      double nearest = 1;
      for (const std::size_t c : of_role(s, "curve"))
        for (const auto& p : s.lines[c])
          nearest = std::min(nearest, std::hypot(p[0] - s.lines[k][0][0], p[1] - s.lines[k][0][1]));
      EXPECT_LT(nearest, 1e-6) << s.parts[k].label;
    }
  }
}

/// Paraboloids are doubly ruled, by the orientations and by the joint's places; a hyperboloid's levels are circles.
TEST(DrawSurfaces, GeneratorsAreStraight) {
  for (const Family::Design& other : {slider, swinging}) {
    const SurfaceDrawing s = drawn(crank, other, poses_of(crank, other));
    const auto sliding = of_role(s, "surface", 2);
    EXPECT_GE(sliding.size(), 20u);
    for (const std::size_t k : sliding) EXPECT_TRUE(is_straight(s.lines[k])) << k;
    const auto turning = of_role(s, "surface", 1);
    const auto straight =
        std::count_if(turning.begin(), turning.end(), [&](auto k) { return is_straight(s.lines[k]); });
    EXPECT_GE(straight, 20);
    EXPECT_GE(static_cast<long>(turning.size()) - straight, 9);
  }
}

TEST(DrawSurfaces, HalfTurnsAreOutOfThePicture) {
  std::vector<Pose> poses = poses_of(crank, rocker);
  const Pose first = poses[0];
  const SurfaceDrawing all = draw_surfaces(1, {{{1, crank}, {2, rocker}}}, poses, {});
  EXPECT_EQ(of_role(all, "pose").size(), 5u);
  poses.push_back({first.x, first.y, -first.X4, first.X3});  // half a turn on
  EXPECT_EQ(of_role(draw_surfaces(1, {{{1, crank}, {2, rocker}}}, poses, {}), "pose").size(), 5u);
}

/// Far pivots, sliders only, one orientation: finite lines, all of them in a box about the poses.
TEST(DrawSurfaces, AnyLinkageGivesFiniteLines) {
  const Family::Design constant = PP::Design{0.3}, far = RR::Design{{1e6, 2e6}, {0.1, 0.2}, std::hypot(1e6, 2e6)};
  const Family::Design other_slider = PR::Design{{0.1, 0.9}, Line::through({0, 0.3}, 1.2)};
  std::vector<Pose> parallel;
  for (int i = 0; i < 5; ++i) parallel.push_back(pose_from_radians(0.1 * i, 0.05 * i * i, 0.3));
  const std::vector<Pose> turning = poses_of(crank, rocker);
  const auto check = [](const SurfaceDrawing& s, int dyads) {
    EXPECT_EQ(of_role(s, "pose").size(), 5u);
    for (int dyad = 1; dyad <= dyads; ++dyad) EXPECT_FALSE(of_role(s, "surface", dyad).empty()) << dyad;
    for (const Polyline& line : s.lines) {
      EXPECT_FALSE(line.empty());
      for (const auto& p : line) EXPECT_LT(std::hypot(p[0], p[1]), 20);
    }
  };
  check(draw_surfaces(1, {{{1, crank}, {2, constant}}}, parallel, {}), 2);
  check(draw_surfaces(1, {{{1, slider}, {2, other_slider}}}, turning, {}), 2);
  check(draw_surfaces(1, {{{1, crank}, {2, far}}}, turning, {}), 1);
}

}  // namespace
}  // namespace burmester::planar
