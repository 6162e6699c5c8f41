#include "burmester/geometry/null_space.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/quad.hpp"
#include "burmester/geometry/rational.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

template <class T, int rows, int cols>
Matrix<T, rows, cols> cast(const Matrix<double, rows, cols>& m) {
  Matrix<T, rows, cols> out;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) out(r, c) = T(m(r, c));
  return out;
}

template <int rows, int cols>
Matrix<double, rows, cols> random_matrix(Random& random) {
  Matrix<double, rows, cols> m;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) m(r, c) = random.normal();
  return m;
}

/// The basis has the identity in the rows of the free unknowns, which are distinct.
template <class T, int rows, int cols>
void expect_identity_in_free_rows(const NullSpace<T, rows, cols>& n, const std::string& label) {
  for (int f = 0; f < cols - rows; ++f)
    for (int g = 0; g < cols - rows; ++g) EXPECT_EQ(n.basis(n.free[f], g), T(f == g ? 1 : 0)) << label;
}

template <int rows, int cols>
void expect_exact_basis(const std::string& label) {
  Random random(label);
  for (int i = 0; i < 100; ++i) {
    Matrix<Rational, rows, cols> m;
    for (int r = 0; r < rows; ++r) m.row(r) = random_rationals<cols>(random).transpose();
    const auto n = null_space(m);
    EXPECT_GT(n.smallest_pivot(), 0) << label << ", case " << i;
    const Matrix<Rational, rows, cols - rows> product = m * n.basis;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < cols - rows; ++c) EXPECT_EQ(product(r, c), 0) << label << ", case " << i;
    expect_identity_in_free_rows(n, label);
  }
}

TEST(NullSpace, IsExactOverRationals) {  // even and odd widths, of one and of several dimensions
  expect_exact_basis<4, 7>("NullSpace.IsExactOverRationals.4x7");
  expect_exact_basis<3, 4>("NullSpace.IsExactOverRationals.3x4");
  expect_exact_basis<2, 5>("NullSpace.IsExactOverRationals.2x5");
  expect_exact_basis<5, 8>("NullSpace.IsExactOverRationals.5x8");
  expect_exact_basis<2, 3>("NullSpace.IsExactOverRationals.2x3");
  expect_exact_basis<6, 9>("NullSpace.IsExactOverRationals.6x9");
}

/// The exact basis with the identity in the given rows, from any exact basis.
template <int cols, int dimension>
Matrix<Rational, cols, dimension> with_free(Matrix<Rational, cols, dimension> basis,
                                            const std::array<int, dimension>& free) {
  for (int f = 0; f < dimension; ++f) {
    basis.col(f) /= Rational(basis(free[f], f));
    for (int g = 0; g < dimension; ++g)
      if (g != f) basis.col(g) -= Rational(basis(free[f], g)) * basis.col(f);
  }
  return basis;
}

/// Largest error of the double basis, relative to its largest entry, in unit roundoffs over the smallest
/// pivot.
template <int rows, int cols>
double error(const Matrix<double, rows, cols>& m) {
  const auto n = null_space(m);
  const auto exact = with_free<cols, cols - rows>(null_space(cast<Rational>(m)).basis, n.free);
  double worst = 0;
  for (int r = 0; r < cols; ++r)
    for (int c = 0; c < cols - rows; ++c)
      worst = std::max(worst, std::abs(approximate(Rational(Rational(n.basis(r, c)) - exact(r, c)))));
  return worst / n.basis.cwiseAbs().maxCoeff() / unit_roundoff * n.smallest_pivot();
}

// Backward stable: the computed basis is that of a matrix a few roundoffs away, and the smallest pivot
// (relative to the first) is within a factor of its distance from a deficient one. 16: rounding errors per
// entry, 4 pivots deep.
TEST(NullSpace, IsAccurateForRandomMatrices) {
  Random random("NullSpace.IsAccurateForRandomMatrices");
  for (int i = 0; i < 1000; ++i) {
    const auto m = random_matrix<4, 7>(random);
    EXPECT_LT((error<4, 7>(m)), 16) << "case " << i << "\n" << m;
  }
}

