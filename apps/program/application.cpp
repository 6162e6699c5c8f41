#include "program/application.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <new>
#include <ostream>
#include <sstream>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/problem.hpp"

namespace burmester {
namespace {

int complain(Console& console, int code, const std::string& line) {
  console.err << printable(line, 1000) << '\n' << std::flush;
  return code;
}

}  // namespace

void prepare_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) _exit(3);
  std::signal(SIGPIPE, SIG_IGN);  // writing reports it
}

int guarded(const std::string& name, Console& console, const std::function<int()>& work) {
  try {
    return work();
  } catch (const InputError& error) {
    return complain(console, bad_input, error.what());
  } catch (const NotAvailable& error) {
    return complain(console, not_available, std::string("not available yet: ") + error.what());
  } catch (const ReaderGone&) {
    return answered;
  } catch (const std::bad_alloc&) {
    return complain(console, internal_failure, name + ": internal failure: out of memory");
  } catch (const std::exception& error) {
    return complain(console, internal_failure, name + ": internal failure: " + error.what());
  } catch (...) {
    return complain(console, internal_failure, name + ": internal failure of unknown kind");
  }
}

Synthesis answer_of(const Module& module, const Problem& problem, const std::string& file) {
  try {
    return module.synthesize(problem);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

int run_application(CLI::App& app, std::vector<std::string> arguments, Console& console,
                    const std::function<int()>& job) {
  try {
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
  } catch (const CLI::Success& help_or_version) {
    std::ostringstream text;
    app.exit(help_or_version, text, text);
    emit(console.out, text.str() + (text.str().ends_with('\n') ? "" : "\n"));
    return answered;
  } catch (const CLI::ParseError& error) {
    const auto called = app.get_subcommands();
    const std::string name = app.get_name() + (called.empty() ? "" : " " + called.front()->get_name());
    throw InputError(fmt::format("{}: {} (expected: see {} --help)", name, error.what(), name));
  }
  return job();
}

}  // namespace burmester
