// Signs that are known, or known not to be known.
#pragma once

#include <optional>

namespace burmester {

/// -1, 0 or 1; nothing where the number type cannot tell (an interval that contains 0 and more). Over exact types
/// always known. Over double the sign of the double, which proves nothing about what it was rounded from.
template <class T>
std::optional<int> known_sign(const T& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

}  // namespace burmester
