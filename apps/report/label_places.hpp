// Places for the labels of a figure that is too full for fixed ones: each where it covers least.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "report/svg.hpp"

namespace burmester {

/// Points in pixels, y downwards. First all that is drawn is noted, then the labels are placed, the most important
/// first: a label that stands counts as drawn.
class LabelPlaces {
 public:
  /// What is drawn at p, and how bad it is to cover it.
  void avoid(const Point2& p, double weight) { taken_.push_back({p, weight}); }

  /// Where to put the middle of a label that belongs to p.
  Point2 place(const Point2& p, double half_width) {
    Point2 best{};
    double least = 1e300;
    for (const double distance : {15.0, 22.0})
      for (int k = 0; k < 12; ++k) {
        const double angle = k * std::numbers::pi / 6 + 0.5;
        const Point2 at{p[0] + (distance + half_width - 4) * std::cos(angle), p[1] - distance * std::sin(angle)};
        if (const double cost = covered(at, half_width) + 0.02 * distance; cost < least) least = cost, best = at;
      }
    for (const double shift : {-half_width, 0.0, half_width}) avoid({best[0] + shift, best[1]}, 4);
    return best;
  }

 private:
  struct Taken {
    Point2 p;
    double weight;
  };
  double covered(const Point2& at, double half_width) const {
    double sum = 0;
    for (const Taken& t : taken_) {
      const double x = std::max(0.0, std::abs(t.p[0] - at[0]) - half_width), y = std::abs(t.p[1] - at[1]);
      sum += t.weight * std::max(0.0, 1 - std::hypot(x, y) / 14);
    }
    return sum;
  }
  std::vector<Taken> taken_;
};

}  // namespace burmester
