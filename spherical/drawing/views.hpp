// From where a drawing on the sphere is looked at.
#pragma once

#include <vector>

#include "burmester/modules/framework/drawing.hpp"

namespace burmester::spherical {

/// Four views: along the mean of the points of the strokes (guides and curves, which go all round, left out), then
/// along the axes x, y, z of the fixed frame, each from the side on which that mean lies. z is up, and y where one
/// looks along z.
std::vector<SphereView> views_of(const std::vector<SphereStroke>& strokes);

}  // namespace burmester::spherical
