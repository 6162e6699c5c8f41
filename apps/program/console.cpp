#include "program/console.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <ostream>

#include <fmt/format.h>

#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

constexpr std::size_t largest_input = std::size_t{256} << 20;

std::string read_all(std::istream& in, const std::string& name) {
  std::string text;
  char block[1 << 16];
  while (in.read(block, sizeof block), in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_input)
      throw InputError(fmt::format("{}: expected at most 256 MiB, got more", name));
  }
  if (in.bad())
    throw InputError(
        fmt::format("{}: expected a readable file, got an error ({})", name, std::strerror(errno)));
  return text;
}

}  // namespace

void emit(std::ostream& out, std::string_view text) {
  errno = 0;
  out.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
  if (out) return;
  if (errno == EPIPE) throw ReaderGone();
  throw OutputError(
      fmt::format("standard output cannot be written ({})", errno ? std::strerror(errno) : "unknown reason"));
}

std::string read_text(const std::string& path, Console& console) {
  const std::string name = shown_name(path);
  if (path == "-") return read_all(console.in, name);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(fmt::format("{}: expected a file, got a directory", name));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InputError(fmt::format("{}: expected a readable file, got none ({})", name, std::strerror(errno)));
  return read_all(file, name);
}

std::string shown_name(const std::string& path) {
  return path == "-" ? "standard input" : printable(path, 200);
}

}  // namespace burmester
