// Dyads that two given points lead to: pivots that are partners of each other, points with one nearest dyad.
#pragma once

#include <fmt/format.h>

#include <cmath>

#include "burmester/modules/framework/report.hpp"

namespace burmester {

/// Drops dyads that repeat an earlier one, with a warning: of its type, and each pivot within both certified radii and
/// the rounding of residuals there. `points`: what people call what was given. G: a PivotGeometry (given_pivots.hpp).
template <class G>
void drop_repeated(Report<typename G::Dyads>& report, std::span<const typename G::Pose> poses,
                   std::string_view points) {
  const std::vector<DyadRecord> records = records_of(report);
  const auto close = [&](const std::vector<double>& p, const std::vector<double>& q, double radii) {
    double square = 0;
    for (std::size_t i = 0; i < p.size(); ++i) square += (p[i] - q[i]) * (p[i] - q[i]);
    return p.empty() || std::sqrt(square) <= radii + G::rounding(p, poses);
  };
  const auto same = [&](const DyadRecord& a, const DyadRecord& b) {
    const double radii = a.certificate.radius + b.certificate.radius;
    return a.type == b.type && close(a.fixed, b.fixed, radii) && close(a.moving, b.moving, radii);
  };
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < records.size(); ++k)
    if (std::any_of(kept.begin(), kept.end(), [&](std::size_t i) { return same(records[i], records[k]); }))
      report.warnings.push_back(
          fmt::format("two of the given {} lead to the same {} dyad: listed once", points, records[k].type));
    else
      kept.push_back(k);
  decltype(report.dyads) dyads;
  for (const std::size_t k : kept) dyads.push_back(std::move(report.dyads[k]));
  report.dyads = std::move(dyads);
}

}  // namespace burmester
