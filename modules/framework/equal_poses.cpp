#include "burmester/modules/framework/equal_poses.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "burmester/modules/framework/counted.hpp"

namespace burmester {

std::string name_equal_poses(const std::function<bool(int, int)>& same, int count) {
  std::vector<std::string> groups;
  std::array<bool, 5> seen{};
  int different = 0;
  for (int i = 0; i < count; ++i) {
    if (seen[i]) continue;
    ++different;
    std::vector<int> group{i + 1};
    for (int j = i + 1; j < count; ++j)
      if (same(i, j)) seen[j] = true, group.push_back(j + 1);
    if (group.size() > 1) groups.push_back(fmt::format("{}", fmt::join(group, " and ")));
  }
  static constexpr const char* family[] = {"", "met by every dyad",
                                           "in general met by a three-dimensional family of dyads",
                                           "in general met by a two-dimensional family of dyads",
                                           "in general met by a curve of dyads (circle points and centre points)"};
  return fmt::format("poses {} are equal: in effect {}, {}", fmt::join(groups, ", "), counted(different, "pose"),
                     family[different]);
}

}  // namespace burmester
