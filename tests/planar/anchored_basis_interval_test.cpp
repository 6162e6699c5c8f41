// The rational steps of the five-pose solver over intervals: boxes that contain the exact values.
#include <gtest/gtest.h>

#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/rational.hpp"
#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {
namespace {

bool contains(const Interval& box, const Rational& x) {
  const bool above = box.inf() == -std::numeric_limits<double>::infinity() || Rational(box.inf()) <= x;
  const bool below = box.sup() == std::numeric_limits<double>::infinity() || x <= Rational(box.sup());
  return above && below;
}

template <int rows, int cols>
::testing::AssertionResult contains(const Matrix<Interval, rows, cols>& boxes,
                                    const Matrix<Rational, rows, cols>& exact) {
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c)
      if (!contains(boxes(r, c), exact(r, c)))
        return ::testing::AssertionFailure()
               << "entry " << r << ", " << c << ": " << exact(r, c) << " is not in [" << boxes(r, c).inf()
               << ", " << boxes(r, c).sup() << ']';
  return ::testing::AssertionSuccess();
}

/// The exact basis with the identity in the given rows.
Matrix<Rational, 7, 3> with_free(Matrix<Rational, 7, 3> basis, const std::array<int, 3>& free) {
  for (int f = 0; f < 3; ++f) {
    int pivot = f;  // a column that does not vanish there
    while (basis(free[f], pivot) == 0) ++pivot;
    basis.col(f).swap(basis.col(pivot));
    basis.col(f) /= Rational(basis(free[f], f));
    for (int g = 0; g < 3; ++g)
      if (g != f) basis.col(g) -= Rational(basis(free[f], g)) * basis.col(f);
  }
  return basis;
}

struct Boxes {
  Matrix<Interval, 4, 7> rows;
  NullSpace<Interval, 4, 7> null;
  std::array<Conic<Interval>, 2> conics;
};

Boxes boxes_of(const FivePoseTask& task, const Anchor& anchor) {
  const UpwardRounding upward;
  Boxes out;
  out.rows = anchored_rows<Interval>(task, anchor);
  out.null = null_space(out.rows);
  out.conics = relation_conics(out.null.basis, Interval(anchor.turn));
  return out;
}

TEST(FivePoseIntervals, ContainTheExactRowsNullSpaceAndConics) {
  for (const TaskClass& c : random_task_classes()) {
    const std::string stream =
        "FivePoseIntervals.ContainTheExactRowsNullSpaceAndConics." + std::string(c.name);
    Random random(stream);
    for (int i = 0; i < 50; ++i) {
      const FivePoseTask task = c.make(random);
      const Anchor anchor = choose_anchor(task).anchor;
      const Boxes boxes = boxes_of(task, anchor);
      const Matrix<Rational, 4, 7> rows = anchored_rows<Rational>(task, anchor);
      EXPECT_TRUE((contains<4, 7>(boxes.rows, rows))) << stream << ", task " << i;
      const Matrix<Rational, 7, 3> basis = with_free(null_space(rows).basis, boxes.null.free);
      EXPECT_TRUE((contains<7, 3>(boxes.null.basis, basis))) << stream << ", task " << i;
      const auto conics = relation_conics(basis, Rational(anchor.turn));
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t q = 0; q < 6; ++q)
          EXPECT_TRUE(contains(boxes.conics[k].q[q], conics[k].q[q]))
              << stream << ", task " << i << ", conic " << k << ", coefficient " << q;
    }
  }
}

/// Widest box of the basis, relative to its largest entry.
double width(const NullSpace<Interval, 4, 7>& null) {
  double widest = 0, largest = 0;
  for (int r = 0; r < 7; ++r)
    for (int c = 0; c < 3; ++c) {
      const Interval& x = null.basis(r, c);
      widest = std::max(widest, x.sup() - x.inf());
      largest = std::max({largest, std::abs(x.inf()), std::abs(x.sup())});
    }
  return widest / largest;
}

// Boxes that contain everything prove nothing: in the median of generic tasks they stay narrow.
TEST(FivePoseIntervals, AreNarrow) {
  Random random("FivePoseIntervals.AreNarrow");
  std::vector<double> widths;
  for (int i = 0; i < 501; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    widths.push_back(width(boxes_of(task, choose_anchor(task).anchor).null));
  }
  std::nth_element(widths.begin(), widths.begin() + 250, widths.end());
  EXPECT_LT(widths[250], 1000 * unit_roundoff);
  RecordProperty("median_relative_width_in_unit_roundoffs", std::to_string(widths[250] / unit_roundoff));
}

}  // namespace
}  // namespace burmester::planar
