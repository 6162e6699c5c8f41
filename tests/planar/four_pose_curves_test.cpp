// The curves of four poses: every pair of points meets the poses, nothing is missed, and what other solvers find lies
// on them.
#include "burmester/planar/four_pose_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "burmester/geometry/curve_analysis.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/poles.hpp"
#include "cgal_leaks.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

TEST(FourPoseCurves, PairedPointsMeetThePoses) {
  Random random("FourPoseCurves.PairedPointsMeetThePoses");
  int pairs = 0;
  for (int i = 0; i < 1000; ++i) {
    const FourPoseTask task = random_four_poses(random);
    const FourPoseCurves curves = four_pose_curves(task, {1e-3, 1, 8});
    ASSERT_NE(curves.topology.rung, Rung::none) << i;
    ASSERT_FALSE(curves.pieces.empty()) << i;
    EXPECT_TRUE(curves.complete) << i;
    for (const CurveRecord& piece : curves.pieces) {
      ASSERT_EQ(piece.moving.size(), piece.fixed.size());
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++pairs) {
        const Vector2 m(piece.moving[k][0], piece.moving[k][1]), c(piece.fixed[k][0], piece.fixed[k][1]);
        // Vertices are on the curves to rounding, amplified near double points: in 30,000 sets by 1e4 at most.
        EXPECT_LT(concyclicity(task, m, c), 1e-12) << i;
      }
    }
  }
  EXPECT_GT(pairs, 50000);
}

#ifndef BURMESTER_WITHOUT_GMP
TEST(FourPoseCurves, TheirTopologyIsThatOfTheGeneralAnalysis) {
  Random random("FourPoseCurves.TheirTopologyIsThatOfTheGeneralAnalysis");
  int ovals = 0;
  for (int i = 0; i < 12; ++i) {  // a tenth of a second each
    const FourPoseTask task = random_four_poses(random);
    const ExactCubics cubics(task);
    const CurveTopology fast = four_pose_curves(task, {1, 1, 0.01}).topology;
    const CurveTopology exact = analyse_curve(TernaryForm<Rational>(i % 2 ? cubics.moving() : cubics.fixed()));
    ASSERT_EQ(exact.rung, Rung::exact) << exact.reason;
    EXPECT_EQ(fast.components, exact.components) << i;
    EXPECT_EQ(fast.ovals, exact.ovals) << i;
    EXPECT_EQ(fast.singular.size(), exact.singular.size()) << i;
    ovals += fast.ovals;
  }
  EXPECT_GT(ovals, 1);
  EXPECT_LT(ovals, 12);
}
#endif

TEST(FourPoseCurves, FivePoseDyadsLieOnAllFiveCurves) {
  Random random("FourPoseCurves.FivePoseDyadsLieOnAllFiveCurves");
  int dyads = 0;
  for (int i = 0; i < 200; ++i) {
    std::array<Pose, 5> five;
    for (Pose& p : five) p = Space::random_pose(random);
    const PlanarReport report = FivePoseSolver().solve(five);
    ASSERT_TRUE(report.counts.certified) << i;
    for (std::size_t left_out = 0; left_out < 5; ++left_out) {
      FourPoseTask four;
      for (std::size_t j = 0, k = 0; j < 5; ++j)
        if (j != left_out) four[k++] = five[j];
      const ExactCubics cubics(four);
      const FourPoseCurves curves = four_pose_curves(four);
      for (const auto& found : report.dyads) {
        const auto* rr = std::get_if<RR::Design>(&found.design);
        if (!rr) continue;
        // Off by the proved radius at most; twice that to first order, and the change of frame rounded.
        const double off = 2 * found.certificate.radius / power_of_two_below(task_size(four)) + 16 * unit_roundoff;
        EXPECT_LT(cubics.distance_of_moving(rr->moving), off) << i;
        EXPECT_LT(cubics.distance_of_fixed(rr->fixed), off) << i;
        if (!within_window(rr->moving, rr->fixed, four)) continue;
        ++dyads;
        EXPECT_LT(distance_to_curves(rr->moving, curves.pieces, true), found.certificate.radius) << i;
        EXPECT_LT(distance_to_curves(rr->fixed, curves.pieces, false), found.certificate.radius) << i;
      }
    }
  }
  EXPECT_GT(dyads, 1000);
}

