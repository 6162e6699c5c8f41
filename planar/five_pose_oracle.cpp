#include "burmester/planar/five_pose_oracle.hpp"

#include "burmester/planar/five_pose_steps.hpp"

namespace burmester::planar {

namespace detail {
template <>
constexpr int newton_steps<Quad> = 3;
}

FivePoseRoots<Quad> five_pose_roots_quad(FivePoses poses) { return detail::solve<Quad>(poses, choose_anchor(poses)); }

FivePoseRoots<Quad> five_pose_roots_as_given(FivePoses poses) {
  AnchorChoice choice = choose_anchor(poses);
  choice.noise = 0;
  return detail::solve<Quad>(poses, choice);
}

}  // namespace burmester::planar
