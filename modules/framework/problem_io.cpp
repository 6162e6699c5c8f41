#include "burmester/modules/framework/problem_io.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "burmester/modules/framework/csv.hpp"
#include "burmester/modules/framework/input.hpp"

namespace burmester {
namespace {

constexpr std::string_view schema = "burmester/problem/1";

std::vector<std::string> names_of(const Registry& registry) {
  std::vector<std::string> names;
  for (const Module* module : registry.modules()) names.push_back(module->info().name);
  return names;
}

/// A document of another kind is the likeliest mix-up, so it is told apart from a misspelt schema.
void check_schema(const InputNode& root) {
  if (!root.has("schema")) return;
  const InputNode node = root.at("schema");
  const std::string given = node.string();
  if (given == schema) return;
  for (const auto& [kind, command] :
       {std::pair{"linkage", "analyze"}, {"platform", "platform"}, {"result", "export"}})
    if (given == fmt::format("burmester/{}/1", kind))
      node.reject(fmt::format("expected {}, got {} (for burmester {})", schema, given, command));
  node.fail(schema);
}

const Module& module_of(const InputNode& root, const Registry& registry, const ReadOptions& options) {
  const bool given = root.has("geometry") || !options.geometry;
  const std::string name = given ? root.at("geometry").choice(names_of(registry)) : *options.geometry;
  const Module* module = registry.find(name);
  if (!module)
    throw InputError(
        fmt::format("--geometry: expected {}, got {}", one_of(names_of(registry)), printable(name)));
  return *module;
}

Units read_units(const InputNode& root) {
  Units units;
  if (!root.has("units")) return units;
  const InputNode node = root.at("units");
  node.expect_keys({"length", "angle"});
  if (node.has("length")) units.length = node.at("length").string();
  if (node.has("angle")) units.degrees = node.at("angle").choice({"deg", "rad"}) == "deg";
  return units;
}

std::vector<PoseData> read_poses(const InputNode& root, const Module& module, const Units& units) {
  const InputNode node = root.at("poses");
  if (!node.is_array()) node.fail("an array of two or more poses");
  const std::size_t count = node.size();
  if (count < 2) node.fail("two or more poses");
  if (count > most_poses) node.fail(fmt::format("at most {} poses", most_poses));
  std::vector<PoseData> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(module.read_pose(node.at(i), units));
  return poses;
}

std::vector<std::string> read_types(const InputNode& root, const Module& module) {
  if (!root.has("types")) return {};
  const InputNode node = root.at("types");
  if (!node.is_array() || node.size() == 0)
    node.fail("an array of dyad types, " + one_of(module.info().dyad_types));
  std::vector<std::string> types;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string type = node.at(i).string();
    try {
      types.push_back(known_types(module, {type}).front());
    } catch (const InputError& error) {
      node.at(i).reject(error.what());
    }
  }
  return types;
}

std::vector<std::vector<double>> read_points(const InputNode& root, std::string_view key,
                                             const Module& module) {
  if (!root.has(key)) return {};
  const InputNode node = root.at(key);
  const auto size = static_cast<std::size_t>(module.info().point_size);
  if (!node.is_array()) node.fail(fmt::format("an array of points of {} numbers", size));
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < node.size(); ++i) points.push_back(node.at(i).numbers(size));
  return points;
}

std::vector<std::optional<double>> read_weights(const InputNode& root, std::size_t pose_count) {
  if (!root.has("weights")) return {};
  const InputNode node = root.at("weights");
  if (!node.is_array() || node.size() != pose_count)
    node.fail(fmt::format("an array of {} weights, one for each pose", pose_count));
  std::vector<std::optional<double>> weights;
  bool any = false;
  for (std::size_t i = 0; i < pose_count; ++i) {
    const InputNode weight = node.at(i);
    if (weight.is_string() && weight.string() == "exact")
      weights.push_back(std::nullopt);
    else if (weight.is_number() && weight.number() >= 0)
      weights.push_back(weight.number());
    else
      weight.fail("a number that is not negative, or \"exact\"");
    any = any || !weights.back() || *weights.back() > 0;
  }
  if (!any) node.reject("expected a weight that is not 0, got none");
  return weights;
}

LinkageRequest::Box read_box(const InputNode& node, std::size_t size) {
  if (!node.is_array() || node.size() != 2) node.fail("two opposite corners");
  LinkageRequest::Box box{node.at(0).numbers(size), node.at(1).numbers(size)};
  for (std::size_t k = 0; k < size; ++k)
    if (box.low[k] > box.high[k]) std::swap(box.low[k], box.high[k]);
  return box;
}

std::size_t read_count(const InputNode& node, std::size_t most) {
  const double count = node.number();
  if (!(count >= 1 && count <= static_cast<double>(most) && count == std::floor(count)))
    node.fail(fmt::format("a whole number from 1 to {}", most));
  return static_cast<std::size_t>(count);
}

