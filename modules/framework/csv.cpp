#include "burmester/modules/framework/csv.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t from = text.find_first_not_of(blank);
  return from == text.npos ? "" : text.substr(from, text.find_last_not_of(blank) - from + 1);
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t comma; (comma = line.find(',')) != line.npos; line.remove_prefix(comma + 1))
    fields.emplace_back(trimmed(line.substr(0, comma)));
  fields.emplace_back(trimmed(line));
  return fields;
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

CsvTable read_csv_table(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  CsvTable table;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t newline = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, newline));
    text.remove_prefix(newline == text.npos ? text.size() : newline + 1);
    if (line.empty()) continue;
    if (table.header_line != 0) {
      table.lines.push_back({number, fields_of(line)});
    } else {
      table.header_line = number;
      table.header = fields_of(line);
    }
  }
  if (table.header_line == 0)
    throw InputError(fmt::format("{}: line 1: expected a CSV header line, got nothing", file));
  return table;
}

std::vector<CsvRow> csv_numbers(const CsvTable& table, const std::string& file) {
  std::vector<CsvRow> rows;
  for (const CsvLine& line : table.lines) {
    if (line.fields.size() != table.header.size())
      throw InputError(fmt::format("{}: line {}: expected {} values, got {}", file, line.line,
                                   table.header.size(), line.fields.size()));
    CsvRow row{line.line, {}};
    for (std::size_t i = 0; i < line.fields.size(); ++i) {
      const std::optional<double> value = finite_number(line.fields[i]);
      if (!value)
        throw InputError(fmt::format("{}: line {}, column {}: expected a finite number, got \"{}\"", file,
                                     line.line, table.header[i], printable(line.fields[i])));
      row.values.push_back(*value);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace burmester
