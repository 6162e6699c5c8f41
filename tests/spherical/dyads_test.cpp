#include "burmester/spherical/dyads.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "burmester/modules/framework/local.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/spherical/family.hpp"
#include "rational.hpp"

namespace burmester::spherical {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
constexpr double pi = std::numbers::pi;
const Axis x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

TEST(SphericalRR, ResidualIsTheArcBeyondTheLink) {
  const RR::Design d{z, x, pi / 2};
  EXPECT_NEAR(RR::residual(d, {}), 0, 1e-15);
  EXPECT_NEAR(RR::residual(d, pose_from_axis_degrees({0, 1, 0}, -30)), -pi / 6, 1e-15);  // x rises towards z
  EXPECT_NEAR(RR::residual(d, pose_from_axis_degrees({0, 1, 0}, 30)), pi / 6, 1e-15);
}

TEST(SphericalRR, ResidualDoesNotSeeTheScaleOfTheQuaternion) {
  Random random("SphericalRR.ResidualDoesNotSeeTheScaleOfTheQuaternion");
  for (int i = 0; i < 100; ++i) {
    const RR::Design d = RR::random_design(random);
    const Pose p = Space::random_pose(random);
    for (const double s : {-1.0, 1e-20, 3.0, 1e20})
      EXPECT_NEAR(RR::residual(d, {s * p.w, s * p.x, s * p.y, s * p.z}), RR::residual(d, p), 2e-15);
  }
}

TEST(SphericalRR, RowIsTheRotationMatrixRowByRow) {
  const Vector<double, 10> row = Family::row<double>(pose_from_axis_degrees({0, 0, 1}, 90));
  const Vector<double, 10> expected{{0, -1, 0, 1, 0, 0, 0, 0, 1, 1}};
  EXPECT_LT((row / row[9] - expected).norm(), 1e-15);
}

TEST(SphericalRR, LiftedFormIsTheConstraintExactlyOverTheRationals) {
  // norm(x) (b . Q a) - norm(x) c = row . [b (x) a, -c] for any b, a, c: no rounding, no sign left to chance.
  Random random("SphericalRR.LiftedFormIsTheConstraintExactlyOverTheRationals");
  for (int i = 0; i < 50; ++i) {
    const Pose pose{random.normal(), random.normal(), random.normal(), random.normal()};
    const Vector<Rational, 3> a = random_rationals<3>(random), b = random_rationals<3>(random);
    const Rational c(random.below(100) - 50, 50);
    Vector<Rational, 10> k;
    for (int r = 0; r < 3; ++r)
      for (int s = 0; s < 3; ++s) k[3 * r + s] = b[r] * a[s];
    k[9] = -c;
    const Vector<Rational, 4> point = Space::point<Rational>(pose);
    const Vector<Rational, 3> moved = Space::act<Rational>(point, a);
    const Rational constraint = b.dot(moved) - Space::norm<Rational>(point) * c;
    EXPECT_EQ(Rational(Family::row<Rational>(pose).dot(k)), constraint);
    const Vector<Rational, 9> minors = Family::relations<Rational>(k);
    for (int j = 0; j < 9; ++j) EXPECT_EQ(minors[j], 0);
  }
}

TEST(SphericalFamily, RelationsVanishForRankOneOnly) {
  Vector<double, 10> two = Vector<double, 10>::Zero();
  two[0] = two[4] = 1;  // rank two
  const Vector<double, 9> minors = Family::relations<double>(two);
  EXPECT_THAT(std::vector<double>(minors.begin(), minors.end()), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 1));
}

TEST(SphericalFamily, DecodeTakesTheNearestRankOneMatrix) {
  Random random("SphericalFamily.DecodeTakesTheNearestRankOneMatrix");
  const RR::Design d{z, Axis(1, 2, 2) / 3, 1.0};
  Vector<double, 10> k = RR::encode(d);
  for (int i = 0; i < 10; ++i) k[i] += 1e-9 * random.normal();
  const auto decoded = Family::decode(k);
  ASSERT_TRUE(decoded && std::holds_alternative<RR::Design>(*decoded));
  std::vector<Pose> probes;
  for (int i = 0; i < 10; ++i) probes.push_back(Space::random_pose(random));
  EXPECT_LT(disagreement<RR>(std::get<RR::Design>(*decoded), d, probes), 1e-8);
}

