// The two surfaces on which curves are drawn: plane and sphere, as sets of vectors.
#pragma once

namespace burmester {

/// z = 1, or the unit sphere, on which a point and its opposite are one.
enum class Surface { plane, sphere };

}  // namespace burmester