std::optional<LinkageRequest> read_linkages(const InputNode& root, const Module& module) {
  if (!root.has("linkages")) return std::nullopt;
  const InputNode node = root.at("linkages");
  if (!node.is_object()) node.fail("an object, what the linkages listed for four poses are to be like");
  const ModuleInfo& info = module.info();
  if (info.linkage_classes.empty()) {
    node.warn(fmt::format("the {} module ranks no linkages; ignored", info.name));
    return std::nullopt;
  }
  node.expect_keys({"fixed_in", "moving_in", "classes", "largest_ratio", "most"});
  LinkageRequest out;
  const auto size = static_cast<std::size_t>(info.point_size);
  if (node.has("fixed_in")) out.fixed_in = read_box(node.at("fixed_in"), size);
  if (node.has("moving_in")) out.moving_in = read_box(node.at("moving_in"), size);
  if (node.has("classes")) {
    const InputNode classes = node.at("classes");
    if (!classes.is_array() || classes.size() == 0)
      classes.fail("an array of classes, " + one_of(info.linkage_classes));
    for (std::size_t i = 0; i < classes.size(); ++i) out.classes.push_back(classes.at(i).choice(info.linkage_classes));
  }
  if (node.has("largest_ratio")) {
    out.largest_ratio = node.at("largest_ratio").number();
    if (!(*out.largest_ratio >= 1)) node.at("largest_ratio").fail("a number that is not below 1");
  }
  if (node.has("most")) out.most = read_count(node.at("most"), most_linkages);
  return out;
}

Problem read_json(std::string_view text, const Registry& registry, const ReadOptions& options) {
  const InputDocument document(text, options.file);
  const InputNode root = document.root();
  if (!root.is_object()) root.fail("a problem, an object with geometry and poses");
  check_schema(root);
  root.expect_keys({"schema", "geometry", "name", "source", "units", "poses", "types", "fixed", "moving",
                    "weights", "near", "linkages"});
  const Module& module = module_of(root, registry, options);
  Problem problem;
  problem.geometry = module.info().name;
  if (root.has("name")) problem.name = root.at("name").string();
  if (root.has("source")) problem.source = root.at("source").string();
  problem.units = read_units(root);
  problem.poses = read_poses(root, module, problem.units);
  problem.types = read_types(root, module);
  problem.fixed = read_points(root, "fixed", module);
  problem.moving = read_points(root, "moving", module);
  problem.weights = read_weights(root, problem.poses.size());
  problem.near = read_points(root, "near", module);
  problem.linkages = read_linkages(root, module);
  problem.warnings = document.warnings();
  return problem;
}

/// The module, and which of its headers, that a CSV header line belongs to.
std::pair<const Module*, std::size_t> module_of_header(const CsvTable& table, const Registry& registry,
                                                       const std::string& file) {
  std::vector<std::string> known;
  for (const Module* module : registry.modules()) {
    const auto& headers = module->info().csv_headers;
    for (std::size_t i = 0; i < headers.size(); ++i) {
      if (headers[i] == table.header) return {module, i};
      known.push_back(fmt::format("{}", fmt::join(headers[i], ",")));
    }
  }
  throw InputError(fmt::format("{}: line {}: expected a header line, {}, got {}", file, table.header_line,
                               one_of(known), printable(fmt::format("{}", fmt::join(table.header, ",")))));
}

Problem read_csv(std::string_view text, const Registry& registry, const ReadOptions& options) {
  const CsvTable table = read_csv_table(text, options.file);
  const auto [module, header] = module_of_header(table, registry, options.file);
  Problem problem;
  problem.geometry = module->info().name;
  problem.units.degrees = std::none_of(table.header.begin(), table.header.end(),
                                       [](const std::string& column) { return column.ends_with("_rad"); });
  const std::vector<CsvRow> rows = csv_numbers(table, options.file);
  if (rows.size() < 2 || rows.size() > most_poses)
    throw InputError(fmt::format("{}: line {}: expected 2 to {} poses, one on each line, got {}",
                                 options.file, table.header_line + 1, most_poses, rows.size()));
  for (const CsvRow& row : rows) {
    try {
      problem.poses.push_back(module->read_csv_pose(header, row.values));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: line {}: {}", options.file, row.line, error.what()));
    }
  }
  return problem;
}

bool looks_like_csv(std::string_view text, std::string_view file) {
  const std::size_t start = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (start == text.npos) return file.ends_with(".csv");
  if (text[start] == '{' || text[start] == '[') return false;
  return file.ends_with(".csv") || text.substr(start, text.find('\n', start) - start).find(',') != text.npos;
}

}  // namespace

Problem read_problem(std::string_view text, const Registry& registry, const ReadOptions& options) {
  return options.csv && looks_like_csv(text, options.file) ? read_csv(text, registry, options)
                                                           : read_json(text, registry, options);
}

std::vector<std::string> known_types(const Module& module, const std::vector<std::string>& types) {
  const ModuleInfo& info = module.info();
  std::vector<std::string> out;
  for (const std::string& type : types) {
    const auto alias = std::find_if(info.type_aliases.begin(), info.type_aliases.end(),
                                    [&](const auto& pair) { return pair.first == type; });
    const std::string& name = alias == info.type_aliases.end() ? type : alias->second;
    if (std::find(info.dyad_types.begin(), info.dyad_types.end(), name) == info.dyad_types.end())
      throw InputError(fmt::format("expected {}, got \"{}\"", one_of(info.dyad_types), printable(type)));
    out.push_back(name);
  }
  return out;
}

}  // namespace burmester
