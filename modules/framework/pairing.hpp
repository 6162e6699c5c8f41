// Pairs of dyads that close a linkage: what every geometry with P/R dyads does the same way.
//
// Two dyads that share a pivot guide no body. With one moving pivot for both the body is free to turn about it; with
// one fixed pivot it sees that pivot in one of two places and turns with both links about it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "burmester/modules/dyads/dyad_name.hpp"
#include "burmester/modules/framework/record.hpp"
#include "burmester/modules/framework/report.hpp"

namespace burmester {

/// Whether pivots of two found dyads, this far apart, may be one: within both certified radii and what rounding does to
/// a given pivot and to the distance.
template <class AnyDyad>
bool may_be_one(const std::optional<double>& apart, const AnyDyad& a, const AnyDyad& b, double rounding = 0) {
  for (const AnyDyad* d : {&a, &b})
    if (d->certificate.certified) rounding += d->certificate.radius;
  return apart && *apart <= rounding;
}

/// All pairs that make a linkage, numbered from 1; dyad ids are places in `dyads`, from 1. `link(a, b, type)` makes the
/// record of two found dyads in the order of the linkage's type; nothing where they share a pivot. List: the module's
/// DyadList.
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
      std::optional<LinkageRecord> l = link(dyads[first], dyads[second], linkage_type(name(first), name(second)));
      if (!l) continue;
      l->id = static_cast<int>(out.size()) + 1;
      l->dyads[0] = static_cast<int>(first) + 1, l->dyads[1] = static_cast<int>(second) + 1;
      out.push_back(std::move(*l));
    }
  return out;
}

}  // namespace burmester
