#include "burmester/modules/framework/result_io.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "burmester/geometry/random.hpp"
#include "burmester/modules/framework/json_text.hpp"
#include "flat_module.hpp"

namespace burmester {
namespace {

using ::testing::ElementsAre;
using json = nlohmann::ordered_json;
constexpr double pi = std::numbers::pi;

DyadRecord dyad(int id, const char* type, std::vector<double> fixed, std::vector<double> moving) {
  DyadRecord d;
  d.id = id;
  d.type = type;
  d.fixed = std::move(fixed);
  d.moving = std::move(moving);
  return d;
}

LinkageRecord linkage(int id, int first, int second, const char* type, std::optional<double> input,
                      std::optional<double> offset) {
  LinkageRecord l;
  l.id = id;
  l.dyads[0] = first;
  l.dyads[1] = second;
  l.type = type;
  l.input = input;
  l.coupler = 3;
  l.offset = offset;
  return l;
}

/// Dyads 1 (PR), 2 (RR, long), 3 (RR, short), as an untidy module might give them, and every pair of them.
Synthesis untidy() {
  Synthesis s;
  s.status = Status::exact;
  s.message = "3 real dyads";
  s.counts = {0, 4, 3, false};
  s.dyads = {dyad(1, "PR", {}, {1, -0.0}), dyad(2, "RR", {1, 2}, {3, 4}), dyad(3, "RR", {5, 6}, {7, 8})};
  s.dyads[0].line = LineRecord{{0, 2}, pi / 2};
  s.dyads[0].departure = 1e-12;
  s.dyads[1].length = 9;
  s.dyads[1].residual = 1e-15;
  s.dyads[1].condition = 100;
  s.dyads[1].slider = SliderRecord{"PR", LineRecord{{0, 1}, 0}, 0.5};
  s.dyads[2].length = 6;
  s.linkages = {linkage(1, 2, 3, "RRRR", 2, {}), linkage(2, 3, 1, "RRRP", 6, 0.25),
                linkage(3, 2, 1, "RRRP", 9, 0.5)};
  s.linkages[0].motion_class = "crank-rocker";
  s.warnings = {"w2"};
  return s;
}

json document_of(const Synthesis& answer, Problem problem = {}) {
  problem.geometry = "flat";
  problem.poses = {{1, 2}, {3, 4}};
  problem.warnings = {"w1"};
  return result_document(testing::FlatModule(), problem, answer);
}

TEST(Listed, SortsByTypeAndLengthAndNumbersAnew) {
  const Synthesis s = listed(untidy(), {});
  ASSERT_EQ(s.dyads.size(), 3u);
  EXPECT_EQ(s.dyads[0].length, 6);
  EXPECT_EQ(s.dyads[1].length, 9);
  EXPECT_EQ(s.dyads[2].type, "PR");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(s.dyads[i].id, i + 1);
  EXPECT_THAT(s.linkages[0].dyads, ElementsAre(2, 1));
  EXPECT_THAT(s.linkages[1].dyads, ElementsAre(1, 3));
  EXPECT_THAT(s.linkages[2].dyads, ElementsAre(2, 3));
}

TEST(Listed, KeepsCountsAndNumbersWhenTypesAreAskedFor) {
  const Synthesis s = listed(untidy(), {"PR"});
  ASSERT_EQ(s.dyads.size(), 1u);
  EXPECT_EQ(s.dyads[0].id, 3);
  EXPECT_TRUE(s.linkages.empty());
  EXPECT_EQ(s.counts.real, 3);
  EXPECT_EQ(listed(untidy(), {"RR"}).linkages.size(), 1u);
  EXPECT_EQ(listed(untidy(), {"RR", "PR"}).linkages.size(), 3u);
}

TEST(Listed, KeepsSamplesOfTheTypesAskedFor) {
  Synthesis family = untidy();
  family.family.samples = family.dyads;
  EXPECT_EQ(listed(family, {}).family.samples.size(), 3u);
  const Synthesis sliders = listed(family, {"PR"});
  ASSERT_EQ(sliders.family.samples.size(), 1u);
  EXPECT_EQ(sliders.family.samples[0].type, "PR");
  EXPECT_THAT(sliders.warnings, ElementsAre("w2"));
  const Synthesis none = listed(family, {"RP", "PP"});
  EXPECT_TRUE(none.family.samples.empty());
  EXPECT_THAT(none.warnings, ElementsAre("w2", "none of the samples of the family is RP or PP"));
}

TEST(ResultDocument, HasTheKeysOfTheFormat) {
  const json d = document_of(listed(untidy(), {}));
  EXPECT_EQ(d["schema"], "burmester/result/1");
  EXPECT_EQ(d["geometry"], "flat");
  EXPECT_EQ(json_line(d["units"]), R"({"angle": "deg"})");
  EXPECT_EQ(d["pose_count"], 2);
  EXPECT_EQ(d["status"], "exact");
  EXPECT_EQ(json_line(d["solutions"]), R"({"dimension": 0, "complex": 4, "real": 3, "certified": false})");
  EXPECT_EQ(
      json_line(d["dyads"][0]),
      R"({"id": 1, "type": "RR", "fixed": [5, 6], "moving": [7, 8], "length": 6, "residual": 0, )"
      R"("certificate": {"certified": false}})");
  EXPECT_EQ(json_line(d["dyads"][1]["slider"]),
            R"({"type": "PR", "line": {"point": [0, 1], "angle": 0}, "departure": 0.5})");
  EXPECT_EQ(
      json_line(d["dyads"][2]),
      R"({"id": 3, "type": "PR", "moving": [1, 0], "line": {"point": [0, 2], "angle": 90}, "residual": 0, )"
      R"("departure": 1e-12, "certificate": {"certified": false}})");
  EXPECT_EQ(json_line(d["linkages"][1]["links"]),
            R"({"ground": null, "input": 6, "coupler": 3, "output": null})");
  EXPECT_EQ(d["linkages"][1]["offset"], 0.25);
  EXPECT_TRUE(d["linkages"][1]["class"].is_null());
  EXPECT_FALSE(d["linkages"][0].contains("offset"));
  EXPECT_EQ(d["linkages"][0]["verdict"],
            "crank-rocker; circuits, branches and order of poses are not analysed in this version");
  EXPECT_TRUE(d["linkages"][0]["usable"].is_null());
  EXPECT_EQ(json_line(d["warnings"]), R"(["w1", "w2"])");
  EXPECT_EQ(json_line(d["poses"][0]), R"({"a": 1, "pair": [1, 2]})");
  EXPECT_TRUE(d["curves"].empty());
}

TEST(ResultDocument, ShowsAnglesInTheProblemsUnit) {
  Problem radians;
  radians.units.degrees = false;
  EXPECT_EQ(document_of(untidy(), radians)["dyads"][0]["line"]["angle"], pi / 2);
  EXPECT_EQ(document_of(untidy())["dyads"][0]["line"]["angle"], 90);
  const Units degrees{"", true}, rad{"", false};
  for (const double angle : {0.0, -0.0, pi, -pi, 2 * pi, -1e-20, 3.14159265358979356, -1e-300, 1e9}) {
    EXPECT_GE(shown_direction(angle, degrees), 0) << angle;
    EXPECT_LT(shown_direction(angle, degrees), 180) << angle;
    EXPECT_GE(shown_direction(angle, rad), 0) << angle;
    EXPECT_LT(shown_direction(angle, rad), pi) << angle;
  }
}

TEST(ResultDocument, RefusesNumbersThatAreNone) {
  Synthesis s = untidy();
  s.dyads[1].fixed[0] = std::nan("");
  EXPECT_THROW(document_of(s), std::runtime_error);
  s = untidy();
  s.dyads[1].condition = std::numeric_limits<double>::infinity();  // nothing to tell
  EXPECT_FALSE(document_of(s)["dyads"][1].contains("condition"));
}

TEST(ResultDocument, ShowsTheRadiusOfAProof) {
  Synthesis s = untidy();
  s.dyads[1].certificate.certified = true;
  s.dyads[1].certificate.radius = 1e-13;
  EXPECT_EQ(json_line(document_of(s)["dyads"][1]["certificate"]), R"({"certified": true, "radius": 1e-13})");
}

TEST(ResultDocument, ShowsTheMergeDistanceWhereItIsKnown) {
  Synthesis s = untidy();
  EXPECT_FALSE(document_of(s)["solutions"].contains("merge_distance"));
  s.counts.merge_distance = 2.5e-16;
  EXPECT_EQ(document_of(s)["solutions"]["merge_distance"], 2.5e-16);
}

TEST(ResultDocument, ShowsNullForUnknownCounts) {
  Synthesis s;
  s.status = Status::degenerate;
  s.message = "infinitely many";
  EXPECT_EQ(json_line(document_of(s)["solutions"]),
            R"({"dimension": null, "complex": null, "real": null, "certified": false})");
}

TEST(JsonText, WritesTheShortestNumberThatReadsBack) {
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e5), "100000");
  EXPECT_EQ(number_text(6), "6");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(number_text(std::nan("")), "null");
  Random random("JsonText.numbers");
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(random.uniform(-1, 1), random.below(2000) - 1000);
    EXPECT_EQ(std::strtod(number_text(x).c_str(), nullptr), x);
    EXPECT_EQ(json::parse(number_text(x)).get<double>(), x);
  }
}

TEST(JsonText, ReadsBackTheSameIndentedOrNot) {
  const json d = document_of(listed(untidy(), {}));
  EXPECT_EQ(json::parse(json_text(d)), json::parse(json_line(d)));
  EXPECT_EQ(json_line(d).find('\n'), std::string::npos);
  EXPECT_EQ(json_text(d).back(), '\n');
  EXPECT_EQ(json_line({{"a\"b", "x\ny\xFF"}}), "{\"a\\\"b\": \"x\\ny\xEF\xBF\xBD\"}");
  EXPECT_EQ(json_text(json::array()), "[]\n");
}

}  // namespace
}  // namespace burmester
