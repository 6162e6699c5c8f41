// The steps to the sextic of five orientations over intervals: boxes that contain the exact values, and are narrow.
#include <gtest/gtest.h>

#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/spherical/five_pose_sextic.hpp"
#include "burmester/spherical/tasks.hpp"

namespace burmester::spherical {
namespace {

struct Boxes {
  Bilinear<Interval> equations;
  std::array<BinaryForm<Interval>, charts.size()> sextic;
};

Boxes boxes_of(const FivePoseTask& task, int reference) {
  const UpwardRounding upward;
  Boxes out{bilinear_equations<Interval>(task, reference), {}};
  for (std::size_t c = 0; c < charts.size(); ++c)
    out.sextic[c] = sextic(minor_forms(in_chart(out.equations, charts[c])));
  return out;
}

bool contains(const Interval& box, const Rational& x) { return Rational(box.inf()) <= x && x <= Rational(box.sup()); }

TEST(SphericalIntervals, ContainTheExactEquationsAndSextics) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream = "SphericalIntervals.ContainTheExactEquationsAndSextics." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 10; ++i) {
      const FivePoseTask task = c.make(random);
      const int reference = five_pose_equations(task).reference;
      const Boxes boxes = boxes_of(task, reference);
      const Bilinear<Rational> exact = bilinear_equations<Rational>(task, reference);
      for (std::size_t j = 0; j < 4; ++j)
        for (int k = 0; k < 9; ++k) ASSERT_TRUE(contains(boxes.equations[j](k), exact[j](k))) << stream << ' ' << i;
      for (std::size_t chart = 0; chart < charts.size(); ++chart) {
        const BinaryForm<Rational> f = sextic(minor_forms(in_chart(exact, charts[chart])));
        ASSERT_EQ(f.degree, 6u);
        for (std::size_t k = 0; k <= 6; ++k)
          ASSERT_TRUE(contains(boxes.sextic[chart].c[k], f.c[k])) << stream << ' ' << i << ' ' << chart;
      }
    }
  }
}

/// The scale of a close pair is its own: forming its relative rotation from rounded products would leave 2^-53 / 1e-6.
TEST(SphericalIntervals, AreNarrowForAClosePair) {
  const std::string stream = "SphericalIntervals.AreNarrowForAClosePair";
  SCOPED_TRACE(stream);
  Random random(stream);
  for (int i = 0; i < 20; ++i) {
    const FivePoseTask task = find_task_class("close_pair")->make(random);
    for (const Correlation<Interval>& n : boxes_of(task, five_pose_equations(task).reference).equations)
      for (int k = 0; k < 9; ++k) EXPECT_LT(n(k).sup() - n(k).inf(), 0x1p-44);
  }
}

TEST(SphericalIntervals, ChartsAreUnimodular) {
  for (const Chart& c : charts) {
    Matrix<double, 3, 3> m;
    for (std::size_t i = 0; i < 3; ++i) m.row(static_cast<int>(i)) << c[i][0], c[i][1], c[i][2];
    EXPECT_EQ(m.row(0).cross(m.row(1)).dot(m.row(2)), 1);
  }
}

}  // namespace
}  // namespace burmester::spherical
