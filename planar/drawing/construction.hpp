// The two constructions of a dyad for three poses and a given fixed pivot (MECH 576, section 5.2), drawn.
//
// M: the given pivot. Carried back with pose j to pose 1 it comes to M_j; the moving pivot in pose 1 is as far from M
// as from M_2 and M_3 (inversion). M_j is also M turned back about the pole P_1j, where the bisectors of the paths of
// two points of the body meet, and the bisector of M M_j passes through it (poles). M_2 comes to M_3 by a turn about
// the image pole P'_23, the point of the body at the pole of poses 2 and 3, in pose 1.
#pragma once

#include <span>
#include <vector>

#include "burmester/modules/framework/drawing.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

/// Inversion and poles, for one dyad: an RR, or an RP whose bisectors are parallel; for an RR also both step by step in
/// six panels. `number` counts the given pivots from 1 and is part of the names. Precondition: three poses.
std::vector<Plate> three_pose_constructions(std::span<const Pose> poses, const Dyads::Design& dyad,
                                                          int number);

}  // namespace burmester::planar
