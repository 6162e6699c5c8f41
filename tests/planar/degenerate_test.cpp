// Degenerate poses by name: the verdict of the five-pose solver, and that it invents no dyad.
#include "burmester/planar/degeneracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Pose at(double x, double y, double degrees) { return pose_from_degrees(x, y, degrees); }
PlanarReport solve(const FivePoseTask& task) { return FivePoseSolver().solve(task); }

std::string types(const PlanarReport& report) {
  std::string out;
  for (const auto& found : report.dyads)
    out += Dyads::visit(found.design,
                        []<class D>(const typename D::Design&) { return std::string(D::name) + ' '; });
  return out;
}

struct Expected {
  std::string_view name;
  Status status;
  std::optional<int> dimension;
  std::string message;  ///< part of it
  std::string dyads;
};

const std::vector<Expected> all_expected{
    {"equal_poses", Status::degenerate, std::nullopt, "poses 2 and 4 are equal: in effect 4 poses", ""},
    {"all_parallel", Status::exact, 0, "the double slider PP is the only dyad", "PP "},
    {"circular_translation", Status::degenerate, 2, "a translation along a circle or a straight line", "PP "},
    {"straight_translation", Status::degenerate, 2, "a translation along a circle or a straight line", "PP "},
    {"rotation_about_point", Status::degenerate, 2, "rotations about one point", ""},
    {"four_parallel", Status::none, std::nullopt, "four of the five orientations are equal", ""},
    {"cardan_motion", Status::degenerate, 1, "a one-parameter family of PR dyads", "RR "},
    {"oldham_motion", Status::degenerate, 1, "a one-parameter family of RP dyads", "RR "}};

class Degenerate : public ::testing::TestWithParam<Expected> {};

