// Signature of a small symmetric matrix: positive minus negative squares (Sylvester's law of inertia).
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/sign.hpp"
#include "burmester/geometry/vector.hpp"

namespace burmester {

struct Inertia {
  int rank = 0, signature = 0;
};

/// By symmetric elimination, largest diagonal entry first. Nothing where the number type cannot tell a sign. Exact over
/// exact types; there a zero diagonal with entries beside it is made non-zero by a congruence.
template <class T, int N>
std::optional<Inertia> inertia(Matrix<T, N, N> m) {
  Inertia out;
  for (int k = 0; k < N; ++k) {
    int p = k;
    for (int i = k + 1; i < N; ++i)  // approximate() may underflow to 0 where an exact entry is not
      if (std::abs(approximate(m(i, i))) > std::abs(approximate(m(p, p))) || known_sign(m(p, p)) == 0) p = i;
    for (int i = k; i < N && known_sign(m(p, p)) == 0; ++i)
      for (int j = i + 1; j < N; ++j) {
        if (known_sign(m(i, j)) == 0) continue;
        for (int c = 0; c < N; ++c) m(i, c) += m(j, c);
        for (int r = 0; r < N; ++r) m(r, i) += m(r, j);
        p = i;
        break;
      }
    m.row(k).swap(m.row(p));
    m.col(k).swap(m.col(p));
    const std::optional<int> sign = known_sign(m(k, k));
    if (!sign) return std::nullopt;
    if (*sign == 0) return out;  // exact types: the rest is zero
    ++out.rank;
    out.signature += *sign;
    for (int r = k + 1; r < N; ++r) {
      const T factor = m(r, k) / m(k, k);
      for (int c = k + 1; c < N; ++c) m(r, c) -= factor * m(k, c);
    }
  }
  return out;
}

}  // namespace burmester
