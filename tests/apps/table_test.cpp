#include "program/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace burmester {
namespace {

using ::testing::HasSubstr;

DyadRecord dyad(int id, const char* type) {
  DyadRecord d;
  d.id = id;
  d.type = type;
  return d;
}

std::size_t widest(const std::string& text) {
  std::istringstream in(text);
  std::size_t width = 0;
  for (std::string line; std::getline(in, line);) width = std::max(width, line.size());
  return width;
}

Problem planar_problem() {
  Problem p;
  p.geometry = "planar";
  p.name = "a task";
  p.units.length = "mm";
  p.poses.resize(5);
  return p;
}

TEST(AnswerText, ShowsEveryTypeOfDyad) {
  Synthesis s;
  s.message = "4 real dyads";
  s.dyads = {dyad(1, "RR"), dyad(2, "PR"), dyad(3, "RP"), dyad(4, "PP")};
  s.dyads[0].fixed = {1, 1e-15};
  s.dyads[0].moving = {-2.5, 3};
  s.dyads[0].length = 1.23456789;
  s.dyads[0].condition = 1234;
  s.dyads[1].moving = {4, 5};
  s.dyads[1].line = LineRecord{{0, 2}, 3.14159265358979323 / 3};
  s.dyads[2].fixed = {6, 7};
  s.dyads[2].line = LineRecord{{8, 9}, 0};
  s.dyads[3].angle = 0.5;
  s.linkages.resize(1);
  LinkageRecord& linkage = s.linkages.front();
  linkage.id = linkage.dyads[0] = 1;
  linkage.dyads[1] = 2;
  linkage.type = "RRRP";
  linkage.motion_class = "slider-crank";
  linkage.input = 1.5;
  linkage.offset = 0.25;
  const std::string text = answer_text(planar_problem(), s, 1);
  EXPECT_THAT(text, HasSubstr("a task\nplanar, 5 poses; lengths in mm, angles in deg\n4 real dyads\n"));
  EXPECT_THAT(text, HasSubstr("length, line or angle"));
  EXPECT_THAT(text, HasSubstr("1  RR    (1, 0)       (-2.5, 3)     1.23457"));
  EXPECT_THAT(text, HasSubstr("2  PR    -            (4, 5)        (0, 2) at 60 deg"));
  EXPECT_THAT(text, HasSubstr("28.6479 deg"));
  EXPECT_THAT(text, HasSubstr("slider-crank"));
  EXPECT_EQ(text.find("on coupler"), std::string::npos);
  EXPECT_LE(widest(text), 100u);
}

TEST(AnswerText, SaysWhereThePosesComeFrom) {
  Problem p = planar_problem();
  p.source =
      "A. Author, \"Title of some length\", example 2; in the printed table of solutions the columns are "
      "exchanged";
  const std::string text = answer_text(p, {}, 1);
  EXPECT_THAT(text, HasSubstr("a task\nA. Author, "));
  EXPECT_THAT(text, HasSubstr(" columns are\nexchanged\nplanar, 5 poses"));
  EXPECT_LE(widest(text), 100u);
}

TEST(AnswerText, MarksSlidersThatAnglesHideAndTheUnitOfResiduals) {
  Problem p = planar_problem();
  p.geometry = "spherical";
  p.units = {"", true};
  Synthesis s;
  s.dyads = {dyad(1, "RR"), dyad(2, "RR")};
  s.dyads[0].arc = 1.5705;
  s.dyads[0].slider = SliderRecord{"PR", {}, 3e-4};
  s.dyads[1].arc = 1;
  const std::string text = answer_text(p, s, 1);
  EXPECT_THAT(text, HasSubstr("angles in deg, residuals in rad\n"));
  EXPECT_THAT(text, HasSubstr("89.983 deg, nearly PR"));
  EXPECT_THAT(text, HasSubstr("57.2958 deg  "));
}

TEST(AnswerText, FitsIntoHundredColumns) {
  Synthesis s;
  s.message = "m";
  s.dyads = {dyad(1, "RR"), dyad(2, "PR")};
  s.dyads[0].fixed = {-1.23456789e-7, -1.23456789e+17};
  s.dyads[0].moving = s.dyads[1].moving = {-1.23456789e-7, -1.23456789e+17};
  s.dyads[0].length = 1.23456789e-17;
  s.dyads[1].line = LineRecord{{-1.23456789e-7, -1.23456789e+17}, 1.2345678};
  s.dyads[0].condition = 1.5e17;
  EXPECT_LE(widest(answer_text(planar_problem(), s, 0)), 100u);
}

TEST(AnswerText, HasNoTablesWithoutDyads) {
  Synthesis s;
  s.message = "no real dyad";
  Problem p = planar_problem();
  p.name.clear();
  p.units = {"", false};
  EXPECT_EQ(answer_text(p, s, 1), "planar, 5 poses; angles in rad\nno real dyad\n");
}

}  // namespace
}  // namespace burmester