TEST(SphericalFamily, DecodeIsEmptyWhereTheArcIsImaginary) {
  Vector<double, 10> k = RR::encode({z, x, 0.5});
  k[9] = -1.0001;
  EXPECT_FALSE(Family::decode(k));
  k.setZero();
  k[9] = 1;
  EXPECT_FALSE(Family::decode(k));
  k[0] = std::nan("");
  EXPECT_FALSE(Family::decode(k));
}

TEST(SphericalFamily, ArcsWithinTheToleranceOfARightAngleAreSliders) {
  const auto type_at = [](double beyond) {
    return Family::decode(RR::encode({z, x, pi / 2 + beyond}))->index();
  };
  EXPECT_EQ(type_at(0), 1u);
  EXPECT_EQ(type_at(9e-10), 1u);
  EXPECT_EQ(type_at(-9e-10), 1u);
  EXPECT_EQ(type_at(1.1e-9), 0u);
  EXPECT_EQ(type_at(-1.1e-9), 0u);
}

TEST(SphericalPR, IsTheRRWithAnArcOfARightAngle) {
  Random random("SphericalPR.IsTheRRWithAnArcOfARightAngle");
  for (int i = 0; i < 200; ++i) {
    const PR::Design d = PR::random_design(random);
    const Pose p = Space::random_pose(random);
    EXPECT_NEAR(PR::residual(d, p), RR::residual({d.fixed, d.moving, pi / 2}, p), 2e-15);
  }
}

TEST(SphericalRecord, ShowsTheMovingAxisUpwardsAndTheShorterArc) {
  const DyadRecord record = RR::record({x, -z, 1.0});  // = (x, z, pi - 1) = (-x, z, 1)
  EXPECT_EQ(record.type, "RR");
  EXPECT_THAT(record.fixed, ElementsAre(-1, 0, 0));
  EXPECT_THAT(record.moving, ElementsAre(0, 0, 1));
  EXPECT_THAT(*record.arc, DoubleNear(1.0, 4e-16));
}

TEST(SphericalRecord, AllFourWaysToWriteADyadLookTheSame) {
  Random random("SphericalRecord.AllFourWaysToWriteADyadLookTheSame");
  for (int i = 0; i < 100; ++i) {
    const RR::Design d = RR::random_design(random);
    const DyadRecord first = RR::record(d);
    EXPECT_GE(first.moving[2], 0);
    EXPECT_LE(*first.arc, pi / 2);
    for (const RR::Design& same :
         {RR::Design{-d.fixed, d.moving, pi - d.arc}, RR::Design{d.fixed, -d.moving, pi - d.arc},
          RR::Design{-d.fixed, -d.moving, d.arc}}) {
      const DyadRecord other = RR::record(same);
      EXPECT_EQ(other.fixed, first.fixed);
      EXPECT_EQ(other.moving, first.moving);
      EXPECT_NEAR(*other.arc, *first.arc, 4e-16);
    }
  }
}

TEST(SphericalRecord, SlidersShowBothAxesUpwards) {
  const DyadRecord record = PR::record({-x, -y});
  EXPECT_EQ(record.type, "PR");
  EXPECT_THAT(record.fixed, ElementsAre(1, 0, 0));
  EXPECT_THAT(record.moving, ElementsAre(0, 1, 0));
  EXPECT_EQ(*record.arc, pi / 2);
}

TEST(SphericalRecord, CoordinatesBelowTheCertificateRadiusCountAsZero) {
  const Axis a = Axis(0.6, 0.8, -1e-14).normalized();
  EXPECT_LT(RR::record({z, a, 1}).moving[1], 0);
  EXPECT_GT(RR::record({z, a, 1}, 1e-12).moving[1], 0);
}

TEST(SphericalSearch, FindsAPlantedDyadAndAtMostSix) {
  Random random("SphericalSearch.FindsAPlantedDyadAndAtMostSix");
  for (int i = 0; i < 10; ++i) {
    const RR::Design d = RR::random_design(random);
    std::vector<Pose> poses, probes;
    while (poses.size() < 5)
      if (const auto pose = pose_with_residual<RR>(d, Space::random_pose(random))) poses.push_back(*pose);
    for (int j = 0; j < 20; ++j) probes.push_back(Space::random_pose(random));
    const auto found = search<RR>(poses);
    EXPECT_LE(found.size(), 6u);
    bool there = false;
    for (const auto& f : found) there |= std::abs(disagreement<RR>(f.design, d, probes)) < 1e-5;
    EXPECT_TRUE(there) << "task " << i;
  }
}

}  // namespace
}  // namespace burmester::spherical
