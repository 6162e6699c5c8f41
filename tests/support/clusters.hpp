// Five poses in clusters of close ones.
#pragma once

#include <array>
#include <cstddef>

namespace burmester::support {

/// 3 + 2, 2 + 2 + 1, 4 + 1 and 3 + 1 + 1 poses, as i goes on; beside(p) makes a pose close to the first of its cluster.
template <class Task, class Beside>
Task in_clusters(Task task, int i, Beside beside) {
  constexpr std::array<std::array<std::size_t, 5>, 4> firsts{
      {{0, 0, 0, 3, 3}, {0, 0, 2, 2, 4}, {0, 0, 0, 0, 4}, {0, 0, 0, 3, 4}}};
  for (std::size_t j = 0; j < 5; ++j)
    if (const std::size_t first = firsts[static_cast<std::size_t>(i) % 4][j]; first != j) task[j] = beside(task[first]);
  return task;
}

}  // namespace burmester::support
