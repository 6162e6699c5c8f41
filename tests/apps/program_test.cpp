// The program in this process, on a module of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "flat_module.hpp"
#include "program/commands.hpp"

namespace burmester {
namespace {

using ::testing::HasSubstr;

struct Outcome {
  int code;
  std::string out, err;
};

Outcome run(const std::vector<std::string>& arguments, const std::string& input = "") {
  std::istringstream in(input);
  std::ostringstream out, err;
  Console console{in, out, err};
  Synthesis answer;
  answer.status = Status::none;
  answer.message = "no real dyad";
  const int code = run_program(arguments, testing::flat_registry(answer), console);
  return {code, out.str(), err.str()};
}

const std::string problem = R"({"geometry": "flat", "poses": [[1, 2], [3, 4]], "name": ")";

TEST(Program, AnswersThatThereIsNoDyad) {
  const Outcome o = run({"synthesize", "-"}, problem + "n\"}");
  EXPECT_EQ(o.code, answered);
  EXPECT_THAT(o.out, HasSubstr("no real dyad"));
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(run({"synthesize", "-", "--json"}, problem + "n\"}").out, HasSubstr("\"status\": \"none\""));
}

TEST(Program, ReportsInternalFailuresAsSuch) {
  const Outcome o = run({"synthesize", "-"}, problem + "fail\"}");
  EXPECT_EQ(o.code, internal_failure);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err, "burmester: internal failure: asked to fail\n");
  const Outcome batch = run({"batch"}, problem + "fail\"}\n" + problem + "n\"}\n");
  EXPECT_EQ(batch.code, internal_failure);
  EXPECT_THAT(batch.out, HasSubstr("\"line 1: internal failure: asked to fail\""));
  EXPECT_THAT(batch.out, HasSubstr("\"status\": \"none\""));
}

TEST(Program, TellsWhatIsNotAvailable) {
  const Outcome o =
      run({"synthesize", "-"}, R"({"geometry": "flat", "poses": [[1,2],[1,2],[1,2],[1,2],[1,2],[1,2]]})");
  EXPECT_EQ(o.code, not_available);
  EXPECT_EQ(o.err, "not available yet: more than five flat poses\n");
  EXPECT_EQ(run({"analyze"}).code, not_available);
}

TEST(Program, TakesTheModulesNamesForTypes) {
  EXPECT_THAT(run({"synthesize", "-", "--json", "--types", "RP"}, problem + "n\"}").out,
              HasSubstr("\"types\": [\"PR\"]"));
  EXPECT_EQ(run({"synthesize", "-", "--types", ""}, problem + "n\"}").code, bad_input);
  EXPECT_EQ(run({"synthesize", "-", "--types", ","}, problem + "n\"}").code, bad_input);
}

TEST(Program, KnowsOnlyTheRegistry) {
  EXPECT_THAT(run({"modules"}).out, HasSubstr("flat  (tests)"));
  EXPECT_EQ(run({"synthesize", "-"}, R"({"geometry": "planar", "poses": [[1, 2], [3, 4]]})").err,
            "standard input: geometry: expected flat, got \"planar\"\n");
}

}  // namespace
}  // namespace burmester
