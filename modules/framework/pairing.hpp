// Pairs of dyads that close a linkage: what every geometry with P/R dyads does the same way.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "burmester/modules/dyads/dyad_name.hpp"
#include "burmester/modules/framework/record.hpp"
#include "burmester/modules/framework/report.hpp"

namespace burmester {

/// All pairs that make a linkage, numbered from 1; dyad ids are places in `dyads`, from 1. `link(a, b, type)` makes the
/// record of two found dyads in the order of the linkage's type. List: the module's DyadList.
template <class List, class Link>
std::vector<LinkageRecord> paired_linkages(const std::vector<Found<typename List::Design>>& dyads, Link link) {
  const auto name = [&](std::size_t i) {
    return List::visit(dyads[i].design, []<class D>(const typename D::Design&) { return std::string_view(D::name); });
  };
  std::vector<LinkageRecord> out;
  for (std::size_t i = 0; i < dyads.size(); ++i)
    for (std::size_t j = i + 1; j < dyads.size(); ++j) {
      if (!pairs(name(i), name(j))) continue;
      const bool ordered = type_rank(name(i)) <= type_rank(name(j));
      const std::size_t first = ordered ? i : j, second = ordered ? j : i;
      LinkageRecord l = link(dyads[first], dyads[second], linkage_type(name(first), name(second)));
      l.id = static_cast<int>(out.size()) + 1;
      l.dyads[0] = static_cast<int>(first) + 1, l.dyads[1] = static_cast<int>(second) + 1;
      out.push_back(std::move(l));
    }
  return out;
}

}  // namespace burmester
