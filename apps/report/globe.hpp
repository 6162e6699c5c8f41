// The unit sphere in an orthographic view: what lies on the near side and what on the far side.
#pragma once

#include <vector>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester {

/// Part of a polyline that lies on one side, in the view's plane: right, up.
struct GlobeRun {
  bool near = true;
  Polyline points;
};

/// On the near side; points of the limb count as near.
bool is_near(const SphereView& view, const std::array<double, 3>& p);
std::array<double, 2> projected(const SphereView& view, const std::array<double, 3>& p);
/// The polyline cut where it crosses the limb; the points put in there lie on the limb.
std::vector<GlobeRun> runs_of(const SphereView& view, const std::vector<std::array<double, 3>>& points, bool closed);
/// Meridians and parallels every 30 degrees.
std::vector<std::vector<std::array<double, 3>>> graticule();

}  // namespace burmester