TEST(NullSpace, IsAccurateForRowsOfDifferentSize) {
  Random random("NullSpace.IsAccurateForRowsOfDifferentSize");
  for (int i = 0; i < 1000; ++i) {
    auto m = random_matrix<4, 7>(random);
    for (int r = 0; r < 4; ++r) m.row(r) *= std::pow(10.0, random.uniform(-6, 6));
    EXPECT_LT((error<4, 7>(m)), 16) << "case " << i << "\n" << m;
  }
}

TEST(NullSpace, IsAccurateNearRankThree) {
  Random random("NullSpace.IsAccurateNearRankThree");
  for (int i = 0; i < 1000; ++i) {
    auto m = random_matrix<4, 7>(random);
    m.row(2) = m.row(0) - 2 * m.row(3) + 1e-8 * m.row(2);
    EXPECT_LT((error<4, 7>(m)), 16) << "case " << i << "\n" << m;
  }
}

TEST(NullSpace, LastPivotTellsTheRank) {
  Random random("NullSpace.LastPivotTellsTheRank");
  for (int i = 0; i < 1000; ++i) {
    auto m = random_matrix<4, 7>(random);
    EXPECT_GT(null_space(m).smallest_pivot(), 1e-6) << "case " << i;
    m.row(1) = 0.3 * m.row(0) + m.row(2) - 0.7 * m.row(3);
    const auto n = null_space(m);
    EXPECT_LT(n.pivot[3], 64 * unit_roundoff / n.pivot[2]) << "case " << i;
    EXPECT_TRUE(n.is_zero(3, 64 * unit_roundoff)) << "case " << i;
    EXPECT_FALSE(n.is_zero(2, 64 * unit_roundoff)) << "case " << i;
  }
}

TEST(NullSpace, ExactlyDeficientMatricesGiveTheRank) {
  Matrix<Rational, 4, 7> m = Matrix<Rational, 4, 7>::Zero();
  EXPECT_EQ(null_space(m).pivot, (std::array<double, 4>{}));
  Random random("NullSpace.ExactlyDeficientMatricesGiveTheRank");
  m.row(0) = random_rationals<7>(random).transpose();
  m.row(2) = random_rationals<7>(random).transpose();
  m.row(3) = m.row(0) - m.row(2);
  const auto n = null_space(m);
  EXPECT_EQ(n.pivot[0], 1);
  EXPECT_GT(n.pivot[1], 0);
  EXPECT_EQ(n.pivot[2], 0);
  EXPECT_EQ(n.pivot[3], 0);
}

TEST(NullSpace, PivotsFallAndStartAtOne) {
  Random random("NullSpace.PivotsFallAndStartAtOne");
  for (int i = 0; i < 100; ++i) {
    const auto n = null_space(random_matrix<4, 7>(random));
    EXPECT_EQ(n.pivot[0], 1);
    for (int k = 1; k < 4; ++k)
      EXPECT_LE(n.pivot[k], 2 * n.pivot[k - 1]);  // growth of one step of elimination
  }
}

TEST(NullSpace, AgreesInQuad) {
  Random random("NullSpace.AgreesInQuad");
  for (int i = 0; i < 100; ++i) {
    const auto m = random_matrix<4, 7>(random);
    const auto n = null_space(cast<Quad>(m));
    const Matrix<Quad, 4, 3> product = cast<Quad>(m) * n.basis;
    EXPECT_LT(approximate(Quad(product.cwiseAbs().maxCoeff())), 1e-31 / n.smallest_pivot()) << "case " << i;
    expect_identity_in_free_rows(n, "NullSpace.AgreesInQuad");
  }
}

}  // namespace
}  // namespace burmester
