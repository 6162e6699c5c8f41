#include "burmester/geometry/random.hpp"

#include <gtest/gtest.h>

namespace burmester {

// Tasks, goldens and benchmarks are named by their seeds: the numbers may never change.
TEST(Random, StreamsAreFixed) {
  EXPECT_EQ(seed_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(seed_of("a"), 0xaf63dc4c8601ec8cu);  // the published FNV-1a value
  Random first("golden"), again("golden");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(first.uniform(), again.uniform());
}

TEST(Random, NamesGiveDifferentStreams) { EXPECT_NE(Random("planar.1").uniform(), Random("planar.2").uniform()); }

TEST(Random, UniformFillsItsInterval) {
  Random random("Random.UniformFillsItsInterval");
  double low = 1, high = 0, sum = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform();
    ASSERT_TRUE(x >= 0 && x < 1);
    low = std::min(low, x), high = std::max(high, x), sum += x;
  }
  EXPECT_LT(low, 1e-3);
  EXPECT_GT(high, 1 - 1e-3);
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));  // five standard deviations
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
  Random random("Random.NormalHasMeanZeroAndVarianceOne");
  double sum = 0, squares = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    ASSERT_TRUE(std::isfinite(x));
    sum += x, squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
}

TEST(Random, BelowHitsEveryNumber) {
  Random random("Random.BelowHitsEveryNumber");
  int hits[5] = {};
  for (int i = 0; i < 5000; ++i) {
    const int k = random.below(5);
    ASSERT_TRUE(k >= 0 && k < 5);
    ++hits[k];
  }
  for (const int count : hits) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace burmester
