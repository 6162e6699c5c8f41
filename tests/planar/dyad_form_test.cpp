// The dyad form: the same curves as the cubic, by another way, and clear words where the poses allow none.
#include "burmester/planar/dyad_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "four_poses.hpp"
#include "repetitions.hpp"

namespace burmester::planar {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Limit = FreeRange::Limit;

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// Two sets of four positions with what the algorithm of "Theory of Mechanisms", lecture 19, gives for them, computed
/// independently of this library in 15 digits: the lecture itself prints no numbers.
struct Published {
  struct Row {
    double phi2;  // degrees, like all angles here
    int mode;
    double phi3, phi4;
    std::array<double, 4> Z;     // Z1, Z2
    std::array<double, 4> pair;  // K, M
  };
  std::array<std::array<double, 3>, 4> poses;
  std::array<std::array<double, 2>, 4> delta;
  std::array<double, 4> links;
  std::vector<double> limits;  // all of them stretched
  std::vector<Row> rows;
  std::array<double, 3> PR, RP;  // pivot, direction of the line
  int PR_mode, RP_mode;
  std::vector<std::array<double, 4>> meetings;  // where the modes meet: K, M
};

const std::vector<Published>& published() {
  static const std::vector<Published> sets{
      {{{{0, 0, 0}, {-2.7, 0.5, -55}, {3.9, -0.9, 75}, {1.3, -2, 50}}},
       {{{-0.5275962850656358, 2.4381962137893565},
         {1.6720047346268299, -0.5709989954753817},
         {2.7741059536084784, -2.0348756613001897},
         {-3.918514403169673, 0.16767844298621454}}},
       {2.4946259473018824, 1.766816256844053, 3.4404044527929982, 3.9221003541585286},
       {},
       {{15,
         1,
         -161.07131197542472,
         123.9446620836455,
         {-0.6205202963413308, 1.75212271686731, 0.4419843584457464, -2.5382204160716286},
         {-0.4419843584457464, 2.5382204160716286, 0.17853593789558442, 0.7860976992043189}},
        {15,
         -1,
         -2.4827746972957665,
         4.879841052154349,
         {-7.353651059140923, 10.344110248479002, -2.5101974924631394, -1.6403843660273563},
         {2.5101974924631394, 1.6403843660273563, 9.863848551604063, -8.703725882451646}},
        {130,
         1,
         -98.07803594284475,
         157.96707923495296,
         {0.28776951594496547, 1.0502938811744282, -1.214409473139146, -2.3689580490444535},
         {1.214409473139146, 2.3689580490444535, 0.9266399571941806, 1.3186641678700255}},
        {220,
         -1,
         73.46740087834495,
         84.17219195846317,
         {1.3137033466796009, 2.0016212267729006, -3.853325580846852, -4.040407001000688},
         {3.853325580846852, 4.040407001000688, 2.5396222341672511, 2.0387857742277874}}},
       {2.5556155220862196, 1.353002973339223, 38.986923810045504},
       {-0.4154912580278662, 4.555738417056104, 12.642958581391746},
       -1,
       -1,
       {}},
      {{{{0, 0, 0}, {1.5, 0.8, 20}, {3.2, 0.9, 50}, {4, -0.6, 85}}},
       {{{-1.3661016401038435, -0.4488847097238844},
         {2.8484539561076088, 0.9122420042975105},
         {-2.130204713490944, -0.640248359495385},
         {0.6478523974871784, 0.176891064921759}}},
       {1.4379607691861092, 2.990965632445453, 2.224340370360518, 0.6715677015603408},
       {-71.78360732078545, 72.64719380629694},
       {{15,
         1,
         18.85075895247611,
         -4.572739297118233,
         {5.133330155384008, -3.0131130375267126, -2.237594863249881, -2.2224406285983154},
         {2.237594863249881, 2.2224406285983154, -2.8957352921341264, 5.235553666125028}},
        {15,
         -1,
         38.696363558553784,
         65.03309163549542,
         {-34.393149871544246, -25.891799200471244, 28.195144011538908, 13.662451634879442},
         {-28.195144011538908, -13.662451634879442, 6.198005860005341, 12.2293475655918}},
        {70,
         -1,
         106.07301129657222,
         -101.5062021696025,
         {1.2229640058818452, -1.051166943802783, -3.6099524135012473, -3.213860684252017},
         {3.6099524135012473, 3.213860684252017, 2.3869884076194023, 4.2650276280548}},
        {310,
         1,
         -93.6511779133589,
         175.2038363656554,
         {-1.3529670921351098, 0.7570487796976689, -0.1219896146759707, -1.2555210988968972},
         {0.1219896146759707, 1.2555210988968972, 1.4749567068110805, 0.4984723191992283}}},
       {-1.4615035892119252, -4.1506159021961295, 10.37100280777032},
       {5.115332877588492, 9.895472558467297, 180 - 61.68449443033245},
       1,
       -1,
       {{1.2069279544638651, 1.8962591170836363, 2.3551981603525847, 1.9074802131823707},
        {3.13627327655793, 2.9438178073211696, 2.135452849607466, 3.9981394914475996}}}};
  return sets;
}

TEST(DyadForm, AgreesWithTwoSetsComputedInFifteenDigits) {
  for (const Published& set : published()) {
    const DyadForm form(four_poses(set.poses));
    ASSERT_EQ(form.degeneracy(), "");
    EXPECT_EQ(form.free_pose(), 2);
    EXPECT_FALSE(form.change_point());
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_LT(std::abs(form.delta()[j] - Complex(set.delta[j][0], set.delta[j][1])), 1e-14);
      EXPECT_NEAR(std::abs(form.delta()[j]), set.links[j], 1e-14);
    }
    ASSERT_EQ(form.ranges().size(), 1u);
    const FreeRange& range = form.ranges()[0];
    EXPECT_EQ(range.full, set.limits.empty());
    if (!range.full) {
      EXPECT_LT(angle_between(range.middle - range.half, set.limits[0] * degree), 1e-14);
      EXPECT_LT(angle_between(range.middle + range.half, set.limits[1] * degree), 1e-14);
      EXPECT_EQ(range.ends[0], Limit::stretched);
      EXPECT_EQ(range.ends[1], Limit::stretched);
    }
    for (const Published::Row& row : set.rows) {
      const auto pair = form.at(row.phi2 * degree, row.mode);
      ASSERT_TRUE(pair) << row.phi2;
      EXPECT_LT(angle_between(pair->phi[1], row.phi3 * degree), 1e-13) << row.phi2;
      EXPECT_LT(angle_between(pair->phi[2], row.phi4 * degree), 1e-13) << row.phi2;
      const double small = 1e-14 * (1 + std::abs(pair->Z1) * std::abs(pair->Z2));  // far pivots lose as many digits
      EXPECT_LT(std::abs(pair->Z1 - Complex(row.Z[0], row.Z[1])), small) << row.phi2;
      EXPECT_LT(std::abs(pair->Z2 - Complex(row.Z[2], row.Z[3])), small) << row.phi2;
      EXPECT_LT((pair->moving - Vector2(row.pair[0], row.pair[1])).norm(), small) << row.phi2;
      EXPECT_LT((pair->fixed - Vector2(row.pair[2], row.pair[3])).norm(), small) << row.phi2;
    }
    for (std::size_t k = 0; k < set.meetings.size(); ++k)
      for (const int mode : {1, -1}) {
        // A limit rounded to a double moves the pair by the root of that along the curve.
        const auto pair = form.at(set.limits[k] * degree, mode);
        ASSERT_TRUE(pair) << k;
        EXPECT_LT((pair->moving - Vector2(set.meetings[k][0], set.meetings[k][1])).norm(), 1e-6) << k;
        EXPECT_LT((pair->fixed - Vector2(set.meetings[k][2], set.meetings[k][3])).norm(), 1e-6) << k;
      }
    const auto PR = form.PR_limit();
    const auto RP = form.RP_limit();
    ASSERT_TRUE(PR && RP);
    EXPECT_EQ(PR->mode, set.PR_mode);
    EXPECT_EQ(RP->mode, set.RP_mode);
    EXPECT_LT((PR->design.moving - Vector2(set.PR[0], set.PR[1])).norm(), 1e-13);
    EXPECT_LT((RP->design.fixed - Vector2(set.RP[0], set.RP[1])).norm(), 1e-13);
    EXPECT_NEAR(PR->design.line.record().angle, set.PR[2] * degree, 1e-13);
    EXPECT_NEAR(RP->design.line.record().angle, set.RP[2] * degree, 1e-13);
  }
}

