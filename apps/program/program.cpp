#include <algorithm>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "burmester/modules/framework/input.hpp"
#include "program/application.hpp"
#include "program/commands.hpp"

namespace burmester {
namespace {

std::vector<std::string> command_names(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// The command line parser would call a wrong command an unexpected argument.
void check_command(CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> names = command_names(app);
  if (arguments.empty())
    throw InputError(fmt::format("burmester: expected a command, {} (burmester --help)", one_of(names)));
  const std::string& first = arguments.front();
  if (first.starts_with('-') || std::find(names.begin(), names.end(), first) != names.end()) return;
  throw InputError(
      fmt::format("burmester: expected a command, {}, got \"{}\"", one_of(names), printable(first)));
}

}  // namespace

int run_program(const std::vector<std::string>& arguments, const Registry& registry, Console& console) {
  return guarded("burmester", console, [&] {
    CLI::App app("Every linkage that guides a rigid body through given poses.", "burmester");
    app.set_version_flag("--version", "burmester " BURMESTER_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 answered, 1 reproduce found a difference, 2 bad usage or input, 3 internal failure,\n"
        "4 not available in this version. COMMAND --help tells more.");
    Program program{registry, console, {}};
    add_synthesize(app, program);
    add_batch(app, program);
    add_modules(app, program);
    add_planned(app, program);
    check_command(app, arguments);
    return run_application(app, arguments, console, [&] { return program.job(); });
  });
}

}  // namespace burmester
