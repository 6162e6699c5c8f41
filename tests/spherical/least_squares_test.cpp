// More orientations than a dyad can meet: fits against planted dyads, a slow search, the laws and a published slider.
#include "burmester/spherical/least_squares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/pose_format.hpp"
#include "burmester/spherical/spherical.hpp"

namespace burmester::spherical {
namespace {

using ImagePoint = Space::Point<double>;

ImagePoint point(const Pose& pose) { return Space::point<double>(pose); }
Pose product(const Pose& a, const Pose& b) { return Space::pose(Space::product<double>(point(a), point(b))); }
Pose inverse(const Pose& a) { return Space::pose(Space::conjugate<double>(point(a))); }
Pose about(const Axis& axis, double angle) { return pose_from_axis_radians({axis[0], axis[1], axis[2]}, angle); }
/// Of two axes, which have no direction.
double angle(const Axis& a, const Axis& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }
template <class Design>
double difference(const Design& a, const Design& b) {
  return std::max(angle(a.fixed, b.fixed), angle(a.moving, b.moving));
}

std::vector<Pose> random_poses(Random& random, int count) {
  std::vector<Pose> out;
  for (int i = 0; i < count; ++i) out.push_back(Space::random_pose(random));
  return out;
}

/// Orientations that meet a dyad: the moving axis brought to its arc from the fixed one, then turns about both.
std::vector<Pose> planted(const RR::Design& d, Random& random, int count) {
  const Axis across = d.fixed.unitOrthogonal();
  const Axis place = std::cos(d.arc) * d.fixed + std::sin(d.arc) * across;
  const Pose there = about(d.moving.cross(place), Space::distance(d.moving, place));
  std::vector<Pose> out;
  const auto any = [&] { return random.uniform(-std::numbers::pi, std::numbers::pi); };
  for (int i = 0; i < count; ++i) out.push_back(product(product(about(d.fixed, any()), there), about(d.moving, any())));
  return out;
}

template <class D>
double sum_of_squares(const typename D::Design& d, std::span<const Pose> poses) {
  return residuals<D>(d, poses).squaredNorm();
}

template <class D>
double least(const std::vector<Found<typename D::Design>>& found, std::span<const Pose> poses) {
  double out = HUGE_VAL;
  for (const auto& f : found) out = std::min(out, sum_of_squares<D>(f.design, poses));
  return out;
}

TEST(SphericalLeastSquares, FindPlantedDyadsExactly) {
  Random random("SphericalLeastSquares.FindPlantedDyadsExactly");
  for (int i = 0; i < 30; ++i) {
    const RR::Design d = RR::random_design(random);
    const SphericalReport report = LeastSquaresSolver().solve(planted(d, random, 6 + i % 10));
    ASSERT_EQ(report.status, Status::exact) << i << ": " << report.message;
    EXPECT_TRUE(std::any_of(report.dyads.begin(), report.dyads.end(), [&](const auto& f) {
      const auto* rr = std::get_if<RR::Design>(&f.design);
      return rr && difference(*rr, d) < 1e-12 * (1 + *f.condition);
    })) << i;
    for (const auto& f : report.dyads) EXPECT_LE(f.residual, exact_residual) << i;
  }
}

TEST(SphericalLeastSquares, FindPlantedSlidersExactlyAsSliders) {
  Random random("SphericalLeastSquares.FindPlantedSlidersExactlyAsSliders");
  for (int i = 0; i < 10; ++i) {
    RR::Design d = RR::random_design(random);
    d.arc = std::numbers::pi / 2;
    const SphericalReport report = LeastSquaresSolver().solve(planted(d, random, 7));
    ASSERT_EQ(report.status, Status::exact) << i << ": " << report.message;
    EXPECT_TRUE(std::any_of(report.dyads.begin(), report.dyads.end(), [&](const auto& f) {
      const auto* pr = std::get_if<PR::Design>(&f.design);
      return pr && difference(*pr, PR::Design{d.fixed, d.moving}) < 1e-12 * (1 + *f.condition);
    })) << i;
  }
}

TEST(SphericalLeastSquares, SmallErrorsMoveTheFitLittle) {
  Random random("SphericalLeastSquares.SmallErrorsMoveTheFitLittle");
  constexpr double error = 1e-4;
  for (int i = 0; i < 20; ++i) {
    const RR::Design d = RR::random_design(random);
    std::vector<Pose> poses = planted(d, random, 12);
    for (Pose& p : poses)
      p = Space::nudged(p, {error * random.normal(), error * random.normal(), error * random.normal()});
    const SphericalReport report = LeastSquaresSolver().solve(poses);
    ASSERT_EQ(report.status, Status::approximate) << i;
    EXPECT_TRUE(std::any_of(report.dyads.begin(), report.dyads.end(), [&](const auto& f) {
      const auto* rr = std::get_if<RR::Design>(&f.design);
      return rr && f.residual < 5 * error && difference(*rr, d) < 10 * error * (1 + *f.condition);
    })) << i;
  }
}

/// Random starts in great number are the slow oracle: no fit of theirs is better.
TEST(SphericalLeastSquares, NoSearchFindsBetterFits) {
  Random random("SphericalLeastSquares.NoSearchFindsBetterFits");
  for (int i = 0; i < 20; ++i) {
    const std::vector<Pose> poses = random_poses(random, 6 + i % 7);
    EXPECT_LE(least<RR>(best_dyads(poses), poses), (1 + 1e-9) * least<RR>(search<RR>(poses, {.starts = 60}), poses))
        << i;
    const std::vector<Pose> some = random_poses(random, 5 + i % 7);
    EXPECT_LE(sum_of_squares<PR>(best_slider(some)->design, some),
              (1 + 1e-9) * least<PR>(search<PR>(some, {.starts = 60}), some))
        << i;
  }
}

/// Six orientations of which two are equal are five: every dyad of the direct solver is a fit without error.
TEST(SphericalLeastSquares, AgreeWithTheDirectSolverWhereTwoOrientationsAreEqual) {
  Random random("SphericalLeastSquares.AgreeWithTheDirectSolverWhereTwoOrientationsAreEqual");
  int dyads = 0, missed = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<Pose> poses = random_poses(random, 5);
    const SphericalReport direct = FivePoseSolver{.certify = false}.solve(poses);
    poses.push_back(poses[2]);
    const auto fits = best_dyads(poses);
    for (const auto& f : direct.dyads) {
      ++dyads;
      missed += std::none_of(fits.begin(), fits.end(), [&](const auto& fit) {
        return fit.residual < exact_residual && difference(fit.design, std::get<RR::Design>(f.design)) < 1e-8;
      });
    }
  }
  EXPECT_GT(dyads, 80);
  EXPECT_EQ(missed, 0);
}

/// Sums of squares and axes of two sets of fits, the second moved.
template <class D, class Moved>
void expect_same(const std::vector<Found<typename D::Design>>& got,
                 const std::vector<Found<typename D::Design>>& expected, Moved moved) {
  ASSERT_EQ(got.size(), expected.size());
  for (const auto& e : expected)
    EXPECT_TRUE(std::any_of(got.begin(), got.end(), [&](const auto& g) {
      return std::abs(g.residual - e.residual) < 1e-6 && difference(g.design, moved(e.design)) < 1e-5;
    }));
}

TEST(SphericalLeastSquares, FollowTheFramesAndForgetOrderAndSign) {
  Random random("SphericalLeastSquares.FollowTheFramesAndForgetOrderAndSign");
  const auto same = [](const RR::Design& d) { return d; };
  for (int i = 0; i < 10; ++i) {
    // a dyad with errors: its fit is isolated and no other comes near
    const std::vector<Pose> exact = planted(RR::random_design(random), random, 9);
    std::vector<Pose> poses;
    for (const Pose& p : exact) poses.push_back(Space::nudged(p, {1e-2 * random.normal(), 1e-2 * random.normal(), 0}));
    const auto best_of = [](std::vector<Pose> task, std::vector<double> weights = {}) {
      auto all = best_dyads(task, weights);
      all.resize(1);
      return all;
    };
    const auto fits = best_of(poses);
    const Pose g = Space::random_pose(random), h = Space::random_pose(random);
    std::vector<Pose> turned, inverted, ordered(poses.rbegin(), poses.rend()), negative = poses, twice = poses;
    for (const Pose& p : poses) turned.push_back(product(product(g, p), inverse(h))), inverted.push_back(inverse(p));
    negative[4] = {-2 * poses[4].w, -2 * poses[4].x, -2 * poses[4].y, -2 * poses[4].z};
    SCOPED_TRACE(i);
    expect_same<RR>(best_of(turned), fits, [&](const RR::Design& d) { return RR::moved(d, point(g), point(h)); });
    expect_same<RR>(best_of(inverted), fits, [](const RR::Design& d) { return RR::inverse(d); });
    expect_same<RR>(best_of(ordered), fits, same);
    expect_same<RR>(best_of(negative), fits, same);
    // a weight of 2 is the orientation twice, a weight of 0 leaves it out
    twice.push_back(poses[3]);
    std::vector<double> weights(9, 1);
    weights[3] = 2;
    expect_same<RR>(best_of(poses, weights), best_of(twice), same);
    std::vector<Pose> without = poses;
    without.push_back(Space::random_pose(random));
    weights.assign(10, 1), weights[9] = 0;
    const auto all = best_dyads(without, weights);  // listed by the residuals of all, so the order may differ
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [&](const auto& f) { return difference(f.design, fits[0].design) < 1e-5; }));
  }
}

