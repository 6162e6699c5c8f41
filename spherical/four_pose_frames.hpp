// Four orientations seen from one of a closest pair: their equations, and the axes in the frames that people know.
#pragma once

#include <array>
#include <optional>

#include "burmester/spherical/dyads.hpp"
#include "burmester/spherical/equal_angles.hpp"
#include "burmester/spherical/shared_rotation.hpp"

namespace burmester::spherical {

/// Moving axes in E; fixed ones in S turned back by the reference pose. Keeps the span.
class FourPoseFrames {
 public:
  explicit FourPoseFrames(FourPoses poses) : poses_(poses), reference_(static_cast<std::size_t>(reference_of(poses))) {}

  static double length() { return 1; }
  const Pose& reference() const { return poses_[reference_]; }
  /// a^T N b' = 0 for moving axes a and fixed axes b'. With a shared rotation: of orientations that share it exactly.
  template <class T>
  std::array<Correlation<T>, 3> correlations(const std::optional<SharedRotation>& shared = {}) const {
    std::array<Correlation<T>, 3> n;
    const auto seen = [&](std::size_t j) { return relative_rotation<T>(poses_[reference_], poses_[j]); };
    const auto [i, j, k, last] = shared ? shared->from(reference_) : std::array<std::size_t, 4>{4, 4, 4, 4};
    for (std::size_t pose = 0, at = 0; pose < 4; ++pose)
      if (pose != reference_) n[at++] = equal_angles(pose == last ? Space::product<T>(seen(j), seen(k)) : seen(pose));
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
  FourPoses poses_;
  std::size_t reference_;
};

}  // namespace burmester::spherical
