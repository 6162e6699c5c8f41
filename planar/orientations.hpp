// Five poses by equal orientations.
#pragma once

#include <optional>

#include "burmester/planar/anchored_basis.hpp"

namespace burmester::planar {

struct OrientationClass {
  int size = 0;
  std::array<int, 5> member{};  ///< poses, the first `size` count
};

/// The classes of equal orientations, largest first; `same(a, b)` tells whether two poses have one orientation.
template <class Same>
std::array<OrientationClass, 5> orientation_classes(FivePoses poses, Same same) {
  std::array<OrientationClass, 5> classes;
  std::array<bool, 5> seen{};
  for (int i = 0; i < 5; ++i) {
    if (seen[i]) continue;
    for (int j = i; j < 5; ++j)
      if (!seen[j] && same(poses[i], poses[j])) seen[j] = true, classes[i].member[classes[i].size++] = j;
  }
  std::stable_sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) { return a.size > b.size; });
  return classes;
}

struct TripleAndPair {
  std::array<int, 3> triple;
  std::array<int, 2> pair;
};

/// Of 3 + 2 poses; nothing for others.
template <class Same>
std::optional<TripleAndPair> triple_and_pair(FivePoses poses, Same same) {
  const auto c = orientation_classes(poses, same);
  if (c[0].size != 3 || c[1].size != 2) return std::nullopt;
  return TripleAndPair{{c[0].member[0], c[0].member[1], c[0].member[2]}, {c[1].member[0], c[1].member[1]}};
}

}  // namespace burmester::planar
