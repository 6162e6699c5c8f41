#include "report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "report/figure.hpp"
#include "report/surfaces_figure.hpp"
#include "report/plate_figure.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using json = nlohmann::ordered_json;

/// A slider-crank in two poses, one motion of three frames.
Drawing slider_crank() {
  LinkageDrawing l;
  l.id = 7;
  l.parts = {{"guide", "", false, 2}, {"link", "", false, 1},          {"coupler", "", true, 0},
             {"block", "", true, 2},  {"fixed_pivot", "A0", false, 1}, {"moving_pivot", "A", false, 1},
             {"frame", "", false, 0}};
  const auto shot = [](double x) -> Snapshot {
    return {{{-100, 0}, {100, 0}},          {{0, 0}, {1, 1}}, {{1, 1}, {x, 0}, {2, 1}},
            {{x, 0}, {x + 1, 0}, {x, 0.5}}, {{0, 0}},         {{1, 1}},
            {{x + 1, 0}, {x, 0}, {x, 1}}};
  };
  l.at_pose = {shot(2), shot(3.000000123456)};
  l.motions = {{{1, 2}, {0, 2}, false, {shot(2), shot(2.5), shot(3)}}};
  l.window = {-1, -1, 4, 3};
  Drawing d;
  d.poses = {{"1", {2, 0}, {1, 0}, {0, 1}}, {"2", {3, 0}, {1, 0}, {0, 1}}};
  d.linkages = {l};
  return d;
}

TEST(DrawingDocument, IsWhatThePageReads) {
  const json d = drawing_document(slider_crank());
  EXPECT_EQ(d["poses"][1]["label"], "2");
  EXPECT_EQ(d["poses"][1]["origin"], json({3, 0}));
  const json& l = d["linkages"][0];
  EXPECT_EQ(l["id"], 7);
  EXPECT_EQ(l["parts"][4]["role"], "fixed_pivot");
  EXPECT_EQ(l["parts"].size(), l["at_pose"][0].size());
  EXPECT_EQ(l["at_pose"][1][2][1][0], 3);  // rounded to a millionth of the window
  EXPECT_EQ(l["motions"][0]["frames"].size(), 3u);
  EXPECT_EQ(l["motions"][0]["pose_frames"], json({0, 2}));
  EXPECT_EQ(l["window"], json({-1, -1, 4, 3}));
}

