#include "burmester/spherical/pose_format.hpp"

#include <gmock/gmock.h>

#include "burmester/spherical/space.hpp"
#include "burmester/spherical/spherical.hpp"

namespace burmester::spherical {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PoseData read(const std::string& text, bool degrees = true) {
  const InputDocument document(text, "task.json");
  return read_pose(document.root(), {"", degrees});
}
std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
double gap(const PoseData& a, const PoseData& b) {
  return Space::gap(Space::point<double>(pose_of(a)), Space::point<double>(pose_of(b)));
}

TEST(SphericalPoseFormat, FourWaysToWriteOnePose) {
  const PoseData expected = read(R"({"axis": [0, 0, 2], "angle": 90})");
  EXPECT_LT(gap(read(R"({"quaternion_wxyz": [1, 0, 0, 1]})"), expected), 4e-16);
  EXPECT_LT(gap(read(R"({"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]})"), expected), 4e-16);
  EXPECT_LT(gap(read(R"({"longitude": 90, "latitude": 0, "roll": 0})"), expected), 4e-16);
  EXPECT_LT(gap(read(R"({"axis": [0, 0, 1], "angle": 1.5707963267948966})", false), expected), 4e-16);
}

TEST(SphericalPoseFormat, AQuaternionIsTakenAsGiven) {
  EXPECT_THAT(read(R"({"quaternion_wxyz": [-3, 0.1, 0, 7]})"), ElementsAre(-3, 0.1, 0, 7));
  EXPECT_THAT(read_csv_pose({2, 0, 0, 1}), ElementsAre(2, 0, 0, 1));
}

TEST(SphericalPoseFormat, QuaternionsOfEverySizeAreScaledExactly) {
  const auto image = [](double w, double x, double y, double z) { return Space::point<double>({w, x, y, z}); };
  EXPECT_EQ(image(0x1p-600, 0, 0, -0x1p-601), Space::Point<double>(1, 0, 0, -0.5));
  EXPECT_EQ(image(0, 0x1p1023, 0, 0x1p1000), Space::Point<double>(0, 1, 0, 0x1p-23));
  EXPECT_EQ(image(0, -0x1p-1073, 0, 0x1p-1074), Space::Point<double>(0, -1, 0, 0.5));
  EXPECT_EQ(image(1, 0.25, -0.5, 0.75), Space::Point<double>(1, 0.25, -0.5, 0.75));
}

TEST(SphericalPoseFormat, ZeroesAreNoPoses) {
  EXPECT_EQ(complaint(R"({"quaternion_wxyz": [0, 0, 0, 0]})"),
            "task.json: quaternion_wxyz: expected a quaternion that is not zero, got an array of 4");
  EXPECT_THAT(complaint(R"({"axis": [0, 0, 0], "angle": 1})"),
              HasSubstr("axis: expected an axis that is not zero"));
  EXPECT_THROW(read_csv_pose({0, 0, 0, 0}), InputError);
}

TEST(SphericalPoseFormat, MatricesMustBeRotationsWithinOneMillionth) {
  EXPECT_EQ(complaint(R"({"matrix": [[0.9999996, 0, 0], [0, 1, 0], [0, 0, 1]]})"), "");
  for (const char* text : {R"({"matrix": [[0.999, 0, 0], [0, 1, 0], [0, 0, 1]]})",  // stretched
                           R"({"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]})",     // a reflection
                           R"({"matrix": [[1, 0.001, 0], [0, 1, 0], [0, 0, 1]]})",  // sheared
                           R"({"matrix": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]})"})
    EXPECT_THAT(complaint(text), HasSubstr("orthogonal matrix with determinant +1")) << text;
}

TEST(SphericalPoseFormat, WrongShapesSayWhere) {
  EXPECT_THAT(complaint(R"({"axis": [0, 1], "angle": 1})"),
              HasSubstr("axis: expected an array of 3 numbers"));
  EXPECT_THAT(complaint(R"({"axis": [0, 0, 1]})"), HasSubstr("angle: expected a number, got nothing"));
  EXPECT_THAT(complaint(R"({"matrix": [[1, 0, 0], [0, 1, 0]]})"),
              HasSubstr("matrix: expected an array of 3 rows"));
  EXPECT_THAT(complaint(R"({"matrix": [[1, 0, 0], [0, 1], [0, 0, 1]]})"), HasSubstr("matrix[1]"));
  EXPECT_THAT(complaint(R"({"longitude": 10})"), HasSubstr("latitude: expected a number"));
  for (const char* text :
       {"{}", "[1, 0, 0, 0]", "3", R"({"axis": [0, 0, 1], "angle": 1, "quaternion_wxyz": [1, 0, 0, 0]})"})
    EXPECT_THAT(complaint(text), HasSubstr("a pose: one of")) << text;
}

TEST(SphericalPoseFormat, UnknownKeysAreWarnedOf) {
  const InputDocument document(R"({"axis": [0, 0, 1], "angle": 5, "colour": "red"})", "task.json");
  read_pose(document.root(), {});
  EXPECT_EQ(document.warnings().size(), 1u);
}

TEST(SphericalModule, HasItsFace) {
  const auto module = make_module();
  EXPECT_EQ(module->info().name, "spherical");
  EXPECT_THAT(module->info().dyad_types, ElementsAre("RR", "PR"));
  EXPECT_THAT(module->info().csv_headers, ElementsAre(ElementsAre("qw", "qx", "qy", "qz")));
  EXPECT_EQ(module->info().point_size, 3);
  ASSERT_EQ(module->info().solvers.size(), 4u);
  for (const auto& [at, orientations] : {std::pair{0u, "two and three"}, {1u, "four"}, {2u, "five"}, {3u, "six"}})
    EXPECT_THAT(module->info().solvers[at].name, testing::StartsWith(orientations));
  EXPECT_TRUE(module->draw({}, {}).poses.empty());
  EXPECT_EQ(module->task_size({}), 1);
  EXPECT_EQ(module->show_pose({1, 0, 0, 0.5}, {}).back(), (std::pair<std::string, double>("quaternion_wxyz", 0.5)));
}

}  // namespace
}  // namespace burmester::spherical
