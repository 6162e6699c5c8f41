#include "program/table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/result_io.hpp"

namespace burmester {
namespace {

/// A line's direction; one that the table's digits would round up to half a turn is shown as 0.
double direction(double angle, const Units& units) {
  const double shown = shown_direction(angle, units), half_turn = shown_direction(std::numbers::pi / 2, units) * 2;
  return half_turn - shown < 1e-6 * half_turn ? 0 : shown;
}

constexpr std::size_t width = 100;

struct Column {
  std::string head;
  bool right = false;
};
using Row = std::vector<std::string>;

std::string number(double value, int digits) {
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}
std::string number(const std::optional<double>& value, int digits) {
  return value ? number(*value, digits) : "";
}

/// How numbers are shown: significant digits, and what counts as 0 in a coordinate.
struct Style {
  int digits = 6;
  double zero = 0;
};

std::string point(const std::vector<double>& values, const Style& style) {
  std::vector<std::string> out;
  for (const double value : values)
    out.push_back(number(std::abs(value) < style.zero ? 0 : value, style.digits));
  return out.empty() ? "" : fmt::format("({})", fmt::join(out, ", "));
}

/// Columns without any entry are left out; missing entries are dashes.
std::vector<std::string> lines_of(const std::vector<Column>& columns, const std::vector<Row>& rows) {
  std::vector<std::string> lines(rows.size() + 1);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::size_t widest = 0;
    for (const Row& row : rows) widest = std::max(widest, row[k].size());
    if (widest == 0) continue;
    widest = std::max(widest, columns[k].head.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string text = i == 0 ? columns[k].head : rows[i - 1][k].empty() ? "-" : rows[i - 1][k];
      lines[i] +=
          columns[k].right ? fmt::format("  {:>{}}", text, widest) : fmt::format("  {:<{}}", text, widest);
    }
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

bool fits(const std::vector<std::string>& lines) {
  return std::all_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.size() <= width; });
}

/// The table with as many digits as fit, 3 at least; after that the last columns have to go.
std::string table(std::vector<Column> columns, const std::function<std::vector<Row>(int)>& rows) {
  std::vector<std::string> lines;
  for (int digits = 6; digits >= 3; --digits) {
    lines = lines_of(columns, rows(digits));
    if (fits(lines)) break;
  }
  for (; !fits(lines) && columns.size() > 5; lines = lines_of(columns, rows(3))) columns.pop_back();
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

std::string line_text(const LineRecord& line, const Units& units, const Style& style) {
  return fmt::format("{} at {} {}", point(line.point, style), number(direction(line.angle, units), style.digits),
                     units.degrees ? "deg" : "rad");
}

std::string reach(const DyadRecord& dyad, const Units& units, const Style& style) {
  const auto angle = [&](double value) {
    return fmt::format("{} {}", number(value, style.digits), units.degrees ? "deg" : "rad");
  };
  const std::string nearly = dyad.slider ? fmt::format(", nearly {}", dyad.slider->type) : "";
  if (dyad.line) return line_text(*dyad.line, units, style);
  if (dyad.length) return number(*dyad.length, style.digits) + nearly;
  if (dyad.arc) return angle(shown_angle(*dyad.arc, units)) + nearly;
  return dyad.angle ? angle(shown_angle(*dyad.angle, units)) : "";
}

std::string reach_title(const std::vector<DyadRecord>& dyads) {
  const auto any = [&](auto has) { return std::any_of(dyads.begin(), dyads.end(), has); };
  std::vector<std::string> words;
  if (any([](const DyadRecord& d) { return d.length.has_value(); })) words.push_back("length");
  if (any([](const DyadRecord& d) { return d.arc.has_value(); })) words.push_back("arc");
  if (any([](const DyadRecord& d) { return d.line.has_value(); })) words.push_back("line");
  if (any([](const DyadRecord& d) { return d.angle.has_value(); })) words.push_back("angle");
  return one_of(words);
}

std::string pole_table(const Problem& problem, const std::vector<PoleRecord>& poles, double task_size) {
  return table({{"poses"}, {"angle", true}, {"fixed frame"}, {"moving body"}, {"at infinity"}}, [&](int digits) {
    const Style style{digits, 1e-9 * task_size};
    std::vector<Row> rows;
    for (const PoleRecord& p : poles)
      rows.push_back({fmt::format("{}, {}", p.poses[0], p.poses[1]),
                      number(shown_angle(p.angle, problem.units), digits), point(p.fixed, style),
                      point(p.moving, style), p.far ? "of " + line_text(*p.far, problem.units, style) : ""});
    return rows;
  });
}

std::string partners_table(const Problem& problem, const std::vector<PartnersRecord>& partners, double task_size) {
  const std::string pivot = partners[0].line ? " pivot" : " axis";
  return table({{"fixed" + pivot}, {"moving" + pivot}, {"on the line"}, {"perpendicular to"}}, [&](int digits) {
    const Style style{digits, 1e-9 * task_size};
    std::vector<Row> rows;
    for (const PartnersRecord& p : partners)
      rows.push_back({point(p.fixed, style), point(p.moving, style),
                      p.line ? line_text(*p.line, problem.units, style) : "", point(p.normal, style)});
    return rows;
  });
}

/// On the sphere axes take the place of pivots.
bool has_arcs(const std::vector<DyadRecord>& dyads) {
  return std::any_of(dyads.begin(), dyads.end(),
                     [](const DyadRecord& d) { return d.arc.has_value(); });
}

std::string dyad_table(const Problem& problem, const std::vector<DyadRecord>& dyads, double task_size) {
  const std::string pivot = has_arcs(dyads) ? " axis" : " pivot";
  const std::vector<Column> columns = {
      {"id", true},       {"type"},           {"fixed" + pivot}, {"moving" + pivot}, {reach_title(dyads)},
      {"residual", true}, {"condition", true}};
  return table(columns, [&](int digits) {
    const Style style{digits, 1e-9 * task_size};
    std::vector<Row> rows;
    for (const DyadRecord& d : dyads)
      rows.push_back({d.id > 0 ? fmt::format("{}", d.id) : "", d.type, point(d.fixed, style), point(d.moving, style),
                      reach(d, problem.units, style), number(d.residual, 2), number(d.condition, 2)});
    return rows;
  });
}

std::string linkage_table(const Problem& problem, const Synthesis& answer, bool arcs) {
  const std::vector<Column> columns = {
      {"id", true},    {"type"},          {"dyads"},        {"class"},        {"ground", true},
      {"input", true}, {"coupler", true}, {"output", true}, {"offset", true}, {"on coupler", true}};
  return table(columns, [&](int digits) {
    const auto length = [&](const std::optional<double>& value) {
      return value && arcs ? number(shown_angle(*value, problem.units), digits) : number(value, digits);
    };
    std::vector<Row> rows;
    for (const LinkageRecord& l : answer.linkages)
      rows.push_back({fmt::format("{}", l.id), l.type, fmt::format("{}, {}", l.dyads[0], l.dyads[1]),
                      l.motion_class.value_or(""), length(l.ground), length(l.input), length(l.coupler),
                      length(l.output), length(l.offset), length(l.coupler_offset)});
    return rows;
  });
}

std::string family_text(const Problem& problem, const FamilyRecord& family, double task_size) {
  constexpr std::size_t most_samples = 12;
  std::string out;
  if (!family.poles.empty()) out += "\nPoles\n" + pole_table(problem, family.poles, task_size);
  if (!family.partners.empty())
    out += fmt::format("\nPartners fill a {}\n", family.partners[0].line ? "line" : "great circle") +
           partners_table(problem, family.partners, task_size);
  if (family.samples.empty()) return out;
  const std::size_t shown = std::min(most_samples, family.samples.size());
  std::vector<DyadRecord> samples;  // some of all
  for (std::size_t k = 0; k < shown; ++k) samples.push_back(family.samples[k * family.samples.size() / shown]);
  return out + fmt::format("\nSamples: {} of {} (--json lists all)\n", shown, family.samples.size()) +
         dyad_table(problem, samples, task_size);
}

/// Two lines each, one for each dyad.
std::string candidate_table(const std::vector<CandidateRecord>& candidates, double task_size) {
  const std::vector<Column> columns = {
      {"rank", true},  {"class"},        {"one branch"},   {"ratio", true},  {"fixed pivot"},
      {"moving pivot"}, {"length", true}, {"ground", true}, {"coupler", true}};
  return table(columns, [&](int digits) {
    const Style style{std::min(digits, 5), 1e-9 * task_size};
    std::vector<Row> rows;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const auto& [dyads, linkage, ratio, one_branch] = candidates[k];
      const auto of_dyad = [&](const DyadRecord& d) {
        return Row{point(d.fixed, style), point(d.moving, style), number(d.length, style.digits)};
      };
      Row first = {fmt::format("{}", k + 1), linkage.motion_class.value_or(""), one_branch ? "yes" : "no",
                   number(ratio, 3)};
      for (std::string& cell : of_dyad(dyads[0])) first.push_back(std::move(cell));
      first.push_back(number(linkage.ground, style.digits));
      first.push_back(number(linkage.coupler, style.digits));
      Row second(first.size(), " ");
      std::ranges::move(of_dyad(dyads[1]), second.begin() + 4);
      rows.push_back(std::move(first));
      rows.push_back(std::move(second));
    }
    return rows;
  });
}

std::string curves_text(const std::vector<CurveRecord>& curves) {
  std::size_t points = 0;
  double error = 0;
  for (const CurveRecord& curve : curves) points += curve.moving.size(), error = std::max(error, curve.max_error);
  return fmt::format(
      "\nCurves of {}: {} pieces, {} pairs, within {:.1g} of the true curves (-o DIR draws them, --json "
      "lists them)\n",
      curves[0].moving[0].size() == 3 ? "axes" : "pivots", curves.size(), points, error);
}

std::string task_text(const Problem& problem, bool arcs) {
  std::string out = fmt::format("{}, {} poses; ", problem.geometry, problem.poses.size());
  if (!problem.units.length.empty())
    out += fmt::format("lengths in {}, ", printable(problem.units.length, 20));
  if (!problem.units.degrees) return out + "angles in rad";
  return out + (arcs ? "angles in deg, residuals in rad" : "angles in deg");
}

/// In lines of the table's width, broken between words.
std::string paragraph(const std::string& text) {
  std::istringstream words(printable(text, 10 * width));
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) out += std::exchange(line, "") + "\n";
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? out : out + line + "\n";
}

}  // namespace

std::string answer_text(const Problem& problem, const Synthesis& answer, double task_size) {
  std::string out;
  if (!problem.name.empty()) out += printable(problem.name, width - 2) + "\n";
  out += paragraph(problem.source);
  const bool arcs = has_arcs(answer.dyads) || has_arcs(answer.family.samples);
  out += fmt::format("{}\n{}\n", task_text(problem, arcs), answer.message);
  if (!answer.dyads.empty()) out += "\nDyads\n" + dyad_table(problem, answer.dyads, task_size);
  out += family_text(problem, answer.family, task_size);
  if (!answer.curves.empty()) out += curves_text(answer.curves);
  if (!answer.linkages.empty()) out += "\nLinkages\n" + linkage_table(problem, answer, has_arcs(answer.dyads));
  if (answer.candidates && !answer.candidates->empty())
    out +=
        "\nLinkages from pairs of points of the curves, best first\n" + candidate_table(*answer.candidates, task_size);
  return out;
}

}  // namespace burmester
