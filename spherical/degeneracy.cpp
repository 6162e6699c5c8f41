#include "burmester/spherical/degeneracy.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// From orientations that bring an axis of S to one place where it is in i and j, and to one in the others (i = j: four
/// others).
double distance_from_two_places(const Turns& turns, std::size_t i, std::size_t j) {
  const double apart = i == j ? 1 : 2;
  std::array<Vector3, 6> within;  // pairs of four, or of three and two
  std::size_t count = 0;
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t l = k + 1; l < 5; ++l) {
      const bool first = k == i || k == j, second = l == i || l == j;
      if (first == second) within[count++] = turns[k][l] / std::sqrt(first ? apart : 5 - apart);
    }
  const std::span<const Vector3> all(within.data(), count);
  const Vector3 v = common_direction(all);
  double square = 0;  // not from the small eigenvalues, which have half of the digits
  for (const Vector3& s : all) square += s.cross(v).squaredNorm();
  return std::sqrt(square);
}

double distance_from_three_and_two(const Turns& turns) {
  double least = 2;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) least = std::min(least, distance_from_two_places(turns, i, j));
  return least;
}

}  // namespace

NearDegeneracy axis_in_two_places(FivePoses poses) {
  std::array<Pose, 5> inverse;
  for (std::size_t i = 0; i < 5; ++i)
    inverse[i] = Space::pose(Space::conjugate<double>(Space::point<double>(poses[i])));
  const Turns of_S = turns_between(poses), of_E = turns_between(inverse);
  double four = 2;
  for (std::size_t i = 0; i < 5; ++i) four = std::min(four, distance_from_two_places(of_S, i, i));
  const double moving = distance_from_three_and_two(of_E), fixed = distance_from_three_and_two(of_S);
  NearDegeneracy out{Degeneracy::none, std::min({four, moving, fixed})};
  if (four <= same_tolerance)
    out.kind = Degeneracy::rank_deficient;
  else if (std::max(moving, fixed) <= same_tolerance)
    out.kind = Degeneracy::both_on_circles;
  else if (out.distance <= same_tolerance)
    out.kind = moving < fixed ? Degeneracy::moving_on_circle : Degeneracy::fixed_on_circle;
  return out;
}

}  // namespace burmester::spherical
