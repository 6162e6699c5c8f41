// Real roots against planted ones and against Sturm's theorem (exact_roots.hpp shares no code with them).
#include "burmester/geometry/real_roots.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "burmester/geometry/random.hpp"
#include "exact_roots.hpp"
#include "rational.hpp"
#include "repetitions.hpp"

namespace burmester {
namespace {

using P = Polynomial<Rational>;

P linear(const Rational& root) { return P({-root, Rational(1)}); }

exact::RootCount count_of(const std::vector<RealRoot>& roots) {
  exact::RootCount out;
  for (const RealRoot& root : roots) ++out.distinct, out.counted += root.multiplicity();
  return out;
}

exact::RootCount sturm(const P& p) { return exact::count_real_roots(exact::polynomial(p.coefficients())); }

/// What every list of roots must satisfy whatever the polynomial.
void expect_lawful(const std::vector<RealRoot>& roots, const P& p, const std::string& label) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RationalInterval box = roots[i].bounds();
    const Range range = roots[i].enclosure();
    EXPECT_TRUE(Rational(range.low) <= box.low() && box.high() <= Rational(range.high)) << label;
    EXPECT_TRUE(range.low <= roots[i].approximate() && roots[i].approximate() <= range.high) << label;
    EXPECT_NE(roots[i].rung(), Rung::none) << label;
    if (i > 0) {
      EXPECT_LE(roots[i - 1].bounds().high(), box.low()) << label;
    }
    const Rational low = p(box.low()), high = p(box.high());
    if (roots[i].is_point()) {
      EXPECT_EQ(low, 0) << label;
    } else if (roots[i].rung() == Rung::exact) {
      EXPECT_TRUE(low != 0 && high != 0) << label;
      EXPECT_EQ((low > 0) == (high > 0), roots[i].multiplicity() % 2 == 0) << label;
    } else {
      EXPECT_LE(exact::sign(low) * exact::sign(high), 0) << label;
    }
  }
}

// ---- Random polynomials with every kind of root ----

struct Planted {
  P p;
  std::map<Rational, int> rational;  // multiplicities
  std::string label;
};

P power(const P& p, int n) { return n == 0 ? P({Rational(1)}) : p * power(p, n - 1); }

/// x^2 - 2 h x + h^2 - q: two real roots, irrational or not (q > 0), or two complex ones
P quadratic(Random& random) {
  const Rational h = random_rational(random) / 10, q = random_rational(random) / 10;
  return P({h * h - q, Rational(-2 * h), Rational(1)});
}

Planted plant(Random& random, int n) {
  Planted out{P({Rational(1 + random.below(9))}), {}, "random " + std::to_string(n)};
  const auto add = [&](const Rational& root, int multiplicity) {
    out.p = out.p * power(linear(root), multiplicity);
    out.rational[root] += multiplicity;
  };
  switch (n % 5) {
    case 0:  // rational roots, some repeated
      for (int k = 1 + random.below(4); k > 0; --k) add(random_rational(random), 1 + random.below(3));
      break;
    case 1:  // dyadic ones, which bisection meets
      for (int k = 1 + random.below(5); k > 0; --k) add(Rational(random.below(33) - 16, 1 << random.below(5)), 1);
      break;
    case 2:  // simple pairs
      for (int k = 1 + random.below(4); k > 0; --k) out.p = out.p * quadratic(random);
      break;
    case 3:  // repeated pairs
      out.p = out.p * power(quadratic(random), 1 + random.below(3)) * quadratic(random);
      break;
    case 4: {  // a cluster 1e-1 .. 1e-14 wide
      const Rational at = random_rational(random);
      const Rational gap(std::pow(10.0, -1 - random.below(14)));
      for (int k = 2 + random.below(3); k > 0; --k) add(at + gap * Rational(random.below(4)), 1);
      out.p = out.p * quadratic(random);
      break;
    }
  }
  return out;
}

