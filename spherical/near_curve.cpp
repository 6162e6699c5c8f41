#include "burmester/spherical/near_curve.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "burmester/spherical/five_pose_certificate.hpp"
#include "burmester/spherical/four_pose_frames.hpp"
#include "burmester/spherical/pivots.hpp"

namespace burmester::spherical {
namespace {

std::array<Range, 3> ranges(const Point2<RationalInterval>& p) {
  return {range_of(p[0]), range_of(p[1]), range_of(p[2])};
}

/// Seen from the reference pose.
class Centres {
 public:
  using Pivots = spherical::Pivots;
  static constexpr Surface surface = Surface::sphere;

  explicit Centres(FourPoses poses) : poses_(poses), frames_(poses) {}

  static double length() { return FourPoseFrames::length(); }
  Point2<double> seen(std::span<const double> b) const {
    const Axis axis(b[0], b[1], b[2]);
    return frames_.seen(axis / axis.cwiseAbs().maxCoeff());
  }
  template <class T>
  std::array<Correlation<T>, 3> correlations() const {
    auto n = frames_.correlations<T>();
    for (Correlation<T>& form : n) form.transposeInPlace();
    return n;
  }
  static bool finite(const Point2<RationalInterval>& partner) { return !detail::may_vanish(partner); }

  Found<Dyads::Design> dyad(const Point2<double>& b, const Point2<Rational>& a,
                            const std::optional<PairBox>& box) const {
    auto found = judged(frames_.fixed(b), frames_.moving(detail::to_double(a)), Body::fixed, poses_);
    if (box) {
      const AxesBox axes{.moving = ranges(box->partner), .fixed = ranges(box->centre), .rung = Rung::exact};
      if (const double radius = error_bound(found.design, axes, frames_.reference()); std::isfinite(radius))
        found.certificate = {true, radius, axes.rung};
    }
    return found;
  }

 private:
  FourPoses poses_;
  FourPoseFrames frames_;
};

}  // namespace

NearDyads dyads_near(FourPoses poses, const std::vector<CurveRecord>& curves,
                     const std::vector<std::vector<double>>& near, bool certify) {
  return burmester::dyads_near(Centres(poses), curves, near, certify);
}

}  // namespace burmester::spherical
