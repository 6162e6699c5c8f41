#include "burmester/spherical/degeneracy.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "burmester/modules/framework/equal_poses.hpp"
#include "burmester/spherical/exact_orientations.hpp"

namespace burmester::spherical {
namespace {

/// Vector parts of the rotations from i to j, i < j, of five unit quaternions.
using Turns = std::array<std::array<Vector3, 5>, 5>;

Turns turns_between(FivePoses poses) {
  Turns out;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) out[i][j] = half_angle_sine(poses[i], poses[j]);
  return out;
}

/// The largest eigenvector v of sum s s^T, and one step of power iteration: it takes off what rounding the squares did.
Vector3 common_direction(std::span<const Vector3> all) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& s : all) moments += s * s.transpose();
  const Vector3 v = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(2);
  Vector3 off = Vector3::Zero();
  double sum = 0;
  for (const Vector3& s : all) off += s.dot(v) * v.cross(s.cross(v)), sum += s.dot(v) * s.dot(v);
  return sum > 0 ? Vector3((v + off / sum).normalized()) : v;
}

/// From turns about one axis.
double distance_from_parallel(std::span<const Vector3> turns) {
  const Vector3 v = common_direction(turns);
  double square = 0;  // not from the small eigenvalues, which have half of the digits
  for (const Vector3& s : turns) square += s.cross(v).squaredNorm();
  return std::sqrt(square);
}

/// Between all pairs of n orientations, over sqrt(n).
std::vector<Vector3> turns_among(std::span<const Pose> poses) {
  std::vector<Vector3> out;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = i + 1; j < poses.size(); ++j)
      out.push_back(half_angle_sine(poses[i], poses[j]) / std::sqrt(static_cast<double>(poses.size())));
  return out;
}

/// "(0, 0, 1)", the axis of the rotation from the first pose to the second; what turns that leave it by same_tolerance
/// make of a zero is 0.
std::string common_axis(std::span<const Pose> poses) {
  const std::vector<Vector3> turns = turns_among(poses);
  double size = 0;
  for (const Vector3& s : turns) size = std::hypot(size, s.norm());
  Vector3 v = common_direction(turns);
  if (v.dot(half_angle_sine(poses[0], poses[1])) < 0) v = -v;
  for (double& x : v) x = std::abs(x) * size <= same_tolerance ? 0 : x;
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

/// The turns within two groups of orientations, over the roots of the sizes of the groups: how far these are from
/// bringing an axis of S to one place in each.
class Groups {
 public:
  Groups() = default;
  /// {i, j} and the other three; i = j: {i} and the other four.
  Groups(const Turns& turns, std::size_t i, std::size_t j) {
    const double apart = i == j ? 1 : 2;
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < 5; ++k)
      for (std::size_t l = k + 1; l < 5; ++l) {
        const bool first = k == i || k == j, second = l == i || l == j;
        if (first != second) continue;
        within_[count_] = turns[k][l] / std::sqrt(first ? apart : 5 - apart);
        moments += within_[count_] * within_[count_].transpose(), ++count_;
      }
    const double trace = moments.trace(), minors = (trace * trace - moments.squaredNorm()) / 2;
    square_at_least_ = trace > 0 ? minors / trace - 0x1p-48 * trace : 0;
  }
  double distance() const { return distance_from_parallel({within_.data(), count_}); }
  /// Of eigenvalues x >= y >= z, x y + x z + y z <= (x + y + z) (y + z): below the square of the distance by more than
  /// rounding.
  double square_at_least() const { return square_at_least_; }

 private:
  std::array<Vector3, 6> within_;
  std::size_t count_ = 0;
  double square_at_least_ = 0;
};

/// Of few of them more than the bound is needed.
template <std::size_t n>
double least_distance(const std::array<Groups, n>& all) {
  const auto nearest = std::ranges::min_element(all, {}, &Groups::square_at_least);
  double least = nearest->distance();
  for (auto groups = all.begin(); groups != all.end(); ++groups)
    if (groups != nearest && groups->square_at_least() <= least * least) least = std::min(least, groups->distance());
  return least;
}

double distance_from_four_and_one(const Turns& turns) {
  std::array<Groups, 5> all;
  for (std::size_t i = 0; i < 5; ++i) all[i] = Groups(turns, i, i);
  return least_distance(all);
}

double distance_from_three_and_two(const Turns& turns) {
  std::array<Groups, 10> all;
  auto to = all.begin();
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) *to++ = Groups(turns, i, j);
  return least_distance(all);
}

}  // namespace

NearDegeneracy axis_in_two_places(FivePoses poses) {
  std::array<Pose, 5> inverse;
  for (std::size_t i = 0; i < 5; ++i)
    inverse[i] = Space::pose(Space::conjugate<double>(Space::point<double>(poses[i])));
  const Turns of_S = turns_between(poses), of_E = turns_between(inverse);
  const double four = distance_from_four_and_one(of_S), moving = distance_from_three_and_two(of_E),
               fixed = distance_from_three_and_two(of_S);
  NearDegeneracy out{Degeneracy::none, std::min({four, moving, fixed})};
  if (four <= same_tolerance)
    out.kind = Degeneracy::rank_deficient;
  else if (std::max(moving, fixed) <= same_tolerance)
    out.kind = Degeneracy::both_on_circles;
  else if (out.distance <= same_tolerance)
    out.kind = moving < fixed ? Degeneracy::moving_on_circle : Degeneracy::fixed_on_circle;
  return out;
}

double distance_from_one_axis(std::span<const Pose> poses) { return distance_from_parallel(turns_among(poses)); }

std::string name_degeneracy(Degeneracy what, std::span<const Pose> poses, bool (*same)(const Pose&, const Pose&)) {
  switch (what) {
    case Degeneracy::equal_orientations:
      return name_equal_poses(
          [&](int i, int j) { return same(poses[static_cast<std::size_t>(i)], poses[static_cast<std::size_t>(j)]); },
          static_cast<int>(poses.size()));
    case Degeneracy::one_axis:
      return fmt::format(
          "all rotations from one orientation to another have one axis, {}: every moving axis keeps its angle from it, "
          "and the moving axis that coincides with it keeps its angle from every fixed axis",
          common_axis(poses));
    case Degeneracy::rank_deficient:
      return "the five orientations give fewer than four independent conditions: infinitely many dyads";
    case Degeneracy::moving_on_circle:
      return "infinitely many dyads: a moving axis takes only two places, and every fixed axis as far from the one as "
             "from the other goes with it";
    case Degeneracy::fixed_on_circle:
      return "infinitely many dyads: seen from the body a fixed axis takes only two places, and every moving axis as "
             "far from the one as from the other goes with it";
    default:
      return "infinitely many dyads: a moving axis takes only two places, opposite to each other, and so does, seen "
             "from the body, the fixed axis there; all axes at right angles to the one go with the other";
  }
}

std::string degeneracy_of(std::span<const Pose> poses) {
  bool equal = false, exactly = true;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = i + 1; j < poses.size(); ++j)
      if (same_orientation(poses[i], poses[j])) equal = true, exactly = exactly && equal_exactly(poses[i], poses[j]);
  if (!equal) {
    if (poses.size() == 2 || !(distance_from_one_axis(poses) <= same_tolerance)) return "";
    exactly = one_axis_exactly(poses);
  }
  const Degeneracy what = equal ? Degeneracy::equal_orientations : Degeneracy::one_axis;
  return name_degeneracy(what, poses, same_orientation) + (exactly ? "" : ", within rounding");
}

}  // namespace burmester::spherical