TEST(RealRoots, AgreeWithSturmAndWithThePlantedRoots) {
  Random random("RealRoots.AgreeWithSturmAndWithThePlantedRoots");
  int by_intervals = 0, exactly = 0;
  for (int n = 0; n < repetitions(20000); ++n) {
    const Planted planted = plant(random, n);
    const std::vector<RealRoot> roots = real_roots(planted.p);
    if (n / 5 % 8 == 0) {  // every class
      ASSERT_EQ(count_of(roots), sturm(planted.p)) << planted.label;
      expect_lawful(roots, planted.p, planted.label);
    }
    for (const auto& [root, multiplicity] : planted.rational) {
      const auto hit = std::find_if(roots.begin(), roots.end(), [&](const RealRoot& r) {
        return r.bounds().low() <= root && root <= r.bounds().high();
      });
      ASSERT_NE(hit, roots.end()) << planted.label;
      EXPECT_GE(hit->multiplicity(), multiplicity) << planted.label;  // a quadratic may share it
    }
    if (!roots.empty()) (roots[0].rung() == Rung::exact ? exactly : by_intervals) += 1;
  }
  EXPECT_GT(by_intervals, repetitions(2000));
  EXPECT_GT(exactly, repetitions(2000));
}

TEST(RealRoots, BothRoutesSayTheSame) {
  Random random("RealRoots.BothRoutesSayTheSame");
  for (int n = 0; n < 1000; ++n) {
    std::vector<double> c;
    for (int k = 2 + random.below(12); k > 0; --k) c.push_back(std::ldexp(random.normal(), random.below(41) - 20));
    const P p(std::vector<Rational>(c.begin(), c.end()));
    const std::vector<RealRoot> fast = real_roots(c), exact = real_roots_exactly(p);
    ASSERT_EQ(fast.size(), exact.size()) << n;
    expect_lawful(fast, p, "random doubles " + std::to_string(n));
    for (std::size_t i = 0; i < fast.size(); ++i) {
      EXPECT_TRUE(fast[i].bounds().low() <= exact[i].bounds().high() &&
                  exact[i].bounds().low() <= fast[i].bounds().high())
          << n;
      EXPECT_EQ(exact[i].rung(), Rung::exact);
    }
  }
}

// ---- Famous polynomials ----

TEST(RealRoots, Wilkinson) {
  P p({Rational(1)});
  for (int k = 1; k <= 12; ++k) p = p * linear(k);
  for (const std::vector<RealRoot>& roots : {real_roots(p), real_roots_exactly(p)}) {
    ASSERT_EQ(roots.size(), 12u);
    for (int k = 0; k < 12; ++k) EXPECT_NEAR(roots[static_cast<std::size_t>(k)].approximate(), k + 1, 1e-3);
  }
  for (const RealRoot& root : real_roots_exactly(p)) EXPECT_TRUE(root.is_point());
}

TEST(RealRoots, Chebyshev) {
  P before({Rational(1)}), p({Rational(0), Rational(1)});  // T0, T1
  for (int n = 1; n <= 16; ++n) {
    const std::vector<RealRoot> roots = real_roots(p);
    ASSERT_EQ(roots.size(), static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
      EXPECT_NEAR(roots[static_cast<std::size_t>(k)].approximate(), -std::cos((2 * k + 1) * std::numbers::pi / (2 * n)),
                  1e-10)
          << n;
    const P next = P({Rational(0), Rational(2)}) * p - before;
    before = std::exchange(p, next);
  }
}

// x^n - 2 (a x - 1)^2 has two roots within 2 a^-(n/2 + 1) of 1/a (M. Mignotte, 1982).
TEST(RealRoots, Mignotte) {
  for (const int n : {5, 8, 11}) {
    const P p = power(P({Rational(0), Rational(1)}), n) - power(P({Rational(-1), Rational(1000)}), 2) * Rational(2);
    std::vector<RealRoot> roots = real_roots(p);
    ASSERT_EQ(count_of(roots), sturm(p)) << n;
    const auto near = [](const RealRoot& r) { return std::abs(r.approximate() - 1e-3) < 1e-9; };
    ASSERT_EQ(std::count_if(roots.begin(), roots.end(), near), 2) << n;
    auto first = std::find_if(roots.begin(), roots.end(), near);
    EXPECT_LT(first->bounds().low(), Rational(1, 1000));
    EXPECT_GT((first + 1)->bounds().high(), Rational(1, 1000));
  }
}

TEST(RealRoots, ExactDoubleRootsAndDyadicPoints) {
  const std::vector<double> c{2.25, -3, 1};  // (x - 3/2)^2
  const auto roots = real_roots(c);
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_EQ(roots[0].multiplicity(), 2);
  EXPECT_EQ(roots[0].rung(), Rung::exact);
  EXPECT_TRUE(roots[0].is_point());
  EXPECT_EQ(roots[0].approximate(), 1.5);
  EXPECT_EQ(roots[0].enclosure().low, roots[0].enclosure().high);
}

TEST(RealRoots, OfExtremeSizes) {
  const std::vector<double> c{-1e-300, 0, 1e300};  // +-1e-300
  const auto roots = real_roots(c);
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_NEAR(roots[1].approximate(), 1e-300, 1e-312);
  const std::vector<double> beyond{1e300, 1e-300};  // -1e600
  const auto far = real_roots(beyond);
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].enclosure().low, -std::numeric_limits<double>::infinity());
  EXPECT_LT(far[0].enclosure().high, -1e308);
  const std::vector<double> tiny{0x1p-1074, 3 * 0x1p-1074};
  EXPECT_NEAR(real_roots(tiny).at(0).approximate(), -1.0 / 3, 1e-15);
}

