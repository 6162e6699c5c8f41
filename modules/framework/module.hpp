// A module: one geometry behind a type-erased face. The program and bindings know modules by this face only.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/modules/framework/problem.hpp"
#include "burmester/modules/framework/record.hpp"

namespace burmester {

class InputNode;  // modules/framework/input.hpp: a JSON value that knows its place in the file

struct SolverInfo {
  std::string name;     ///< "five poses, direct"
  std::string answers;  ///< one line: which problems, what comes out
};

struct ModuleInfo {
  std::string name;    ///< the value of "geometry" in files
  std::string origin;  ///< "built in", or the plugin's file
  std::vector<std::string> dyad_types;
  std::vector<SolverInfo> solvers;
  std::vector<std::vector<std::string>> csv_headers;  ///< accepted header lines, e.g. {x, y, angle_deg}
  int point_size = 2;  ///< coordinates of a pivot in files
  std::vector<std::pair<std::string, std::string>> type_aliases{};  ///< asked for and meant: on the sphere RP, PR
  std::vector<std::string> linkage_classes{};  ///< of the linkages ranked from a curve of dyads; empty: none are ranked
};

/// What the types of a built-in module say of themselves: its pose space, its DyadList, its solvers, each with the two
/// texts of a SolverInfo.
template <class Space, class Dyads, class... Solver>
ModuleInfo built_in() {
  ModuleInfo info;
  info.name = Space::name;
  info.origin = "built in";
  Dyads::for_each([&]<class D>() { info.dyad_types.push_back(D::name); });
  info.solvers = {{Solver::name, Solver::answers}...};
  info.point_size = Space::feature_size;
  return info;
}

class Module {
 public:
  virtual ~Module() = default;
  virtual const ModuleInfo& info() const = 0;

  /// One pose from a file, in any of the module's formats. Throws InputError with the place.
  virtual PoseData read_pose(const InputNode& node, const Units& units) const = 0;
  /// One pose from a CSV row under one of info().csv_headers. Throws InputError without the place.
  virtual PoseData read_csv_pose(std::size_t header, const std::vector<double>& row) const = 0;
  /// A pose as shown in results, in the problem's units: name and value pairs, e.g. x, y, angle.
  virtual std::vector<std::pair<std::string, double>> show_pose(const PoseData& pose, const Units& units) const = 0;
  /// The largest distance between two pose origins, 1 if all coincide (sphere: 1).
  virtual double task_size(const Problem& problem) const = 0;

  /// Throws NotAvailable for problems that this version cannot answer. "No real dyad" is an answer.
  virtual Synthesis synthesize(const Problem& problem) const = 0;
  /// The poses and the linkages of an answer; an empty drawing where the module does not draw.
  virtual Drawing draw(const Problem& problem, const Synthesis& answer) const = 0;
};

}  // namespace burmester
