#include "burmester/modules/framework/json_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace burmester {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t line_length = 110;

std::string quoted(const std::string& text) {
  return ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string scalar(const ordered_json& value) {
  if (value.is_string()) return quoted(value.get_ref<const std::string&>());
  if (value.is_number_float()) return number_text(value.get<double>());
  return value.dump();
}

/// One line, given up (and cut short) once it is longer than `limit`.
void write_line(const ordered_json& value, std::size_t limit, std::string& out) {
  if (!value.is_structured()) {
    out += scalar(value);
    return;
  }
  const bool object = value.is_object();
  const char* separator = "";
  out += object ? '{' : '[';
  for (const auto& item : value.items()) {
    if (out.size() > limit) return;
    out += separator;
    if (object) out += quoted(item.key()) + ": ";
    write_line(item.value(), limit, out);
    separator = ", ";
  }
  out += object ? '}' : ']';
}

void write_indented(const ordered_json& value, std::size_t depth, std::size_t used, std::string& out) {
  std::string line;
  write_line(value, line_length, line);
  if (depth > 0 && used + line.size() <= line_length) {
    out += line;
    return;
  }
  if (!value.is_structured() || value.empty()) {
    out += line;
    return;
  }
  const bool object = value.is_object();
  const std::string margin(2 * depth + 2, ' ');
  const char* separator = "\n";
  out += object ? '{' : '[';
  for (const auto& item : value.items()) {
    const std::string key = object ? quoted(item.key()) + ": " : "";
    out += separator + margin + key;
    write_indented(item.value(), depth + 1, margin.size() + key.size() + 1, out);
    separator = ",\n";
  }
  out += fmt::format("\n{:{}}{}", "", 2 * depth, object ? '}' : ']');
}

}  // namespace

std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  return value == 0 ? "0" : fmt::format("{}", value);
}

std::string json_line(const ordered_json& value) {
  std::string out;
  write_line(value, std::string::npos, out);
  return out;
}

std::string json_text(const ordered_json& value) {
  std::string out;
  write_indented(value, 0, 0, out);
  return out + "\n";
}

}  // namespace burmester