TEST_P(Degenerate, IsNamed) {
  const Expected& e = GetParam();
  const std::string stream = "Degenerate.IsNamed." + std::string(e.name);
  Random random(stream);
  for (int i = 0; i < 200; ++i) {
    const PlanarReport report = solve(find_task_class(e.name)->make(random));
    EXPECT_EQ(report.status, e.status) << stream << ", task " << i << ": " << report.message;
    EXPECT_EQ(report.counts.dimension, e.dimension) << stream << ", task " << i;
    EXPECT_THAT(report.message, HasSubstr(e.message)) << stream << ", task " << i;
    EXPECT_EQ(types(report), e.dyads) << stream << ", task " << i;
    EXPECT_TRUE(report.warnings.empty()) << stream << ", task " << i << ": " << report.warnings.front();
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, Degenerate, ::testing::ValuesIn(all_expected),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DegenerateClasses, AreAllExpectedSomewhere) {
  for (const TaskClass& c : degenerate_task_classes()) {
    const auto named = [&](const Expected& e) { return e.name == c.name; };
    EXPECT_TRUE(c.name == "two_orientations" || std::any_of(all_expected.begin(), all_expected.end(), named))
        << c.name;
  }
}

// ---- Two orientations, 3 + 2: the radius is that of the circle through the three parallel origins ----

struct Triple {
  double radius, apart;  ///< circumradius of origins 0, 1, 3; distance of origins 2 and 4
};
Triple triple_of(const FivePoseTask& t) {
  const Vector2 a(t[1].x - t[0].x, t[1].y - t[0].y), b(t[3].x - t[0].x, t[3].y - t[0].y);
  const double twice_area = std::abs(a[0] * b[1] - a[1] * b[0]);
  return {a.norm() * b.norm() * (a - b).norm() / (2 * twice_area),
          std::hypot(t[4].x - t[2].x, t[4].y - t[2].y)};
}

TEST(TwoOrientations, RemainingDyadsHaveTheRadiusOfTheTriple) {
  Random random("TwoOrientations.RemainingDyadsHaveTheRadiusOfTheTriple");
  int real = 0;
  for (int i = 0; i < 1000; ++i) {
    FivePoseTask task = find_task_class("two_orientations")->make(random);
    const double three = random.uniform(-3, 3), two = random.uniform(-3, 3);
    for (std::size_t j = 0; j < 5; ++j)
      task[j] = pose_from_radians(task[j].x, task[j].y, j == 2 || j == 4 ? two : three);
    const Triple triple = triple_of(task);
    const PlanarReport report = solve(task);
    const bool reachable = triple.apart < 2 * triple.radius;
    ASSERT_EQ(types(report), reachable ? "RR RR " : "") << "task " << i << ": " << report.message;
    EXPECT_EQ(report.status, reachable ? Status::exact : Status::none) << "task " << i;
    EXPECT_EQ(report.counts.complex, 2) << "task " << i;
    for (const auto& found : report.dyads) {
      const double length = std::get<RR::Design>(found.design).length;
      EXPECT_NEAR(length / triple.radius, 1, 1e-7) << "task " << i;
      EXPECT_LT(found.residual, 1e-9 * std::max(length, task_size(task))) << "task " << i;
    }
    real += reachable;
  }
  EXPECT_TRUE(100 < real && real < 900);
}

TEST(TwoOrientations, NoFiniteDyadWhereTheTripleIsInLine) {
  Random random("TwoOrientations.NoFiniteDyadWhereTheTripleIsInLine");
  for (int i = 0; i < 200; ++i) {
    FivePoseTask task = find_task_class("two_orientations")->make(random);
    const double along = random.normal();
    task[3].x = task[0].x + along * (task[1].x - task[0].x),
    task[3].y = task[0].y + along * (task[1].y - task[0].y);
    const PlanarReport report = solve(task);
    EXPECT_EQ(report.status, Status::none) << "task " << i << ": " << report.message;
    EXPECT_EQ(types(report), "") << "task " << i;
    EXPECT_THAT(report.message, HasSubstr("the three parallel ones lie on a line")) << "task " << i;
  }
}

TEST(TwoOrientations, AFamilyOfSlidersWhereBothLinesAreParallel) {
  const PlanarReport report = solve({at(0, 0, 20), at(1, 1, 20), at(3, 3, 20), at(0, 2, 50), at(2, 4, 50)});
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_THAT(report.message, HasSubstr("a one-parameter family of PR dyads"));
  EXPECT_EQ(types(report), "");
}

TEST(TwoOrientations, SharedOrigins) {
  const PlanarReport report = solve({at(0, 0, 20), at(1, 3, 20), at(3, -2, 20), at(0, 0, 50), at(1, 3, 50)});
  EXPECT_EQ(types(report), "RR RR ");
  for (const auto& found : report.dyads) EXPECT_LT(found.residual, 1e-13);
}

// ---- The isolated dyad of the Cardan motion ----

RR::Design only_RR(const PlanarReport& report) {
  EXPECT_EQ(types(report), "RR ") << report.message;
  return report.dyads.size() == 1 ? std::get<RR::Design>(report.dyads[0].design) : RR::Design{};
}

TEST(CardanMotion, MiddleOfTheMovingSegmentIsIsolated) {
  Random random("CardanMotion.MiddleOfTheMovingSegmentIsIsolated");
  for (int i = 0; i < 200; ++i) {
    const RR::Design d = only_RR(solve(find_task_class("cardan_motion")->make(random)));
    // Five random places on the ellipse may lie close together: 1e-16 times a condition up to 1e8.
    EXPECT_LT(d.fixed.norm(), 1e-8) << "task " << i;
    EXPECT_LT((d.moving - Vector2(1, 0)).norm(), 1e-8) << "task " << i;
    EXPECT_NEAR(d.length, 1, 1e-8) << "task " << i;
  }
}

TEST(OldhamMotion, InverseOfTheIsolatedDyad) {
  Random random("OldhamMotion.InverseOfTheIsolatedDyad");
  for (int i = 0; i < 200; ++i) {
    const RR::Design d = only_RR(solve(find_task_class("oldham_motion")->make(random)));
    EXPECT_LT((d.fixed - Vector2(1, 0)).norm(), 1e-8) << "task " << i;
    EXPECT_LT(d.moving.norm(), 1e-8) << "task " << i;
    EXPECT_NEAR(d.length, 1, 1e-8) << "task " << i;
  }
}

TEST(CardanMotion, OfAnySizeAtAnyPlaceInAnyNorm) {
  constexpr double degree = std::numbers::pi / 180;
  for (const double size : {1e-3, 1.0, 1e3})
    for (const double shift : {0.0, 1e4})
      for (const double factor : {1.0, 2.0, -1.0}) {
        FivePoseTask task;
        for (int j = 0; j < 5; ++j) {
          const double angle = (10 + 62 * j) * degree;
          task[j] = pose_from_radians(size * (shift - 2 * std::cos(angle)), size * shift, angle);
          if (j < 3) task[j].X3 *= factor, task[j].X4 *= factor;
        }
        const PlanarReport report = solve(task);
        EXPECT_EQ(report.status, Status::degenerate) << size << ' ' << shift << ' ' << factor;
        EXPECT_THAT(report.message, StartsWith("a one-parameter family of PR dyads"));
        const RR::Design d = only_RR(report);
        const double rounding = 1e-13 * (1 + shift);
        EXPECT_LT((d.fixed / size - Vector2(shift, shift)).norm(), rounding)
            << size << ' ' << shift << ' ' << factor;
        EXPECT_LT((d.moving / size - Vector2(1, 0)).norm(), rounding)
            << size << ' ' << shift << ' ' << factor;
      }
}

// ---- Equal poses ----

void expect_equal(const FivePoseTask& task, const std::string& message) {
  const PlanarReport report = solve(task);
  EXPECT_EQ(report.status, Status::degenerate) << message;
  EXPECT_THAT(report.message, StartsWith(message));
  EXPECT_EQ(types(report), "");
  EXPECT_EQ(report.counts.real, std::nullopt);
}

TEST(EqualPoses, AreNamed) {
  const Pose a = at(0, 0, 0), b = at(1, 2, 30), c = at(3, 1, 70);
  expect_equal({a, b, a, a, c},
               "poses 1 and 3 and 4 are equal: in effect 3 poses, in general met by a two-dimensional");
  expect_equal({a, b, a, b, c},
               "poses 1 and 3, 2 and 4 are equal: in effect 3 poses, in general met by a two");
  expect_equal({a, b, a, b, a},
               "poses 1 and 3 and 5, 2 and 4 are equal: in effect 2 poses, in general met by a three");
  expect_equal({b, b, b, b, b},
               "poses 1 and 2 and 3 and 4 and 5 are equal: in effect 1 pose, met by every dyad");
}

TEST(EqualPoses, WithWholeTurnsAndOtherNormsBetween) {
  const Pose a = at(1, 2, 30);
  for (const Pose& same :
       {at(1, 2, 390), at(1, 2, -330), Pose{1, 2, 2 * a.X3, 2 * a.X4}, Pose{1, 2, -a.X3, -a.X4}})
    expect_equal({a, at(0, 1, 110), same, at(3, 1, 70), at(-1, 0, 10)},
                 "poses 1 and 3 are equal: in effect 4 poses");
}

TEST(EqualPoses, AmongParallelOnes) {
  expect_equal({at(0, 0, 20), at(1, 3, 20), at(0, 0, 20), at(3, 1, 20), at(-1, 4, 20)},
               "poses 1 and 3 are equal: in effect 4 poses");
}

// ---- Other mixtures ----

TEST(RotationAboutAPoint, ThatIsTheOriginOfBothFrames) {
  for (const double x : {0.0, 5.0}) {
    const PlanarReport report =
        solve({at(x, 0, 0), at(x, 0, 30), at(x, 0, 50), at(x, 0, 130), at(x, 0, -30)});
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_THAT(report.message, HasSubstr("rotations about one point"));
    EXPECT_EQ(types(report), "");
  }
}

TEST(FourParallel, InfinitelyManyDyadsWhereTheirOriginsLieOnACircleOrLine) {
  const FivePoseTask circle{at(1, 0, 20), at(0, 1, 20), at(-1, 0, 20), at(0, -1, 20), at(2, 5, 50)};
  const FivePoseTask line{at(1, 0.5, 20), at(2, 1, 20), at(3, 1.5, 20), at(-4, -2, 20), at(2, 5, 50)};
  for (const FivePoseTask& task : {circle, line}) {
    const PlanarReport report = solve(task);
    EXPECT_EQ(report.status, Status::degenerate);
    EXPECT_THAT(report.message, HasSubstr("fewer than four independent conditions"));
    EXPECT_EQ(types(report), "");
  }
}

TEST(FewParallel, AreHarmless) {
  const FivePoseTask two_pairs{at(0, 0, 20), at(1, 3, 20), at(3, -2, 50), at(0, 4, 50), at(2, 5, 90)};
  const FivePoseTask triple{at(0, 0, 20), at(1, 3, 20), at(3, -2, 20), at(0, 4, 50), at(2, 5, 90)};
  for (const FivePoseTask& task : {two_pairs, triple}) {
    const PlanarReport report = solve(task);
    EXPECT_EQ(types(report), "RR RR ");
    for (const auto& found : report.dyads) EXPECT_LT(found.residual, 1e-13);
  }
}

TEST(FourRotationsAboutAPoint, LeaveInfinitelyManyDyads) {
  const PlanarReport report = solve({at(0, 0, 20), at(0, 0, 40), at(0, 0, 70), at(0, 0, 150), at(2, 5, 90)});
  EXPECT_EQ(report.status, Status::degenerate);
  EXPECT_EQ(types(report), "");
}

// A parallel pose short of equal: the fourth orientation decides.
TEST(NearlyDegenerate, IsNotDegenerate) {
  const PlanarReport report =
      solve({at(0, 0, 20), at(1, 3, 20), at(3, -2, 20), at(0, 4, 20 + 1e-6), at(2, 5, 50)});
  EXPECT_TRUE(report.status == Status::exact || report.status == Status::none) << report.message;
  EXPECT_EQ(report.counts.complex, 4) << report.message;
}

TEST(Verdict, CountsAndStatus) {
  const FivePoseTask task{at(0, 0, 0), at(1, 2, 30), at(3, 1, 70), at(1, 1, 100), at(2, -1, 15)};
  EXPECT_EQ(verdict(FivePoseCase::regular, task, 0, "").status, Status::none);
  EXPECT_EQ(verdict(FivePoseCase::regular, task, 2, "").status, Status::exact);
  EXPECT_EQ(verdict(FivePoseCase::regular, task, 2, "").counts.complex, 4);
  EXPECT_EQ(verdict(FivePoseCase::two_orientations, task, 2, "").counts.complex, 2);
  EXPECT_THAT(verdict(FivePoseCase::regular, task, 1, "").message, StartsWith("1 real dyad of 4"));
  EXPECT_THAT(verdict(FivePoseCase::common_line, task, 0, "PR").message, HasSubstr("family of PR dyads"));
  EXPECT_THAT(verdict(FivePoseCase::common_line, task, 0, "RR").message, HasSubstr("family of RR dyads"));
  EXPECT_EQ(verdict(FivePoseCase::whole_conic, task, 0, "").counts.dimension, 1);
  EXPECT_EQ(verdict(FivePoseCase::common_vertex, task, 1, "").status, Status::degenerate);
  EXPECT_EQ(verdict(FivePoseCase::common_vertex, task, 1, "").counts.real, std::nullopt);
}

}  // namespace
}  // namespace burmester::planar
