#include <CLI/App.hpp>

#include "burmester/modules/framework/problem.hpp"
#include "program/commands.hpp"

namespace burmester {
namespace {

void add(CLI::App& app, Program& program, const std::string& name, const std::string& description) {
  CLI::App* const command = app.add_subcommand(name, description + " (not available yet)");
  command->allow_extras();
  add_plugin_option(*command);
  command->callback(
      [&program, name] { program.job = [name]() -> int { throw NotAvailable("burmester " + name); }; });
}

}  // namespace

void add_planned(CLI::App& app, Program& program) {
  add(app, program, "analyze", "One linkage: circuits, branches, transmission, coupler curve");
  add(app, program, "platform", "Assembly modes of a three-legged platform");
  add(app, program, "export", "One linkage as DXF, SVG, CSV, MJCF or SDF");
  add(app, program, "reproduce", "Published examples: printed value, ours, difference");
}

void add_plugin_option(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--plugin", [](const std::string&) { throw NotAvailable("--plugin"); },
          "Load a module from a shared library (not available yet)")
      ->type_name("LIB");
}

}  // namespace burmester