TEST(DrawingDocument, HoldsSpheres) {
  Drawing d;
  d.spheres = {{4,
                {{.role = "link", .dyad = 2, .pose = 3, .points = {{1, 0, 0}, {0.6, 0.8000000001, 0}}}},
                {{"from +x", {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}}};
  const json sphere = drawing_document(d)["spheres"][0];
  EXPECT_EQ(sphere["linkage"], 4);
  EXPECT_EQ(sphere["strokes"][0]["role"], "link");
  EXPECT_EQ(sphere["strokes"][0]["pose"], 3);
  EXPECT_EQ(sphere["strokes"][0]["points"][1], json({0.6, 0.8, 0}));
  EXPECT_EQ(sphere["views"][0]["towards"], json({1, 0, 0}));
}

TEST(ReportPage, HasEverythingInIt) {
  const std::string page = report_page({{"name", "</script><script>alert(1)"}}, slider_crank());
  EXPECT_THAT(page, Not(HasSubstr("/*BURMESTER_")));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("\\u003c/script>"));
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme"));
  EXPECT_THAT(page, HasSubstr("\"at_pose\""));
}

TEST(Figure, ShowsLinkageAndPoses) {
  const Drawing d = slider_crank();
  const std::string svg = linkage_figure(d.linkages[0], d, "a < b & c", "mm");
  EXPECT_TRUE(svg.starts_with(figure_mark));
  EXPECT_THAT(svg, HasSubstr("<title>Linkage 7 \u00b7 a &lt; b &amp; c</title>"));
  EXPECT_THAT(svg, HasSubstr(">0.5 mm</text>"));
  EXPECT_THAT(svg, HasSubstr(">A<tspan"));
  EXPECT_THAT(svg, HasSubstr(pose_colour(1)));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(poses_figure(d, "", ""), HasSubstr("<title>Task poses</title>"));
}

TEST(Figure, IsNeverTallerOrWiderThanItsSheet) {
  for (const double size : {1e-300, 1e-3, 1.0, 1e6, 1e300})
    for (const std::array<double, 2> stretch : {std::array{1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}, {1e-9, 1.0}}) {
      const Svg svg({0, 0, size * stretch[0], size * stretch[1]}, "t");
      EXPECT_LE(svg.width(), 800) << size;
      EXPECT_LE(svg.height(), 800) << size;
      EXPECT_TRUE(svg.inside(svg.place({0, 0})));
    }
}

TEST(Figure, StandsEmptyAndSinglePoints) {
  Drawing d = slider_crank();
  d.linkages[0].at_pose.clear();
  EXPECT_THAT(linkage_figure(d.linkages[0], d, "", ""), HasSubstr("</svg>"));
  d.linkages[0].at_pose = {Snapshot(7)};
  EXPECT_THAT(linkage_figure(d.linkages[0], d, "", ""), HasSubstr("</svg>"));
  d.poses = {d.poses[0], d.poses[0]};
  EXPECT_THAT(poses_figure(d, "", ""), Not(HasSubstr("nan")));
}

TEST(WindowOf, HoldsAllPoints) {
  EXPECT_EQ(window_of({}, 0.1), (std::array<double, 4>{-1, -1, 1, 1}));
  EXPECT_EQ(window_of({{3, 4}}, 0.1), (std::array<double, 4>{2, 3, 4, 5}));
  EXPECT_EQ(window_of({{0, 0}, {10, 5}}, 0.1), (std::array<double, 4>{-1, -1, 11, 6}));
}

TEST(SurfacesFigure, ShowsBothDyadsTheCurveAndThePoses) {
  SurfaceDrawing d;
  d.linkage = 4;
  d.parts = {{"surface", "", false, 2}, {"surface", "", false, 5}, {"axis", "X3", false, 0}, {"curve", "", false, 0},
             {"pose", "1", false, 0}};
  d.lines = {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{0, 0}, {0.5, 0.7}, {1, 1}}, {{0.5, 0.7}}};
  const std::string svg = surfaces_figure(d, "a < b");
  EXPECT_TRUE(svg.starts_with(figure_mark));
  EXPECT_THAT(svg, HasSubstr("<title>Constraint surfaces of linkage 4 \u00b7 a &lt; b</title>"));
  EXPECT_THAT(svg, HasSubstr(">dyad 2</text>"));
  EXPECT_THAT(svg, HasSubstr(">dyad 5</text>"));
  EXPECT_THAT(svg, HasSubstr(std::string("stroke=\"") + std::string(pose_colour(0))));
  EXPECT_THAT(svg, HasSubstr(std::string("stroke=\"") + std::string(pose_colour(1))));
  EXPECT_THAT(svg, HasSubstr("<circle"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Svg, NamesOfMarksDoNotOverlapHoweverCloseTheMarksAre) {
  for (const double apart : {0.0, 1.0, 60.0}) {
    Svg svg({0, 0, 1, 1}, "title");
    std::vector<MarkLabel> labels;
    for (int k = 0; k < 12; ++k)
      labels.push_back({{svg.width() - 8 - apart * k, 8 + apart * k / 2}, fmt::format("P{}", 10 + k), ""});
    labels.push_back({{-8, 8}, "P99", ""});  // off the sheet
    svg.labels(labels);
    const std::string text = svg.finish();
    EXPECT_THAT(text, Not(HasSubstr(">99<")));
    EXPECT_EQ(text.find("stroke-width=\"0.7\"") != text.npos, apart < 60) << apart;  // lines to marks
    const std::regex place("<text x=\"([^\"]+)\" y=\"([^\"]+)\" class=\"halo\" >P");
    std::vector<Point2> found;
    for (std::sregex_iterator it(text.begin(), text.end(), place); it != std::sregex_iterator(); ++it)
      found.push_back({std::stod((*it)[1]), std::stod((*it)[2])});
    ASSERT_EQ(found.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_TRUE(found[i][0] > 0 && found[i][0] + 24 < svg.width() && found[i][1] > 10) << apart << " " << i;
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_TRUE(std::abs(found[i][0] - found[j][0]) > 24 || std::abs(found[i][1] - found[j][1]) > 16)
            << apart << " " << i << " " << j;
    }
  }
}

TEST(Svg, SideBySideIsOneFileWithThePanelsInRows) {
  const std::vector<Svg> panels(4, Svg({0, 0, 1, 1}, "panel"));
  const std::string text = side_by_side(panels, "all");
  const auto times = [&](const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
    return count;
  };
  EXPECT_TRUE(text.starts_with(figure_mark));
  EXPECT_EQ(times("<!--"), 1u);
  EXPECT_EQ(times("<svg "), 5u);
  EXPECT_EQ(times("</svg>"), 5u);
  EXPECT_EQ(times("<title>panel</title>"), 4u);
  EXPECT_EQ(times("<svg x=\"0\" y="), 2u);  // the first and the fourth
}

TEST(PlateFigure, DrawsItsPartsByRole) {
  const Plate plate{"curves",
                    "Curves",
                    "how to read <it>",
                    {{"circle_points", "", false, 0}, {"centre_points", "", false, 1}, {"pole", "P12"}, {"pole", "P34"},
                     {"fixed_pivot", "A0"}, {"frame", "1", false, 0},
                     {"vector", "Z1", false, 3}, {"vector", "Z2", false, 3}},
                    {{{0, 0}, {4, 0}}, {{0, 1}, {4, 1}}, {{2, 2}}, {{200, 2}}, {{1, 1}}, {{1, 0}, {0, 0}, {0, 1}},
                     {{0, 2}, {3, 2}}, {{3, 2}, {3, 2}}},
                    {0, 0, 4, 3}};
  const std::string svg = plate_figure(plate, "task", "mm");
  EXPECT_TRUE(svg.starts_with(figure_mark));
  EXPECT_THAT(svg, HasSubstr("<title>Curves \u00b7 task</title>"));
  EXPECT_THAT(svg, HasSubstr("how to read &lt;it&gt;"));
  EXPECT_THAT(svg, HasSubstr(">P<tspan dy=\"4\" font-size=\"10\">12<"));
  EXPECT_THAT(svg, Not(HasSubstr(">34<")));  // outside the sheet
  EXPECT_THAT(svg, HasSubstr("stroke=\"#cc79a7\""));
  EXPECT_THAT(svg, HasSubstr(">Z<tspan dy=\"4\" font-size=\"10\">1<"));
  EXPECT_THAT(svg, Not(HasSubstr(">2<")));  // too short for an arrow
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace burmester
