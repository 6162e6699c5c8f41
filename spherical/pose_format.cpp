#include "burmester/spherical/pose_format.hpp"

#include <algorithm>
#include <cmath>

#include "burmester/spherical/space.hpp"

namespace burmester::spherical {
namespace {

constexpr const char* zero_quaternion = "a quaternion that is not zero";

PoseData data_of(const Pose& p) { return {p.w, p.x, p.y, p.z}; }

bool is_zero(const std::vector<double>& v) {
  return std::all_of(v.begin(), v.end(), [](double c) { return c == 0; });
}

PoseData read_quaternion(const InputNode& node) {
  PoseData data = node.numbers(4);
  if (is_zero(data)) node.fail(zero_quaternion);
  return data;
}

PoseData read_axis(const InputNode& node, const InputNode& angle, bool degrees) {
  const std::vector<double> a = node.numbers(3);
  if (is_zero(a)) node.fail("an axis that is not zero");
  const std::array<double, 3> axis{a[0], a[1], a[2]};
  return data_of(degrees ? pose_from_axis_degrees(axis, angle.number())
                         : pose_from_axis_radians(axis, angle.number()));
}

PoseData read_globe(const InputNode& node, bool degrees) {
  const double l = node.at("longitude").number(), b = node.at("latitude").number(),
               r = node.at("roll").number();
  return data_of(degrees ? pose_from_globe_degrees(l, b, r) : pose_from_globe_radians(l, b, r));
}

PoseData read_matrix(const InputNode& node) {
  if (!node.is_array() || node.size() != 3) node.fail("an array of 3 rows");
  std::array<std::array<double, 3>, 3> rows;
  Eigen::Matrix3d m;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double> row = node.at(i).numbers(3);
    std::copy(row.begin(), row.end(), rows[i].begin());
    m.row(static_cast<Eigen::Index>(i)) << row[0], row[1], row[2];
  }
  const double off = (m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= matrix_tolerance && std::abs(m.determinant() - 1) <= matrix_tolerance))
    node.fail("an orthogonal matrix with determinant +1 (within 1e-6)");
  return data_of(pose_from_matrix(rows));
}

}  // namespace

PoseData read_pose(const InputNode& node, const Units& units) {
  const bool axis = node.has("axis"), quaternion = node.has("quaternion_wxyz"), matrix = node.has("matrix");
  const bool globe = node.has("longitude") || node.has("latitude") || node.has("roll");
  if (axis + quaternion + matrix + globe != 1)
    node.fail(
        "a pose: one of {\"axis\", \"angle\"}, {\"quaternion_wxyz\"}, {\"matrix\"} or "
        "{\"longitude\", \"latitude\", \"roll\"}");
  if (quaternion) {
    node.expect_keys({"quaternion_wxyz"});
    return read_quaternion(node.at("quaternion_wxyz"));
  }
  if (matrix) {
    node.expect_keys({"matrix"});
    return read_matrix(node.at("matrix"));
  }
  if (globe) {
    node.expect_keys({"longitude", "latitude", "roll"});
    return read_globe(node, units.degrees);
  }
  node.expect_keys({"axis", "angle"});
  return read_axis(node.at("axis"), node.at("angle"), units.degrees);
}

PoseData read_csv_pose(const std::vector<double>& row) {
  if (is_zero(row)) throw InputError(std::string("expected ") + zero_quaternion);
  return row;
}

Pose pose_of(const PoseData& data) { return {data[0], data[1], data[2], data[3]}; }

std::vector<Pose> poses_of(const Problem& problem) {
  std::vector<Pose> poses;
  for (const PoseData& data : problem.poses) poses.push_back(pose_of(data));
  return poses;
}

}  // namespace burmester::spherical
