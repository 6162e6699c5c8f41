// The upper rungs of ladder.hpp: intervals, then the exact ring. For targets made by
// burmester_enable_intervals only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "burmester/geometry/dyadic.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/ladder.hpp"

namespace burmester {

/// Nothing where the interval contains 0 and more. For a batch: one UpwardRounding serves all.
template <class F, std::size_t N>
std::optional<int> sign_by_intervals(const std::array<double, N>& x, const UpwardRounding&) {
  return known_sign(evaluate<F, Interval>(x));
}
template <class F, std::size_t N>
std::optional<int> sign_by_intervals(const std::array<double, N>& x) {
  return sign_by_intervals<F>(x, UpwardRounding());
}

/// Always known. Precondition: x is finite.
template <class F, std::size_t N>
int sign_by_exact(const std::array<double, N>& x) {
  return evaluate<F, Dyadic>(x).sign();
}

template <class F, std::size_t N>
Sign sign_beyond_doubles(const std::array<double, N>& x) {
  if (!std::ranges::all_of(x, [](double a) { return std::isfinite(a); })) return {};
  if (const std::optional<int> sign = sign_by_intervals<F>(x)) return {*sign, Rung::intervals};
  return {sign_by_exact<F>(x), Rung::exact};
}

}  // namespace burmester
