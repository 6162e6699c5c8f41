// Reading problems: JSON documents of schema burmester/problem/1, or CSV with a header line. What a pose
// looks like is the module's business.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/registry.hpp"

namespace burmester {

struct ReadOptions {
  std::string file = "input";           ///< what messages call the source
  std::optional<std::string> geometry;  ///< for problems that name none
  bool csv = true;                      ///< CSV is understood too
};

inline constexpr std::size_t most_poses = 100000;
inline constexpr std::size_t most_linkages = 1000;  ///< in a list that a problem may ask for

/// Throws InputError: one line with file, place and what was expected.
Problem read_problem(std::string_view text, const Registry& registry, const ReadOptions& options);

/// Checks names of dyad types ("RR") against those of the module and puts its own names for them.
/// Throws InputError without the place.
std::vector<std::string> known_types(const Module& module, const std::vector<std::string>& types);

}  // namespace burmester
