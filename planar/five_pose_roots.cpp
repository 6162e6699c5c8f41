#include "burmester/planar/five_pose_roots.hpp"

#include "burmester/planar/five_pose_steps.hpp"

namespace burmester::planar {

FivePoseRoots<double> five_pose_roots(FivePoses poses) { return detail::solve<double>(poses, choose_anchor(poses)); }

}  // namespace burmester::planar
