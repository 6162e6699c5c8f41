#include "burmester/planar/anchored_basis.hpp"

#include <limits>

namespace burmester::planar {

AnchorChoice choose_anchor(FivePoses poses) {
  double distance2[10], turn2[10], longest = 0, widest = 0, narrowest = std::numeric_limits<double>::infinity();
  double per_norm[5];
  for (int i = 0; i < 5; ++i) per_norm[i] = 2 / (poses[i].X3 * poses[i].X3 + poses[i].X4 * poses[i].X4);
  for (int i = 0, k = 0; i < 5; ++i) {
    const Pose& a = poses[i];
    for (int j = i + 1; j < 5; ++j, ++k) {
      const Pose& b = poses[j];
      const double x = b.x - a.x, y = b.y - a.y, s = b.X3 * a.X4 - b.X4 * a.X3;
      distance2[k] = x * x + y * y;
      turn2[k] = s * s * per_norm[i] * per_norm[j];
      longest = std::max(longest, distance2[k]);
      widest = std::max(widest, turn2[k]);
      narrowest = std::min(narrowest, turn2[k]);
    }
  }
  constexpr double same_turn2 = 4 * same_orientation_tolerance * same_orientation_tolerance;
  AnchorChoice out;
  out.parallel_pair = narrowest <= 4 * same_turn2;
  out.anchor.length = longest > 0 ? power_of_two_below(std::sqrt(longest)) : 1;
  out.anchor.turn = widest > same_turn2 ? power_of_two_below(std::sqrt(widest)) : 0;
  const double per_length2 = longest > 0 ? 1 / longest : 0, per_turn2 = out.anchor.turn > 0 ? 1 / widest : 0;
  double closest = std::numeric_limits<double>::infinity();
  for (int i = 0, k = 0; i < 5; ++i)
    for (int j = i + 1; j < 5; ++j, ++k) {
      const double apart = distance2[k] * per_length2 + turn2[k] * per_turn2;
      if (apart < closest) closest = apart, out.anchor.reference = i;
      const bool one_place = poses[i].x == poses[j].x && poses[i].y == poses[j].y;  // squares may underflow
      if (one_place && turn2[k] <= 4 * same_turn2 && same_orientation(poses[i], poses[j])) out.equal_poses = true;
    }
  double farthest = 0;
  for (const Pose& p : poses) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  const double per_turn = out.anchor.turn > 0 ? 1 / out.anchor.turn : 0;
  if (closest > 0)
    out.noise =
        unit_roundoff * std::max({1.0, farthest / out.anchor.length, per_turn}) / std::sqrt(std::min(1.0, closest));
  const bool drowned = closest == 0 && !out.equal_poses;
  if (drowned || out.noise > largest_noise) out.noise = unit_roundoff, out.indistinct = true;
  return out;
}

}  // namespace burmester::planar
