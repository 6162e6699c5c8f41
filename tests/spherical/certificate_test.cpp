// The proof that a list of dyads for five orientations is complete: which arithmetic decides, against another
// elimination, against 100 digits, for wrong lists and double dyads.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <numbers>
#include <thread>

#include "burmester/spherical/five_pose_oracle.hpp"
#include "burmester/spherical/tasks.hpp"
#include "certified_axes.hpp"
#include "rounding_mode.hpp"

namespace burmester::spherical {
namespace {

using ::testing::Each;
using ::testing::Field;

FivePoseTask task_of(const char* name, Random& random) { return find_task_class(name)->make(random); }

// ---- Rungs ----

TEST(SphericalCertificate, IntervalsDecideGenericTasks) {
  Random random("SphericalCertificate.IntervalsDecideGenericTasks");
  const FivePoseTask task = task_of("generic", random);
  const CertifiedAxes proved = certified_axes(task, found_in(task));
  EXPECT_EQ(proved.count_rung, Rung::intervals);
  EXPECT_TRUE(proved.complete);
  EXPECT_THAT(boxes(proved), Each(Field(&AxesBox::rung, Rung::intervals)));
}

TEST(SphericalCertificate, RationalsDecideNearlyCoaxialTasks) {
  Random random("SphericalCertificate.RationalsDecideNearlyCoaxialTasks");
  const FivePoseTask task = task_of("nearly_coaxial", random);
  EXPECT_EQ(count_by_intervals(task), -1);
  const CertifiedAxes proved = certified_axes(task, found_in(task));
  EXPECT_EQ(proved.count_rung, Rung::exact);
  EXPECT_TRUE(proved.complete);
  EXPECT_EQ(proved.count, exact_count(task));
  EXPECT_THAT(boxes(proved), Each(Field(&AxesBox::rung, Rung::exact)));
}

// ---- Against another elimination ----

TEST(SphericalCertificate, EveryCountIsThatOfAnotherElimination) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "SphericalCertificate.EveryCountIsThatOfAnotherElimination." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 30; ++i) {
      const FivePoseTask task = c.make(random);
      const CertifiedAxes proved = certified_axes(task, found_in(task));
      const int truth = exact_count(task).value();
      ASSERT_TRUE(proved.complete) << stream << ' ' << i;
      ASSERT_EQ(proved.count, truth) << stream << ' ' << i;
      const int by_intervals = count_by_intervals(task);
      ASSERT_TRUE(by_intervals == -1 || by_intervals == truth) << stream << ' ' << i;
      ASSERT_EQ(count_exactly(task), truth) << stream << ' ' << i;
    }
  }
}

// ---- Against 100 digits ----

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using LongAxis = Vector<Long, 3>;

struct LongDyad {
  LongAxis fixed, moving;
  Long arc;
};

Matrix<Long, 3, 3> long_rotation(const Pose& p) {
  const auto at = [&](const LongAxis& a) -> LongAxis {
    const LongAxis v(p.x, p.y, p.z);
    const Long w = p.w, n = w * w + v.dot(v);
    return a + 2 * (w * v.cross(a) + v.cross(v.cross(a))) / n;
  };
  Matrix<Long, 3, 3> q;
  for (int i = 0; i < 3; ++i) q.col(i) = at(LongAxis::Unit(i));
  return q;
}

/// Newton on b . Q_j a = cos(arc) for five poses and |a| = |b| = 1, in (a, b, cos(arc)); nothing where it does not
/// converge.
std::optional<LongDyad> refined(const RR::Design& start, FivePoses poses) {
  LongAxis a = start.moving.cast<Long>(), b = start.fixed.cast<Long>();
  Long c = b.dot(long_rotation(poses[0]) * a);
  for (int i = 0; i < 12; ++i) {
    Eigen::Matrix<Long, 7, 7> J = Eigen::Matrix<Long, 7, 7>::Zero();
    Eigen::Matrix<Long, 7, 1> f;
    for (int j = 0; j < 5; ++j) {
      const Matrix<Long, 3, 3> q = long_rotation(poses[static_cast<std::size_t>(j)]);
      f[j] = b.dot(q * a) - c;
      J.row(j) << (q.transpose() * b).transpose(), (q * a).transpose(), Long(-1);
    }
    f[5] = (a.dot(a) - 1) / 2, f[6] = (b.dot(b) - 1) / 2;
    J.row(5).head<3>() = a.transpose(), J.row(6).segment<3>(3) = b.transpose();
    const Eigen::Matrix<Long, 7, 1> step = J.partialPivLu().solve(-f);
    a += step.head<3>(), b += step.segment<3>(3), c += step[6];
    if (step.norm() < Long(1e-60)) {
      const LongAxis at = long_rotation(poses[0]) * a;
      return LongDyad{b, a, atan2(Long(at.cross(b).norm()), Long(at.dot(b)))};
    }
  }
  return std::nullopt;
}