/// The smaller the turns, the farther the poles; the curves go with them, and so does what is looked at. Sliders go
/// farther still, with the square of the turns.
TEST(FourPoseCurves, SmallTurnsAreSeenFromFartherAway) {
  Random random("FourPoseCurves.SmallTurnsAreSeenFromFartherAway");
  for (int decade = 1; decade <= 5; ++decade) {
    int complete = 0, sliders = 0, poles = 0;
    constexpr int sets = 50;
    for (int i = 0; i < sets; ++i) {
      FourPoseTask task;
      for (Pose& p : task) {
        const double x = random.normal(), y = random.normal();
        p = pose_from_radians(x, y, std::pow(10.0, -decade) * random.normal());
      }
      const FourPoseCurves curves = four_pose_curves(task);
      for (const CurveRecord& piece : curves.pieces)
        for (std::size_t k = 0; k < piece.moving.size(); k += 5) {
          const Vector2 m(piece.moving[k][0], piece.moving[k][1]), c(piece.fixed[k][0], piece.fixed[k][1]);
          // Rounding moves a far pivot by more.
          EXPECT_LT(concyclicity(task, m, c), 1e-12 * (1 + m.norm() / task_size(task))) << decade << " " << i;
        }
      complete += curves.complete;
      const double window = CurveOptions().window * power_of_two_below(curve_scale(task)) / curve_scale(task);
      std::array<Correlation<double>, 3> to_body;
      for (std::size_t j = 0; j < 3; ++j)
        to_body[j] = equidistance<double>(task[0], task[j + 1], 1 / curve_scale(task)).transpose();
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = j + 1; k < 4; ++k) {
          const Point2<double> p = relative_pole(task[j], task[k]);
          const Vector2 pole = p.head<2>() / p[2];
          const Vector2 origin(task[0].x, task[0].y), seen = (pole - origin) / curve_scale(task);
          const Point2<double> body = partner(to_body, Point2<double>(seen[0], seen[1], 1));
          const double farthest =
              std::max(body.head<2>().cwiseAbs().maxCoeff() / std::abs(body[2]), seen.cwiseAbs().maxCoeff());
          if (!curves.complete || !(farthest < 0.99 * window)) continue;
          ++poles;
          EXPECT_LT(distance_to_curves(pole, curves.pieces, false), 1e-10 * curve_scale(task))
              << decade << " " << i << " " << j << k;
        }

      const PlanarReport report = FourPoseSolver().solve(task);
      for (const auto& found : report.dyads) {
        const auto* pr = std::get_if<PR::Design>(&found.design);
        const Vector2 pivot = pr ? pr->moving : std::get<RP::Design>(found.design).fixed;
        EXPECT_LT(found.residual, 1e-14 * (10 + pivot.norm())) << decade << " " << i;
      }
      const auto told = std::ranges::count_if(report.warnings, [](const std::string& warning) {
        return warning.find("dyad is listed: its pivot is") != std::string::npos;
      });
      EXPECT_EQ(static_cast<int>(report.dyads.size() + static_cast<std::size_t>(told)), 2) << decade << " " << i;
      sliders += static_cast<int>(report.dyads.size());
    }
    // Measured with this stream: 50 complete at each decade, 227 to 240 poles, 100 sliders (16 at the last).
    EXPECT_GT(complete, 0.9 * sets) << decade;
    EXPECT_GT(poles, 4 * complete) << decade;
    EXPECT_GE(sliders, decade < 4 ? 2 * sets : decade == 4 ? 2 * sets - 2 : 12) << decade;
  }
}

TEST(FourPoseCurves, SlidersMeetThePosesAndSwapUnderInversion) {
  Random random("FourPoseCurves.SlidersMeetThePosesAndSwapUnderInversion");
  for (int i = 0; i < 200; ++i) {
    const FourPoseTask task = random_four_poses(random);
    FourPoseTask inverse;
    for (std::size_t j = 0; j < 4; ++j)
      inverse[j] = Space::pose(Space::conjugate<double>(Space::point<double>(task[j])));
    const PlanarReport report = FourPoseSolver().solve(task), turned = FourPoseSolver().solve(inverse);
    ASSERT_EQ(report.dyads.size(), 2u) << i;
    ASSERT_EQ(turned.dyads.size(), 2u) << i;
    const auto& pr = std::get<PR::Design>(report.dyads[0].design);
    const auto& rp = std::get<RP::Design>(report.dyads[1].design);
    for (const auto& found : report.dyads)
      EXPECT_LT(found.residual, 1e-9 * (1 + pr.moving.norm() + rp.fixed.norm())) << i;
    const auto& turned_rp = std::get<RP::Design>(turned.dyads[1].design);
    EXPECT_LT((turned_rp.fixed - pr.moving).norm(), 1e-7 * (1 + pr.moving.norm())) << i;
  }
}

