// The JSON parser behind InputDocument.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace burmester {

/// Throws InputError for anything that is not JSON, and for keys given twice, numbers beyond the range of a
/// double and values nested deeper than 100 levels.
nlohmann::json parse_json(std::string_view text, const std::string& file);

}  // namespace burmester
