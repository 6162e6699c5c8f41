#include "burmester/spherical/degeneracy.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace burmester::spherical {
namespace {

using Orientations = std::array<Pose, 5>;

/// From orientations that bring an axis of S to one place where it is in i and j, and to one in the others (i = j: four
/// others).
double distance_from_two_places(const Orientations& poses, std::size_t i, std::size_t j) {
  const double apart = i == j ? 1 : 2;
  Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(3, 10);
  for (std::size_t k = 0, column = 0; k < 5; ++k)
    for (std::size_t l = k + 1; l < 5; ++l, ++column) {
      const bool first = k == i || k == j, second = l == i || l == j;
      if (first == second)
        turns.col(static_cast<Eigen::Index>(column)) =
            half_angle_sine(poses[k], poses[l]) / std::sqrt(first ? apart : 5 - apart);
    }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turns);
  return svd.singularValues().tail(2).norm();
}

double distance_from_three_and_two(const Orientations& poses) {
  double least = 2;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) least = std::min(least, distance_from_two_places(poses, i, j));
  return least;
}

}  // namespace

NearDegeneracy axis_in_two_places(FivePoses poses) {
  Orientations of_E, of_S;
  for (std::size_t i = 0; i < 5; ++i) {
    const Pose& p = poses[i];
    of_S[i] = p, of_E[i] = {p.w, -p.x, -p.y, -p.z};
  }
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
