// Degenerate poses proved: exact tasks of every kind with a proof that an independent rational computation confirms,
// and rounded ones that claim none.
#include "burmester/planar/exact_degeneracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burmester/planar/five_pose_solver.hpp"
#include "exact_five_pose.hpp"
#include "integer_tasks.hpp"

namespace burmester::planar {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// Integer poses with given origins and one orientation per letter of `turns`.
FivePoseTask with_turns(const std::string& turns, const std::array<std::array<double, 2>, 5>& origins) {
  FivePoseTask task;
  for (std::size_t j = 0; j < 5; ++j) {
    const double multiple = static_cast<double>(j + 1) * (j % 2 ? -1 : 1);  // of one orientation in many ways
    const double s = turns[j] == 'a' ? 1 : -2, c = turns[j] == 'a' ? 2 : 3;
    task[j] = {origins[j][0], origins[j][1], multiple * s, multiple * c};
  }
  return task;
}

constexpr std::array<std::array<double, 2>, 5> on_circle{{{5, 0}, {3, 4}, {-3, 4}, {0, -5}, {4, 3}}};
constexpr std::array<std::array<double, 2>, 5> on_line{{{0, 1}, {3, 3}, {-3, -1}, {6, 5}, {9, 7}}};
constexpr std::array<std::array<double, 2>, 5> anywhere{{{0, 0}, {1, 3}, {3, -2}, {0, 4}, {2, 5}}};
constexpr std::array<std::array<double, 2>, 5> triple_in_line{{{0, 0}, {1, 3}, {2, 6}, {0, 4}, {2, 5}}};

/// Integer turns about (3, -2); the point of the body that stays is a common multiple of the norms.
FivePoseTask rotations(int how_many) {
  Random random("ExactDegeneracy.rotations");
  FivePoseTask task;
  const Rational multiple = detail::random_turns(random, task);
  for (int j = 0; j < 5; ++j) task[static_cast<std::size_t>(j)].X3 = j - 2;  // five different ones
  Rational norms = 1;
  for (Pose& p : task) p.X4 = 1, norms *= Rational(p.X3 * p.X3 + 1);
  const Place moving = multiple * norms * Place{Rational(1), Rational(2)};
  for (int j = 0; j < how_many; ++j) {
    Pose& p = task[static_cast<std::size_t>(j)];
    detail::put(p, Place{Rational(3), Rational(-2)} - times(rotation(p), moving));
  }
  for (int j = how_many; j < 5; ++j) task[static_cast<std::size_t>(j)].x = 1000;
  return task;
}

/// The Cardan motion with rational cosines: two points of E on two fixed lines, scaled to integers.
FivePoseTask cardan() {
  FivePoseTask task;
  double size = 1;
  for (int j = 0; j < 5; ++j) size *= (j + 1) * (j + 1) + 4;
  for (int j = 0; j < 5; ++j) {
    const double s = j + 1, c = 2;
    task[static_cast<std::size_t>(j)] = {-size / (s * s + c * c) * (c * c - s * s), 0, s, c};
  }
  return task;
}

Pose inverse(const Pose& p) {
  const Pose back{0, 0, -p.X3, p.X4};
  const Place origin_of_S = -times(rotation(back), origin(p));
  Pose out = back;
  detail::put(out, origin_of_S);
  return out;
}

FivePoseTask oldham() {
  FivePoseTask task = cardan();
  double norms = 1;
  for (const Pose& p : task) norms *= p.X3 * p.X3 + p.X4 * p.X4;
  for (Pose& p : task) p.x *= norms, p = inverse(p);
  return task;
}

struct Named {
  const char* name;
  FivePoseTask task;
  const char* message;
  std::size_t dimension;  ///< of the null space of the 5 x 8 system
};

const std::vector<Named>& exact_tasks() {
  static const std::vector<Named> tasks{
      {"equal", with_turns("aabab", {{{0, 0}, {1, 3}, {3, -2}, {1, 3}, {2, 5}}}),
       "poses 2 and 4 are equal: in effect 4", 4},
      {"parallel", with_turns("aaaaa", anywhere), "the double slider PP is the only dyad", 4},
      {"on_a_circle", with_turns("aaaaa", on_circle), "a translation along a circle", 5},
      {"on_a_line", with_turns("aaaaa", on_line), "a translation along a circle or a straight line", 5},
      {"four_parallel", with_turns("aabaa", anywhere), "four of the five orientations are equal", 3},
      {"triple_in_line", with_turns("aaabb", triple_in_line), "the three parallel ones lie on a line", 3},
      {"rotation", rotations(5), "rotations about one point", 5},
      {"four_rotations", rotations(4), "fewer than four independent conditions", 4},
      {"four_on_a_circle", with_turns("aaaab", on_circle), "fewer than four independent conditions", 4},
      {"cardan", cardan(), "a one-parameter family of PR dyads", 3},
      {"oldham", oldham(), "a one-parameter family of RP dyads", 3},
      {"family_of_RR",
       {Pose{0, -1, 1, 1}, {1, 0, -1, 1}, {0, 1, -1, 1}, {0, -1, 1, 0}, {1, 0, 1, 0}},
       "a one-parameter family of RR dyads; besides it 1 isolated dyad",
       3},
      {"lines_in_one_point",
       {Pose{1, 1, 1, 0}, {0, 1, -1, 1}, {0, -1, -1, 1}, {1, 0, -1, 0}, {1, -1, -1, 0}},
       "a one-parameter family of PR dyads",
       3},
      {"one_conic",
       {Pose{0, 0, 1, 1}, {-1, 0, 0, 1}, {0, -1, 1, 1}, {0, 0, -1, 0}, {-1, 0, 1, 1}},
       "a one-parameter family of dyads",
       3}};
  return tasks;
}

class ExactDegeneracyOf : public ::testing::TestWithParam<Named> {};

TEST_P(ExactDegeneracyOf, IsProved) {
  const Named& e = GetParam();
  const PlanarReport report = FivePoseSolver().solve(e.task);
  EXPECT_THAT(report.message, HasSubstr(e.message));
  EXPECT_THAT(report.message, EndsWith(", proved"));
  EXPECT_TRUE(report.counts.certified);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_FALSE(FivePoseSolver{.certify = false}.solve(e.task).counts.certified);
}

/// The absolute system, its resultant, and Sturm's theorem know nothing of the proof.
TEST_P(ExactDegeneracyOf, IsConfirmed) {
  const Named& e = GetParam();
  Random coordinates(std::string("ExactDegeneracyOf.IsConfirmed.") + e.name);
  const exact::Solutions truth = exact::count_solutions(e.task, coordinates);
  EXPECT_EQ(truth.dimension, e.dimension);
  if (truth.dimension > 3) return;
  const std::string message = e.message;
  const bool none = FivePoseSolver().solve(e.task).status == Status::none;
  EXPECT_EQ(truth.finite, none && message.find("lie on a line") != message.npos) << "four parallel: one double conic";
  if (truth.finite) {
    EXPECT_EQ(truth.real.distinct, 1) << "the pair of orientations";
  }
}

/// What is listed beside the degeneracy satisfies the exact equations.
TEST_P(ExactDegeneracyOf, ListsExactDyads) {
  const Named& e = GetParam();
  const FivePoseRoots<double> roots = five_pose_roots(e.task);
  const auto proof = exact_degeneracy(roots.what, e.task, roots.anchor);
  ASSERT_TRUE(proof);
  for (const Anchored<Rational>& w : proof->isolated) {
    EXPECT_EQ((anchored_rows<Rational>(e.task, roots.anchor) * w), (Vector<Rational, 4>::Zero()));
    EXPECT_EQ(anchored_relations<Rational>(w, Rational(roots.anchor.turn)), (std::array<Rational, 2>{}));
  }
  const PlanarReport report = FivePoseSolver().solve(e.task);
  for (const auto& found : report.dyads) {
    EXPECT_TRUE(found.certificate.certified);
    EXPECT_LT(found.certificate.radius, 1e-9 * task_size(e.task));
    EXPECT_LT(found.residual, 1e-9 * task_size(e.task));
  }
}

/// One datum changed in its last place: the verdict may stand, the proof may not, unless the poses still are such.
TEST_P(ExactDegeneracyOf, IsNotClaimedOfRoundedPoses) {
  const Named& e = GetParam();
  Random random(std::string("ExactDegeneracyOf.IsNotClaimedOfRoundedPoses.") + e.name);
  for (int i = 0; i < 10; ++i) {
    FivePoseTask task = e.task;
    for (Pose& p : task) {
      const double up = 1 + 0x1p-52 * random.below(3), down = 1 - 0x1p-52 * random.below(3);
      p = {p.x * up + 0x1p-50 * random.below(3), p.y * down + 0x1p-50 * random.below(3), p.X3 * down, p.X4 * up};
    }
    const PlanarReport report = FivePoseSolver().solve(task);
    Random coordinates("ExactDegeneracyOf.IsNotClaimedOfRoundedPoses.coordinates");
    const exact::Solutions truth = exact::count_solutions(task, coordinates);
    const bool regular = truth.dimension == 3 && truth.finite && truth.real.distinct == truth.real.counted;
    if (!regular) continue;
    if (report.status == Status::degenerate) {
      EXPECT_FALSE(report.counts.certified) << report.message;
    }
    if (report.message.find("the doubles given have") != std::string::npos) {
      EXPECT_THAT(report.message, HasSubstr("the doubles given have " + std::to_string(truth.real.distinct) + " real"));
    }
    EXPECT_FALSE(report.message.ends_with(", proved") && report.status != Status::none) << report.message;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExactDegeneracyOf, ::testing::ValuesIn(exact_tasks()),
                         [](const auto& test) { return std::string(test.param.name); });

// ---- Two orientations ----

TEST(ExactTwoOrientations, AreCountedByTheCircleThroughTheTriple) {
  Random random("ExactTwoOrientations.AreCountedByTheCircleThroughTheTriple");
  int with[3] = {0, 0, 0};
  for (int i = 0; i < 300; ++i) {
    std::array<std::array<double, 2>, 5> origins;
    for (auto& p : origins) p = {random.below(9) - 4.0, random.below(9) - 4.0};
    const FivePoseTask task = with_turns("abaab", origins);
    if (five_pose_roots(task).what != FivePoseCase::two_orientations) continue;
    const PlanarReport report = FivePoseSolver().solve(task);
    Random coordinates("ExactTwoOrientations.coordinates");
    const exact::Solutions truth = exact::count_solutions(task, coordinates);
    ASSERT_TRUE(truth.finite) << i;
    const int count = count_of_two_orientations(task);
    EXPECT_EQ(report.counts.certified, count >= 0) << i << ": " << report.message;
    if (count < 0) {
      EXPECT_EQ(truth.real.distinct, 2) << i << ": the pair of orientations, and one double dyad";
    } else {
      EXPECT_EQ(truth.real.distinct, count + 1) << i;
      EXPECT_EQ(report.counts.real, count) << i;
    }
    ++with[std::max(count, 0) / 2 + (count < 0 ? 2 : 0)];
  }
  EXPECT_GT(with[0], 20);
  EXPECT_GT(with[1], 20);
}

/// The fourth orientation equal up to a few units in the last place: told by the pencil,
/// which is |u|^2 times a constant.
TEST(NearlyFourParallel, IsNotCalledAFamily) {
  for (const double degrees : {1e-13, 1e-12}) {
    const PlanarReport report = FivePoseSolver().solve(FivePoseTask{
        pose_from_degrees(0, 0, 20), pose_from_degrees(1, 3, 20), pose_from_degrees(3, -2, 20),
        pose_from_degrees(0, 4, 20 + degrees), pose_from_degrees(2, 5, 50)});
    EXPECT_THAT(report.message, Not(HasSubstr("family"))) << degrees;
    EXPECT_FALSE(report.status == Status::degenerate) << report.message;
  }
}

}  // namespace
}  // namespace burmester::planar
