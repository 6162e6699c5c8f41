#include "program/ordered_map.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>

namespace burmester {
namespace {

using Map = OrderedMap<int, int>;

/// 0, 1, .., count - 1
Map::Next counting(int count) {
  return [i = 0, count]() mutable { return i < count ? std::optional(i++) : std::nullopt; };
}

/// Work that takes longer for earlier items, so that replies come out of order.
int slow_square(std::size_t index, const int& item) {
  if (index % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
  return item * item;
}

TEST(OrderedMap, KeepsTheOrderOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 16}) {
    std::vector<int> out;
    Map map(slow_square, [&](const int& reply) { out.push_back(reply); });
    map.run(threads, counting(500));
    ASSERT_EQ(out.size(), 500u);
    for (int i = 0; i < 500; ++i) ASSERT_EQ(out[i], i * i);
  }
}

TEST(OrderedMap, DoesNotReadFarAhead) {
  std::atomic<int> read = 0, written = 0;
  int farthest = 0;
  OrderedMap<int, int> map([](std::size_t, const int& item) { return item; }, [&](const int&) { ++written; });
  map.run(2, [&]() -> std::optional<int> {
    farthest = std::max(farthest, read - written);
    return read < 2000 ? std::optional(read++) : std::nullopt;
  });
  EXPECT_EQ(written, 2000);
  EXPECT_LE(farthest, 33);
}

TEST(OrderedMap, PassesFailuresOn) {
  const auto fails = [](std::size_t, const int& item) {
    return item == 5 ? throw std::runtime_error("work") : item;
  };
  Map work(fails, [](const int&) {});
  EXPECT_THROW(work.run(3, counting(1000)), std::runtime_error);
  Map write(slow_square, [](const int& reply) {
    if (reply == 25) throw std::runtime_error("write");
  });
  EXPECT_THROW(write.run(3, counting(1000)), std::runtime_error);
  Map next(slow_square, [](const int&) {});
  EXPECT_THROW(next.run(3, []() -> std::optional<int> { throw std::runtime_error("next"); }),
               std::runtime_error);
}

TEST(OrderedMap, EndsWithoutItems) {
  Map map(slow_square, [](const int&) { FAIL(); });
  map.run(4, counting(0));
}

}  // namespace
}  // namespace burmester
