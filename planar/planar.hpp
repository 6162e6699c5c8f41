// The planar module: rigid bodies of the plane guided by RR, PR, RP and PP dyads. Where to start:
//   pose.hpp, space.hpp      poses, and the image space P^3 (Blaschke-Gruenwald)
//   dyads.hpp, family.hpp    the dyad types, and the one linear family they all live in
//   synthesis.hpp            five poses in, every dyad with residual and condition out
//   linkage.hpp              two dyads closed by the coupler: type, link lengths, class
//   five_pose_roots.hpp      the solver itself; anchored_basis.hpp has its equations
//   tasks.hpp                random, planted and degenerate tasks by name
#pragma once

#include <memory>

#include "burmester/modules/framework/module.hpp"

namespace burmester::planar {

std::unique_ptr<Module> make_module();

}  // namespace burmester::planar
