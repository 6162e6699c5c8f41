// What the tests of the proof for five orientations read off its answer.
#pragma once

#include <algorithm>
#include <vector>

#include "burmester/spherical/five_pose_certificate.hpp"

namespace burmester::spherical {

inline std::vector<AxisPair> listed(const CertifiedAxes& axes) {
  return {axes.axes.begin(), axes.axes.begin() + std::max(0, axes.count)};
}
inline std::vector<AxesBox> boxes(const CertifiedAxes& axes) {
  return {axes.boxes.begin(), axes.boxes.begin() + std::max(0, axes.count)};
}
/// What a good solver would find: the exact dyads, rounded.
inline std::vector<AxisPair> found_in(FivePoses poses) { return listed(certified_axes(poses, {})); }

inline RR::Design shown(const AxisPair& axes, const Pose& reference) {
  const RR::Design d{axes.fixed, axes.moving, 0};
  return {d.fixed, d.moving, RR::residual(d, reference)};
}

/// As far as doubles tell: the same two lists of lines, in the same order.
inline bool same_axes(const AxisPair& a, const AxisPair& b) {
  const auto apart = [](const Axis& u, const Axis& v) { return u.normalized().cross(v.normalized()).norm(); };
  return apart(a.moving, b.moving) < 1e-9 && apart(a.fixed, b.fixed) < 1e-9;
}

}  // namespace burmester::spherical
