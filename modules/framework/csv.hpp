// Tables of numbers with a header line, commas between the values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace burmester {

struct CsvLine {
  std::size_t line = 0;  ///< counted from 1
  std::vector<std::string> fields;
};

struct CsvTable {
  std::size_t header_line = 0;
  std::vector<std::string> header;
  std::vector<CsvLine> lines;  ///< blank lines are left out
};

struct CsvRow {
  std::size_t line = 0;
  std::vector<double> values;
};

/// Fields lose the spaces around them; lines may end in CR LF. Throws InputError where there is no header.
CsvTable read_csv_table(std::string_view text, const std::string& file);

/// Throws InputError for a line that is not one finite number for each column.
std::vector<CsvRow> csv_numbers(const CsvTable& table, const std::string& file);

}  // namespace burmester