double distance(const RR::Design& d, const LongDyad& truth) {
  const auto angle = [](const Axis& u, const LongAxis& v) {
    const LongAxis w = u.cast<Long>();
    return atan2(Long(w.cross(v).norm()), Long(w.dot(v)));
  };
  const Long of_fixed = angle(d.fixed, truth.fixed), of_moving = angle(d.moving, truth.moving),
             of_arc = truth.arc - d.arc;
  return static_cast<double>(Long(sqrt(Long(of_fixed * of_fixed + of_moving * of_moving + of_arc * of_arc))));
}

TEST(SphericalCertificate, TheTruthInHundredDigitsLiesWithinTheRadius) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "SphericalCertificate.TheTruthInHundredDigitsLiesWithinTheRadius." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 6; ++i) {
      const FivePoseTask task = c.make(random);
      std::vector<AxisPair> found = found_in(task);
      for (AxisPair& pair : found) pair.moving += 1e-12 * Space::random_feature(random);
      for (const bool exact_rung : {false, true}) {
        const CertifiedAxes proved = exact_rung ? certified_axes(task, {}) : certified_axes(task, found);
        ASSERT_TRUE(proved.complete) << stream << ' ' << i;
        for (int k = 0; k < proved.count; ++k) {
          const Pose& reference = task[static_cast<std::size_t>(proved.reference)];
          const RR::Design d = shown(proved.axes[static_cast<std::size_t>(k)], reference);
          const auto truth = refined(d, task);
          ASSERT_TRUE(truth) << stream << ' ' << i;
          const double radius = error_bound(d, proved.boxes[static_cast<std::size_t>(k)], reference);
          EXPECT_LE(distance(d, *truth), radius) << stream << ' ' << i;
          EXPECT_LT(radius, 1e-9) << stream << ' ' << i;
        }
      }
    }
  }
}

TEST(SphericalCertificate, WhatIsShownMayLieFarFromTheBox) {
  Random random("SphericalCertificate.WhatIsShownMayLieFarFromTheBox");
  const PlantedFourBar planted = planted_four_bar(random);
  const CertifiedAxes proved = certified_axes(planted.task, {});
  const Pose& reference = planted.task[static_cast<std::size_t>(proved.reference)];
  RR::Design d = shown(proved.axes[0], reference);
  const double exactly = error_bound(d, proved.boxes[0], reference);
  EXPECT_LT(exactly, 1e-14);
  d.arc += 1e-3;
  EXPECT_NEAR(error_bound(d, proved.boxes[0], reference), 1e-3, 2e-6);
  d.moving = (d.moving + 1e-3 * d.moving.unitOrthogonal()).normalized();
  EXPECT_NEAR(error_bound(d, proved.boxes[0], reference), std::sqrt(2) * 1e-3, 4e-6);
  d.fixed = d.fixed.unitOrthogonal();
  EXPECT_EQ(error_bound(d, proved.boxes[0], reference), std::numeric_limits<double>::infinity());
}

// ---- Wrong lists ----

void expect_all_and_no_more(FivePoses task, const std::vector<AxisPair>& wrong, const std::vector<AxisPair>& right) {
  const CertifiedAxes proved = certified_axes(task, wrong);
  ASSERT_TRUE(proved.complete);
  ASSERT_EQ(proved.count, static_cast<int>(right.size()));
  const std::vector<AxisPair> all = listed(proved);
  for (const AxisPair& pair : right)
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [&](const AxisPair& a) { return same_axes(a, pair); }), 1);
}

