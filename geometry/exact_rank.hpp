// The rank of a matrix of rationals, exact however small the entries: the pivots that NullSpace (null_space.hpp)
// reports are doubles, and may be rounded to 0.
#pragma once

#include "burmester/geometry/rational.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

/// Gaussian elimination.
template <int Rows, int Cols>
int exact_rank(Matrix<Rational, Rows, Cols> m) {
  int rank = 0;
  for (int c = 0; c < Cols && rank < Rows; ++c) {
    int row = rank;
    while (row < Rows && m(row, c) == 0) ++row;
    if (row == Rows) continue;
    m.row(row).swap(m.row(rank));
    for (int r = rank + 1; r < Rows; ++r) {
      const Rational factor = m(r, c) / m(rank, c);
      for (int k = c; k < Cols; ++k) m(r, k) -= factor * m(rank, k);
    }
    ++rank;
  }
  return rank;
}

}  // namespace burmester
