// The zero curves of a function sampled on a rectangular grid, by marching squares: in each cell straight segments
// between the points where linear interpolation along the cell's edges is zero. FOR PICTURES AND RAW ESTIMATES: the
// curves are off by the order of the cell size squared, and what is smaller than a cell may be missed.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace burmester {

/// Samples on a square grid over [-extent, extent]^2, `cells` + 1 in each direction, u changing fastest.
struct SampledSquare {
  double extent = 1;
  int cells = 0;
  std::vector<double> values;

  double coordinate(int index) const { return extent * (2.0 * index / cells - 1); }
  double value(int i, int j) const { return values[static_cast<std::size_t>(j * (cells + 1) + i)]; }
};

SampledSquare sampled(double extent, int cells, const std::function<double(double u, double v)>& f);

struct ContourSegment {
  std::array<double, 2> from, to;  ///< u, v
  int cell = 0;                    ///< that it lies in: row times `cells` plus column
};

/// In the order of the cells. A sample that is exactly 0 counts as positive; where the corners of a cell alternate in
/// sign, the mean of the corners decides which are joined.
std::vector<ContourSegment> zero_contour(const SampledSquare& f);

/// The segments joined into polylines; a closed one ends where it began.
std::vector<std::vector<std::array<double, 2>>> joined(const std::vector<ContourSegment>& segments);

/// Where segments of one cell cross, one of each contour. Precondition: both from grids with the same cells.
std::vector<std::array<double, 2>> crossings(const std::vector<ContourSegment>& f,
                                             const std::vector<ContourSegment>& g);

}  // namespace burmester