TEST(SphericalCertificate, WrongListsAreCorrected) {
  const std::string stream = "SphericalCertificate.WrongListsAreCorrected";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 10; ++i) {
    const FivePoseTask task = task_of("planted_four_bar", random);
    const std::vector<AxisPair> right = found_in(task);
    ASSERT_GE(right.size(), 2u);
    std::vector<AxisPair> fewer(right.begin() + 1, right.end()), twice = right, noisy = right, more = right,
                                                                 broken = right;
    twice[1] = twice[0];
    for (AxisPair& pair : noisy) pair.fixed += 1e-2 * Space::random_feature(random);
    more.push_back({Space::random_feature(random), Space::random_feature(random)});
    broken[0].moving[0] = std::numeric_limits<double>::quiet_NaN();
    for (const auto& wrong : {fewer, twice, noisy, more, broken, std::vector<AxisPair>(9, right[0])})
      expect_all_and_no_more(task, wrong, right);
  }
}

// ---- The same task seen otherwise ----

TEST(SphericalCertificate, CountsDoNotDependOnFramesOrderSignOrSide) {
  const std::string stream = "SphericalCertificate.CountsDoNotDependOnFramesOrderSignOrSide";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 10; ++i) {
    FivePoseTask task;  // integers: turned exactly
    for (Pose& p : task)
      p = {1.0 + random.below(50), random.below(101) - 50.0, random.below(101) - 50.0, random.below(101) - 50.0};
    const int count = certified_axes(task, {}).count;
    ASSERT_EQ(count, exact_count(task));
    const Vector<double, 4> g(3, -5, 7, 11), h(2, 13, -1, -4);
    FivePoseTask turned = task, reversed = task, inverse = task;
    for (std::size_t j = 0; j < 5; ++j) {
      const auto point = Space::point<double>(task[j]);
      turned[j] = Space::pose(Space::product<double>(Space::product<double>(g, point), h));
      reversed[4 - j] = Space::pose(-point * (1 + random.below(3)));
      inverse[j] = Space::pose(Space::conjugate<double>(point));
    }
    for (const FivePoseTask& same : {turned, reversed, inverse}) {
      EXPECT_EQ(certified_axes(same, {}).count, count);
      EXPECT_EQ(certified_axes(same, found_in(same)).count, count);
    }
  }
}

// ---- Coinciding dyads ----

/// Rotations p of small integers with a . (R - I)^T b = 0 for a dyad and for one infinitesimally near: found by search.
struct CoincidingDyads {
  FivePoseTask task;
  Axis moving, fixed;
  int multiplicity;
};
const std::vector<CoincidingDyads> coinciding{
    {{Pose{1, 0, 0, 0}, {1, 2, 0, -2}, {3, 1, -5, -1}, {3, 2, 8, -2}, {4, 0, 5, -4}}, {3, -3, 0}, {0, 3, 3}, 2},
    {{Pose{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 1, 5, 1}, {1, -1, -3, 1}, {1, -1, 0, -2}}, {-2, 0, 2}, {-3, 3, -3}, 2},
    {{Pose{1, 0, 0, 0}, {1, 2, -1, 0}, {1, 3, -1, -1}, {3, 7, -7, 7}, {4, 3, 1, 0}}, {-1, 1, -1}, {3, 3, 0}, 2},
    {{Pose{1, 0, 0, 0}, {0, 1, 1, -5}, {0, 1, 1, 0}, {1, -2, -2, 1}, {1, -2, -1, 3}}, {2, 2, -1}, {1, -1, 0}, 3},
    {{Pose{1, 0, 0, 0}, {1, 1, 1, 3}, {1, 2, 1, -4}, {2, -1, -4, -3}, {2, 1, -1, -2}}, {1, -1, 3}, {-1, 1, 2}, 3}};

