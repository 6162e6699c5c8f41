// Which of n things hang together (R. E. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975).
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace burmester {

/// The classes of 0 .. n - 1 under the pairs united so far.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace burmester
