#include "burmester/planar/pose_format.hpp"

namespace burmester::planar {
namespace {

PoseData data_of(double x, double y, double angle, bool degrees) {
  const Pose p = degrees ? pose_from_degrees(x, y, angle) : pose_from_radians(x, y, angle);
  return {p.x, p.y, p.X3, p.X4};
}

}  // namespace

PoseData read_pose(const InputNode& node, const Units& units) {
  if (node.is_array()) {
    const std::vector<double> row = node.numbers(3);
    return data_of(row[0], row[1], row[2], units.degrees);
  }
  if (!node.is_object()) node.fail("a pose: {\"x\", \"y\", \"angle\"} or [x, y, angle]");
  node.expect_keys({"x", "y", "angle"});
  return data_of(node.at("x").number(), node.at("y").number(), node.at("angle").number(), units.degrees);
}

PoseData read_csv_pose(bool degrees, const std::vector<double>& row) {
  return data_of(row[0], row[1], row[2], degrees);
}

Pose pose_of(const PoseData& data) { return {data[0], data[1], data[2], data[3]}; }

std::vector<Pose> poses_of(const Problem& problem) {
  std::vector<Pose> poses;
  for (const PoseData& data : problem.poses) poses.push_back(pose_of(data));
  return poses;
}

}  // namespace burmester::planar
