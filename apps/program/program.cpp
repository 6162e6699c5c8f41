#include <algorithm>
#include <new>
#include <ostream>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "program/commands.hpp"

namespace burmester {
namespace {

int complain(Console& console, int code, const std::string& line) {
  console.err << printable(line, 1000) << '\n' << std::flush;
  return code;
}

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

void parse(CLI::App& app, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());
  app.parse(std::move(arguments));
}

int run_job(CLI::App& app, Program& program, const std::vector<std::string>& arguments) {
  Console& console = program.console;
  try {
    check_command(app, arguments);
    parse(app, arguments);
    return program.job();
  } catch (const CLI::Success& help_or_version) {
    std::ostringstream text;
    app.exit(help_or_version, text, text);
    emit(console.out, text.str() + (text.str().ends_with('\n') ? "" : "\n"));
    return answered;
  } catch (const CLI::ParseError& error) {
    const auto called = app.get_subcommands();
    const std::string name = called.empty() ? "burmester" : "burmester " + called.front()->get_name();
    return complain(console, bad_input,
                    fmt::format("{}: {} (expected: see {} --help)", name, error.what(), name));
  }
}

}  // namespace

int run_program(const std::vector<std::string>& arguments, const Registry& registry, Console& console) {
  try {
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
    return run_job(app, program, arguments);
  } catch (const InputError& error) {
    return complain(console, bad_input, error.what());
  } catch (const NotAvailable& error) {
    return complain(console, not_available, std::string("not available yet: ") + error.what());
  } catch (const ReaderGone&) {
    return answered;
  } catch (const std::bad_alloc&) {
    return complain(console, internal_failure, "burmester: internal failure: out of memory");
  } catch (const std::exception& error) {
    return complain(console, internal_failure, std::string("burmester: internal failure: ") + error.what());
  } catch (...) {
    return complain(console, internal_failure, "burmester: internal failure of unknown kind");
  }
}

}  // namespace burmester
