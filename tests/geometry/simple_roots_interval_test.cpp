#include "burmester/geometry/simple_roots.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "burmester/geometry/random.hpp"
#include "exact_roots.hpp"

namespace burmester {
namespace {

template <int N>
std::array<Interval, N + 1> points(const std::array<double, N + 1>& c) {
  std::array<Interval, N + 1> out;
  std::copy(c.begin(), c.end(), out.begin());
  return out;
}

template <int N>
std::vector<Rational> leading_first(const std::array<double, N + 1>& c) {
  return std::vector<Rational>(c.rbegin(), c.rend());
}

/// Sign of the form at the end of a box.
template <int N>
int sign_of_form(const std::array<double, N + 1>& c, bool reciprocal, double at) {
  Rational value = 0;
  for (int k = N; k >= 0; --k)
    value = value * Rational(at) + Rational(c[static_cast<std::size_t>(reciprocal ? N - k : k)]);
  return exact::sign(value);
}

template <int N>
void expect_proved(const std::array<double, N + 1>& c, const SimpleRoots<N>& roots, const std::string& label) {
  const exact::RootCount truth = exact::count_real_roots_of_form(leading_first<N>(c));
  EXPECT_EQ(roots.count, truth.distinct) << label;
  EXPECT_EQ(truth.distinct, truth.counted) << label;
  double last = -2;
  for (std::size_t i = 0; i < static_cast<std::size_t>(roots.count); ++i) {
    const ProjectiveBox& box = roots.at[i];
    EXPECT_LE(sign_of_form<N>(c, box.reciprocal, box.at.low) * sign_of_form<N>(c, box.reciprocal, box.at.high), 0)
        << label;
    const double place = box.reciprocal ? 4 - box.at.high : box.at.low;
    EXPECT_GT(place, last) << label << ": order";
    last = box.reciprocal ? 4 - box.at.low : box.at.high;
  }
}

template <int N>
void expect_sturm(int cases, double least_share) {
  const std::string name = "SimpleRoots.degree" + std::to_string(N);
  Random random(name);
  int proved = 0;
  for (int n = 0; n < cases; ++n) {
    std::array<double, N + 1> c;
    for (double& x : c) x = std::ldexp(random.normal(), random.below(9) - 4);
    if (n % 7 == 0) c[static_cast<std::size_t>(random.below(N + 1))] = 0;
    std::optional<SimpleRoots<N>> roots;
    {
      const UpwardRounding upward;
      roots = simple_roots<N>(points<N>(c));
    }
    if (!roots) continue;
    ++proved;
    expect_proved<N>(c, *roots, name + " case " + std::to_string(n));
  }
  EXPECT_GT(proved, least_share * cases) << name;
}

TEST(SimpleRoots, AreThoseOfSturm) {
  expect_sturm<1>(300, 0.99);
  expect_sturm<2>(1000, 0.99);
  expect_sturm<3>(1000, 0.99);
  expect_sturm<4>(2000, 0.99);
  expect_sturm<6>(1000, 0.99);
  expect_sturm<12>(300, 0.95);
}

/// Product of the linear forms (t_i s - s_i t) with integers: exact in doubles.
template <int N>
std::array<double, N + 1> through(const std::array<std::array<int, 2>, N>& roots) {
  std::array<double, N + 1> c{1};
  for (int n = 0; n < N; ++n)
    for (int k = n + 1; k >= 0; --k) {
      const auto [s, t] = roots[static_cast<std::size_t>(n)];
      const auto i = static_cast<std::size_t>(k);
      c[i] = (k > 0 ? t * c[i - 1] : 0) - (k <= n ? s * c[i] : 0);
    }
  return c;
}

// Many of them lie where intervals are split: 0, infinity, 1, -1, 2, 1/2.
TEST(SimpleRoots, EncloseSmallIntegerRatios) {
  Random random("SimpleRoots.EncloseSmallIntegerRatios");
  int proved = 0, simple = 0;
  for (int n = 0; n < 3000; ++n) {
    std::array<std::array<int, 2>, 4> root;
    for (auto& [s, t] : root)
      do s = random.below(9) - 4, t = random.below(9) - 4;
      while (s == 0 && t == 0);
    bool distinct = true;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) distinct = distinct && root[i][0] * root[j][1] != root[i][1] * root[j][0];
    const UpwardRounding upward;
    const auto found = simple_roots<4>(points<4>(through<4>(root)));
    EXPECT_TRUE(distinct || !found) << n;
    simple += distinct;
    if (!found) continue;
    ++proved;
    EXPECT_EQ(found->count, 4) << n;
    for (const auto& [s, t] : root) {
      int hits = 0;
      for (const ProjectiveBox& box : found->at) {
        const int top = box.reciprocal ? t : s, bottom = box.reciprocal ? s : t;
        if (bottom == 0) continue;
        const Interval at = Interval(top) / Interval(bottom);
        hits += at.sup() >= box.at.low && at.inf() <= box.at.high && box.at.high - box.at.low < 1e-12;
      }
      EXPECT_EQ(hits, 1) << n << ": " << s << " : " << t;
    }
  }
  EXPECT_GT(proved, 0.9 * simple);
}

TEST(SimpleRoots, ProveNothingOfDoubleRoots) {
  const UpwardRounding upward;
  EXPECT_FALSE(simple_roots<2>({Interval(1), Interval(-2), Interval(1)}));
  EXPECT_FALSE(simple_roots<2>({Interval(0), Interval(0), Interval(0)}));
  EXPECT_FALSE(simple_roots<2>({Interval(1), Interval(0), Interval(0)}));                              // at infinity
  EXPECT_FALSE(simple_roots<4>({Interval(1), Interval(0), Interval(-2), Interval(0), Interval(1)}));  // (x^2 - 1)^2
  const auto complex =
      simple_roots<4>({Interval(1), Interval(0), Interval(2), Interval(0), Interval(1)});  // (x^2 + 1)^2
  ASSERT_TRUE(complex);
  EXPECT_EQ(complex->count, 0);
}

TEST(SimpleRoots, HoldForAllFormsInTheIntervals) {
  const UpwardRounding upward;
  EXPECT_FALSE(simple_roots<1>({Interval(-1, 1), Interval(-1, 1)}));
  EXPECT_FALSE(simple_roots<2>({Interval(-1, 1), Interval(0), Interval(1)}));
  const auto roots = simple_roots<2>({Interval(-0.26, -0.24), Interval(0), Interval(1)});  // x^2 = 0.24 .. 0.26
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->count, 2);
  const Range at = roots->at[1].at;
  EXPECT_LE(at.low * at.low, 0.24);
  EXPECT_GE(at.high * at.high, 0.26);
  EXPECT_GT(at.low, 0);
}

}  // namespace
}  // namespace burmester
