// What the program and the research apps share: how they ask a module, and how they end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burmester/modules/framework/module.hpp"
#include "program/console.hpp"

namespace CLI {
class App;
}

namespace burmester {

/// A closed standard stream would lend its number to the next file that is opened: output would end up in that file.
/// And a reader that leaves shall be noticed when writing. To be called first.
void prepare_standard_streams();

/// Runs the work of an application. What it throws becomes one line on the console's error stream and an exit code.
int guarded(const std::string& name, Console& console, const std::function<int()>& work);

/// The module's answer. Modules do not know the file; its name is put before what they complain of.
Synthesis answer_of(const Module& module, const Problem& problem, const std::string& file);

/// Parses the arguments (without the application's own name), then runs the job. Help and version are printed; throws
/// InputError for bad usage.
int run_application(CLI::App& app, std::vector<std::string> arguments, Console& console,
                    const std::function<int()>& job);

}  // namespace burmester
