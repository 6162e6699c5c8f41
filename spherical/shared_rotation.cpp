#include "burmester/spherical/shared_rotation.hpp"

#include <algorithm>

#include "burmester/geometry/rational.hpp"
#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {
namespace {

// Radians. In units of 2^-53 a unit quaternion in doubles is off by up to 1, normalised once more by as much again, and
// a product of two by up to 8 (each coordinate a sum of four products); the angle is twice the chord. Four quaternions
// and two products, that of the task and the one here: 2 (4 (1 + 1) + 2 * 8) = 48 units where all errors add up, 14 at
// most in two million random tasks; 2^-48 is 32.
constexpr double rounding = 0x1p-48;
// So rounding stays below 2^-28 of the smallest rotation between two orientations.
constexpr double least_turn = 0x1p-20;

using Rotation = Quaternion<double>;

/// Between two unit quaternions, either of which may be taken with the other sign.
double angle(const Rotation& a, const Rotation& b) { return 2 * std::min((a - b).norm(), (a + b).norm()); }

/// Whether R_j R_i^-1 = R_l R_k^-1, seen from pose i: R_i^-1 R_j R_i^-1 R_k = R_i^-1 R_l.
bool is_shared_exactly(FourPoses poses, const std::array<std::size_t, 4>& at) {
  const auto seen = [&](std::size_t n) { return relative_rotation<Rational>(poses[at[0]], poses[at[n]]); };
  const Matrix<Rational, 4, 4> both = Space::product<Rational>(seen(1), seen(2)) * seen(3).transpose();
  return both == both.transpose();
}

}  // namespace

std::array<std::size_t, 4> SharedRotation::from(std::size_t pose) const {
  const auto [i, j, k, l] = poses;
  if (pose == j) return {j, i, l, k};
  if (pose == k) return {k, l, i, j};
  if (pose == l) return {l, k, j, i};
  return poses;
}

std::optional<SharedRotation> shared_rotation(FourPoses poses) {
  std::array<Rotation, 4> q;
  std::ranges::transform(poses, q.begin(), [](const Pose& p) { return Space::point<double>(p).normalized(); });
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (angle(q[i], q[j]) < least_turn) return std::nullopt;
  std::optional<SharedRotation> best;
  std::array<std::size_t, 4> at{0, 1, 2, 3};
  do {
    const auto& [i, j, k, l] = at;
    const Rotation turn = Space::product<double>(q[j], Space::conjugate<double>(q[i]));
    const double off = angle(Space::product<double>(turn, q[k]), q[l]);
    if (!(off < rounding)) continue;
    if (is_shared_exactly(poses, at)) return SharedRotation{at, 0, true};
    if (!best || off < best->off) best = SharedRotation{at, off, false};
  } while (std::next_permutation(at.begin() + 1, at.end()));
  return best;
}

}  // namespace burmester::spherical
