#include "research/planar_limit/command.hpp"

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "burmester/modules/framework/input.hpp"
#include "burmester/modules/framework/problem_io.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/pose_format.hpp"
#include "program/application.hpp"
#include "program/output_folder.hpp"
#include "research/planar_limit/plot.hpp"

namespace burmester {
namespace {

constexpr std::size_t decade = 60;  // steps of the path from e to 10 e

/// 1e-3 to 0.5.
std::vector<double> curvatures() {
  std::vector<double> out;
  const auto e = [&] { return 1e-3 * std::pow(10, static_cast<double>(out.size()) / decade); };
  while (e() < 0.5) out.push_back(e());
  out.push_back(0.5);
  return out;
}

std::vector<planar::RR::Design> real_RR(const planar::PlanarReport& report) {
  std::vector<planar::RR::Design> out;
  for (const auto& found : report.dyads)
    if (const auto* rr = std::get_if<planar::RR::Design>(&found.design)) out.push_back(*rr);
  return out;
}

std::string text(const Problem& problem, const PlanarLimit& limit) {
  std::string out = problem.name.empty() ? "" : printable(problem.name, 98) + "\n";
  out += fmt::format("planar limit, 5 poses; L = {:.6g}{}, sphere of radius L / e; real RR dyads: {}\n\n", limit.size,
                     problem.units.length.empty() ? "" : " " + printable(problem.units.length, 20), limit.dyads.size());
  out += fmt::format("  {:>4}  {:>22}  {:>22}  {}\n", "dyad", "fixed pivot", "moving pivot, pose 1",
                     "spherical dyad apart, / L: e = 0.1, 0.01, 0.001; exponent");
  for (std::size_t k = 0; k < limit.dyads.size(); ++k) {
    const FollowedDyad& d = limit.dyads[k];
    const auto place = [](const planar::Vector2& p) { return fmt::format("({:.6g}, {:.6g})", p[0], p[1]); };
    out += fmt::format("  {:>4}  {:>22}  {:>22}", k + 1, place(d.planar.fixed), place(d.planar.moving));
    for (const std::size_t i : {2 * decade, decade, std::size_t{0}})
      out += i < d.path.size() ? fmt::format("  {:.3e}", apart(d.path[i], d.planar) / limit.size) : "    complex";
    const auto p = exponent(limit, d, 0, decade);
    out += p ? fmt::format("  {:.3f}\n", *p) : "\n";
  }
  return out + fmt::format("\nThe exponent is that of e between 0.001 and 0.01. The other {} dyads: {}.\n",
                           6 - limit.dyads.size(), about_others(limit));
}

void write(const std::string& file, const std::string& figure) {
  const std::filesystem::path path(file);
  if (!path.has_filename()) throw InputError(fmt::format("-o: expected a file, got {}", printable(file, 200)));
  OutputFolder(path.has_parent_path() ? path.parent_path().string() : ".").write(path.filename().string(), figure);
}

int follow(const std::string& file, const std::string& figure, const Registry& registry, Console& console) {
  const std::string name = shown_name(file);
  const Problem problem = read_problem(read_text(file, console), registry, {.file = name, .geometry = "planar"});
  if (problem.geometry != "planar")
    throw InputError(fmt::format("{}: geometry: expected planar, got \"{}\"", name, printable(problem.geometry)));
  if (problem.poses.size() != 5)
    throw InputError(fmt::format("{}: poses: expected 5 poses, got {}", name, problem.poses.size()));
  const std::vector<planar::Pose> list = planar::poses_of(problem);
  const std::span<const planar::Pose, 5> poses(list.data(), 5);
  const planar::PlanarReport report = planar::FivePoseSolver().solve(poses);
  const std::vector<planar::RR::Design> dyads = real_RR(report);
  if (dyads.empty()) {
    emit(console.out, "No RR dyad to follow: " + report.message + ".\n");
    return answered;
  }
  const PlanarLimit limit = planar_limit(poses, dyads, curvatures());
  if (!figure.empty()) write(figure, planar_limit_plot(limit, poses, problem.name));
  emit(console.out, text(problem, limit));
  return answered;
}

}  // namespace

int run_planar_limit(const std::vector<std::string>& arguments, const Registry& registry, Console& console) {
  return guarded("burmester-planar-limit", console, [&] {
    CLI::App app("Five planar poses wrapped onto larger and larger spheres: spherical dyads become the planar ones.",
                 "burmester-planar-limit");
    std::string problem, figure;
    app.set_version_flag("--version", "burmester " BURMESTER_VERSION);
    app.add_option("problem", problem, "File with five planar poses, JSON or CSV; - for standard input")
        ->type_name("PROBLEM")
        ->required();
    app.add_option("-o", figure, "Draw the dyads' paths and their distances into this SVG file")->type_name("FILE");
    app.footer("Exit codes: 0 answered, 2 bad usage or input, 3 internal failure, 4 not available in this version.");
    return run_application(app, arguments, console, [&] { return follow(problem, figure, registry, console); });
  });
}

}  // namespace burmester
