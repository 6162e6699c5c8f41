#include "burmester/planar/anchored_basis.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/quad.hpp"
#include "burmester/planar/five_pose_roots.hpp"
#include "integer_tasks.hpp"

namespace burmester::planar {
namespace {

using Exact = Anchored<Rational>;

// ---- The planted dyads in the anchored basis, from the definitions in the header ----

/// From K0, G, u, v (complex numbers in units of the anchor's length) to w.
Exact scaled(const Rational& K0, const Place& G, const Place& u, const Place& v, const Anchor& anchor) {
  const Rational e(anchor.turn);
  Exact w;
  w << K0, G[0], G[1], e * u[0], e * u[1], e * e * v[0], e * v[1];
  return w;
}

Exact RR_point(const IntegerTask& t, const Anchor& anchor) {
  const Pose& reference = t.poses[anchor.reference];
  const Rational per_length = 1 / Rational(anchor.length);
  const Place p = per_length * times(rotation(reference), t.moving);
  const Place centre = per_length * (t.fixed - origin(reference)), K = -2 * centre;
  return scaled(1, K + 2 * p, p, times(conjugate(p), K), anchor);
}
Exact PR_point(const IntegerTask& t, const Anchor& anchor) {
  const Place p = times(rotation(t.poses[anchor.reference]), t.moving) / Rational(anchor.length);
  return scaled(0, t.normal, Place::Zero(), times(conjugate(p), t.normal), anchor);
}
Exact RP_point(const IntegerTask& t, const Anchor& anchor) {
  const Pose& reference = t.poses[anchor.reference];
  const Place f = (t.fixed - origin(reference)) / Rational(anchor.length);
  const Place u = times(rotation(reference), t.normal);
  return scaled(0, 2 * u, u, -2 * times(conjugate(u), f), anchor);
}

void expect_on_all_rows(const std::string& stream, IntegerTask (*make)(Random&),
                        Exact (*point)(const IntegerTask&, const Anchor&)) {
  Random random(stream);
  for (int i = 0; i < 100; ++i) {
    const IntegerTask task = make(random);
    Anchor anchor = choose_anchor(task.poses).anchor;
    if (anchor.turn == 0) continue;
    for (anchor.reference = 0; anchor.reference < 5; ++anchor.reference) {
      const Exact w = point(task, anchor);
      const Vector<Rational, 4> values = anchored_rows<Rational>(task.poses, anchor) * w;
      for (int r = 0; r < 4; ++r) EXPECT_EQ(values[r], 0) << stream << ", case " << i << ", row " << r;
      for (const Rational& f : anchored_relations(w, Rational(anchor.turn)))
        EXPECT_EQ(f, 0) << stream << ", case " << i;
    }
  }
}

TEST(AnchoredRows, AnnihilatePlantedRR) {
  expect_on_all_rows("AnchoredRows.AnnihilatePlantedRR", integer_RR_task, RR_point);
}
TEST(AnchoredRows, AnnihilatePlantedPR) {
  expect_on_all_rows("AnchoredRows.AnnihilatePlantedPR", integer_PR_task, PR_point);
}
TEST(AnchoredRows, AnnihilatePlantedRP) {
  expect_on_all_rows("AnchoredRows.AnnihilatePlantedRP", integer_RP_task, RP_point);
}

TEST(AnchoredRows, LargestEntryIsBetweenOneAndTwo) {
  Random random("AnchoredRows.LargestEntryIsBetweenOneAndTwo");
  for (const TaskClass& c : random_task_classes())
    for (int i = 0; i < 100; ++i) {
      const FivePoseTask task = c.make(random);
      const Matrix<double, 4, 7> rows = anchored_rows<double>(task, choose_anchor(task).anchor);
      for (int r = 0; r < 4; ++r) {
        const double size = rows.row(r).cwiseAbs().maxCoeff();
        EXPECT_TRUE(1 <= size && size < 2) << c.name << ", case " << i;
      }
    }
}

TEST(RelationConics, AreTheRelationsOnTheNullSpace) {
  Random random("RelationConics.AreTheRelationsOnTheNullSpace");
  for (int i = 0; i < 50; ++i) {
    Matrix<Rational, 7, 3> basis;
    for (int r = 0; r < 7; ++r)
      for (int c = 0; c < 3; ++c) basis(r, c) = random.below(41) - 20;
    const Rational e(1, 8);
    const Point2<Rational> z(random.below(9) - 4, random.below(9) - 4, 1);
    const auto conics = relation_conics(basis, e);
    const auto relations = anchored_relations<Rational>(basis * z, e);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(conics[k](z), relations[k]) << "case " << i;
  }
}

// ---- Decoding ----

template <class T>
void expect_decoded_RR(const char* stream, double tolerance) {
  Random random(stream);
  for (int i = 0; i < 100; ++i) {
    const IntegerTask task = integer_RR_task(random);
    const Anchor anchor = choose_anchor(task.poses).anchor;
    if (anchor.turn == 0) continue;
    const Exact exact = RR_point(task, anchor);
    Anchored<T> w;
    for (int k = 0; k < 7; ++k) w[k] = static_cast<T>(exact[k]) * T(-0.3);
    const AnchoredPivots<T> pivots = decode_pivots(w, anchor);
    const Pose& reference = task.poses[anchor.reference];
    const Place moving = times(rotation(reference), task.moving), fixed = task.fixed - origin(reference);
    for (int k = 0; k < 2; ++k) {
      const T L(anchor.length);
      EXPECT_NEAR(approximate(T(pivots.moving[k] * L - static_cast<T>(moving[k]))), 0, tolerance)
          << "case " << i;
      EXPECT_NEAR(approximate(T(pivots.fixed[k] * L - static_cast<T>(fixed[k]))), 0, tolerance)
          << "case " << i;
    }
  }
}

TEST(DecodePivots, FindsThePlantedPivots) {  // of size 1e3 to 1e6
  expect_decoded_RR<double>("DecodePivots.FindsThePlantedPivots.double", 1e6 * 64 * unit_roundoff);
  expect_decoded_RR<Quad>("DecodePivots.FindsThePlantedPivots.quad", 1e6 * 64 * 0x1p-113);
}

TEST(DecodePivots, KeepsTheFinitePivotOfSliders) {
  Random random("DecodePivots.KeepsTheFinitePivotOfSliders");
  const auto rounded = [](const Exact& w) {
    Anchored<double> out;
    for (int k = 0; k < 7; ++k) out[k] = approximate(w[k]);
    return out;
  };
  for (int i = 0; i < 100; ++i) {
    const IntegerTask pr = integer_PR_task(random), rp = integer_RP_task(random);
    const Anchor a = choose_anchor(pr.poses).anchor, b = choose_anchor(rp.poses).anchor;
    if (a.turn == 0 || b.turn == 0) continue;
    const Place moving = times(rotation(pr.poses[a.reference]), pr.moving);
    const Place fixed = rp.fixed - origin(rp.poses[b.reference]);
    const auto p = decode_pivots(rounded(PR_point(pr, a)), a), q = decode_pivots(rounded(RP_point(rp, b)), b);
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(p.moving[k] * a.length, approximate(moving[k]), 1e6 * 64 * unit_roundoff) << "case " << i;
      EXPECT_NEAR(q.fixed[k] * b.length, approximate(fixed[k]), 1e6 * 64 * unit_roundoff) << "case " << i;
    }
    EXPECT_FALSE(p.fixed.allFinite());
    EXPECT_FALSE(q.moving.allFinite());
  }
}

// ---- The anchor ----

TEST(ChooseAnchor, TakesTheClosestPairAndPowersOfTwo) {
  Random random("ChooseAnchor.TakesTheClosestPairAndPowersOfTwo");
  for (int i = 0; i < 200; ++i) {
    const FivePoseTask task = find_task_class("close_pair")->make(random);  // poses 1 and 3
    const AnchorChoice choice = choose_anchor(task);
    EXPECT_EQ(choice.anchor.reference, 1) << "case " << i;
    EXPECT_FALSE(choice.equal_poses);
    double longest = 0, widest = 0;
    for (const Pose& a : task)
      for (const Pose& b : task) {
        longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
        widest = std::max(widest, 2 * std::abs(b.X3 * a.X4 - b.X4 * a.X3));
      }
    EXPECT_EQ(choice.anchor.length, power_of_two_below(longest)) << "case " << i;
    EXPECT_EQ(choice.anchor.turn, power_of_two_below(widest)) << "case " << i;
  }
}

TEST(ChooseAnchor, KnowsEqualAndParallelPoses) {
  Random random("ChooseAnchor.KnowsEqualAndParallelPoses");
  FivePoseTask task = find_task_class("generic")->make(random);
  EXPECT_FALSE(choose_anchor(task).parallel_pair);
  task[4].X3 = -task[2].X3, task[4].X4 = -task[2].X4;  // the same orientation
  EXPECT_TRUE(choose_anchor(task).parallel_pair);
  EXPECT_FALSE(choose_anchor(task).equal_poses);
  task[4].x = task[2].x, task[4].y = task[2].y;
  EXPECT_TRUE(choose_anchor(task).equal_poses);
  task[4].X3 *= 3, task[4].X4 *= 3;
  EXPECT_TRUE(choose_anchor(task).equal_poses);
}

TEST(ChooseAnchor, UnitsOfPointlikeTasks) {
  FivePoseTask task;
  for (int j = 0; j < 5; ++j) task[j] = pose_from_degrees(3, 4, 10.0 * j);
  EXPECT_EQ(choose_anchor(task).anchor.length, 1);
  for (int j = 0; j < 5; ++j) task[j] = pose_from_degrees(j, 4, 10);
  EXPECT_EQ(choose_anchor(task).anchor.turn, 0);
  EXPECT_EQ(choose_anchor(task).anchor.length, 4);
}

// ---- Relative turns ----

/// Relative error of X3 in unit roundoffs.
double turn_error(const Pose& a, const Pose& b) {
  const Rational exact = relative_turn<Rational>(a, b).X3;
  const double got = relative_turn<double>(a, b).X3;
  if (exact == 0) return got == 0 ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(approximate(Rational((Rational(got) - exact) / exact))) / unit_roundoff;
}

// Points of one norm to rounding: two products and their difference, which hardly cancel once the difference
// vector is formed. Of different norms: difference_of_products.
TEST(RelativeTurn, KeepsItsDigitsHoweverSmall) {
  Random random("RelativeTurn.KeepsItsDigitsHoweverSmall");
  for (int i = 0; i < 20000; ++i) {
    const double angle = random.uniform(-4, 4), turn = std::pow(10, random.uniform(-14, 0)) * random.normal();
    const Pose a = pose_from_radians(0, 0, angle);
    Pose b = pose_from_radians(0, 0, angle + turn);
    if (i % 3 == 1) b.X3 = -b.X3, b.X4 = -b.X4;
    if (i % 3 == 2) b.X3 *= 1.7, b.X4 *= 1.7;
    EXPECT_LT(turn_error(a, b), 4) << "case " << i << ", turn " << turn;
  }
}

TEST(RelativeTurn, IsZeroForProportionalPoints) {
  Random random("RelativeTurn.IsZeroForProportionalPoints");
  for (int i = 0; i < 1000; ++i) {
    const Pose a = pose_from_radians(0, 0, random.uniform(-4, 4));
    for (const double factor : {1.0, -1.0, 2.0, -4.0})
      EXPECT_EQ(relative_turn<double>(a, {0, 0, factor * a.X3, factor * a.X4}).X3, 0) << factor;
  }
}

}  // namespace
}  // namespace burmester::planar
