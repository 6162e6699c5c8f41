#include "burmester/modules/framework/result_io.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

using json = nlohmann::ordered_json;

template <class T>
json value_or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

template <class T>
void put(json& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}

json units_of(const Units& units) {
  json out = json::object();
  if (!units.length.empty()) out["length"] = units.length;
  out["angle"] = units.degrees ? "deg" : "rad";
  return out;
}

json counts_of(const SolutionCounts& counts) {
  json out = {{"dimension", value_or_null(counts.dimension)},
              {"complex", value_or_null(counts.complex)},
              {"real", value_or_null(counts.real)},
              {"certified", counts.certified}};
  put(out, "merge_distance", counts.merge_distance);
  return out;
}

json line_of(const LineRecord& line, const Units& units) {
  return {{"point", line.point}, {"angle", shown_direction(line.angle, units)}};
}

/// Without an id for members of a family, which are not numbered.
json dyad_of(const DyadRecord& dyad, const Units& units, bool numbered = true) {
  json out = json::object();
  if (numbered) out["id"] = dyad.id;
  out["type"] = dyad.type;
  if (!dyad.fixed.empty()) out["fixed"] = dyad.fixed;
  if (!dyad.moving.empty()) out["moving"] = dyad.moving;
  if (dyad.line) out["line"] = line_of(*dyad.line, units);
  put(out, "length", dyad.length);
  if (dyad.arc) out["arc"] = shown_angle(*dyad.arc, units);
  if (dyad.angle) out["angle"] = shown_angle(*dyad.angle, units);
  out["residual"] = dyad.residual;
  if (dyad.condition && std::isfinite(*dyad.condition)) out["condition"] = *dyad.condition;
  put(out, "departure", dyad.departure);
  if (dyad.slider) {
    out["slider"]["type"] = dyad.slider->type;
    if (dyad.slider->line) out["slider"]["line"] = line_of(*dyad.slider->line, units);
    out["slider"]["departure"] = dyad.slider->departure;
  }
  out["certificate"] = {{"certified", dyad.certificate.certified}};
  if (dyad.certificate.certified) out["certificate"]["radius"] = dyad.certificate.radius;
  return out;
}

json links_of(const LinkageRecord& linkage, const Units& units, bool arcs) {
  const auto length = [&](const std::optional<double>& value) {
    return !value ? json(nullptr) : json(arcs ? shown_angle(*value, units) : *value);
  };
  return {{"ground", length(linkage.ground)},
          {"input", length(linkage.input)},
          {"coupler", length(linkage.coupler)},
          {"output", length(linkage.output)}};
}

json linkage_of(const LinkageRecord& linkage, const Units& units, bool arcs) {
  const auto length = [&](double value) { return arcs ? shown_angle(value, units) : value; };
  json out = {{"id", linkage.id},
              {"dyads", {linkage.dyads[0], linkage.dyads[1]}},
              {"type", linkage.type},
              {"class", value_or_null(linkage.motion_class)},
              {"links", links_of(linkage, units, arcs)}};
  if (linkage.offset) out["offset"] = length(*linkage.offset);
  if (linkage.coupler_offset) out["coupler_offset"] = length(*linkage.coupler_offset);
  out["circuit_of_pose"] = nullptr;
  out["drives"] = json::array();
  out["usable"] = nullptr;
  out["verdict"] = fmt::format("{}; circuits, branches and order of poses are not analysed in this version",
                               linkage.motion_class.value_or(linkage.type));
  return out;
}

/// Dyads as in a linkage file: they have no number in this result.
json candidate_of(const CandidateRecord& candidate, std::size_t rank, const Units& units, bool arcs) {
  json dyads = json::array();
  for (const DyadRecord& dyad : candidate.dyads) {
    dyads.push_back(dyad_of(dyad, units));
    dyads.back().erase("id");
    dyads.back().erase("certificate");
  }
  return {{"rank", rank},
          {"type", candidate.linkage.type},
          {"class", value_or_null(candidate.linkage.motion_class)},
          {"dyads", dyads},
          {"links", links_of(candidate.linkage, units, arcs)},
          {"link_ratio", candidate.link_ratio},
          {"one_branch", candidate.one_branch}};
}

/// {x, y, angle}; a name that comes several times in a row is one array: quaternion_wxyz.
json pose_of(const std::vector<std::pair<std::string, double>>& shown) {
  json out = json::object();
  for (std::size_t i = 0; i < shown.size();) {
    std::vector<double> values;
    const std::string& name = shown[i].first;
    for (; i < shown.size() && shown[i].first == name; ++i) values.push_back(shown[i].second);
    out[name] = values.size() == 1 ? json(values[0]) : json(values);
  }
  return out;
}

json curves_of(const std::vector<CurveRecord>& curves) {
  json out = json::array();
  for (const CurveRecord& curve : curves)
    out.push_back({{"component", curve.component + 1},
                   {"closed", curve.closed},
                   {"max_error", curve.max_error},
                   {"moving", curve.moving},
                   {"fixed", curve.fixed}});
  return out;
}

json pole_of(const PoleRecord& pole, const Units& units) {
  json out = {{"poses", {pole.poses[0], pole.poses[1]}}, {"angle", shown_angle(pole.angle, units)}};
  if (pole.far)
    out["line"] = line_of(*pole.far, units);
  else
    out["fixed"] = pole.fixed, out["moving"] = pole.moving;
  return out;
}

