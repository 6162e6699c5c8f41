#include "research/semigraphical/command.hpp"

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <vector>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/json_text.hpp"
#include "burmester/modules/framework/problem_io.hpp"
#include "burmester/modules/framework/result_io.hpp"
#include "burmester/spherical/pose_format.hpp"
#include "program/application.hpp"
#include "program/output_folder.hpp"
#include "report/svg.hpp"
#include "research/semigraphical/plot.hpp"

namespace burmester {
namespace {

using json = nlohmann::ordered_json;
using spherical::Axis;
using spherical::AxisPlot;
using spherical::SemigraphicalAnswer;
using Design = spherical::RR::Design;

struct Request {
  std::string problem, folder;
  bool as_json = false;
  int cells = 180;
};

/// Axes nearer than this, radians, are one axis: far above the errors of either method, far below the distance of
/// dyads that the plots can tell apart.
constexpr double same_axis = 1e-6;

double axis_distance(const Axis& a, const std::vector<double>& b) {
  const Axis v(b[0], b[1], b[2]);
  return std::atan2(a.cross(v).norm(), std::abs(a.dot(v)));
}

/// Raw estimates, longitude and latitude: the crossings that are refined to this axis.
using ReadOff = std::vector<std::array<double, 2>>;
ReadOff read_off_at(const AxisPlot& plot, const Axis& axis) {
  ReadOff out;
  for (const auto& c : plot.crossings)
    if (c.accepted() && axis_distance(axis, {c.axis[0], c.axis[1], c.axis[2]}) < same_axis) out.push_back(c.read_off);
  return out;
}
/// How far the worst of them is from the axis, radians.
double error_of(const ReadOff& estimates, const Axis& axis) {
  double out = 0;
  for (const auto& [longitude, latitude] : estimates) {
    const Axis e = spherical::axis_at(longitude, latitude);
    out = std::max(out, axis_distance(axis, {e[0], e[1], e[2]}));
  }
  return out;
}

/// A dyad of the semigraphical method and the algebraic one that it is.
struct Pairing {
  Design dyad;
  ReadOff moving, fixed;
  int algebraic = 0;  ///< id, 0 where there is none
  double apart = 0;   ///< radians, of the axes that differ most
  double read_off_error() const { return std::max(error_of(moving, dyad.moving), error_of(fixed, dyad.fixed)); }
};

/// All that the two plots show, those of the plot of moving axes first.
std::vector<Pairing> paired(const SemigraphicalAnswer& answer, const Synthesis& algebraic) {
  std::vector<Pairing> out;
  const auto add = [&](const Design& d) {
    for (const Pairing& p : out)
      if (std::abs(p.dyad.moving.dot(d.moving)) > 1 - 1e-12 && std::abs(p.dyad.fixed.dot(d.fixed)) > 1 - 1e-12) return;
    Pairing pairing{d, read_off_at(answer.moving, d.moving), read_off_at(answer.fixed, d.fixed), 0, 0};
    for (const DyadRecord& r : algebraic.dyads) {
      const double apart = std::max(axis_distance(d.moving, r.moving), axis_distance(d.fixed, r.fixed));
      if (apart < (pairing.algebraic ? pairing.apart : same_axis)) pairing.algebraic = r.id, pairing.apart = apart;
    }
    out.push_back(pairing);
  };
  for (const Design& d : answer.dyads) add(d);
  for (const Design& d : answer.from_fixed) add(d);
  return out;
}

/// Ids of algebraic dyads that no pairing has.
std::vector<int> missed(const std::vector<Pairing>& pairings, const Synthesis& algebraic) {
  std::vector<int> out;
  for (const DyadRecord& r : algebraic.dyads)
    if (std::none_of(pairings.begin(), pairings.end(), [&](const Pairing& p) { return p.algebraic == r.id; }))
      out.push_back(r.id);
  return out;
}

json spurious_of(const AxisPlot& plot, const char* name, const Units& units) {
  json out = json::array();
  for (const auto& c : plot.crossings)
    if (!c.accepted())
      out.push_back({{"plot", name},
                     {"curves", c.curves},
                     {"longitude", shown_angle(c.read_off[0], units)},
                     {"latitude", shown_angle(c.read_off[1], units)},
                     {"rank_ratio", c.rank_ratio}});
  return out;
}

json shown(ReadOff estimates, const Units& units) {
  for (auto& e : estimates) e = {shown_angle(e[0], units), shown_angle(e[1], units)};
  return estimates;
}

json document(const Problem& problem, const SemigraphicalAnswer& answer, const std::vector<Pairing>& pairings,
              const Synthesis& algebraic) {
  json dyads = json::array(), spurious = spurious_of(answer.moving, "moving", problem.units);
  const auto raw = [&](const ReadOff& estimates) { return shown(estimates, problem.units); };
  for (const Pairing& p : pairings) {
    const DyadRecord d = spherical::RR::record(p.dyad);
    dyads.push_back({{"fixed", d.fixed},
                     {"moving", d.moving},
                     {"arc", shown_angle(*d.arc, problem.units)},
                     {"crossings", {{"moving", p.moving.size()}, {"fixed", p.fixed.size()}}},
                     {"read_off", {{"moving", raw(p.moving)}, {"fixed", raw(p.fixed)}}},
                     {"algebraic", p.algebraic ? json(p.algebraic) : json()},
                     {"apart", p.algebraic ? json(shown_angle(p.apart, problem.units)) : json()}});
  }
  for (json& c : spurious_of(answer.fixed, "fixed", problem.units)) spurious.push_back(std::move(c));
  return {{"schema", "burmester/semigraphical/1"},
          {"units", {{"angle", problem.units.degrees ? "deg" : "rad"}}},
          {"degenerate", answer.degenerate},
          {"dyads", dyads},
          {"spurious", spurious},
          {"missed", missed(pairings, algebraic)},
          {"algebraic", algebraic.message}};
}

std::string plot_line(const AxisPlot& plot, const char* name, std::size_t axes) {
  const auto accepted =
      std::count_if(plot.crossings.begin(), plot.crossings.end(), [](const auto& c) { return c.accepted(); });
  return fmt::format(
      "{} axes: {} crossings of two curves read off; {} of them at the {} axes of rank 2, {} spurious (rank 3)\n", name,
      plot.crossings.size(), accepted, axes, plot.crossings.size() - static_cast<std::size_t>(accepted));
}

std::string text(const Problem& problem, const SemigraphicalAnswer& answer, const std::vector<Pairing>& pairings,
                 const Synthesis& algebraic) {
  std::string out = problem.name.empty() ? "" : printable(problem.name, 98) + "\n";
  const std::string unit = problem.units.degrees ? "deg" : "rad";
  out += fmt::format("semigraphical, 5 orientations; angles in {}\nalgebraic answer: {}\n", unit, algebraic.message);
  if (answer.degenerate)
    return out + "A minor vanishes all over the sphere: there are no curves to plot, and no crossings to read off.\n";
  out += "\n" + plot_line(answer.moving, "moving", answer.dyads.size()) +
         plot_line(answer.fixed, "fixed ", answer.from_fixed.size());
  if (!pairings.empty())
    out += fmt::format("\n  {:>20}  {:>20}  {:>9}  {:>9}  {:>12}  {:>9}  {:>8}\n", "moving axis", "fixed axis", "arc",
                       "crossings", "read off to", "algebraic", "apart");
  const auto place = [&](const std::vector<double>& v) {
    const auto at = spherical::longitude_latitude({v[0], v[1], v[2]});
    return fmt::format("({:.4f}, {:.4f})", shown_angle(at[0], problem.units), shown_angle(at[1], problem.units));
  };
  for (const Pairing& p : pairings) {
    const DyadRecord d = spherical::RR::record(p.dyad);
    out += fmt::format("  {:>20}  {:>20}  {:>9.5f}  {:>9}  {:>12.1e}  {:>9}  {:>8}\n", place(d.moving), place(d.fixed),
                       shown_angle(*d.arc, problem.units), fmt::format("{} + {}", p.moving.size(), p.fixed.size()),
                       shown_angle(p.read_off_error(), problem.units),
                       p.algebraic ? fmt::format("dyad {}", p.algebraic) : "none",
                       p.algebraic ? fmt::format("{:.1e}", shown_angle(p.apart, problem.units)) : "");
  }
  if (!pairings.empty())
    out += "Axes as (longitude, latitude) in the half sphere of longitudes up to a quarter turn.\n";
  for (const int id : missed(pairings, algebraic))
    out += fmt::format("The plots do not show dyad {} of the algebraic answer.\n", id);
  return out;
}

int semigraphical(const Request& request, const Registry& registry, Console& console) {
  const std::string name = shown_name(request.problem);
  const Problem problem =
      read_problem(read_text(request.problem, console), registry, {.file = name, .geometry = "spherical"});
  if (problem.geometry != "spherical")
    throw InputError(fmt::format("{}: geometry: expected spherical, got \"{}\"", name, printable(problem.geometry)));
  if (problem.poses.size() != 5)
    throw InputError(fmt::format("{}: poses: expected 5 orientations, got {}", name, problem.poses.size()));
  std::optional<OutputFolder> folder;
  if (!request.folder.empty()) folder.emplace(request.folder);

  const Synthesis algebraic = listed(answer_of(*registry.find("spherical"), problem, name), {});
  const SemigraphicalAnswer answer = spherical::semigraphical(spherical::poses_of(problem), request.cells);
  const std::vector<Pairing> pairings = paired(answer, algebraic);
  const std::string as_json = json_text(document(problem, answer, pairings, algebraic));
  if (folder) {
    folder->write("moving_axes.svg", semigraphical_plot(answer.moving, true, algebraic.dyads, problem.name));
    folder->write("fixed_axes.svg", semigraphical_plot(answer.fixed, false, algebraic.dyads, problem.name));
    folder->write("semigraphical.json", as_json);
    for (const char* file : {"moving_axes.svg", "fixed_axes.svg", "semigraphical.json"})
      console.err << "wrote " << printable(folder->path(file), 500) << '\n' << std::flush;
  }
  emit(console.out, request.as_json ? as_json : text(problem, answer, pairings, algebraic));
  return answered;
}

}  // namespace

int run_semigraphical(const std::vector<std::string>& arguments, const Registry& registry, Console& console) {
  return guarded("burmester-semigraphical", console, [&] {
    CLI::App app("Five orientations by the semigraphical method, side by side with the algebraic answer.",
                 "burmester-semigraphical");
    Request request;
    app.set_version_flag("--version", "burmester " BURMESTER_VERSION);
    app.add_option("problem", request.problem, "File with five orientations, JSON or CSV; - for standard input")
        ->type_name("PROBLEM")
        ->required();
    app.add_option("-o", request.folder,
                   "Write moving_axes.svg, fixed_axes.svg and semigraphical.json into this folder")
        ->type_name("DIR");
    app.add_flag("--json", request.as_json, "Print one JSON document instead of the table");
    app.add_option("--cells", request.cells, "Cells of the plots' grid in each direction")
        ->type_name("N")
        ->check(CLI::Range(10, 2000))
        ->capture_default_str();
    app.footer("Exit codes: 0 answered, 2 bad usage or input, 3 internal failure, 4 not available in this version.");
    return run_application(app, arguments, console, [&] { return semigraphical(request, registry, console); });
  });
}

}  // namespace burmester
