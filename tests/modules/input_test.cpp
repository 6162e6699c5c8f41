#include "burmester/modules/framework/input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace burmester {
namespace {

using ::testing::ElementsAre;

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

std::string complaint(std::string_view text) {
  return complaint([&] { InputDocument(text, "f"); });
}

TEST(InputNode, ReadsValuesAndKnowsTheirPlace) {
  const InputDocument document(R"({"poses": [{"angle": 12}, {"angle": "x"}], "name": "n"})", "task.json");
  const InputNode poses = document.root().at("poses");
  EXPECT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses.at(0).at("angle").number(), 12);
  EXPECT_EQ(document.root().at("name").string(), "n");
  EXPECT_FALSE(document.root().has("other"));
  EXPECT_FALSE(document.root().at("other").present());
  EXPECT_EQ(complaint([&] { poses.at(1).at("angle").number(); }),
            "task.json: poses[1].angle: expected a number, got \"x\"");
  EXPECT_EQ(complaint([&] { poses.at(0).at("x").number(); }),
            "task.json: poses[0].x: expected a number, got nothing");
  EXPECT_EQ(complaint([&] { poses.number(); }), "task.json: poses: expected a number, got an array of 2");
  EXPECT_EQ(complaint([&] { document.root().string(); }),
            "task.json: top level: expected a string, got an object");
  EXPECT_EQ(complaint([&] { poses.numbers(3); }),
            "task.json: poses: expected an array of 3 numbers, got an array of 2");
  EXPECT_EQ(complaint([&] {
              document.root().at("name").choice({"a", "b", "c"});
            }),
            "task.json: name: expected a, b or c, got \"n\"");
  EXPECT_EQ(complaint([&] { document.root().at("name").at("first"); }),
            "task.json: name: expected an object, got \"n\"");
}

TEST(InputNode, WarnsOfUnknownKeysOnceForEachKindOfPlace) {
  const InputDocument document(R"({"poses": [{"a": 1, "colour": 2}, {"colour": 3, "b": 4}], "nmae": 5})",
                               "f");
  for (std::size_t i = 0; i < 2; ++i) document.root().at("poses").at(i).expect_keys({"a"});
  document.root().expect_keys({"poses"});
  EXPECT_THAT(document.warnings(),
              ElementsAre("poses[0].colour: unknown key, ignored", "poses[1].b: unknown key, ignored",
                          "nmae: unknown key, ignored"));
}

TEST(InputNode, GivesUpWarningAfterTwenty) {
  std::string text = "{";
  for (char c = 'a'; c <= 'z'; ++c) text += std::string("\"") + c + "\": 1, ";
  const InputDocument document(text + "\"x1\": 1}", "f");
  document.root().expect_keys({});
  EXPECT_EQ(document.warnings().size(), 21u);
  EXPECT_EQ(document.warnings().back(), "further warnings are left out");
}

TEST(InputDocument, SaysWhereTheSyntaxBreaks) {
  EXPECT_EQ(complaint(""), "f: line 1: expected a JSON value, got nothing");
  EXPECT_EQ(complaint(" \n\t"), "f: line 1: expected a JSON value, got nothing");
  EXPECT_EQ(complaint("{\"a\": 1,\n \"b\": nul}"), "f: line 2, column 7 (b): expected a value, got nul");
  EXPECT_EQ(complaint("{\"a\": NaN}"), "f: line 1, column 7 (a): expected a value, got NaN");
  EXPECT_EQ(complaint("{\"p\": [1, 2}"), "f: line 1, column 12 (p[2]): expected ',' or ']', got '}'");
  EXPECT_EQ(complaint("{\"p\": 1 \"q\": 2}"), "f: line 1, column 9 (p): expected ',' or '}', got \"q\"");
  EXPECT_EQ(complaint("{\"p\" 1}"), "f: line 1, column 6 (p): expected ':', got 1");
  EXPECT_EQ(complaint("{p: 1}"), "f: line 1, column 2: expected a key in quotes, got p");
  EXPECT_EQ(complaint("[1, 2"), "f: line 1, column 6 ([2]): expected ',' or ']', got the end of the input");
  EXPECT_EQ(complaint("{} x"), "f: line 1, column 4: expected the end of the input, got x");
  EXPECT_EQ(complaint("[1,]"), "f: line 1, column 4 ([1]): expected a value, got ']'");
}

TEST(InputDocument, RefusesWhatWouldBeLost) {
  EXPECT_EQ(complaint(R"({"a": {"b": 1, "b": 2}})"), "f: a.b: expected each key once, got it twice");
  EXPECT_EQ(complaint("[1e999]"), "f: line 1, column 2 ([0]): expected a finite number, got 1e999");
  EXPECT_EQ(complaint("[-1e999]"), "f: line 1, column 2 ([0]): expected a finite number, got -1e999");
}

TEST(InputDocument, StandsDeepNesting) {
  EXPECT_THAT(complaint(std::string(1000000, '[')), ::testing::HasSubstr("expected at most 100 levels"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THAT(complaint(objects), ::testing::HasSubstr("expected at most 100 levels"));
  EXPECT_EQ(complaint(std::string(100, '[') + std::string(100, ']')), "no complaint");
}

TEST(InputDocument, TakesAByteOrderMarkAndRefusesBrokenText) {
  EXPECT_EQ(complaint("\xEF\xBB\xBF{}"), "no complaint");
  const std::string broken = complaint("{\"a\": \"\xFF\"}");
  EXPECT_THAT(broken, ::testing::HasSubstr("ill-formed UTF-8"));
  EXPECT_EQ(broken.find('\xFF'), std::string::npos);
  EXPECT_THAT(complaint(std::string("{\"a\": 1}\0", 9)),
              ::testing::HasSubstr("column 9: expected text, got a zero byte"));
}

TEST(Printable, IsOneLineOfValidText) {
  EXPECT_EQ(printable("a\nb\tc\x1b[0m\x7f"), "a b c?[0m?");
  EXPECT_EQ(printable("gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x98\x80"),
            "gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x98\x80");
  EXPECT_EQ(printable("\xC3"), "?");
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");  // half of a surrogate pair
  EXPECT_EQ(printable("\xC2\x9B"), "?");         // a control character of Latin-1
  EXPECT_EQ(printable("abcdef", 3), "abc..");
}

}  // namespace
}  // namespace burmester
