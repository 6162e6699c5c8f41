#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/json_text.hpp"
#include "burmester/modules/framework/problem_io.hpp"
#include "burmester/modules/framework/result_io.hpp"
#include "program/application.hpp"
#include "program/commands.hpp"
#include "program/output_folder.hpp"
#include "program/table.hpp"
#include "report/figure.hpp"
#include "report/plate_figure.hpp"
#include "report/report.hpp"
#include "report/sphere_figure.hpp"
#include "report/surfaces_figure.hpp"
#include "report/svg.hpp"

namespace burmester {
namespace {

struct Request {
  std::string problem, folder;
  std::optional<std::string> types;
  bool as_json = false;
  bool no_certify = false;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else if (c != ' ')
      parts.back() += c;
  }
  return parts;
}

std::vector<std::string> types_of(const std::string& text, const Module& module) {
  try {
    return known_types(module, split(text));
  } catch (const InputError& error) {
    throw InputError(fmt::format("burmester synthesize: --types: {}", error.what()));
  }
}

void write_figures(const OutputFolder& folder, const Problem& problem, const Drawing& drawing) {
  std::map<std::string, std::string> figures;
  const std::string& unit = problem.units.length;
  if (!drawing.poses.empty()) figures["poses.svg"] = poses_figure(drawing, problem.name, unit);
  for (const LinkageDrawing& linkage : drawing.linkages)
    figures[fmt::format("linkage_{}.svg", linkage.id)] = linkage_figure(linkage, drawing, problem.name, unit);
  for (const SphereDrawing& sphere : drawing.spheres)
    figures[sphere.linkage == 0 ? "poses.svg" : fmt::format("linkage_{}.svg", sphere.linkage)] =
        sphere_figure(sphere, problem.name);
  for (const Plate& plate : drawing.plates)
    figures[plate.name + ".svg"] = plate_figure(plate, problem.name, unit);
  for (const SurfaceDrawing& surfaces : drawing.surfaces)
    if (!surfaces.lines.empty())
      figures[fmt::format("surfaces_{}.svg", surfaces.linkage)] = surfaces_figure(surfaces, problem.name);
  for (const Plate& construction : drawing.constructions)
    figures[construction.name + ".svg"] = construction_figure(construction, problem.name, unit);
  std::set<std::string> names;
  for (const auto& [name, text] : figures) {
    folder.write(name, text);
    names.insert(name);
  }
  folder.remove_others(names, figure_mark);
}

void write_folder(const OutputFolder& folder, const Module& module, const Problem& problem,
                  const Synthesis& answer, const nlohmann::ordered_json& document) {
  const Drawing drawing = module.draw(problem, answer);
  folder.write("result.json", json_text(document));
  write_figures(folder, problem, drawing);
  folder.write("report.html", report_page(document, drawing));
}

int synthesize(const Request& request, Program& program) {
  Console& console = program.console;
  const std::string name = shown_name(request.problem);
  Problem problem =
      read_problem(read_text(request.problem, console), program.registry, {.file = name, .geometry = {}});
  const Module& module = *program.registry.find(problem.geometry);
  if (request.types) problem.types = types_of(*request.types, module);
  problem.certify = !request.no_certify;
  std::optional<OutputFolder> folder;
  if (!request.folder.empty()) folder.emplace(request.folder);

  const Synthesis answer = listed(answer_of(module, problem, name), problem.types);
  const nlohmann::ordered_json document = result_document(module, problem, answer);
  if (folder) write_folder(*folder, module, problem, answer, document);
  for (const auto& warning : document["warnings"])
    console.err << fmt::format("{}: warning: {}\n", name, printable(warning.get<std::string>(), 500));
  if (folder) console.err << "wrote " << printable(folder->path("report.html"), 500) << '\n';
  console.err << std::flush;
  emit(console.out,
       request.as_json ? json_text(document) : answer_text(problem, answer, module.task_size(problem)));
  return answered;
}

}  // namespace

void add_synthesize(CLI::App& app, Program& program) {
  CLI::App* const command = app.add_subcommand("synthesize", "All dyads and linkages for the poses");
  const auto request = std::make_shared<Request>();
  command->add_option("problem", request->problem, "File with the problem, JSON or CSV; - for standard input")
      ->type_name("PROBLEM")
      ->required();
  command->add_option("-o", request->folder, "Write report.html, result.json and figures into this folder")
      ->type_name("DIR");
  command->add_flag("--json", request->as_json, "Print the result as one JSON document instead of tables");
  command
      ->add_option("--types", request->types, "List only dyads of these types, e.g. RR,PR (RR, PR, RP, PP)")
      ->type_name("TYPES");
  command->add_flag("--no-certify", request->no_certify,
                    "Leave the certificates out");
  add_plugin_option(*command);
  command->footer(
      "Exit code 0 also where no real dyad exists.\n"
      "Problem: {\"geometry\": \"planar\", \"poses\": [{\"x\": 0, \"y\": 0, \"angle\": 0}, ...]}, or CSV "
      "with the header\n"
      "x,y,angle_deg; burmester modules tells the geometries.");
  command->callback(
      [&program, request] { program.job = [&program, request] { return synthesize(*request, program); }; });
}

}  // namespace burmester
