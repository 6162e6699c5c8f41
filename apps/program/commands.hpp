// The commands. Each adds itself to the command line; the one that is called puts what it has to do into
// `job`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burmester/modules/framework/registry.hpp"
#include "program/console.hpp"

namespace CLI {
class App;
}

namespace burmester {

struct Program {
  const Registry& registry;
  Console& console;
  std::function<int()> job;  ///< returns the exit code
};

void add_synthesize(CLI::App& app, Program& program);
void add_batch(CLI::App& app, Program& program);
void add_modules(CLI::App& app, Program& program);
/// Commands that are planned: analyze, platform, export, reproduce.
void add_planned(CLI::App& app, Program& program);

/// `--plugin LIB`, which every command takes; using it is not available yet.
void add_plugin_option(CLI::App& command);

/// The whole program on the given arguments (without its own name).
int run_program(const std::vector<std::string>& arguments, const Registry& registry, Console& console);

}  // namespace burmester
