#include "burmester/planar/five_pose_oracle.hpp"

#include "burmester/planar/five_pose_steps.hpp"

namespace burmester::planar {

namespace detail {
template <>
constexpr int newton_steps<Quad> = 3;
}

FivePoseRoots<Quad> five_pose_roots_quad(FivePoses poses) { return detail::solve<Quad>(poses); }

}  // namespace burmester::planar