TEST(SphericalCertificate, CoincidingDyadsAreProvedWithTheirMultiplicity) {
  for (const CoincidingDyads& c : coinciding) {
    EXPECT_EQ(count_by_intervals(c.task), -1);
    const CertifiedAxes proved = certified_axes(c.task, {});
    ASSERT_TRUE(proved.complete);
    EXPECT_EQ(proved.count_rung, Rung::exact);
    EXPECT_EQ(proved.count, exact_count(c.task));
    int counted = 0;
    for (const AxesBox& box : boxes(proved)) counted += box.multiplicity;
    EXPECT_EQ(counted % 2, 0);
    const AxisPair planted{c.moving, c.fixed};
    const std::vector<AxisPair> all = listed(proved);
    const auto here = std::find_if(all.begin(), all.end(), [&](const AxisPair& a) { return same_axes(a, planted); });
    ASSERT_NE(here, all.end());
    EXPECT_EQ(proved.boxes[static_cast<std::size_t>(here - all.begin())].multiplicity, c.multiplicity);
  }
}

TEST(SphericalCertificate, CountsBesideADoubleDyadAreThoseOfTheDoubles) {
  const std::string stream = "SphericalCertificate.CountsBesideADoubleDyadAreThoseOfTheDoubles";
  SCOPED_TRACE(stream);
  Random random(stream);
  int fewer = 0, more = 0;
  for (const CoincidingDyads& c : coinciding)
    for (const double distance : {1e-6, 1e-10, 1e-13, 1e-15})
      for (int i = 0; i < 2; ++i) {
        FivePoseTask task = c.task;
        for (Pose& p : task) p.x += distance * random.normal(), p.z += distance * random.normal();
        const int count = certified_axes(task, {}).count;
        ASSERT_EQ(count, exact_count(task)) << distance;
        ASSERT_EQ(certified_axes(task, found_in(task)).count, count) << distance;
        const int at_double = exact_count(c.task).value();
        (count < at_double ? fewer : more) += 1;
      }
  EXPECT_GT(fewer, 3);
  EXPECT_GT(more, 3);
}

/// All four conditions are stationary at one dyad: four of the six coincide, and C has rank two there in every chart.
TEST(SphericalCertificate, FourDyadsThatCoincideInAllDirectionsAreOne) {
  const FivePoseTask task{Pose{1, 0, 0, 0}, {0, 0, 1, 0}, {0, 2, -1, -2}, {1, -1, 1, 1}, {1, 1, 1, -1}};
  const CertifiedAxes answer = certified_axes(task, {});
  EXPECT_TRUE(answer.complete);
  ASSERT_EQ(answer.count, 1);
  EXPECT_EQ(answer.boxes[0].multiplicity, 4);
  EXPECT_EQ(answer.degeneracy, Degeneracy::none);
  EXPECT_LT(largest_residual<RR>(shown(answer.axes[0], task[static_cast<std::size_t>(answer.reference)]), task), 1e-15);
}

// ---- Surroundings ----

TEST(SphericalCertificate, RoundingModeIsRestored) {
  Random random("SphericalCertificate.RoundingModeIsRestored");
  for (const char* name : {"generic", "nearly_coaxial", "equal_poses"}) {
    const FivePoseTask task = task_of(name, random);
    const CertifiedAxes proved = certified_axes(task, found_in(task));
    EXPECT_EQ(rounding_mode(), RoundingMode::nearest) << name;
    if (proved.count <= 0) continue;
    const Pose& reference = task[static_cast<std::size_t>(proved.reference)];
    error_bound(shown(proved.axes[0], reference), proved.boxes[0], reference);
    EXPECT_EQ(rounding_mode(), RoundingMode::nearest) << name;
  }
}

TEST(SphericalCertificate, TwoThreadsAgreeWithOne) {
  const auto run = [] {
    std::vector<double> out;
    for (const TaskClass& c : random_task_classes()) {
      Random random("SphericalCertificate.TwoThreadsAgreeWithOne." + std::string(c.name));
      for (int i = 0; i < 5; ++i) {
        const FivePoseTask task = c.make(random);
        const CertifiedAxes proved = certified_axes(task, found_in(task));
        out.push_back(proved.count);
        for (const AxesBox& box : boxes(proved)) out.insert(out.end(), {box.moving[0].low, box.fixed[2].high});
      }
    }
    return out;
  };
  const std::vector<double> alone = run();
  std::vector<double> first, second;
  std::thread one([&] { first = run(); }), two([&] { second = run(); });
  one.join(), two.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
}  // namespace burmester::spherical
