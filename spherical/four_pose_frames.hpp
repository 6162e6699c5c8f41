// Four orientations seen from one of a closest pair: their equations, and the axes in the frames that people know.
#pragma once

#include <array>
#include <span>

#include "burmester/spherical/dyads.hpp"
#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {

/// Moving axes in E; fixed ones in S turned back by the reference pose. Keeps the span.
class FourPoseFrames {
 public:
  explicit FourPoseFrames(std::span<const Pose, 4> poses)
      : poses_(poses), reference_(static_cast<std::size_t>(reference_of(poses))) {}

  static double length() { return 1; }
  const Pose& reference() const { return poses_[reference_]; }
  /// a^T N b' = 0 for moving axes a and fixed axes b'
  template <class T>
  std::array<Correlation<T>, 3> correlations() const {
    std::array<Correlation<T>, 3> n;
    for (std::size_t j = 0, k = 0; j < 4; ++j)
      if (j != reference_) n[k++] = equal_angles(relative_rotation<T>(poses_[reference_], poses_[j]));
    return n;
  }
  static Axis moving(const Point2<double>& a) { return a.normalized(); }
  Axis fixed(const Point2<double>& b) const {
    return Space::act<double>(Space::point<double>(reference()), b).normalized();
  }
  /// b' of a fixed axis in S.
  Point2<double> seen(const Axis& fixed) const {
    return Space::act<double>(Space::conjugate<double>(Space::point<double>(reference())), fixed).normalized();
  }

 private:
  std::span<const Pose, 4> poses_;
  std::size_t reference_;
};

}  // namespace burmester::spherical
