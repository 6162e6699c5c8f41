#include "burmester/planar/pose_format.hpp"

#include <cmath>

namespace burmester::planar {
namespace {

/// Squares and products of lengths must not overflow.
constexpr double longest_length = 1e100;
constexpr const char* too_long = "coordinates of magnitude at most 1e100";

bool is_too_long(double x, double y) { return !(std::abs(x) <= longest_length && std::abs(y) <= longest_length); }

PoseData data_of(double x, double y, double angle, bool degrees) {
  const Pose p = degrees ? pose_from_degrees(x, y, angle) : pose_from_radians(x, y, angle);
  return {p.x, p.y, p.X3, p.X4};
}

}  // namespace

PoseData read_pose(const InputNode& node, const Units& units) {
  if (node.is_array()) {
    const std::vector<double> row = node.numbers(3);
    if (is_too_long(row[0], row[1])) node.fail(too_long);
    return data_of(row[0], row[1], row[2], units.degrees);
  }
  if (!node.is_object()) node.fail("a pose: {\"x\", \"y\", \"angle\"} or [x, y, angle]");
  node.expect_keys({"x", "y", "angle"});
  const double x = node.at("x").number(), y = node.at("y").number();
  if (is_too_long(x, y)) node.fail(too_long);
  return data_of(x, y, node.at("angle").number(), units.degrees);
}

PoseData read_csv_pose(bool degrees, const std::vector<double>& row) {
  if (is_too_long(row[0], row[1])) throw InputError(std::string("expected ") + too_long);
  return data_of(row[0], row[1], row[2], degrees);
}

Pose pose_of(const PoseData& data) { return {data[0], data[1], data[2], data[3]}; }

std::vector<Pose> poses_of(const Problem& problem) {
  std::vector<Pose> poses;
  for (const PoseData& data : problem.poses) poses.push_back(pose_of(data));
  return poses;
}

}  // namespace burmester::planar
