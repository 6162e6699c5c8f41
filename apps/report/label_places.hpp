// Places for the labels of a figure that is too full for fixed ones: each where it covers least.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : distances)
      for (int k = 0; k < directions; ++k) {
        const double angle = first_angle + k * 2 * std::numbers::pi / directions,
                     sideways = distance + half_width - half_character;
        const Point2 at{p[0] + sideways * std::cos(angle), p[1] - distance * std::sin(angle)};
        const double cost = covered(at, half_width) + cost_of_distance * distance;
        if (cost < least) least = cost, best = at;
      }
    for (const double shift : {-half_width, 0.0, half_width}) avoid({best[0] + shift, best[1]}, weight_of_label);
    return best;
  }

 private:
  static constexpr double distances[] = {15, 22};   // of a label from its point, pixels
  static constexpr int directions = 12;             // tried round the point
  static constexpr double first_angle = 0.5;        // of these, radians
  static constexpr double half_character = 4;       // pixels: a label of one character is as near sideways as above
  static constexpr double reach = 14;               // pixels: what is this far from a label is not covered
  static constexpr double cost_of_distance = 0.02;  // for each pixel: of two places that cover the same the nearer one
  static constexpr double weight_of_label = 4;      // more than a point of a curve has

  struct Taken {
    Point2 p;
    double weight;
  };
  double covered(const Point2& at, double half_width) const {
    double sum = 0;
    for (const Taken& t : taken_) {
      const double x = std::max(0.0, std::abs(t.p[0] - at[0]) - half_width), y = std::abs(t.p[1] - at[1]);
      sum += t.weight * std::max(0.0, 1 - std::hypot(x, y) / reach);
    }
    return sum;
  }
  std::vector<Taken> taken_;
};

}  // namespace burmester