/// Without an answer outside its range, and at the two positions that are no dyads.
TEST(DyadForm, NoPairWhereTheLinkageDoesNotCloseOrAPivotIsInfinitelyFar) {
  const DyadForm form(four_poses(published()[1].poses));
  EXPECT_TRUE(form.at(72.6 * degree, 1));
  EXPECT_FALSE(form.at(72.7 * degree, 1));
  EXPECT_FALSE(form.at(180 * degree, -1));
  EXPECT_FALSE(form.at(0, 1));
  EXPECT_FALSE(form.at(20 * degree, -1));
}

TEST(DyadForm, AgreesWithTheCubicOnRandomSets) {
  Random random("DyadForm.AgreesWithTheCubicOnRandomSets");
  int points = 0, two_loops = 0;
  for (int i = 0; i < repetitions(1000); ++i) {
    const FourPoseTask task = random_four_poses(random);
    const DyadForm form(task);
    ASSERT_EQ(form.degeneracy(), "") << i;
    const ExactCubics cubics(task);
    std::size_t loops = 0;
    for (const FreeRange& range : form.ranges()) loops += range.full ? 2 : 1;
    EXPECT_EQ(loops, static_cast<std::size_t>(four_pose_curves(task, {1, 1, 0.01}).topology.components)) << i;
    two_loops += loops == 2;
    for (const DyadFormPiece& piece : form.sampled({1e-2, 1, 8}))
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++points) {
        EXPECT_LT(concyclicity(task, piece.moving[k], piece.fixed[k]), 1e-12) << i;
        if (k % 4 != 0) continue;  // exact arithmetic is slow
        // A few unit roundoffs times what near poses or a near double point of the curve amplify them by.
        EXPECT_LT(cubics.distance_of_moving(piece.moving[k]), 1e-10) << i;
        EXPECT_LT(cubics.distance_of_fixed(piece.fixed[k]), 1e-10) << i;
      }
  }
  EXPECT_GT(points, repetitions(100000));
  EXPECT_GT(two_loops, repetitions(100));
  EXPECT_LT(two_loops, repetitions(900));
}