/// Two sets of four positions, computed by the dyad form (compatibility linkage, position analysis) in 15 digits: pairs
/// of circle and centre point, the six poles, the sliders. Where the compatibility linkage turns fully its two modes
/// are the two components of the curve.
struct Published {
  std::array<std::array<double, 3>, 4> poses;
  int components;
  std::vector<std::array<double, 4>> pairs;
  std::vector<std::array<double, 2>> poles;
  std::array<double, 3> PR, RP;  ///< pivot and direction of the line in degrees
};

TEST(FourPoseCurves, AgreeWithTheDyadForm) {
  const Published sets[] = {{{{{0, 0, 0}, {-2.7, 0.5, -55}, {3.9, -0.9, 75}, {1.3, -2, 50}}},
                             2,
                             {{-0.4419843584457464, 2.5382204160716286, 0.17853593789558442, 0.7860976992043189},
                              {2.5101974924631394, 1.6403843660273563, 9.863848551604063, -8.703725882451646},
                              {0.6329112568989839, 2.255364118409023, 0.7716390632322574, 0.9637904477096992}},
                             {{-0.8697544682572086, 2.843325871411074},
                              {2.5364514177785424, 2.0912894770403514},
                              {2.7945069205095585, 0.3939294983312131},
                              {0.9264153607084991, 1.3388152719114954},
                              {0.25915873497370046, 0.7846539759579206},
                              {0.11911032298586857, 4.413921054760674}},
                             {2.5556155220862196, 1.353002973339223, 38.986923810045504},
                             {-0.4154912580278662, 4.555738417056104, 12.642958581391746}},
                            {{{{0, 0, 0}, {1.5, 0.8, 20}, {3.2, 0.9, 50}, {4, -0.6, 85}}},
                             1,
                             {{2.237594863249881, 2.2224406285983154, -2.8957352921341264, 5.235553666125028},
                              {2.821743589528946, 2.7599265009322216, 1.8731285370836521, 3.8347962570515306},
                              {1.2069279544638651, 1.8962591170836363, 2.3551981603525847, 1.9074802131823707},
                              {3.13627327655793, 2.9438178073211696, 2.135452849607466, 3.9981394914475996}},
                             {{-1.5185127278470838, 4.653461364713282},
                              {0.6349718857706986, 3.8812110728152938},
                              {2.3273925503207815, 1.8826170021385429},
                              {2.163397459621556, 4.0222431864335455},
                              {3.8487799039822432, 2.062106971396863},
                              {5.978696101772409, 1.418637920945285}},
                             {-1.4615035892119252, -4.1506159021961295, 10.37100280777032},
                             {5.115332877588492, 9.895472558467297, 180 - 61.68449443033245}}};
  for (const Published& set : sets) {
    const FourPoseTask task = four_poses(set.poses);
    const PlanarReport report = FourPoseSolver().solve(task);
    EXPECT_EQ(four_pose_curves(task).topology.components, set.components);
    for (const auto& [mx, my, cx, cy] : set.pairs) {
      EXPECT_LT(distance_to_curves({mx, my}, report.curves, true), 1e-12);
      EXPECT_LT(distance_to_curves({cx, cy}, report.curves, false), 1e-12);
    }
    for (const auto& [x, y] : set.poles)
      EXPECT_LT(distance_to_curves({x, y}, report.curves, false), 1e-12) << x << " " << y;
    ASSERT_EQ(report.dyads.size(), 2u);
    const auto& pr = std::get<PR::Design>(report.dyads[0].design);
    const auto& rp = std::get<RP::Design>(report.dyads[1].design);
    EXPECT_LT((pr.moving - Vector2(set.PR[0], set.PR[1])).norm(), 1e-12);
    EXPECT_LT((rp.fixed - Vector2(set.RP[0], set.RP[1])).norm(), 1e-12);
    EXPECT_NEAR(pr.line.record().angle * 180 / std::numbers::pi, set.PR[2], 1e-11);
    EXPECT_NEAR(rp.line.record().angle * 180 / std::numbers::pi, set.RP[2], 1e-11);
  }
}