std::vector<Pose> with_errors(std::vector<Pose> poses, double error, Random& random) {
  for (Pose& p : poses) p = Space::nudged(p, error * Space::random_feature(random));
  return poses;
}

TEST(SphericalLeastSquares, OnlyRatiosOfWeightsMatter) {
  Random random("SphericalLeastSquares.OnlyRatiosOfWeightsMatter");
  const std::vector<Pose> poses = with_errors(planted(RR::random_design(random), random, 7), 0.1, random);
  const std::vector<double> weights{1, 2, 0.5, 0, 3, 1, 1};
  const auto fits = best_dyads(poses, weights);
  const auto slider = best_slider(poses, weights);
  for (const double power : {-300, -150, -20, -1, 1, 20, 150, 300, 307}) {
    SCOPED_TRACE(power);
    std::vector<double> scaled = weights;
    for (double& w : scaled) w *= std::pow(10, power);
    expect_same<RR>(best_dyads(poses, scaled), fits, [](const RR::Design& d) { return d; });
    EXPECT_LT(difference(best_slider(poses, scaled)->design, slider->design), 1e-7);
  }
}

/// Weights above largest_weight_ratio as that much.
double weighted_sum(const RR::Design& d, std::span<const Pose> poses, std::span<const double> weights) {
  double sum = 0;
  for (std::size_t j = 0; j < poses.size(); ++j)
    sum += std::min(weights[j], largest_weight_ratio) * std::pow(RR::residual(d, poses[j]), 2);
  return sum;
}