TEST(DyadForm, ItsJointsCloseAndItsDyadsMeetThePoses) {
  Random random("DyadForm.ItsJointsCloseAndItsDyadsMeetThePoses");
  for (int i = 0; i < 200; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const DyadForm form(task);
    const FreeRange& range = form.ranges()[0];
    const double size = task_size(task);
    for (const int mode : {1, -1}) {
      const auto pair = form.at(range.middle + 0.3 * range.half, mode);
      ASSERT_TRUE(pair) << i;
      const auto joints = form.joints(*pair);
      const double longest = std::abs(form.delta()[0]) + std::abs(form.delta()[3]);
      EXPECT_LT(std::abs(joints[3] + form.delta()[3] * std::polar(1.0, pair->phi[2])), 1e-13 * longest) << i;
      const double far = 1e-12 * (size + std::abs(pair->Z1) + std::abs(pair->Z2));
      for (std::size_t j = 1; j < 4; ++j) {  // the sum of the dyad's vectors moves with the body
        const double gamma = angle_of(task[j]) - angle_of(task[0]);
        const Complex moved =
            pair->Z1 * (std::polar(1.0, pair->phi[j - 1]) - 1.0) + pair->Z2 * (std::polar(1.0, gamma) - 1.0);
        EXPECT_LT(std::abs(moved - Complex(task[j].x - task[0].x, task[j].y - task[0].y)), far) << i;
      }
    }
  }
}

