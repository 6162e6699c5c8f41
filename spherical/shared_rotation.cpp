#include "burmester/spherical/shared_rotation.hpp"

#include <algorithm>

namespace burmester::spherical {
namespace {

constexpr double rounding = 0x1p-48, least_turn = 0x1p-20;  // radians

using Rotation = Quaternion<double>;

/// Between two unit quaternions, either of which may be taken with the other sign.
double angle(const Rotation& a, const Rotation& b) { return 2 * std::min((a - b).norm(), (a + b).norm()); }

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
    if (off < (best ? best->off : rounding)) best = SharedRotation{at, off};
  } while (std::next_permutation(at.begin() + 1, at.end()));
  return best;
}

}  // namespace burmester::spherical