TEST(FourPoseCurves, DegeneratePosesAreNamed) {
  const std::pair<const char*, std::array<std::array<double, 3>, 4>> cases[] = {
      {"poses 2 and 3 are equal: in effect 3 poses", {{{0, 0, 0}, {2, 1, 40}, {2, 1, 40}, {-1, 3, 100}}}},
      {"poses 1 and 2 are equal: in effect 3 poses", {{{0, 0, 0}, {0, 0, 0}, {2, 1, 40}, {-1, 3, 100}}}},
      {"all four poses are parallel", {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}}}},
      {"all four poses are rotations about one point", {{{0, 0, 0}, {0, 0, 30}, {0, 0, 60}, {0, 0, 90}}}}};
  for (const auto& [words, poses] : cases) {
    const PlanarReport report = FourPoseSolver().solve(four_poses(poses));
    EXPECT_EQ(report.status, Status::degenerate) << words;
    EXPECT_NE(report.message.find(words), std::string::npos) << report.message;
    EXPECT_TRUE(report.curves.empty() && report.dyads.empty()) << words;
  }
}

/// Sets with a special position of the poles that still have curves: what splits off, and that the pairs meet the
/// poses.
TEST(FourPoseCurves, SpecialPosesAreStillAFamily) {
  struct Case {
    const char* name;
    std::array<std::array<double, 3>, 4> poses;
    std::size_t lines, conics, sliders;
    int far = 0;  ///< components whose partners are at infinity
  };
  const Case cases[] = {{"one translation", {{{0, 0, 0}, {2, 0, 0}, {2, 1, 40}, {-1, 3, 100}}}, 0, 0, 2},
                        {"three parallel", {{{0, 0, 0}, {2, 0, 0}, {2, 1, 40}, {-1, 3, 0}}}, 1, 1, 0, 1},
                        {"coincident poles", {{{0, 0, 0}, {0, 0, 30}, {0, 0, 80}, {3, 1, -50}}}, 1, 1, 2},
                        {"mirror images in pairs", {{{-1, 0, -30}, {1, 0, 30}, {-3, 2, -70}, {3, 2, 70}}}, 1, 1, 2},
                        {"coincident poles, a half turn", {{{0, 0, 0}, {0, 0, 90}, {0, 0, 180}, {1, 0, 0}}}, 1, 1, 2},
                        {"a rectangle", {{{0, 0, 0}, {1, 0, 0}, {0, 0, 180}, {1, 0, 180}}}, 3, 0, 0},
                        {"two orientations", {{{0, 0, 0}, {1, 2, 0}, {3, 1, 50}, {-2, 2, 50}}}, 1, 1, 0}};
  for (const Case& c : cases) {
    const FourPoseTask task = four_poses(c.poses);
    const PlanarReport report = FourPoseSolver().solve(task);
    EXPECT_EQ(report.status, Status::family) << c.name << ": " << report.message;
    const FourPoseCurves curves = four_pose_curves(task);
    const CurveTopology& topology = curves.topology;
    EXPECT_EQ(topology.lines.size(), c.lines) << c.name;
    EXPECT_EQ(topology.conics.size(), c.conics) << c.name;
    EXPECT_EQ(report.dyads.size(), c.sliders) << c.name;
    std::size_t pairs = 0;
    std::set<int> components;
    for (const CurveRecord& piece : report.curves) {
      components.insert(piece.component);
      for (std::size_t k = 0; k < piece.moving.size(); ++k, ++pairs)
        EXPECT_LT(concyclicity(task, {piece.moving[k][0], piece.moving[k][1]}, {piece.fixed[k][0], piece.fixed[k][1]}),
                  1e-12)
            << c.name << " " << piece.moving[k][0] << " " << piece.moving[k][1];
    }
    EXPECT_GT(pairs, 20u) << c.name;
    EXPECT_LT(pairs, 5000u) << c.name;
    const int points = topology.isolated - (topology.isolated > 0 ? curves.lines_of_partners : 0);
    EXPECT_EQ(static_cast<int>(components.size()) + points + c.far, topology.components) << c.name;
    EXPECT_EQ(points > 0, std::ranges::any_of(report.warnings,
                                              [](const std::string& warning) {
                                                return warning.find("is a single point and is not listed") !=
                                                       std::string::npos;
                                              }))
        << c.name;
  }
}

}  // namespace
}  // namespace burmester::planar
