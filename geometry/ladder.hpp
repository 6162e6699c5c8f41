// The ladder of exact signs: the sign of a polynomial in doubles by the cheapest arithmetic that proves it.
//
// An expression is written once, as a functor with no data over every number type:
//     struct Area {
//       template <class T>
//       constexpr T operator()(const std::array<T, 2>& x) const { return x[0] * x[0] - 2 * x[1]; }
//     };
// Allowed are + - *, integers that doubles hold, and difference() (bounded.hpp); constexpr, because its depth
// is computed at compile time by running it. exact_sign<Area>(x) climbs: doubles with an error bound, inlined
// here; intervals; the exact ring of the doubles. The upper rungs are defined in predicate.hpp, for targets
// that compile intervals; other targets call predicates for which some .cpp file says
//     template Sign sign_beyond_doubles<Area>(const std::array<double, 2>&);
#pragma once

#include <array>
#include <cstddef>

#include "burmester/geometry/bounded.hpp"
#include "burmester/geometry/rung.hpp"

namespace burmester {

struct Sign {
  int sign = 0;                  ///< -1, 0 or 1
  Rung decided_by = Rung::none;  ///< none: an argument was not finite
  friend bool operator==(const Sign&, const Sign&) = default;
};

/// Defined in predicate.hpp. Cold: not worth inlining.
template <class F, std::size_t N>
[[gnu::cold]] Sign sign_beyond_doubles(const std::array<double, N>& x);

/// The sign of F(x) and the rung that decided it. Doubles never prove a zero, intervals only where nothing was rounded.
template <class F, std::size_t N>
inline Sign exact_sign(const std::array<double, N>& x) {
  if (const std::optional<int> sign = sign_by_doubles<F>(x)) return {*sign, Rung::doubles};
  return sign_beyond_doubles<F>(x);
}

}  // namespace burmester
