#include "burmester/planar/four_pose_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "burmester/geometry/enclosure.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

constexpr double nearby = 64;  // curve scales: a common pole farther out is far from all that is listed

/// P_ij from pose 1's origin, and what rounding the data once does to it: as (t + cot(a/2) J t) / 2 from the one
/// origin, with an angle a that is known to same_orientation_tolerance.
struct RoundedPole {
  Vector2 at;
  double rounding;
};

RoundedPole rounded_pole(FourPoses poses, std::size_t i, std::size_t j) {
  const Pose &a = poses[i], &b = poses[j], &first = poses[0];
  const Point2<double> p =
      relative_pole({a.x - first.x, a.y - first.y, a.X3, a.X4}, {b.x - first.x, b.y - first.y, b.X3, b.X4});
  const auto [s, c] = relative_turn<double>(a, b);
  const Vector2 at = p.head<2>() / p[2];
  const double sine = std::abs(s) / std::hypot(s, c),
               farthest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}),
               radius = (at - Vector2(a.x - first.x, a.y - first.y)).norm();
  return {at, (same_orientation_tolerance * radius + 4 * unit_roundoff * farthest) / sine};
}

double distance(const RoundedPole& a, const RoundedPole& b) {
  const double out = (a.at - b.at).norm();
  return std::isfinite(out) ? out : std::numeric_limits<double>::infinity();
}

template <class T>
T converted(const Rational& x) {
  if constexpr (std::is_same_v<T, double>)
    return approximate(x);
  else if constexpr (std::is_same_v<T, Interval>)
    return enclosure(x);
  else
    return T(x);
}

}  // namespace

std::optional<CommonPole> common_pole(FourPoses poses) {
  std::array<std::array<RoundedPole, 4>, 4> pole;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) pole[i][j] = rounded_pole(poses, i, j);
  CommonPole best;
  best.spread = std::numeric_limits<double>::infinity();
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const std::size_t i = left_out == 0, j = left_out <= 1 ? 2 : 1, k = left_out == 3 ? 2 : 3;
    const RoundedPole &p = pole[i][j], &q = pole[i][k], &r = pole[j][k];
    const double spread = std::max({distance(p, q), distance(p, r), distance(q, r)});
    if (!(spread < best.spread)) continue;
    const double rounding = p.rounding + q.rounding + r.rounding;
    best = {{i, j, k}, p.at + Vector2(poses[0].x, poses[0].y), spread, rounding, false};
  }
  if (!(best.spread <= together * curve_scale(poses))) return std::nullopt;
  const RoundedPole& one = pole[best.poses[0]][best.poses[1]];
  best.all = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      best.all = best.all && std::isfinite(pole[i][j].rounding) &&
                 distance(one, pole[i][j]) <= one.rounding + pole[i][j].rounding;
  return best;
}

FourPoseFrames::FourPoseFrames(FourPoses poses)
    : poses_(poses), pole_(common_pole(poses)), length_(power_of_two_below(curve_scale(poses))) {
  if (!pole_) return;
  const auto from = [&](const Pose& pose) { return Vector2(pole_->at - Vector2(pose.x, pose.y)); };
  const Vector2 origin = from(poses[pole_->poses[0]]);
  const double off = std::max(origin.norm(), from(poses[0]).norm()) / length_;
  if (!(off <= nearby)) return;
  reference_ = pole_->poses[0], origin_ = origin, off_ = off;
}

template <class T>
std::array<Correlation<T>, 3> FourPoseFrames::correlations() const {
  std::array<Correlation<T>, 3> out;
  const bool shifted = off_ > 0;
  Correlation<Rational> shift = Correlation<Rational>::Identity();
  for (int k = 0; k < 2; ++k) shift(k, 2) = Rational(origin_[k] / length_);
  for (std::size_t j = 0, k = 0; j < 4; ++j) {
    if (j == reference_) continue;
    if (!shifted) {
      out[k++] = equidistance<T>(reference(), poses_[j], 1 / length_);
      continue;
    }
    const Correlation<Rational> n =
        shift.transpose() * equidistance<Rational>(reference(), poses_[j], 1 / length_) * shift;
    out[k++] = n.unaryExpr([](const Rational& x) { return converted<T>(x); });
  }
  return out;
}

template std::array<Correlation<double>, 3> FourPoseFrames::correlations() const;
template std::array<Correlation<Interval>, 3> FourPoseFrames::correlations() const;
template std::array<Correlation<Rational>, 3> FourPoseFrames::correlations() const;
template std::array<Correlation<RationalInterval>, 3> FourPoseFrames::correlations() const;

}  // namespace burmester::planar
