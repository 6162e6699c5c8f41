#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <memory>

#include "burmester/modules/framework/json_text.hpp"
#include "program/commands.hpp"

namespace burmester {
namespace {

using json = nlohmann::ordered_json;

std::string as_json(const Registry& registry) {
  json list = json::array();
  for (const Module* module : registry.modules()) {
    const ModuleInfo& info = module->info();
    json solvers = json::array();
    for (const SolverInfo& solver : info.solvers)
      solvers.push_back({{"name", solver.name}, {"answers", solver.answers}});
    list.push_back({{"name", info.name},
                    {"origin", info.origin},
                    {"dyad_types", info.dyad_types},
                    {"solvers", solvers},
                    {"csv_headers", info.csv_headers}});
  }
  return json_text({{"modules", list}});
}

std::string as_text(const Registry& registry) {
  std::string out;
  for (const Module* module : registry.modules()) {
    const ModuleInfo& info = module->info();
    out +=
        fmt::format("{}  ({})\n  dyad types  {}\n", info.name, info.origin, fmt::join(info.dyad_types, ", "));
    const char* title = "solvers";
    for (const SolverInfo& solver : info.solvers) {
      out += fmt::format("  {:<10}  {}: {}\n", title, solver.name, solver.answers);
      title = "";
    }
    title = "CSV header";
    for (const auto& header : info.csv_headers) {
      out += fmt::format("  {:<10}  {}\n", title, fmt::join(header, ","));
      title = "";
    }
  }
  return out;
}

}  // namespace

void add_modules(CLI::App& app, Program& program) {
  CLI::App* const command =
      app.add_subcommand("modules", "Geometries, dyad types, solvers, where they come from");
  const auto json_asked = std::make_shared<bool>(false);
  command->add_flag("--json", *json_asked, "One JSON document instead of text");
  add_plugin_option(*command);
  command->callback([&program, json_asked] {
    program.job = [&program, json_asked] {
      emit(program.console.out, *json_asked ? as_json(program.registry) : as_text(program.registry));
      return static_cast<int>(answered);
    };
  });
}

}  // namespace burmester
