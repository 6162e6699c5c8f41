// The spherical module: rigid bodies that turn about a fixed centre, guided by RR dyads and sliders.
// Where to start:
//   pose.hpp, space.hpp      poses, and the image space P^3 (quaternions)
//   dyads.hpp, family.hpp    the dyad types, and the one linear family they all live in
//   five_pose_solver.hpp     five orientations in, a report with every dyad out (docs/spherical.md)
//   tasks.hpp                tasks by name, for tests and measurements
//   linkage.hpp              two dyads closed by the coupler
//   drawing.hpp              linkages on the unit sphere
//   semigraphical.hpp        five orientations by contour plots, to look at
//   pose_format.hpp          the poses that files may hold
#pragma once

#include <memory>

#include "burmester/modules/framework/module.hpp"

namespace burmester::spherical {

std::unique_ptr<Module> make_module();

}  // namespace burmester::spherical
