// Dyads near given directions: on the cone, certified, and no axis of the cone is nearer.
#include "burmester/spherical/near_curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "burmester/spherical/spherical.hpp"
#include "five_orientations.hpp"

namespace burmester::spherical {
namespace {

using testing::ElementsAre;

using FourPoseTask = std::array<Pose, 4>;

FourPoseTask random_task(Random& random) {
  FourPoseTask task;
  for (Pose& p : task) p = Space::random_pose(random);
  return task;
}
Pose product(const Pose& a, const Pose& b) {
  return Space::pose(Space::product<double>(Space::point<double>(a), Space::point<double>(b)));
}
Pose inverse(const Pose& a) { return Space::pose(Space::conjugate<double>(Space::point<double>(a))); }
Axis placed(const Pose& pose, const Axis& a) { return Space::act<double>(Space::point<double>(pose), a).normalized(); }
std::vector<double> list(const Axis& a) { return {a[0], a[1], a[2]}; }

/// Between axes without direction.
double angle(const Axis& a, const Axis& b) { return std::min(Space::distance(a, b), Space::distance(a, -b)); }

/// Zero for centre axes (circle axes for the inverse poses): equation 10 of J. Angeles, S. Bai, "A robust solution of
/// the spherical Burmester problem", for the places of the axis that the body sees.
template <class T>
T determinant(const FourPoseTask& task, const Vector<T, 3>& b) {
  const auto back = [](const Pose& p) { return Space::conjugate<T>(Space::point<T>(p)); };
  const auto place = [&](std::size_t j) -> Vector<T, 3> {
    return Space::act<T>(back(task[j]), b) / Space::norm<T>(back(task[j]));
  };
  const Vector<T, 3> from = place(0), u = place(1) - from, v = place(2) - from, w = place(3) - from;
  return u.dot(v.cross(w));
}

NearDyads nearest_of(const FourPoseTask& task, const std::vector<std::vector<double>>& near, bool certify = true) {
  return dyads_near(task, four_pose_curves(task).pieces, near, certify);
}
RR::Design only_dyad(const NearDyads& answer) {
  EXPECT_EQ(answer.dyads.size(), 1u);
  EXPECT_TRUE(answer.warnings.empty());
  return answer.dyads.empty() ? RR::Design{} : std::get<RR::Design>(answer.dyads[0].design);
}

/// The least angle from q at which a great circle through q crosses the cone, over many great circles.
double nearest_crossing(const FourPoseTask& task, const Axis& q) {
  const Axis u = q.unitOrthogonal(), v = q.cross(u);
  double best = std::numbers::pi / 2;
  constexpr int circles = 360, steps = 90;
  for (int i = 0; i < circles; ++i) {
    const double l = i * 2 * std::numbers::pi / circles;
    const Axis ahead = std::cos(l) * u + std::sin(l) * v;
    const auto value = [&](double t) { return determinant<double>(task, std::cos(t) * q + std::sin(t) * ahead); };
    double low = 0, high = 0;
    const double side = value(0), step = std::numbers::pi / 2 / steps;
    while (low < best && value(high = low + step) * side > 0) low = high;
    for (int bits = 0; bits < 48; ++bits) {
      const double middle = (low + high) / 2;
      (value(middle) * side > 0 ? low : high) = middle;
    }
    best = std::min(best, high);
  }
  return best;
}

TEST(SphericalNearCurve, NoAxisOfTheConeIsNearer) {
  Random random("SphericalNearCurve.NoAxisOfTheConeIsNearer");
  int certified = 0, all = 0;
  double worst = 0, excess = 0;
  for (int i = 0; i < 40; ++i) {
    const FourPoseTask task = random_task(random);
    const Axis q = Space::random_feature(random);
    for (const auto& found : nearest_of(task, {list(q)}).dyads) {
      const auto& d = std::get<RR::Design>(found.design);
      const double away = angle(d.fixed, q), sampled = nearest_crossing(task, q);
      ++all, certified += found.certificate.certified;
      worst = std::max(worst, found.residual);
      EXPECT_LE(away, sampled + 1e-12) << i;
      excess = std::max(excess, sampled - away);
    }
  }
  EXPECT_EQ(all, 40);
  EXPECT_EQ(certified, 40);
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(excess, 1e-3);  // the great circles sampled are a degree apart
}

/// Two points of space within the radius, on two sides of the exact cone.
void expect_crossed(const FourPoseTask& task, const Axis& axis, double radius, int i) {
  const double h = 1e-6;
  Axis slope;
  for (int k = 0; k < 3; ++k)
    slope[k] =
        determinant<double>(task, axis + h * Axis::Unit(k)) - determinant<double>(task, axis - h * Axis::Unit(k));
  const Axis off = 1.01 * radius * (slope - slope.dot(axis) * axis).normalized();
  const Vector<Rational, 3> above = (axis + off).cast<Rational>(), below = (axis - off).cast<Rational>();
  EXPECT_LE(determinant<Rational>(task, above) * determinant<Rational>(task, below), 0) << i;
}

TEST(SphericalNearCurve, WithinItsCertificateIsAnExactDyad) {
  Random random("SphericalNearCurve.WithinItsCertificateIsAnExactDyad");
  double widest = 0;
  for (int i = 0; i < 40; ++i) {
    FourPoseTask task = random_task(random), inverted = task;
    if (i % 2) task[2] = Space::nudged(task[1], {1e-5, 2e-5, -1e-5});  // two that nearly agree
    std::ranges::transform(task, inverted.begin(), inverse);
    for (const auto& found : nearest_of(task, {list(Space::random_feature(random))}).dyads) {
      ASSERT_TRUE(found.certificate.certified) << i;
      EXPECT_EQ(found.certificate.rung, Rung::exact);
      const auto& d = std::get<RR::Design>(found.design);
      const double radius = found.certificate.radius;
      widest = std::max(widest, radius);
      expect_crossed(task, d.fixed, radius, i);
      expect_crossed(inverted, d.moving, radius, i);
      EXPECT_LT(found.residual, 2 * radius + 1e-15) << i;
    }
  }
  EXPECT_GT(widest, 0);
  EXPECT_LT(widest, 1e-8);
}

TEST(SphericalNearCurve, ACentreAxisIsNearestToItselfAtAnyLengthAndSign) {
  Random random("SphericalNearCurve.ACentreAxisIsNearestToItselfAtAnyLengthAndSign");
  for (int i = 0; i < 20; ++i) {
    const FourPoseTask task = random_task(random);
    const RR::Design d = only_dyad(nearest_of(task, {list(Space::random_feature(random))}, false));
    for (const double length : {1.0, -1.0, 0x1p-1000, -0x1p1000}) {
      const RR::Design again = only_dyad(nearest_of(task, {list(length * d.fixed)}, false));
      EXPECT_LT(support::distance(d, again), 1e-11) << i << " " << length;
    }
  }
}

TEST(SphericalNearCurve, FollowsTheFramesAndForgetsOrderAndSign) {
  Random random("SphericalNearCurve.FollowsTheFramesAndForgetsOrderAndSign");
  for (int i = 0; i < 25; ++i) {
    const FourPoseTask task = random_task(random);
    const Axis q = Space::random_feature(random);
    const Pose g = Space::random_pose(random), h = Space::random_pose(random);
    FourPoseTask turned = task, ordered = task, negative = task;
    for (Pose& p : turned) p = product(product(g, p), inverse(h));
    std::ranges::rotate(ordered, ordered.begin() + 1 + i % 3);
    negative[1] = {-3 * task[1].w, -3 * task[1].x, -3 * task[1].y, -3 * task[1].z};
    const RR::Design d = only_dyad(nearest_of(task, {list(q)}));
    const RR::Design carried{placed(g, d.fixed), placed(h, d.moving), d.arc};
    EXPECT_LT(support::distance(carried, only_dyad(nearest_of(turned, {list(placed(g, q))}))), 1e-10) << i;
    EXPECT_LT(support::distance(d, only_dyad(nearest_of(ordered, {list(q)}))), 1e-10) << i;
    EXPECT_LT(support::distance(d, only_dyad(nearest_of(negative, {list(-q)}))), 1e-10) << i;
  }
}

/// The axis of a relative rotation is a centre axis like others.
TEST(SphericalNearCurve, AnAxisOfRotationIsNearestToItself) {
  Random random("SphericalNearCurve.AnAxisOfRotationIsNearestToItself");
  for (int i = 0; i < 10; ++i) {
    const FourPoseTask task = random_task(random);
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = j + 1; k < 4; ++k) {
        const Pose turn = product(task[k], inverse(task[j]));
        const Axis pole = Axis(turn.x, turn.y, turn.z).normalized();
        const NearDyads answer = nearest_of(task, {list(pole)});
        EXPECT_LT(angle(only_dyad(answer).fixed, pole), 1e-13) << i;
        EXPECT_LT(answer.dyads[0].residual, 1e-12) << i;
        EXPECT_TRUE(answer.dyads[0].certificate.certified) << i;
      }
  }
}

TEST(SphericalNearCurve, DirectionsWithoutADyadAreTold) {
  Random random("SphericalNearCurve.DirectionsWithoutADyadAreTold");
  FourPoseTask task = random_task(random);
  while (!sliders(task) || sliders(task)->size() < 4) task = random_task(random);
  const auto found = sliders(task);
  for (const FoundSlider& slider : *found) {
    const NearDyads at_slider = nearest_of(task, {list(std::get<PR::Design>(slider.slider.design).fixed)});
    EXPECT_TRUE(at_slider.dyads.empty());
    EXPECT_THAT(at_slider.warnings,
                ElementsAre("near[0]: the nearest centre point is the axis of a slider; no RR dyad"));
  }
  // three of four orientations turn about z
  const FourPoseTask coaxial{Pose{1, 0, 0, 0}, Pose{3, 0, 0, 1}, Pose{2, 0, 0, 1},
                             pose_from_axis_degrees({1, 2, 3}, 40)};
  EXPECT_THAT(
      nearest_of(coaxial, {{0, 0.1, 1}}).warnings,
      ElementsAre("near[0]: the nearest centre point is a common axis of rotation, every point of a great circle "
                  "is its partner; no dyad"));
  const FourPoseTask equal{Pose{1, 0, 0, 0}, Pose{1, 0, 0, 0}, Pose{2, 0, 0, 1}, pose_from_axis_degrees({1, 2, 3}, 40)};
  EXPECT_THAT(nearest_of(equal, {{1, 0, 0}, {0, 1, 0}}).warnings,
              ElementsAre("near[0]: no curve is listed; no dyad", "near[1]: no curve is listed; no dyad"));
}

/// Every direction is answered by a dyad or a warning, also where poles coincide and cones split.
TEST(SphericalNearCurve, SymmetricSetsAreAnswered) {
  const FourPoseTask tasks[] = {{Pose{1, 0, 0, 0}, Pose{0, 1, 0, 0}, Pose{0, 0, 1, 0}, Pose{0, 0, 0, 1}},
                                {Pose{3, 1, 2, 0}, Pose{3, -1, 2, 0}, Pose{5, 1, -1, 2}, Pose{5, -1, -1, -2}},
                                {Pose{1, 0, 0, 0}, Pose{3, 0, 0, 1}, Pose{2, 0, 0, 1}, Pose{2, 1, 1, 0}}};
  int dyads = 0;
  for (const FourPoseTask& task : tasks)
    for (const std::vector<double>& q :
         {std::vector<double>{1, 1, 1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0.3, 2, -1}})
      for (const bool certify : {false, true}) {
        const NearDyads answer = nearest_of(task, {q}, certify);
        EXPECT_EQ(answer.dyads.size() + answer.warnings.size(), 1u) << q[0] << q[1] << q[2];
        dyads += static_cast<int>(answer.dyads.size());
        for (const auto& found : answer.dyads) EXPECT_LT(found.residual, 1e-12) << q[0] << q[1] << q[2];
      }
  EXPECT_GE(dyads, 10);
}

TEST(SphericalNearCurve, IsPartOfTheAnswerAndRefusesZero) {
  const auto module = make_module();
  Problem problem;
  problem.poses = {{1, 0, 0, 0}, {3, 1, 0, 0.5}, {2, 1, -1, 0.5}, {1, 0.5, 2, 1}}, problem.certify = true;
  const std::size_t without = module->synthesize(problem).dyads.size();
  problem.near = {{1, 2, 3}, {-2, -4, -6}, {0, 0, -1}};
  const Synthesis answer = module->synthesize(problem);
  EXPECT_EQ(answer.dyads.size(), without + 2);
  EXPECT_THAT(answer.warnings, ElementsAre("two of the given directions lead to the same RR dyad: listed once"));
  EXPECT_EQ(answer.dyads[0].type, "RR");
  problem.near = {{1, 2, 3}, {0, 0, 0}};
  try {
    module->synthesize(problem);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "near[1]: expected an axis that is not zero");
  }
}

}  // namespace
}  // namespace burmester::spherical
