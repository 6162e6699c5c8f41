#include "report/label_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace burmester {
namespace {

TEST(LabelPlaces, AreOnTheEmptySide) {
  const Point2 p{100, 100};
  for (const double side : {-1.0, 1.0}) {
    LabelPlaces labels;
    for (double x = 0; x <= 40; x += 4)
      for (double y = -40; y <= 40; y += 4) labels.avoid({p[0] + side * x, p[1] + y}, 1);
    EXPECT_LT(side * (labels.place(p, 5)[0] - p[0]), 0) << side;
  }
}

TEST(LabelPlaces, OfOnePointAreApart) {
  LabelPlaces labels;
  std::vector<Point2> placed;
  for (int k = 0; k < 4; ++k) placed.push_back(labels.place({0, 0}, 4));
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_LT(std::hypot(placed[i][0], placed[i][1]), 23) << "near its point: " << i;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(std::hypot(placed[i][0] - placed[k][0], placed[i][1] - placed[k][1]), 8) << i << " and " << k;
  }
}

}  // namespace
}  // namespace burmester
