#include "burmester/modules/framework/curve_report.hpp"

#include <fmt/format.h>

#include "burmester/modules/framework/counted.hpp"

namespace burmester {

std::string description_of(const CurveTopology& t, const CurveWords& words) {
  std::string out = "a curve of dyads: circle points and centre points";
  if (!t.lines.empty())
    out += fmt::format(", split into {}{}", counted(t.lines.size(), words.line),
                       t.conics.empty() ? "" : fmt::format(" and a {}", words.conic));
  out += ", in " + counted(t.components, "component");
  if (t.ovals > 0) out += ", one of them an oval";
  return out + ", proved";
}

}  // namespace burmester
