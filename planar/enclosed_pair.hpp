// A pair of pivots, exact or enclosed, as the dyad that is shown and the box that it lies in.
#pragma once

#include "burmester/geometry/rational_interval.hpp"
#include "burmester/modules/framework/given_pivots.hpp"
#include "burmester/planar/five_pose_certificate.hpp"

namespace burmester::planar {

/// From a pose's origin in directions of S, length units. T: Rational or RationalInterval.
template <class T>
struct PivotPair {
  std::array<T, 2> moving, fixed;
};

struct EnclosedDyad {
  RR::Design shown;
  DyadBox box;
  Pose from;  ///< that the pair was seen from
};

template <class T>
EnclosedDyad enclosed(const PivotPair<T>& pair, const Pose& from) {
  const T s(from.X3), c(from.X4), n = s * s + c * c, cosine = (c * c - s * s) / n, sine = 2 * s * c / n;
  const std::array<T, 2> moving{T(cosine * pair.moving[0] + sine * pair.moving[1]),
                                T(cosine * pair.moving[1] - sine * pair.moving[0])};
  const T x = pair.moving[0] - pair.fixed[0], y = pair.moving[1] - pair.fixed[1], square = x * x + y * y;
  const auto range = [](const T& number) { return range_of(RationalInterval(number)); };
  const std::array<double, 2> origin{from.x, from.y};
  EnclosedDyad out;
  out.from = from;
  for (std::size_t i = 0; i < 2; ++i) {
    out.shown.moving[static_cast<int>(i)] = approximate(moving[i]);
    out.shown.fixed[static_cast<int>(i)] = approximate(T(pair.fixed[i] + T(origin[i])));
    out.box.moving[i] = range(moving[i]), out.box.fixed[i] = range(pair.fixed[i]);
  }
  out.shown.length = std::sqrt(approximate(square));
  out.box.length = root_of(range(square));
  out.box.rung = Rung::exact;
  return out;
}

/// The dyad of a given pivot (of body `given`): the RR shown, or the slider where its partner is `far` or its circle
/// leaves the slider's line by no more than sliders may. Certified, on request, by the box.
Found<Dyads::Design> judged(const EnclosedDyad& dyad, Body given, const Vector2& pivot, bool far,
                            std::span<const Pose> poses, bool certify);

}  // namespace burmester::planar
