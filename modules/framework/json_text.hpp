// Writing JSON for people and programs: keys in the order given, numbers as the shortest text that reads back
// as the same double, short arrays and objects on one line.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burmester {

/// Indented, lines up to about 110 columns, a newline at the end.
std::string json_text(const nlohmann::ordered_json& value);

/// All on one line, no newline.
std::string json_line(const nlohmann::ordered_json& value);

/// The shortest text that reads back as the same double; 0 for -0, "null" for what JSON has no number for.
std::string number_text(double value);

}  // namespace burmester
