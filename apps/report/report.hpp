// The report: one HTML file with style, script and data in it.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// A drawing as the page reads it: {"poses": [..], "linkages": [..], "spheres": [..]}, coordinates rounded to
/// a millionth of the figure.
nlohmann::ordered_json drawing_document(const Drawing& drawing);

/// `result`: the result document.
std::string report_page(const nlohmann::ordered_json& result, const Drawing& drawing);

}  // namespace burmester