TEST(RealRoots, OfNothing) {
  EXPECT_THROW(real_roots(std::vector<double>{0, 0}), std::invalid_argument);
  EXPECT_THROW(real_roots(P()), std::invalid_argument);
  EXPECT_THROW(real_roots_exactly(P()), std::invalid_argument);
  EXPECT_THROW(real_roots(std::vector<double>{1, std::nan("")}), std::invalid_argument);
  EXPECT_TRUE(real_roots(std::vector<double>{5, 0}).empty());
  EXPECT_TRUE(real_roots_exactly(P({Rational(5)})).empty());
}

// ---- Laws ----

P random_polynomial(Random& random, int degree) {
  std::vector<Rational> c;
  for (int k = 0; k <= degree; ++k) c.push_back(random_rational(random));
  return P(c);
}

TEST(RealRoots, DescartesRuleOfSigns) {
  Random random("RealRoots.DescartesRuleOfSigns");
  for (int n = 0; n < 1000; ++n) {
    const P p = random_polynomial(random, 1 + random.below(9));
    if (p.is_zero() || p[0] == 0) continue;
    std::vector<int> signs;
    for (const Rational& c : p.coefficients()) signs.push_back(exact::sign(c));
    int positive = 0;
    for (const RealRoot& root : real_roots(p)) positive += root.approximate() > 0 ? root.multiplicity() : 0;
    EXPECT_LE(positive, exact::sign_changes(signs)) << n;
    EXPECT_EQ(positive % 2, exact::sign_changes(signs) % 2) << n;
  }
}

/// The same numbers, box by box, up to the widths of the boxes.
void expect_same(const std::vector<RealRoot>& a, const std::vector<RealRoot>& b, auto map, int n) {
  ASSERT_EQ(a.size(), b.size()) << n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].multiplicity(), b[i].multiplicity()) << n;
    const RationalInterval x = a[i].bounds(), y = map(b[i].bounds());
    EXPECT_TRUE(x.low() <= y.high() && y.low() <= x.high()) << n;
  }
}

TEST(RealRoots, MirroredInvertedScaled) {
  Random random("RealRoots.MirroredInvertedScaled");
  for (int n = 0; n < 1000; ++n) {
    P p = random_polynomial(random, 1 + random.below(6));
    if (n % 2 == 0) p = p * p;
    if (p.degree() < 1 || p[0] == 0) continue;
    const std::vector<RealRoot> roots = real_roots(p);
    std::vector<Rational> mirrored = p.coefficients(), scaled = mirrored;
    Rational factor = 1;
    for (std::size_t k = 0; k < scaled.size(); ++k, factor *= 3) {
      if (k % 2 == 1) mirrored[k] = -mirrored[k];
      scaled[k] *= factor;
    }
    std::vector<RealRoot> reflected = real_roots(P(mirrored));
    std::reverse(reflected.begin(), reflected.end());
    expect_same(roots, reflected, [](const RationalInterval& x) { return -x; }, n);
    expect_same(roots, real_roots(P(scaled)), [](const RationalInterval& x) { return 3 * x; }, n);
    std::vector<RealRoot> inverted = real_roots(p.reversed());
    std::sort(inverted.begin(), inverted.end(), [](const RealRoot& a, const RealRoot& b) {
      return 1 / a.bounds().low() < 1 / b.bounds().low();
    });
    expect_same(roots, inverted, [](const RationalInterval& x) { return RationalInterval(1) / x; }, n);
  }
}

