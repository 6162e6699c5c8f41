#include "burmester/planar/near_curve.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "burmester/planar/enclosed_pair.hpp"
#include "burmester/planar/pivots.hpp"

namespace burmester::planar {
namespace {

/// Seen from pose 1's origin, in units of length().
class Centres {
 public:
  using Pivots = planar::Pivots;
  static constexpr Surface surface = Surface::plane;

  explicit Centres(FourPoses poses) : poses_(poses), length_(power_of_two_below(curve_scale(poses))) {}

  double length() const { return length_; }
  Point2<double> seen(std::span<const double> c) const {
    return {(c[0] - poses_[0].x) / length_, (c[1] - poses_[0].y) / length_, 1};
  }
  template <class T>
  std::array<Correlation<T>, 3> correlations() const {
    std::array<Correlation<T>, 3> n;
    for (std::size_t j = 0; j < 3; ++j) n[j] = equidistance<T>(poses_[0], poses_[j + 1], 1 / length_).transpose();
    return n;
  }
  static bool finite(const Point2<RationalInterval>& partner) { return !contains_zero(partner[2]); }

  /// A slider where the partner is at infinity.
  Found<Dyads::Design> dyad(const Point2<double>& c, const Point2<Rational>& p,
                            const std::optional<PairBox>& box) const {
    const Vector2 at = length_ * c.head<2>() + Vector2(poses_[0].x, poses_[0].y);
    const bool far =
        !(std::abs(approximate(p[2])) > 256 * unit_roundoff * std::hypot(approximate(p[0]), approximate(p[1])));
    if (far) return judged({}, Body::fixed, at, true, poses_, false);
    EnclosedDyad found = enclosed(pair_of<Rational>(c.cast<Rational>(), p), poses_[0]);
    if (box) found.box = enclosed(pair_of(box->centre, box->partner), poses_[0]).box;
    return judged(found, Body::fixed, at, false, poses_, box.has_value());
  }

 private:
  template <class T>
  PivotPair<T> pair_of(const Point2<T>& c, const Point2<T>& p) const {
    const T unit(length_);
    return {{T(unit * p[0] / p[2]), T(unit * p[1] / p[2])}, {T(unit * c[0]), T(unit * c[1])}};
  }
  FourPoses poses_;
  double length_;
};

}  // namespace

NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify) {
  return burmester::dyads_near(Centres(poses), curves, near, certify);
}

}  // namespace burmester::planar
