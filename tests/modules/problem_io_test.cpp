#include "burmester/modules/framework/problem_io.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flat_module.hpp"

namespace burmester {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Problem read(std::string_view text, ReadOptions options = {.file = "f", .geometry = {}}) {
  return read_problem(text, testing::flat_registry(), options);
}

std::string complaint(std::string_view text, ReadOptions options = {.file = "f", .geometry = {}}) {
  try {
    read(text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

/// A good problem with one more member.
std::string with(const std::string& member) {
  return R"({"geometry": "flat", "poses": [[1, 2], [3, 4]], )" + member + "}";
}

TEST(ReadProblem, TakesEverythingTheFormatHas) {
  const Problem p = read(R"({"schema": "burmester/problem/1", "geometry": "flat", "name": "n", "source": "s",
    "units": {"length": "mm", "angle": "rad"}, "poses": [{"a": 1, "angle": 2}, [3, 4]], "types": ["RP", "RR"],
    "fixed": [[0, 0], [16, 0]], "moving": [[1, 2]], "weights": [1.5, "exact"], "near": [[3, 4]],
    "linkages": {"fixed_in": [[5, 1], [2, 3]], "classes": ["even"], "largest_ratio": 4, "most": 3}})");
  EXPECT_EQ(p.geometry, "flat");
  EXPECT_EQ(p.name, "n");
  EXPECT_EQ(p.source, "s");
  EXPECT_EQ(p.units.length, "mm");
  EXPECT_FALSE(p.units.degrees);
  EXPECT_THAT(p.poses, ElementsAre(PoseData{1, 2}, PoseData{3, 4}));
  EXPECT_THAT(p.types, ElementsAre("PR", "RR"));  // the module's alias
  EXPECT_EQ(p.fixed.size(), 2u);
  EXPECT_THAT(p.weights, ElementsAre(std::optional(1.5), std::nullopt));
  ASSERT_TRUE(p.linkages && p.linkages->fixed_in);
  EXPECT_THAT(p.linkages->fixed_in->low, ElementsAre(2, 1));
  EXPECT_THAT(p.linkages->fixed_in->high, ElementsAre(5, 3));
  EXPECT_FALSE(p.linkages->moving_in);
  EXPECT_THAT(p.linkages->classes, ElementsAre("even"));
  EXPECT_EQ(p.linkages->largest_ratio, 4);
  EXPECT_EQ(p.linkages->most, 3u);
  EXPECT_TRUE(p.warnings.empty());
}

TEST(ReadProblem, NeedsGeometryAndPosesOnly) {
  const Problem p = read(R"({"geometry": "flat", "poses": [[1, 2], [3, 4]]})");
  EXPECT_TRUE(p.units.degrees);
  EXPECT_TRUE(p.types.empty());
  EXPECT_EQ(complaint("{}"), "f: geometry: expected flat, got nothing");
  EXPECT_EQ(complaint(R"({"geometry": "flat"})"),
            "f: poses: expected an array of two or more poses, got nothing");
}

TEST(ReadProblem, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint("[1]"),
            "f: top level: expected a problem, an object with geometry and poses, got an array of 1");
  EXPECT_EQ(complaint(R"({"geometry": "curved", "poses": []})"),
            "f: geometry: expected flat, got \"curved\"");
  EXPECT_EQ(complaint(R"({"geometry": 3})"), "f: geometry: expected flat, got 3");
  EXPECT_EQ(complaint(R"({"geometry": "flat", "poses": []})"),
            "f: poses: expected two or more poses, got an empty array");
  EXPECT_EQ(complaint(R"({"geometry": "flat", "poses": [[1, 2]]})"),
            "f: poses: expected two or more poses, got an array of 1");
  EXPECT_EQ(complaint(R"({"geometry": "flat", "poses": {"0": 1}})"),
            "f: poses: expected an array of two or more poses, got an object");
  EXPECT_EQ(complaint(R"({"geometry": "flat", "poses": [[1, 2], [3]]})"),
            "f: poses[1]: expected an array of 2 numbers, got an array of 1");
  EXPECT_EQ(complaint(R"({"geometry": "flat", "poses": [[1, 2], [3, null]]})"),
            "f: poses[1][1]: expected a number, got null");
  EXPECT_EQ(complaint(with(R"("units": "mm")")), "f: units: expected an object, got \"mm\"");
  EXPECT_EQ(complaint(with(R"("units": {"angle": "grad"})")),
            "f: units.angle: expected deg or rad, got \"grad\"");
  EXPECT_EQ(complaint(with(R"("units": {"length": 1})")), "f: units.length: expected a string, got 1");
  EXPECT_EQ(complaint(with(R"("types": [])")),
            "f: types: expected an array of dyad types, RR or PR, got an empty array");
  EXPECT_EQ(complaint(with(R"("types": ["RR", "XX"])")), "f: types[1]: expected RR or PR, got \"XX\"");
  EXPECT_EQ(complaint(with(R"("fixed": [[1]])")),
            "f: fixed[0]: expected an array of 2 numbers, got an array of 1");
  EXPECT_EQ(complaint(with(R"("near": 3)")), "f: near: expected an array of points of 2 numbers, got 3");
  EXPECT_EQ(complaint(with(R"("weights": [1])")),
            "f: weights: expected an array of 2 weights, one for each pose, got an array of 1");
  EXPECT_EQ(complaint(with(R"("weights": [1, -1])")),
            "f: weights[1]: expected a number that is not negative, or \"exact\", got -1");
  EXPECT_EQ(complaint(with(R"("weights": [1, "exactly"])")),
            "f: weights[1]: expected a number that is not negative, or \"exact\", got \"exactly\"");
  EXPECT_EQ(complaint(with(R"("weights": [0, 0])")), "f: weights: expected a weight that is not 0, got none");
  EXPECT_EQ(complaint(with(R"("linkages": {"fixed_in": [[0, 1]]})")),
            "f: linkages.fixed_in: expected two opposite corners, got an array of 1");
  EXPECT_EQ(complaint(with(R"("linkages": {"classes": ["odd", "strange"]})")),
            "f: linkages.classes[1]: expected even or odd, got \"strange\"");
  EXPECT_EQ(complaint(with(R"("linkages": {"largest_ratio": 0.5})")),
            "f: linkages.largest_ratio: expected a number that is not below 1, got 0.5");
  EXPECT_EQ(complaint(with(R"("linkages": {"most": 1.5})")),
            "f: linkages.most: expected a whole number from 1 to 1000, got 1.5");
  EXPECT_EQ(complaint(with(R"("name": ["n"])")), "f: name: expected a string, got an array of 1");
}

TEST(ReadProblem, TellsDocumentsOfAnotherKind) {
  EXPECT_EQ(complaint(R"({"schema": "burmester/linkage/1"})"),
            "f: schema: expected burmester/problem/1, got burmester/linkage/1 (for burmester analyze)");
  EXPECT_EQ(complaint(R"({"schema": "burmester/platform/1"})"),
            "f: schema: expected burmester/problem/1, got burmester/platform/1 (for burmester platform)");
  EXPECT_EQ(complaint(R"({"schema": "burmester/problem/2"})"),
            "f: schema: expected burmester/problem/1, got \"burmester/problem/2\"");
}

TEST(ReadProblem, WarnsOfUnknownKeys) {
  const Problem p =
      read(R"({"geometry": "flat", "poses": [{"a": 1, "angle": 2, "x": 0}, [3, 4]], "nmae": "typo"})");
  EXPECT_THAT(p.warnings, ElementsAre("nmae: unknown key, ignored", "poses[0].x: unknown key, ignored"));
}

TEST(ReadProblem, TakesAGeometryForProblemsWithoutOne) {
  const ReadOptions options{.file = "f", .geometry = "flat"};
  EXPECT_EQ(read(R"({"poses": [[1, 2], [3, 4]]})", options).geometry, "flat");
  EXPECT_EQ(complaint(R"({"geometry": "curved", "poses": [[1, 2], [3, 4]]})", options),
            "f: geometry: expected flat, got \"curved\"");
}

TEST(ReadProblem, LimitsThePoses) {
  std::string text = R"({"geometry": "flat", "poses": [[0, 0])";
  for (std::size_t i = 0; i < most_poses; ++i) text += ",[0,0]";
  EXPECT_THAT(complaint(text + "]}"), HasSubstr("poses: expected at most 100000 poses"));
}

TEST(ReadCsv, TakesRowsUnderAKnownHeader) {
  const Problem p = read(
      "\xEF\xBB\xBF"
      "a, angle_deg \r\n 1 , 2\r\n\r\n+3,-4e-1\r\n");
  EXPECT_EQ(p.geometry, "flat");
  EXPECT_TRUE(p.units.degrees);
  EXPECT_THAT(p.poses, ElementsAre(PoseData{1, 2}, PoseData{3, -0.4}));
  EXPECT_FALSE(read("a,angle_rad\n1,2\n3,4").units.degrees);
}

TEST(ReadCsv, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint("a,b\n1,2\n"),
            "f: line 1: expected a header line, a,angle_deg or a,angle_rad, got a,b");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n3\n"), "f: line 3: expected 2 values, got 1");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n3,x\n"),
            "f: line 3, column angle_deg: expected a finite number, got \"x\"");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n3,nan\n"),
            "f: line 3, column angle_deg: expected a finite number, got \"nan\"");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n3,1e999\n"),
            "f: line 3, column angle_deg: expected a finite number, got \"1e999\"");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n3,\n"),
            "f: line 3, column angle_deg: expected a finite number, got \"\"");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n"),
            "f: line 2: expected 2 to 100000 poses, one on each line, got 1");
  EXPECT_EQ(complaint("a,angle_deg\n1,2\n-1,2\n"), "f: line 3: expected a that is not negative");
  EXPECT_EQ(complaint("", {.file = "f.csv", .geometry = {}}),
            "f.csv: line 1: expected a CSV header line, got nothing");
}

}  // namespace
}  // namespace burmester
