// Points of a problem that are to be pivots or axes: refused in one line where they cannot be.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/problem.hpp"

namespace burmester {

/// Throws InputError for points that cannot be pivots; `name`: the key of the problem that gives them.
template <class G>
void expect_pivots(std::string_view name, const std::vector<std::vector<double>>& points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    if (const char* expected = G::complaint(points[k]))
      throw InputError(fmt::format("{}[{}]: expected {}", name, k, expected));
}

}  // namespace burmester
