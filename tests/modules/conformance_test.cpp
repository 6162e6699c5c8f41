#include "burmester/modules/framework/conformance.hpp"

#include "toy_geometry.hpp"

namespace burmester {

BURMESTER_SPACE_CONFORMANCE(toy::Plane);
BURMESTER_SPACE_CONFORMANCE(toy::Turns);
BURMESTER_DYAD_CONFORMANCE(DyadList<toy::Circle>);
BURMESTER_DYAD_CONFORMANCE(DyadList<toy::Stop>);

TEST(Conformance, ViolationsPrintInputsBothSidesAndSeed) {
  const laws::Law broken{"broken", [](laws::Findings& f) {
                           f.expect_near(1.0, 2.0, 0.5, "one is two", [] { return "x = 7"; });
                           for (int i = 0; i < 9; ++i) f.expect(false, "false is true", [] { return ""; });
                         }};
  const laws::Violations found = laws::violations(broken, "toy");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0],
            "one is two\n  x = 7\n  expected 2\n  actual   1\n  off by 1, allowed 0.5\n  [seed toy.broken]");
  EXPECT_EQ(found[3], "and 7 more [seed toy.broken]");
}

TEST(Conformance, NotANumberIsAViolation) {
  const laws::Law broken{"broken", [](laws::Findings& f) {
                           f.expect_near(std::nan(""), 2.0, 0.5, "nan is two", [] { return ""; });
                         }};
  EXPECT_EQ(laws::violations(broken, "toy").size(), 1u);
}

TEST(Conformance, SameNameSameNumbers) {
  const auto draw = [](std::string_view) {
    laws::Findings f("toy.law");
    return laws::Pool<toy::Plane>(f.random).draw().text();
  };
  EXPECT_EQ(draw("first"), draw("second"));
}

}  // namespace burmester
