#include "report/globe.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "report/sphere_figure.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const SphereView from_x{"from +x", {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};

std::vector<std::array<double, 3>> meridian(double from, double to, int steps) {
  std::vector<std::array<double, 3>> out;
  for (int i = 0; i <= steps; ++i) {
    const double t = from + (to - from) * i / steps;
    out.push_back({std::cos(t), std::sin(t), 0});
  }
  return out;
}

TEST(Globe, CutsAtTheLimb) {
  const auto runs = runs_of(from_x, meridian(0, 3, 40), false);  // past the limb at a quarter turn
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_TRUE(runs[0].near);
  EXPECT_FALSE(runs[1].near);
  EXPECT_NEAR(runs[0].points.back()[0], 1, 1e-12);
  EXPECT_EQ(runs[0].points.back(), runs[1].points.front());
  EXPECT_NEAR(runs[1].points.back()[0], std::sin(3.0), 1e-12);
}

TEST(Globe, NothingIsLostAndNothingLeavesTheDisc) {
  const auto circle = meridian(0.1, 6.2, 100);
  for (const bool closed : {false, true}) {
    std::size_t points = 0;
    const auto runs = runs_of(from_x, circle, closed);
    for (const GlobeRun& run : runs) {
      points += run.points.size();
      for (const auto& p : run.points) EXPECT_LE(std::hypot(p[0], p[1]), 1 + 1e-12);
    }
    EXPECT_EQ(points, circle.size() + (closed ? 1 : 0) + 2 * (runs.size() - 1));
    EXPECT_EQ(runs.size(), 3u);
  }
  EXPECT_TRUE(runs_of(from_x, {}, true).empty());
}

TEST(Globe, SidesAreExchangedWithTheView) {
  const SphereView from_behind{"from -x", {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
  const auto front = runs_of(from_x, meridian(0.1, 3, 40), false),
             back = runs_of(from_behind, meridian(0.1, 3, 40), false);
  ASSERT_EQ(front.size(), back.size());
  for (std::size_t i = 0; i < front.size(); ++i) EXPECT_NE(front[i].near, back[i].near);
}

TEST(Globe, GraticuleLiesOnTheSphere) {
  EXPECT_EQ(graticule().size(), 17u);
  for (const auto& line : graticule())
    for (const auto& p : line) EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 1e-14);
}

SphereDrawing slider_drawing() {
  return {3,
          {{.role = "guide", .dyad = 2, .closed = true, .points = meridian(0, 6, 60)},
           {.role = "fixed_axis", .label = "A0", .dyad = 1, .points = {{1, 0, 0}}},
           {.role = "task", .label = "1", .pose = 1, .points = {{0.8, 0.6, 0}, {1, 0, 0}, {0.8, 0, 0.6}}},
           {.role = "link", .dyad = 1, .pose = 1, .points = meridian(0, 2, 20)},
           {.role = "moving_axis", .label = "A", .dyad = 1, .pose = 1, .points = {{0, 1, 0}}},
           {.role = "body", .pose = 1, .points = {{0.8, 0.6, 0}, {1, 0, 0}, {0.8, 0, 0.6}}}},
          {from_x, {"from +y", {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}};
}

TEST(SphereFigure, ShowsTheLinkageInEveryView) {
  const std::string svg = sphere_figure(slider_drawing(), "a < b & c");
  EXPECT_TRUE(svg.starts_with(figure_mark));
  EXPECT_THAT(svg, HasSubstr("<title>Linkage 3 \u00b7 a &lt; b &amp; c</title>"));
  for (const char* words : {">from +x<", ">from +y<", ">task attitude<", ">dyad 1<", ">A<tspan", ">far side<"})
    EXPECT_THAT(svg, HasSubstr(words));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr(">ground<")));
}

TEST(SphereFigure, StandsEmptyDrawings) {
  EXPECT_THAT(sphere_figure({}, ""), HasSubstr("<title>Task attitudes</title>"));
  SphereDrawing odd = slider_drawing();
  for (SphereStroke& s : odd.strokes) s.points.clear();
  EXPECT_THAT(sphere_figure(odd, ""), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace burmester
