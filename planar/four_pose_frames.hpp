// Four poses as their curves are computed: seen from one pose and one point, in a length of their own.
//
// Usually pose 1 and its origin. Where three poses turn nearly about one point O, the circle points or the centre
// points of a whole branch are as near to O as the three poles are to each other (docs/curves.md): there one of the
// three poses is the reference, and O the origin of both planes, so that doubles tell these points apart.
#pragma once

#include <array>
#include <optional>

#include "burmester/planar/equidistance.hpp"
#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

/// Of a length: poles this close are one. Frames are chosen with the curve scale (farther apart, doubles about pose 1's
/// origin keep 1e-13), words with the task size.
inline constexpr double together = 0x1p-9;

/// Three poses that turn about one point, nearly: their three poles are one to within `spread`.
struct CommonPole {
  std::array<std::size_t, 3> poses{};  ///< ascending, from 0
  Vector2 at{0, 0};                    ///< in S, one of the poles
  double spread = 0;                   ///< largest distance of two of the poles, length units
  double rounding = 0;                 ///< what rounding the data may make of that distance
  bool all = false;                    ///< the same holds for all six poles of the four poses
};

/// The three poses whose poles are closest, where these are together for the curve scale.
std::optional<CommonPole> common_pole(FourPoses poses);

/// Points p in E and c in S as (x, y, z), in directions of S with E in the reference pose, from the origin, in units of
/// length(). Keeps the span.
class FourPoseFrames {
 public:
  explicit FourPoseFrames(FourPoses poses);

  FourPoses poses() const { return poses_; }
  const std::optional<CommonPole>& pole() const { return pole_; }
  /// Whether that is the origin.
  bool is_about_pole() const { return off_ > 0; }
  double length() const { return length_; }
  /// About the origin, wider by the distance of pose 1's origins, in the same unit.
  double window(double about_pose_1) const { return about_pose_1 + off_; }
  /// p^T N c = 0
  template <class T>
  std::array<Correlation<T>, 3> correlations() const;
  Vector2 moving(const Point2<double>& p) const {
    return to_moving({0, 0, reference().X3, reference().X4}, origin_ + length_ / p[2] * Vector2(p[0], p[1]));
  }
  Vector2 fixed(const Point2<double>& c) const {
    return origin_ + length_ / c[2] * Vector2(c[0], c[1]) + Vector2(reference().x, reference().y);
  }
  Point2<double> seen(const Vector2& fixed) const {
    const Vector2 c = (fixed - Vector2(reference().x, reference().y) - origin_) / length_;
    return {c[0], c[1], 1};
  }
  const Pose& reference() const { return poses_[reference_]; }
  /// From the reference pose's origin, in S.
  const Vector2& origin() const { return origin_; }

 private:
  FourPoses poses_;
  std::optional<CommonPole> pole_;
  std::size_t reference_ = 0;
  double length_, off_ = 0;
  Vector2 origin_{0, 0};
};

}  // namespace burmester::planar
