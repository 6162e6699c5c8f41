// The sliders of four orientations: up to six pairs of axes at right angles in all four.
//
//     b . Q_j a = 0,   j = 1 .. 4
// (equations 13 to 15 of J. Angeles, S. Bai, "A robust solution of the spherical Burmester problem", for four
// attitudes): four bilinear equations, the 4 x 3 matrix with the rows a^T Q_j^T has rank two or less. So they are
// solved like the dyads of five orientations (five_pose_sextic.hpp), over rationals: all real ones, enclosed and
// counted exactly. Special orientations, half turns about three axes at right angles for instance, have infinitely
// many.
#pragma once

#include <optional>
#include <vector>

#include "burmester/modules/framework/report.hpp"
#include "burmester/spherical/dyads.hpp"

namespace burmester::spherical {

struct FoundSlider {
  Found<Dyads::Design> slider;  ///< with its certificate
  int multiplicity = 1;         ///< so many sliders over the complex numbers coincide here
};

/// All different real sliders, proved; nothing where no chart shows each of them alone (exact_axes.hpp), as where there
/// are infinitely many.
std::optional<std::vector<FoundSlider>> sliders(FourPoses poses);

/// Infinitely many sliders, proved.
struct SliderFamily {
  int moving = 0, fixed = 0;                         ///< degrees of the cones that their axes fill (axes_family.hpp)
  std::optional<std::vector<FoundSlider>> isolated;  ///< those in no family, proved; nothing: not decided
};

/// Nothing where there are finitely many: infinitely many are always found to be so (docs/certificates.md). What is
/// left undecided, neither function answering, are finitely many that no chart shows each alone.
std::optional<SliderFamily> slider_family(FourPoses poses);

}  // namespace burmester::spherical
