#include "burmester/spherical/near_curve.hpp"

#include <cmath>
#include <type_traits>

#include "burmester/spherical/five_pose_certificate.hpp"
#include "burmester/spherical/four_pose_frames.hpp"
#include "burmester/spherical/pivots.hpp"

namespace burmester::spherical {
namespace {

template <class T>
Point2<double> near_one(const Point2<T>& p) {
  return {approximate(p[0]), approximate(p[1]), approximate(p[2])};
}

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
  Point2<double> seen(const std::vector<double>& b) const {
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

  template <class T>
  Found<Dyads::Design> dyad(const Point2<T>& b, const Point2<T>& a) const {
    auto found = judged(frames_.fixed(near_one(b)), frames_.moving(near_one(a)), Body::fixed, poses_);
    if constexpr (std::is_same_v<T, RationalInterval>) {
      const AxesBox box{.moving = ranges(a), .fixed = ranges(b), .rung = Rung::exact};
      if (const double radius = error_bound(found.design, box, frames_.reference()); std::isfinite(radius))
        found.certificate = {true, radius, box.rung};
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