TEST(DyadForm, ItsSlidersAreThoseOfTheCubic) {
  Random random("DyadForm.ItsSlidersAreThoseOfTheCubic");
  for (int i = 0; i < 300; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const DyadForm form(task);
    const PlanarReport report = FourPoseSolver().solve(task);
    ASSERT_EQ(report.dyads.size(), 2u) << i;
    const auto PR = form.PR_limit();
    const auto RP = form.RP_limit();
    ASSERT_TRUE(PR && RP) << i;
    const auto& pr = std::get<planar::PR::Design>(report.dyads[0].design);
    const auto& rp = std::get<planar::RP::Design>(report.dyads[1].design);
    const double size = task_size(task);
    EXPECT_LT((PR->design.moving - pr.moving).norm(), 1e-9 * (size + pr.moving.norm())) << i;
    EXPECT_LT((RP->design.fixed - rp.fixed).norm(), 1e-9 * (size + rp.fixed.norm())) << i;
    EXPECT_LT(std::abs(PR->design.line.normal.dot(Vector2(pr.line.normal[1], -pr.line.normal[0]))), 1e-9) << i;
    EXPECT_LT(std::abs(RP->design.line.normal.dot(Vector2(rp.line.normal[1], -rp.line.normal[0]))), 1e-9) << i;
    EXPECT_LT(largest_residual<planar::PR>(PR->design, task), 1e-9 * (size + pr.moving.norm())) << i;
    EXPECT_LT(largest_residual<planar::RP>(RP->design, task), 1e-9 * (size + rp.fixed.norm())) << i;
  }
}

/// Every vertex of the traced cubic lies on the sampled loops, and in one mode the loops have no gap.
void expect_covered(const FourPoseTask& task, const std::string& name) {
  const CurveOptions options{1e-3, 0.25, 8};
  const double unit = power_of_two_below(curve_scale(task));
  const auto pieces = DyadForm(task).sampled(options);
  const FourPoseCurves curves = four_pose_curves(task, options);
  for (const CurveRecord& curve : curves.pieces)
    for (std::size_t k = 0; k < curve.moving.size(); ++k) {
      const Vector2 m(curve.moving[k][0], curve.moving[k][1]), c(curve.fixed[k][0], curve.fixed[k][1]);
      if (!within_window(m, c, task, 0.9)) continue;
      double nearest = 1e300, nearest_fixed = 1e300;
      for (const DyadFormPiece& piece : pieces) {
        const auto moving = [&](std::size_t j) { return piece.moving[j]; };
        const auto fixed = [&](std::size_t j) { return piece.fixed[j]; };
        nearest = std::min(nearest, distance_to_polyline(m, piece.moving.size(), piece.closed, moving));
        nearest_fixed = std::min(nearest_fixed, distance_to_polyline(c, piece.fixed.size(), piece.closed, fixed));
      }
      // The middle of each chord is within the tolerance of the curve; between, it may be off by somewhat more.
      EXPECT_LT(nearest, 4 * options.tolerance * unit + curve.max_error) << name << " " << k;
      EXPECT_LT(nearest_fixed, 4 * options.tolerance * unit + curve.max_error) << name << " " << k;
    }
}

TEST(DyadForm, LeavesNothingOfTheCurvesOut) {
  Random random("DyadForm.LeavesNothingOfTheCurvesOut");
  for (int i = 0; i < 40; ++i) expect_covered(random_four_poses(random), std::to_string(i));
}

TEST(DyadForm, ModesMeetInTheSamePoint) {
  Random random("DyadForm.ModesMeetInTheSamePoint");
  int limited = 0;
  for (int i = 0; i < 200; ++i) {
    const DyadForm form(random_four_poses(random));
    for (const FreeRange& range : form.ranges()) {
      if (range.full) continue;
      ++limited;
      for (const double end : {range.middle - range.half, range.middle + range.half}) {
        const auto a = form.at(end, 1), b = form.at(end, -1);
        ASSERT_TRUE(a && b) << i;
        // The root of a unit roundoff, times the speed of the curve.
        EXPECT_LT((a->moving - b->moving).norm(), 1e-6 * (1 + a->moving.norm())) << i;
      }
    }
  }
  EXPECT_GT(limited, 50);
}

