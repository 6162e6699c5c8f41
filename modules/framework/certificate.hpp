// Certificates: what is proved of an answer, made by a step of its own.
//
// Two halves: each dyad listed is the only one in a box (`radius` bounds its distance from the values shown), and the
// number of real dyads is proved, so that nothing is missing. A certificate speaks of the exact problem: the doubles
// of the poses, read as exact numbers. Which arithmetic decided is told by the rung.
#pragma once

#include "burmester/geometry/rung.hpp"

namespace burmester {

struct Certificate {
  bool certified = false;
  double radius = 0;  ///< distance of all that is shown (coordinates and lengths, angles in radians) from the truth
  Rung rung = Rung::none;
};

}  // namespace burmester
