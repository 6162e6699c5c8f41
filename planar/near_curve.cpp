#include "burmester/planar/near_curve.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "burmester/planar/enclosed_pair.hpp"
#include "burmester/planar/four_pose_frames.hpp"
#include "burmester/planar/pivots.hpp"

namespace burmester::planar {
namespace {

/// Seen as the curves are traced.
class Centres {
 public:
  using Pivots = planar::Pivots;
  static constexpr Surface surface = Surface::plane;

  explicit Centres(FourPoses poses) : frames_(poses) {}

  double length() const { return frames_.length(); }
  Point2<double> seen(std::span<const double> c) const { return frames_.seen({c[0], c[1]}); }
  template <class T>
  std::array<Correlation<T>, 3> correlations() const {
    auto n = frames_.correlations<T>();
    for (Correlation<T>& form : n) form.transposeInPlace();
    return n;
  }
  static bool finite(const Point2<RationalInterval>& partner) { return !contains_zero(partner[2]); }

  /// A slider where the partner is at infinity.
  Found<Dyads::Design> dyad(const Point2<double>& c, const Point2<Rational>& p,
                            const std::optional<PairBox>& box) const {
    const Vector2 at = frames_.fixed(c);
    const bool far =
        !(std::abs(approximate(p[2])) > 256 * unit_roundoff * std::hypot(approximate(p[0]), approximate(p[1])));
    if (far) return judged({}, Body::fixed, at, true, frames_.poses(), false);
    EnclosedDyad found = enclosed(pair_of<Rational>(c.cast<Rational>(), p), frames_.reference());
    if (box) found.box = enclosed(pair_of(box->centre, box->partner), frames_.reference()).box;
    return judged(found, Body::fixed, at, false, frames_.poses(), box.has_value());
  }

 private:
  template <class T>
  PivotPair<T> pair_of(const Point2<T>& c, const Point2<T>& p) const {
    const T unit(frames_.length()), x(frames_.origin()[0]), y(frames_.origin()[1]);
    return {{T(x + unit * p[0] / p[2]), T(y + unit * p[1] / p[2])}, {T(x + unit * c[0]), T(y + unit * c[1])}};
  }
  FourPoseFrames frames_;
};

}  // namespace

NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify) {
  return burmester::dyads_near(Centres(poses), curves, near, certify);
}

}  // namespace burmester::planar