TEST(DyadForm, NamesWhatIsWrongWithThePoses) {
  const std::pair<const char*, std::array<std::array<double, 3>, 4>> cases[] = {
      {"all four poses are parallel", {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}}},
      {"all four poses are parallel", {{{1, 0, 20}, {1, 0, 20}, {1, 0, 20}, {1, 0, 20}}}},
      {"all four poses are rotations about one point", {{{0, 0, 0}, {0, 0, 30}, {0, 0, 60}, {0, 0, 90}}}},
      {"all four poses are rotations about one point", {{{1, 0, 0}, {0, 1, 90}, {-1, 0, 180}, {0, -1, 270}}}},
      {"poses 2 and 3 are equal", {{{0, 0, 0}, {2, 1, 40}, {2, 1, 40}, {-1, 3, 100}}}},
      {"poses 1 and 4 are equal", {{{2, 1, 40}, {0, 0, 0}, {-1, 3, 100}, {2, 1, 40}}}},
      {"poses 1, 2 and 4 are parallel", {{{0, 0, 0}, {2, 0, 0}, {2, 1, 40}, {-1, 3, 0}}}},
      {"poses 2, 3 and 4 are parallel", {{{0, 0, 10}, {2, 0, 0}, {2, 1, 0}, {-1, 3, 0}}}},
      {"poses 1, 2 and 3 are rotations about one point, their poles coincide",
       {{{0, 0, 0}, {0, 0, 30}, {0, 0, 80}, {3, 1, -50}}}},
      {"the compatibility linkage is a rhombus", {{{-1, 0, -90}, {1, 0, 90}, {-3, 2, 0}, {3, 2, 0}}}}};
  for (const auto& [words, poses] : cases) {
    const DyadForm form(four_poses(poses));
    EXPECT_EQ(form.degeneracy(), words);
    EXPECT_TRUE(form.ranges().empty()) << words;
    EXPECT_TRUE(form.sampled().empty()) << words;
  }
}

/// Symmetric poses: the cubic is a line and a conic, the compatibility linkage a kite or a parallelogram.
TEST(DyadForm, SymmetricPosesGiveAChangePointAndBothPartsOfTheCurve) {
  const std::pair<const char*, std::array<std::array<double, 3>, 4>> cases[] = {
      {"mirror images in pairs", {{{-1, 0, -30}, {1, 0, 30}, {-3, 2, -70}, {3, 2, 70}}}},
      {"mirror images in order", {{{-2, 1, -40}, {-1, 0, -15}, {1, 0, 15}, {2, 1, 40}}}},
      {"two orientations", {{{0, 0, 0}, {1, 2, 0}, {3, 1, 50}, {-2, 2, 50}}}}};
  for (const auto& [name, poses] : cases) {
    const FourPoseTask task = four_poses(poses);
    const DyadForm form(task);
    ASSERT_EQ(form.degeneracy(), "") << name;
    EXPECT_TRUE(form.change_point()) << name;
    const CurveTopology topology = four_pose_curves(task).topology;
    EXPECT_EQ(topology.lines.size(), 1u) << name;
    EXPECT_EQ(topology.conics.size(), 1u) << name;
    int points = 0;
    for (const DyadFormPiece& piece : form.sampled())
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++points)
        EXPECT_LT(concyclicity(task, piece.moving[k], piece.fixed[k]), 1e-12) << name;
    EXPECT_GT(points, 50) << name;
    expect_covered(task, name);
  }
}

TEST(DyadForm, OneTranslationIsAnOrdinaryTask) {
  const FourPoseTask task = four_poses({{{0, 0, 0}, {2, 0, 0}, {2, 1, 40}, {-1, 3, 100}}});
  const DyadForm form(task);
  EXPECT_EQ(form.degeneracy(), "");
  EXPECT_TRUE(form.PR_limit() && form.RP_limit());
  expect_covered(task, "one translation");
}

}  // namespace
}  // namespace burmester::planar