json partners_of(const PartnersRecord& partners, const Units& units) {
  json out = json::object();
  if (!partners.fixed.empty()) out["fixed"] = partners.fixed;
  if (!partners.moving.empty()) out["moving"] = partners.moving;
  if (partners.line) out["line"] = line_of(*partners.line, units);
  if (!partners.normal.empty()) out["normal"] = partners.normal;
  return out;
}

/// Keys of their own, where there is something to tell.
void put_family(json& out, const FamilyRecord& family, const Units& units, bool samples) {
  for (const PoleRecord& pole : family.poles) out["poles"].push_back(pole_of(pole, units));
  for (const PartnersRecord& partners : family.partners) out["partners"].push_back(partners_of(partners, units));
  if (!samples) return;
  for (const DyadRecord& dyad : family.samples) out["samples"].push_back(dyad_of(dyad, units, false));
}

int rank_of(const DyadRecord& dyad) {
  constexpr std::string_view order[] = {"RR", "PR", "RP", "PP"};
  return static_cast<int>(std::find(std::begin(order), std::end(order), dyad.type) - std::begin(order));
}

double size_of(const DyadRecord& dyad) { return dyad.length.value_or(dyad.arc.value_or(0)); }

void sort_and_number(Synthesis& answer) {
  std::stable_sort(answer.dyads.begin(), answer.dyads.end(), [](const DyadRecord& a, const DyadRecord& b) {
    return std::pair(rank_of(a), size_of(a)) < std::pair(rank_of(b), size_of(b));
  });
  std::map<int, int> number;
  for (DyadRecord& dyad : answer.dyads) {
    const int old = dyad.id;
    dyad.id = static_cast<int>(number.size()) + 1;
    number[old] = dyad.id;
  }
  for (LinkageRecord& linkage : answer.linkages)
    for (int& dyad : linkage.dyads) dyad = number.at(dyad);
}

/// What JSON has no number for must not pass as "unknown".
void require_finite(const json& value, const std::string& place) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw std::runtime_error(fmt::format("the answer has a number at {} that is not finite", place));
  if (value.is_structured())
    for (const auto& item : value.items())
      require_finite(item.value(), fmt::format("{}/{}", place, item.key()));
}

}  // namespace

Synthesis listed(Synthesis answer, const std::vector<std::string>& types) {
  sort_and_number(answer);
  if (types.empty()) return answer;
  const auto others = [&](const DyadRecord& dyad) {
    return std::find(types.begin(), types.end(), dyad.type) == types.end();
  };
  std::erase_if(answer.dyads, others);
  if (std::erase_if(answer.family.samples, others) > 0 && answer.family.samples.empty())
    answer.warnings.push_back(fmt::format("none of the samples of the family is {}", fmt::join(types, " or ")));
  std::set<int> left;
  for (const DyadRecord& dyad : answer.dyads) left.insert(dyad.id);
  std::erase_if(answer.linkages, [&](const LinkageRecord& linkage) {
    return !left.contains(linkage.dyads[0]) || !left.contains(linkage.dyads[1]);
  });
  return answer;
}

json result_document(const Module& module, const Problem& problem, const Synthesis& answer,
                     const ResultOptions& options) {
  const Units& units = problem.units;
  const bool arcs = std::any_of(answer.dyads.begin(), answer.dyads.end(),
                                [](const DyadRecord& d) { return d.arc.has_value(); });
  json out = {{"schema", "burmester/result/1"}, {"geometry", problem.geometry}};
  if (!problem.name.empty()) out["name"] = problem.name;
  if (!problem.source.empty()) out["source"] = problem.source;
  out["units"] = units_of(units);
  out["pose_count"] = problem.poses.size();
  out["status"] = name_of(answer.status);
  out["message"] = answer.message;
  out["solutions"] = counts_of(answer.counts);
  out["dyads"] = json::array();
  for (const DyadRecord& dyad : answer.dyads) out["dyads"].push_back(dyad_of(dyad, units));
  if (options.curves) out["curves"] = curves_of(answer.curves);
  put_family(out, answer.family, units, options.curves);
  out["linkages"] = json::array();
  for (const LinkageRecord& linkage : answer.linkages)
    out["linkages"].push_back(linkage_of(linkage, units, arcs));
  if (answer.candidates) {
    out["candidates"] = json::array();
    for (const CandidateRecord& candidate : *answer.candidates)
      out["candidates"].push_back(candidate_of(candidate, out["candidates"].size() + 1, units, arcs));
  }
  out["warnings"] = problem.warnings;
  for (const std::string& warning : answer.warnings) out["warnings"].push_back(warning);
  if (!problem.types.empty()) out["types"] = problem.types;
  out["task_size"] = module.task_size(problem);
  out["poses"] = json::array();
  for (const PoseData& pose : problem.poses) out["poses"].push_back(pose_of(module.show_pose(pose, units)));
  require_finite(out, "");
  return out;
}

double shown_angle(double angle, const Units& units) {
  return units.degrees ? angle / std::numbers::pi * 180 : angle;
}

double shown_direction(double angle, const Units& units) {
  const double half_turn = units.degrees ? 180 : std::numbers::pi;
  const double shown = std::fmod(shown_angle(angle, units), half_turn);
  const double positive = shown < 0 ? shown + half_turn : shown;
  return positive < half_turn ? positive : 0;  // also where -1e-20 + 180 rounds to 180
}

}  // namespace burmester
