#include "burmester/planar/degeneracy.hpp"

#include <fmt/format.h>

#include "burmester/modules/framework/equal_poses.hpp"

namespace burmester::planar {
namespace {

std::string plural(int n, const char* one, const char* many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

Verdict finite(int complex, int real, std::string message) {
  return {real > 0 ? Status::exact : Status::none, {0, complex, real, false}, std::move(message)};
}

Verdict infinite(std::optional<int> dimension, std::string message) {
  return {Status::degenerate, {dimension, std::nullopt, std::nullopt, false}, std::move(message)};
}

Verdict nothing(std::string message) {
  return {Status::none, {std::nullopt, std::nullopt, 0, false}, std::move(message)};
}

std::string family_message(const std::string& type, int real) {
  const std::string rest =
      real > 0 ? fmt::format("; besides it {}", plural(real, "isolated dyad", "isolated dyads")) : "";
  if (type == "PR")
    return "a one-parameter family of PR dyads (as in Cardan motion, where a circle of points moves on lines)" + rest;
  if (type == "RP")
    return "a one-parameter family of RP dyads (as in the inverse of Cardan motion)" + rest;
  return fmt::format("a one-parameter family of {} dyads{}", type, rest);
}

}  // namespace

Verdict verdict(FivePoseCase what, FivePoses poses, int real, const std::string& family_type) {
  switch (what) {
    case FivePoseCase::regular:
      return finite(4, real, real > 0 ? plural(real, "real dyad", "real dyads") + " of 4 over the complex numbers"
                                      : "no real dyad exists: all 4 are complex");
    case FivePoseCase::two_orientations:
      return finite(
          2, real,
          fmt::format(
              "the poses have two orientations only (3 + 2): two of the four dyads lie at infinity, {}",
              real > 0 ? plural(real, "real dyad remains", "real dyads remain") : "and of the other two none is real"));
    case FivePoseCase::two_orientations_in_line:
      return nothing("no finite dyad exists: the poses have two orientations only (3 + 2), and the three parallel ones "
                     "lie on a line");
    case FivePoseCase::common_vertex:
      return {Status::degenerate,
              {0, 4, std::nullopt, false},
              "all four dyads coincide: one of them is listed"};
    case FivePoseCase::four_parallel:
      return nothing("no finite dyad exists: four of the five orientations are equal, the fifth is not");
    case FivePoseCase::all_parallel:
      return {Status::exact,
              {0, std::nullopt, 1, false},
              "all orientations are equal: the double slider PP is the only dyad"};
    case FivePoseCase::translation:
      return infinite(2, "a translation along a circle or a straight line: every point of the body is a moving pivot, "
                         "besides the double slider PP");
    case FivePoseCase::equal_poses:
      return infinite(std::nullopt, name_equal_poses([&](int i, int j) {
                        return poses[j].x == poses[i].x && poses[j].y == poses[i].y &&
                               same_orientation(poses[i], poses[j]);
                      }));
    case FivePoseCase::rotation:
      return infinite(2, "the poses are rotations about one point: every point of the body moves on a circle about it, "
                         "and that point of the body is a pivot for any circle through it");
    case FivePoseCase::rank_deficient:
      return infinite(std::nullopt,
                      "the five poses give fewer than four independent conditions: infinitely many dyads");
    case FivePoseCase::common_line: return infinite(1, family_message(family_type, real));
    case FivePoseCase::empty_conic:
      return nothing("no real dyad exists: the two conditions coincide and have no real solution");
    case FivePoseCase::whole_conic: return infinite(1, "a one-parameter family of dyads (the two conditions coincide)");
  }
  return {};
}

}  // namespace burmester::planar
