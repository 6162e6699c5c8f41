#include "burmester/modules/framework/curve_report.hpp"

#include <fmt/format.h>

namespace burmester {

std::string description_of(const CurveTopology& t, const CurveWords& words) {
  std::string out = "a curve of dyads: circle points and centre points";
  if (!t.lines.empty())
    out += fmt::format(", split into {} {}{}{}", t.lines.size(), words.line, t.lines.size() == 1 ? "" : "s",
                       t.conics.empty() ? "" : fmt::format(" and a {}", words.conic));
  out += fmt::format(", in {} component{}", t.components, t.components == 1 ? "" : "s");
  if (t.ovals > 0) out += ", one of them an oval";
  return out + ", proved";
}

}  // namespace burmester
