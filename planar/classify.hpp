// From a root of the five-pose equations to a dyad of a type.
//
// A root is shown as a slider when its circle leaves the best line over the poses by at most 1e-9 of the task
// size (PR: the places of the moving pivot in S; RP: the places of the fixed pivot in E); an RR within 1e-3 also
// carries the slider that it nearly is. Only circles wider than the task are considered: the places of a pivot
// that hardly moves lie on any line.
#pragma once

#include <optional>

#include "burmester/geometry/line_fit.hpp"
#include "burmester/modules/framework/report.hpp"
#include "burmester/planar/anchored_basis.hpp"
#include "burmester/planar/dyads.hpp"

namespace burmester::planar {

inline constexpr double slider_departure = 1e-9;       ///< of the task size: given as PR or RP
inline constexpr double near_slider_departure = 1e-3;  ///< of the task size: an RR that carries its slider

/// A fitted line by its normal.
Line line_of(const FittedLine& fit);

struct Slider {
  const char* type;
  Line line;
  double departure;  ///< largest distance of a place of the pivot from the line
};

/// The best line through the places of a moving pivot, or of a fixed pivot (given from the reference pose's origin) as
/// the body sees it, in any number of poses. Nothing for a pivot that is not finite.
std::optional<Slider> PR_through(const Vector2& moving, std::span<const Pose> poses, const Pose& reference);
std::optional<Slider> RP_through(const Vector2& fixed, std::span<const Pose> poses, const Pose& reference);

/// Residual and condition are left to the caller. T is the number type of the root (double or Quad). `threshold`: the
/// departure, in task sizes, up to which a slider is given.
template <class T>
Found<Dyads::Design> classify(const Anchored<T>& w, const Anchor& anchor, FivePoses poses, double task_size,
                              double threshold = slider_departure);

}  // namespace burmester::planar
