// Writing answers: documents of schema burmester/result/1.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "burmester/modules/framework/module.hpp"

namespace burmester {

/// An answer as it is listed: dyads sorted by type (RR, PR, RP, PP) and then length and numbered from 1, then
/// only the dyads and samples of the given types (none given: all) and the linkages among them, with the numbers they
/// have in the full list. The counts stay those of the full answer; a warning where no sample is left.
Synthesis listed(Synthesis answer, const std::vector<std::string>& types);

struct ResultOptions {
  bool curves = true;  ///< and the samples of families: batch lines go without
};

/// The whole document. Angles are in the problem's unit; the warnings are the problem's and the answer's.
nlohmann::ordered_json result_document(const Module& module, const Problem& problem, const Synthesis& answer,
                                       const ResultOptions& options = {});

/// A direction in radians, as shown: [0, 180) degrees or [0, pi) radians.
double shown_direction(double angle, const Units& units);
/// An angle in radians, as shown.
double shown_angle(double angle, const Units& units);

}  // namespace burmester
