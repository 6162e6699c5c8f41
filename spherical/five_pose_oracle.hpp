// Two slow, exact ways to the dyads of five orientations: what tests hold the direct solver against. Both take the
// doubles of the quaternions as exact numbers, form a polynomial of degree six with integer coefficients, and isolate
// its real roots exactly (geometry/real_roots.hpp); they share nothing with the direct solver or, before the roots,
// with each other.
//
//   elimination   c, c P, c P P from the four bilinear equations (five_pose_roots.hpp says how), by minors of integers
//   cubic cones   moving axes of the poses 1, 2, 3, 4 lie on a cubic cone, those of 1, 2, 3, 5 on another (Angeles and
//                 Bai, equations 9 and 12). Of the nine common lines three carry no dyad: the axes of the rotations
//                 between the poses 1, 2 and 3. They are rational, and divided out of Bezout's resultant.
#pragma once

#include "burmester/geometry/integer_polynomial.hpp"
#include "burmester/geometry/quad.hpp"
#include "burmester/spherical/five_pose_equations.hpp"
#include "burmester/spherical/five_pose_solver.hpp"

namespace burmester::spherical {

/// A real dyad, true to about 30 digits (two that coincide: half of that).
struct ExactDyad {
  Vector<Quad, 3> fixed, moving;  ///< unit vectors, fixed in S and moving in E; signs are free
  Quad arc;
  int multiplicity = 1;

  RR::Design rounded() const;
};

struct ExactFivePoses {
  /// The polynomial whose real roots are the real dyads, primitive; zero: infinitely many dyads, or some of finitely
  /// many that no frame tells apart.
  IntegerPolynomial eliminant;
  std::vector<ExactDyad> real;
};

/// Preconditions of both: as for FivePoseSolver. Axes are projected from a fixed line, from another where a dyad lies
/// in it, at infinity, or behind a second one; the eliminants of one projection agree up to sign.
ExactFivePoses exact_by_elimination(FivePoses poses);
ExactFivePoses exact_by_cones(FivePoses poses);

/// The number of real dyads, each counted once; nothing where the eliminant is zero. Faster than the dyads.
std::optional<int> exact_count(FivePoses poses);

struct EliminationOracle {
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* name = "five orientations, exact elimination";
  static constexpr const char* answers = "a slow oracle of the direct solver: integers, the same exact data";
  SphericalReport solve(std::span<const Pose> poses) const;
};

struct ConesOracle {
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* name = "five orientations, two cubic cones";
  static constexpr const char* answers =
      "a slow oracle of the direct solver: common lines of two circle-point cones, exact";
  SphericalReport solve(std::span<const Pose> poses) const;
};

}  // namespace burmester::spherical
