#include "burmester/geometry/paired_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "burmester/geometry/random.hpp"

namespace burmester {
namespace {

using Three = std::array<Correlation<double>, 3>;

Point2<double> some(Random& random) { return {random.normal(), random.normal(), random.normal()}; }

/// Three correlations under which p and c are partners.
Three correlations(Random& random, const Point2<double>& p, const Point2<double>& c) {
  Three n;
  for (Correlation<double>& each : n) {
    for (int i = 0; i < 9; ++i) each(i) = random.normal();
    each -= p.dot(each * c) / (p.squaredNorm() * c.squaredNorm()) * p * c.transpose();
  }
  return n;
}

std::array<double, 3> squares(const Three& n) { return {n[0].squaredNorm(), n[1].squaredNorm(), n[2].squaredNorm()}; }

double miss(const Three& n, const PairedPoints& at) {
  double out = 0;
  for (const Correlation<double>& each : n)
    out = std::max(out, std::abs(at.p.dot(each * at.c)) / (at.p.norm() * each.norm() * at.c.norm()));
  return out;
}

double angle(const Point2<double>& a, const Point2<double>& b) { return a.normalized().cross(b.normalized()).norm(); }

TEST(PairedPoints, MeetAllThreeNearWhereTheyBegan) {
  Random random("PairedPoints.MeetAllThreeNearWhereTheyBegan");
  int near = 0;
  for (int i = 0; i < 500; ++i) {
    const Point2<double> p = some(random), c = some(random);
    const Three n = correlations(random, p, c);
    const double off = std::ldexp(1.0, -10 - i % 30);
    const PairedPoints begin{p + off * some(random), c + off * some(random)},
        end = paired_points(n, squares(n), begin), from_point = paired_points(n, squares(n), begin.p);
    EXPECT_LT(miss(n, end), 2 * paired_within) << i;
    EXPECT_LT(miss(n, from_point), 2 * paired_within) << i;
    near += angle(begin.p, end.p) < 30 * off && angle(begin.c, end.c) < 30 * off;
  }
  EXPECT_GT(near, 450);  // some points are nearly double points: a small miss is a long way
}

TEST(PairedPoints, StayWhereTheyMeetAllThree) {
  Random random("PairedPoints.StayWhereTheyMeetAllThree");
  int stayed = 0;
  for (int i = 0; i < 100; ++i) {
    const Point2<double> p = some(random), c = some(random);
    const Three n = correlations(random, p, c);
    if (miss(n, {p, c}) > paired_within / 2) continue;
    const PairedPoints end = paired_points(n, squares(n), PairedPoints{p, c});
    EXPECT_TRUE(end.p == p && end.c == c) << i;
    ++stayed;
  }
  EXPECT_GT(stayed, 90);
}

}  // namespace
}  // namespace burmester
