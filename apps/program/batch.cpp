#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <istream>
#include <memory>
#include <ostream>
#include <thread>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/json_text.hpp"
#include "burmester/modules/framework/problem_io.hpp"
#include "burmester/modules/framework/result_io.hpp"
#include "program/commands.hpp"
#include "program/ordered_map.hpp"

namespace burmester {
namespace {

struct Request {
  std::string geometry;
  int threads = 0;
};

struct Reply {
  int code = answered;
  std::string line;
  std::string warnings;
};

Reply failure(int code, std::size_t number, std::string message) {
  const std::string place = fmt::format("line {}", number), twice = place + ": line 1";  // a line is its only one
  if (message.starts_with(twice)) message = place + message.substr(twice.size());
  return {code, json_line({{"status", "error"}, {"message", message}, {"line", number}}), ""};
}

Reply answer_line(const std::string& line, std::size_t number, const Request& request,
                  const Registry& registry) {
  ReadOptions options{.file = fmt::format("line {}", number), .geometry = {}, .csv = false};
  if (!request.geometry.empty()) options.geometry = request.geometry;
  const Problem problem = read_problem(line, registry, options);
  const Module& module = *registry.find(problem.geometry);
  const Synthesis answer = listed(module.synthesize(problem), problem.types);
  const nlohmann::ordered_json document = result_document(module, problem, answer, {.curves = false});
  Reply reply{answered, json_line(document), ""};
  for (const auto& warning : document["warnings"])
    reply.warnings +=
        fmt::format("{}: warning: {}\n", options.file, printable(warning.get<std::string>(), 500));
  return reply;
}

Reply reply_to(const std::string& line, std::size_t number, const Request& request,
               const Registry& registry) {
  const std::string place = fmt::format("line {}: ", number);
  try {
    return answer_line(line, number, request, registry);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return failure(bad_input, number, what.starts_with("line ") ? what : place + what);
  } catch (const NotAvailable& error) {
    return failure(not_available, number, place + "not available yet: " + error.what());
  } catch (const std::exception& error) {
    return failure(internal_failure, number, place + "internal failure: " + error.what());
  }
}

struct Tally {
  std::size_t lines = 0, bad = 0, missing = 0, failed = 0;

  void add(int code) {
    ++lines;
    bad += code == bad_input;
    missing += code == not_available;
    failed += code == internal_failure;
  }
  int code() const {
    return failed ? internal_failure : bad ? bad_input : missing ? not_available : answered;
  }
  std::string text() const {
    std::string out;
    if (failed) out += fmt::format("burmester: internal failure: {} of {} lines\n", failed, lines);
    if (bad)
      out += fmt::format(
          "burmester batch: expected a problem on every line, got bad input on {} of {} lines\n", bad, lines);
    if (missing) out += fmt::format("not available yet: {} of {} lines\n", missing, lines);
    return out;
  }
};

void check_geometry(const Request& request, const Registry& registry) {
  if (request.geometry.empty() || registry.find(request.geometry)) return;
  std::vector<std::string> known;
  for (const Module* module : registry.modules()) known.push_back(module->info().name);
  throw InputError(fmt::format("burmester batch: --geometry: expected {}, got \"{}\"", one_of(known),
                               printable(request.geometry)));
}

int batch(const Request& request, Program& program) {
  Console& console = program.console;
  check_geometry(request, program.registry);
  Tally tally;
  OrderedMap<std::string, Reply> map(
      [&](std::size_t index, const std::string& line) {
        return reply_to(line, index + 1, request, program.registry);
      },
      [&](const Reply& reply) {
        tally.add(reply.code);
        console.err << reply.warnings << std::flush;
        emit(console.out, reply.line + "\n");
      });
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  try {
    map.run(request.threads > 0 ? request.threads : cores, [&]() -> std::optional<std::string> {
      std::string line;
      return std::getline(console.in, line) ? std::optional(line) : std::nullopt;
    });
  } catch (const ReaderGone&) {  // what was asked for is out
  }
  console.err << tally.text() << std::flush;
  return tally.code();
}

}  // namespace

void add_batch(CLI::App& app, Program& program) {
  CLI::App* const command =
      app.add_subcommand("batch", "One problem per line in, one result per line out, same order");
  const auto request = std::make_shared<Request>();
  command->add_option("--geometry", request->geometry, "Geometry of problems that name none")->type_name("G");
  command->add_option("-j", request->threads, "Threads; 0, the default: one for each core")
      ->type_name("N")
      ->check(CLI::Range(0, 256));
  add_plugin_option(*command);
  command->footer(
      "Reads JSON problems from standard input, writes results (without curves and samples) to standard output, each "
      "as soon\n"
      "as those before it are out. Every line gets its line: one that cannot be answered, a blank one too, "
      "gives\n"
      "{\"status\": \"error\", \"message\": ..., \"line\": number}, the rest goes on, and the exit code is 2 "
      "(4 if all such\n"
      "lines ask for what this version cannot answer yet).");
  command->callback(
      [&program, request] { program.job = [&program, request] { return batch(*request, program); }; });
}

}  // namespace burmester
