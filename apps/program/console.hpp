// What the commands share: streams, exit codes, and reading and writing with clear failures.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>

namespace burmester {

struct Console {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
};

enum ExitCode { answered = 0, differs = 1, bad_input = 2, internal_failure = 3, not_available = 4 };

/// Standard output could not be written: exit code 3.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whoever read standard output has enough (`burmester .. | head`): no failure.
class ReaderGone : public std::exception {};

/// Writes and flushes. Throws OutputError or ReaderGone.
void emit(std::ostream& out, std::string_view text);

/// A whole file, "-" for the console's input. Throws InputError.
std::string read_text(const std::string& path, Console& console);

/// What messages call that file.
std::string shown_name(const std::string& path);

}  // namespace burmester
