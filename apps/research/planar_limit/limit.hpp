// A planar task of five poses on larger and larger spheres that touch its plane: its dyads as limits of spherical ones.
//
// e = L / radius, L the largest distance between two pose origins. All places are in pose 1 and in the fixed frame,
// those of spherical dyads where their axes meet the tangent plane.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "burmester/planar/dyads.hpp"

namespace burmester {

struct DyadPlace {
  planar::Vector2 fixed, moving;
};
/// The larger of the distances of the two pivots.
double apart(const DyadPlace& a, const DyadPlace& b);

struct FollowedDyad {
  DyadPlace planar;
  std::vector<DyadPlace> path;  ///< for e[0], e[1], ..; it ends where the spherical dyad becomes complex
};

struct PlanarLimit {
  double size = 1;                             ///< L
  std::vector<double> e;                       ///< rising
  std::vector<FollowedDyad> dyads;             ///< the planar RR dyads given
  std::vector<std::vector<DyadPlace>> others;  ///< for each e the real spherical dyads that are on no path
};

/// Follows the dyads from the smallest sphere curvature to the largest, always to the nearest dyad.
/// Preconditions: the poses are not degenerate; e rises in steps small enough for that, e[0] > 0.
PlanarLimit planar_limit(std::span<const planar::Pose, 5> poses, const std::vector<planar::RR::Design>& dyads,
                         const std::vector<double>& e);

/// Exponent p of apart ~ e^p between two steps of the path; none where it has no such steps.
std::optional<double> exponent(const PlanarLimit& limit, const FollowedDyad& dyad, std::size_t from, std::size_t to);

}  // namespace burmester