TEST(RealRoots, OfAProductAreTheUnion) {
  Random random("RealRoots.OfAProductAreTheUnion");
  for (int n = 0; n < 500; ++n) {
    const P p = random_polynomial(random, 1 + random.below(4)), q = random_polynomial(random, 1 + random.below(4));
    if (p.degree() < 1 || q.degree() < 1) continue;
    const exact::RootCount a = count_of(real_roots(p)), b = count_of(real_roots(q)), both = count_of(real_roots(p * q));
    EXPECT_EQ(both.counted, a.counted + b.counted) << n;
    std::vector<RealRoot> roots = real_roots(p * q);
    int of_p = 0, of_q = 0;
    for (RealRoot& root : roots) {
      const bool in_p = sign_at(p, root) == 0, in_q = sign_at(q, root) == 0;
      EXPECT_TRUE(in_p || in_q) << n;
      of_p += in_p, of_q += in_q;
    }
    EXPECT_EQ(of_p, a.distinct) << n;
    EXPECT_EQ(of_q, b.distinct) << n;
  }
}

// ---- One root ----

TEST(RealRoot, IsRefinedToAnyWidth) {
  Random random("RealRoot.IsRefinedToAnyWidth");
  const Rational tiny = Rational(1) / Rational(Integer(1) << 700);
  for (int n = 0; n < 200; ++n) {
    const P p = random_polynomial(random, 2 + random.below(6));
    if (p.is_zero()) continue;
    for (RealRoot root : n % 2 == 0 ? real_roots(p) : real_roots_exactly(p)) {
      const RationalInterval before = root.bounds();
      const RealRoot copy = root;
      root.refine(tiny);
      const RationalInterval after = root.bounds();
      EXPECT_LE(after.high() - after.low(), tiny);
      EXPECT_TRUE(before.low() <= after.low() && after.high() <= before.high());
      EXPECT_TRUE(copy.bounds().low() == before.low() && copy.bounds().high() == before.high());
      if (root.multiplicity() % 2 == 1 && !root.is_point()) {
        EXPECT_LT(exact::sign(p(after.low())) * exact::sign(p(after.high())), 0) << n;
      }
    }
  }
  RealRoot root = real_roots(P({Rational(-2), Rational(0), Rational(1)})).at(1);
  EXPECT_THROW(root.refine(0.0), std::invalid_argument);
  EXPECT_THROW(root.refine(-1.0), std::invalid_argument);
}

TEST(RealRoot, SignsOfOtherPolynomials) {
  Random random("RealRoot.SignsOfOtherPolynomials");
  int zeros = 0, others = 0;
  for (int n = 0; n < 500; ++n) {
    const P p = quadratic(random), q = quadratic(random);
    for (RealRoot root : real_roots(p * q)) {
      RealRoot again = root;
      const int of_p = sign_at(p, root), of_q = sign_at(q, again);
      EXPECT_EQ(of_p * of_q, 0) << n;
      EXPECT_EQ(sign_at(p * q, root), 0) << n;
      EXPECT_EQ(sign_at(p * q + P({Rational(1, 1000000)}), root), 1) << n;
      EXPECT_EQ(sign_at(q - P({Rational(1) / Rational(Integer(1) << 300)}), again), of_q == 0 ? -1 : of_q) << n;
      (of_p == 0 ? zeros : others) += 1;
    }
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(others, 100);
  RealRoot root = real_roots(P({Rational(-2), Rational(0), Rational(1)})).at(1);
  EXPECT_EQ(sign_at(P(), root), 0);
  EXPECT_EQ(sign_at(P({Rational(-3)}), root), -1);
}

TEST(RealRoots, AnEndlessWidthIsRefused) {
  RealRoot root = real_roots(std::vector<double>{-2, 0, 1}).at(1);
  EXPECT_THROW(root.refine(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(root.refine(std::nan("")), std::invalid_argument);
  EXPECT_THROW(root.refine(0.0), std::invalid_argument);
}

TEST(RealRoots, ARootBeyondTheDoublesKeepsItsExactBox) {
  std::vector<RealRoot> roots = real_roots(std::vector<double>{1, 5e-324});  // -2^1074
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_EQ(sign_at(Polynomial<Rational>({Rational(Integer(1) << 1074), Rational(1)}), roots[0]), 0);
  EXPECT_EQ(sign_at(Polynomial<Rational>({Rational(1)}), roots[0]), 1);
}

}  // namespace
}  // namespace burmester