/// Any number of heavy orientations: fewer than five leave the dyad to the light ones.
TEST(SphericalLeastSquares, VeryDifferentWeightsFindThePlantedDyadOnce) {
  Random random("SphericalLeastSquares.VeryDifferentWeightsFindThePlantedDyadOnce");
  constexpr double error = 1e-4;
  for (const double ratio : {1e6, 1e9})
    for (const std::size_t heavy : {3, 4, 6}) {
      SCOPED_TRACE(testing::Message() << ratio << ' ' << heavy);
      const RR::Design d = RR::random_design(random);
      const std::vector<Pose> exact = planted(d, random, 8), poses = with_errors(exact, error, random);
      std::vector<double> weights(8, 1);
      std::fill_n(weights.begin(), heavy, ratio);
      const auto fits = best_dyads(poses, weights), met = best_dyads(exact, weights);
      EXPECT_TRUE(std::any_of(fits.begin(), fits.end(), [&](const auto& f) {
        return weighted_sum(f.design, poses, weights) <= weighted_sum(d, poses, weights);
      }));
      EXPECT_TRUE(std::any_of(met.begin(), met.end(), [&](const auto& f) {
        return f.residual < exact_residual && difference(f.design, d) < 1e-9;
      }));
      for (std::size_t i = 0; i < fits.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT(difference(fits[i].design, fits[j].design), 1e-4);
    }
}

TEST(SphericalLeastSquares, WeightsBeyondTheLargestRatioAreTold) {
  Random random("SphericalLeastSquares.WeightsBeyondTheLargestRatioAreTold");
  const std::vector<Pose> poses = random_poses(random, 6);
  const auto warnings = [&](double heaviest) {
    return LeastSquaresSolver{{heaviest, 1, 1, 1, 1, 1}}.solve(poses).warnings.size();
  };
  EXPECT_EQ(warnings(largest_weight_ratio), 0u);
  EXPECT_EQ(warnings(2 * largest_weight_ratio), 1u);
  EXPECT_EQ(warnings(std::numeric_limits<double>::max()), 1u);
}

TEST(SphericalLeastSquares, DegenerateOrientationsAreNamed) {
  Random random("SphericalLeastSquares.DegenerateOrientationsAreNamed");
  std::vector<Pose> one_axis;
  for (int i = 0; i < 7; ++i) one_axis.push_back(about({1, 2, 2}, 0.3 * i));
  EXPECT_EQ(LeastSquaresSolver().solve(one_axis).message,
            "all rotations have one axis: every moving axis with that one as fixed axis meets them");
  std::vector<Pose> equal(6, one_axis[3]);
  equal.push_back({-2 * equal[0].w, -2 * equal[0].x, -2 * equal[0].y, -2 * equal[0].z});
  EXPECT_EQ(LeastSquaresSolver().solve(equal).message, "all orientations are equal: every dyad meets them");
  std::vector<Pose> four = random_poses(random, 4);
  four.push_back(four[0]), four.push_back(four[1]);
  const SphericalReport report = LeastSquaresSolver().solve(four);
  EXPECT_EQ(report.status, Status::degenerate) << report.message;
  EXPECT_TRUE(report.dyads.empty());
}

/// Example 2 of J. Angeles, S. Bai, "A robust solution of the spherical Burmester problem", from the printed axes and
/// angles. Its row 4 is the slider; the columns of that table are exchanged: what it heads a0* is the fixed axis, as
/// the arcs show (with the printed roles they vary by tens of degrees). It is printed in four digits, truncated:
/// (0.0655, 0.1015, 0.9926) and (0.5221, 0.8442, -0.1208); 15 digits are the smallest singular vectors of the
/// attitudes' 5 x 3 matrix H. Those minimise the sines of the errors, we the errors: they differ by less than 1e-9.
TEST(SphericalLeastSquares, TheBestSliderOfExampleTwo) {
  const std::vector<Pose> poses{Pose{}, about({-0.2280, -0.4553, -0.8606}, 0.2563),
                                about({-0.0578, 0.2370, -0.9697}, 1.1307), about({0.5049, 0.8505, -0.1468}, 1.1938),
                                about({0.7119, 0.6601, 0.2393}, 1.3665)};
  const PR::Design printed{{0.5221, 0.8442, -0.1208}, {0.0655, 0.1015, 0.9926}};
  const PR::Design computed{{0.5221208808439046, 0.844282063828581, -0.12073765975923612},
                            {0.06558606369083067, 0.10149392515020238, 0.9926718749955331}};
  const auto slider = best_slider(poses);
  ASSERT_TRUE(slider);
  EXPECT_LT(difference(slider->design, printed), 1.5e-4);  // each coordinate truncated by up to 1e-4
  EXPECT_LT(difference(slider->design, computed), 1e-9);
  EXPECT_NEAR(slider->residual, 0.004610868776679 * std::numbers::pi / 180, 1e-8);  // 89.995389131223 deg at pose 1
}

/// Multipliers against very large weights: the same fits, but met to rounding.
TEST(SphericalLeastSquares, ExactOrientationsAreMetAndTheOthersFitBest) {
  Random random("SphericalLeastSquares.ExactOrientationsAreMetAndTheOthersFitBest");
  int fits = 0;
  for (const std::size_t exact : {1, 2, 3, 4})
    for (int i = 0; i < 3; ++i) {
      SCOPED_TRACE(testing::Message() << exact << ' ' << i);
      const std::vector<Pose> poses = with_errors(planted(RR::random_design(random), random, 9), 0.03, random);
      std::vector<double> weights(9, 1), heavy = weights;
      std::fill_n(weights.begin() + 2, exact, met_exactly_weight), std::fill_n(heavy.begin() + 2, exact, 1e8);
      const auto met = best_dyads(poses, weights), near = best_dyads(poses, heavy);
      ASSERT_FALSE(met.empty());
      for (const auto& f : met) {
        ++fits;
        for (std::size_t j = 2; j < 2 + exact; ++j) EXPECT_LT(std::abs(RR::residual(f.design, poses[j])), 1e-13);
        EXPECT_TRUE(std::any_of(near.begin(), near.end(), [&](const auto& n) {
          return difference(n.design, f.design) < 1e-6 * (1 + *f.condition);
        }));
      }
      const auto slider = best_slider(poses, weights);
      for (std::size_t j = 2; slider && j < 2 + exact; ++j)
        EXPECT_LT(std::abs(PR::residual(slider->design, poses[j])), 1e-13);
      EXPECT_TRUE(slider || exact == 4);
    }
  EXPECT_GT(fits, 12);
}

TEST(SphericalModule, AnswersManyOrientationsWithWeights) {
  Random random("SphericalModule.AnswersManyOrientationsWithWeights");
  const auto module = make_module();
  Problem problem;
  for (const Pose& p : random_poses(random, 8)) problem.poses.push_back({p.w, p.x, p.y, p.z});
  EXPECT_EQ(module->synthesize(problem).status, Status::approximate);
  problem.weights.assign(8, 1.0);
  EXPECT_EQ(module->synthesize(problem).status, Status::approximate);
  problem.weights[2] = std::nullopt;
  const Synthesis exact = module->synthesize(problem);
  EXPECT_EQ(exact.status, Status::approximate);
  EXPECT_NE(exact.message.find("of those that meet the 1 exact"), std::string::npos) << exact.message;
  problem.weights.assign(8, std::nullopt);
  EXPECT_THROW(module->synthesize(problem), NotAvailable);
  problem.weights.clear(), problem.poses.resize(5), problem.types = {"PR"};
  const Synthesis sliders = module->synthesize(problem);
  EXPECT_EQ(sliders.status, Status::approximate);
  EXPECT_EQ(sliders.dyads.back().type, "PR");
}

PoseData data(const Pose& p) { return {p.w, p.x, p.y, p.z}; }

TEST(SphericalModule, TheBestSliderJoinsWhatIsCountedAndProved) {
  Random random("SphericalModule.TheBestSliderJoinsWhatIsCountedAndProved");
  const auto module = make_module();
  RR::Design dyad = RR::random_design(random);
  dyad.arc = 1;
  for (const std::vector<Pose>& poses : {random_poses(random, 5), planted(dyad, random, 6)}) {
    Problem problem;
    for (const Pose& p : poses) problem.poses.push_back(data(p));
    const Synthesis all = module->synthesize(problem);
    ASSERT_TRUE(all.status == Status::exact || all.status == Status::none) << all.message;
    for (const std::vector<std::string>& types : {std::vector<std::string>{"PR"}, {"PR", "PR"}}) {  // the second was RP
      problem.types = types;
      const Synthesis sliders = module->synthesize(problem);
      EXPECT_EQ(sliders.status, Status::approximate);
      EXPECT_EQ(sliders.counts.complex, all.counts.complex);
      EXPECT_EQ(sliders.counts.real, all.counts.real);
      EXPECT_EQ(sliders.counts.certified, all.counts.certified);
      ASSERT_EQ(sliders.dyads.size(), all.dyads.size() + 1) << sliders.message;
      EXPECT_EQ(sliders.dyads.back().type, "PR");
      EXPECT_FALSE(sliders.dyads.back().certificate.certified);
      EXPECT_GT(sliders.dyads.back().residual, exact_residual);
    }
    problem.types = {"RR", "PR"};
    EXPECT_EQ(module->synthesize(problem).status, all.status);
  }
}

TEST(SphericalModule, RequestsThatHaveNoEffectAreTold) {
  Random random("SphericalModule.RequestsThatHaveNoEffectAreTold");
  const auto module = make_module();
  const auto warnings = [&](int count, bool given) {
    Problem problem;
    for (const Pose& p : random_poses(random, count)) problem.poses.push_back(data(p));
    if (given) problem.moving = {{0, 0, 1}};
    problem.weights.assign(problem.poses.size(), 1.0);
    if (count != 4 || given) problem.near = {{1, 0, 0}};
    return module->synthesize(problem).warnings;
  };
  const std::string near = "near: only four poses without given axes leave a choice; ignored",
                    alike = "weights: fits with given axes count all poses alike; ignored",
                    met = "weights: up to five poses are met exactly; ignored";
  using Told = std::vector<std::string>;
  EXPECT_EQ(warnings(3, false), (Told{near, met}));
  EXPECT_EQ(warnings(4, false), (Told{met}));
  EXPECT_EQ(warnings(4, true), (Told{near, alike}));
  EXPECT_EQ(warnings(6, false), (Told{near}));
  EXPECT_EQ(warnings(6, true), (Told{near, alike}));
}

}  // namespace
}  // namespace burmester::spherical
