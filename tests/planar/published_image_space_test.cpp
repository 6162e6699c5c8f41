// Numbers printed about the planar image space and the constraint surfaces, and the same in 60 digits where the print
// is short or wrong. MECH 576: "Kinematic Mapping and the Burmester Problem", lecture notes, McGill University, P. J.
// Zsombor-Murray. MECH 5507: M. J. D. Hayes, lecture notes ME 401 / MECH 5507, unit 3, Carleton University.
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <numbers>

#include "burmester/geometry/grassmann.hpp"
#include "burmester/planar/constraint_curve.hpp"
#include "burmester/planar/motion_rank.hpp"
#include "burmester/planar/poles.hpp"

namespace burmester::planar {
namespace {

// ---- MECH 576, section 5: three poses and two given fixed centres, in the image space ----

/// The poses that the notes' figure shows, recovered: table 16 in all its digits.
const std::array<Pose, 3> mech576{pose_from_degrees(-1.221, 22.394, 36.868), pose_from_degrees(12.779, 28.394, -45),
                                  pose_from_degrees(8.154, 12.519, 67.38)};

TEST(Mech576ThreePoses, Table16) {
  const double printed[3][6] = {{1.8974, -21.6310, 5.9229, 0.6324, -34.2034, 9.3654},  // X0 (our X4), X1, X2, X3, pole
                                {1.8478, -31.1229, 0.9403, -0.7654, 40.6641, -1.2286},
                                {1.6641, -5.8934, 13.7288, 1.1094, -5.3123, 12.3750}};
  const double computed[3][6] = {{1.897377069357605, -21.63102596560481, 5.922904074466387, 0.6324241113967317,
                                  -34.20335432472981, 9.365398895664237},
                                 {1.8477590650225735, -31.122947028318958, 0.9403431673873744, -0.7653668647301796,
                                  40.66408994501083, -1.2286175567828908},
                                 {1.6641018961591163, -5.893428414912588, 13.728822910879902, 1.109398431222811,
                                  -5.312273975740783, 12.375015616118727}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<double, 4> X = image_point(mech576[i]);
    const Point2<double> P = pole(mech576[i]);
    const double found[6] = {X[3], X[0], X[1], X[2], P[0] / P[2], P[1] / P[2]};
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(found[k], computed[i][k], 1e-12) << i << k;
      EXPECT_NEAR(found[k], printed[i][k], 6e-5) << i << k;
    }
    const Pose back = *pose_of_image(-2 * X);
    EXPECT_NEAR(back.x, mech576[i].x, 1e-13);
    EXPECT_NEAR(back.y, mech576[i].y, 1e-13);
    EXPECT_NEAR(angle_of(back), angle_of(mech576[i]), 1e-15);
  }
}

/// Eq. 17: Eq. 14 of the poses for the centre (0, 0), divided by (X3^2 + X4^2) / 4: constant + cx x + cy y + x^2 + y^2
/// - R.
TEST(Mech576ThreePoses, Equation17) {
  const double printed[3][3] = {
      {503.9821, 24.9180, 37.2964},  // misprint: the constant is 502.9821, as Eqs. 18, 19 used it
      {969.5221, -22.0829, 58.2274},
      {223.2131, 29.3843, -5.4235}};
  const double constant[3] = {502.982077, 969.522077, 223.213077};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<double, 8> row =
        Family::row<double>(mech576[i]) / std::pow(std::hypot(mech576[i].X3, mech576[i].X4), 2);
    EXPECT_NEAR(row[0], constant[i], 1e-12);
    EXPECT_NEAR(row[0], printed[i][0] - (i == 0 ? 1 : 0), 6e-5);
    EXPECT_NEAR(row[3], printed[i][1], 6e-5);
    EXPECT_NEAR(row[4], printed[i][2], 6e-5);
  }
}

/// The dyads found there stand on their surfaces; seen from the fixed centre their moving pivots run on circles.
TEST(Mech576ThreePoses, DyadsOfTable16) {
  const RR::Design M{{0, 0}, {7.352058590438461, -5.780259849944223}, 23.62332646967654};
  const RR::Design other{{16, 0}, {7.076702762857621, -14.02358240987242}, 15.73827233465615};
  EXPECT_NEAR(M.moving[0], 7.35221, 2e-4);  // printed
  EXPECT_NEAR(M.moving[1], -5.7803, 6e-5);
  EXPECT_NEAR(M.length, 23.6233, 6e-5);
  EXPECT_NEAR((M.moving - other.moving).norm(), 8.2479, 6e-5);
  for (const RR::Design& d : {M, other}) {
    std::array<Point2<double>, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(ConstraintManifold(d).distance(mech576[i]), 0, 1e-13);
      places[i] = to_fixed(mech576[i], d.moving).homogeneous();
    }
    const Circle circle = std::get<Circle>(*curve_of(*circle_through(places)));
    EXPECT_LT((circle.centre - d.fixed).norm(), 1e-12);
    EXPECT_NEAR(circle.radius, d.length, 1e-12);
  }
}

// ---- MECH 5507: the constraint manifold equation ----

struct ManifoldCase {
  const char* dyad;
  bool moving_point;  ///< upper signs: (x, y) in E on K in S; lower: (X, Y) in S on K in E
  double pose[3];     ///< a, b, degrees
  Vector<double, 4> image, K;
  Vector2 point;
  double value_of_printed;  ///< of the printed equation, -(K1 + K0 x) X1 X3 for (K1 - K0 x) X1 X3
};
// clang-format off
const ManifoldCase manifold_cases[] = {
    {"RR", true, {0.9314737547561401, 2.7644999489528557, 35},
     {-1.2354037011028427, 0.9015586202584936, 0.3152987888789835, 1}, {1, -3, -1, 6}, {1.2, -0.7},
     -2.3371277444060405},
    {"RR", true, {-2.1529136515515472, 3.5492338546876647, -80},
     {-0.8713624018571152, -2.5655372349909413, -0.83909963117728, 1}, {1, 1, -4, 16.19}, {-0.4, 2.1},
     -1.4623197400401085},
    {"PR", true, {2.4655140414074777, 2.3573578938145845, 35},
     {-0.7899921512973395, 1.6043930651407639, 0.3152987888789835, 1},
     {0, -0.4330127018922193, 0.25, 2.098076211353316}, {1.2, -0.7}, -0.21571269801049012},
    {"PR", true, {-1.3629077393262397, 2.8140727320326904, 140},
     {-3.2793154853157405, 3.184346774318278, 2.747477419454622, 1},
     {0, 0.17101007166283436, 0.4698463103929542, -1.8793852415718169}, {0.5, 0.5}, 3.0815485627801613},
    {"RP", false, {2.3207701963345118, -0.9066465225501067, 35},
     {0.8191912773604095, 1.0174528229165605, 0.3152987888789835, 1},
     {0, -0.4330127018922193, 0.25, 0.8428203230275509}, {3, 1}, 0.22368571679589141},
    {"RP", false, {-3.2659176033864794, 0.9967035719088695, -100},
     {1.4477327325218197, -2.226871332980178, -1.19175359259421, 1},
     {0, -0.12940952255126037, 0.48296291314453416, -1.2178098359794876}, {-2, 0.5}, -0.4465510285938809},
    {"RR", false, {1.053257561843218, -2.790621657040363, 50},
     {1.6408818620687586, -0.12401534392394756, 0.4663076581549986, 1}, {1, -0.7, -0.2, -1.16}, {2, -1},
     1.0712180897744148}};
// clang-format on

TEST(Mech5507, ConstraintManifoldEquation) {
  for (const ManifoldCase& c : manifold_cases) {
    const Pose pose = pose_from_degrees(c.pose[0], c.pose[1], c.pose[2]);
    const Vector<double, 4> X = image_point(pose) / image_point(pose)[3];
    EXPECT_LT((X - c.image).norm(), 1e-14);
    EXPECT_NEAR(std::remainder(angle_of(*pose_of_image(c.image)) - angle_of(pose), 2 * std::numbers::pi), 0, 1e-15);
    const Vector<double, 8> k =
        c.moving_point ? form_of_moving_point<double>(c.K, c.point) : form_of_fixed_point<double>(c.K, c.point);
    const Quadric<double> surface = constraint_quadric(k);
    EXPECT_NEAR(surface(point_of_image(c.image)), 0, 1e-14 * (1 + k.norm()));
    EXPECT_NEAR(-2 * c.K[1] * X[0] * X[2], c.value_of_printed, 1e-14);  // what the printed sign makes of it

    const auto design = design_of(surface);
    ASSERT_TRUE(design);
    EXPECT_EQ(Family::Types::visit(*design, []<class D>(const auto&) { return std::string(D::name); }), c.dyad);
    EXPECT_NEAR(ConstraintManifold(*design).distance(pose), 0, 4e-15);
  }
}

/// The printed matrices of the two point maps, with the scale X3^2 + X4^2: a point of E to S and back.
TEST(Mech5507, PointsThroughImageCoordinates) {
  for (const ManifoldCase& c : manifold_cases) {
    const double X1 = c.image[0], X2 = c.image[1], X3 = c.image[2], X4 = c.image[3];
    const double cosine = X4 * X4 - X3 * X3, sine = 2 * X3 * X4, n = X3 * X3 + X4 * X4;
    const Vector2 to_S(cosine * c.point[0] - sine * c.point[1] + 2 * (X1 * X3 + X2 * X4),
                       sine * c.point[0] + cosine * c.point[1] + 2 * (X2 * X3 - X1 * X4));
    const Vector2 to_E(cosine * c.point[0] + sine * c.point[1] + 2 * (X1 * X3 - X2 * X4),
                       -sine * c.point[0] + cosine * c.point[1] + 2 * (X2 * X3 + X1 * X4));
    const Point3<double> x = point_of_image(c.image);
    EXPECT_LT((Space::act<double>(x, c.point) - to_S).norm(), 1e-13);
    EXPECT_LT((Space::act<double>(Space::conjugate<double>(x), c.point) - to_E).norm(), 1e-13);
    const Pose pose = *pose_of_image(c.image);
    EXPECT_LT((to_fixed(pose, c.point) - to_S / n).norm(), 1e-14);
    EXPECT_LT((to_moving(pose, c.point) - to_E / n).norm(), 1e-14);
  }
}

// ---- MECH 5507: parametrised surfaces, X4 = 1 ----

/// The printed text calls K1, K2 the coordinates of the fixed centre; the printed formula holds for their negatives.
TEST(Mech5507, SurfaceParametrisation) {
  struct Sample {
    double t, at;
    Vector<double, 3> X;
  };
  struct Case {
    Family::Design design;
    Sample samples[3];
  };
  const Line fixed_line{{-0.8660254037844386, 0.5}, -2.3547660358};                        // 60 deg in S
  const Line moving_line{{-0.9396926207859084, 0.3420201433256687}, 0.17101007166283436};  // 70 deg in E
  const Case cases[] = {{RR::Design{{5, 0}, {3, -2}, 2},
                         {{-1.5, 0.3, {-5.277742651567941, 3.0327566290265873, -1.5}},
                          {0.4, 2.0, {0.1517961402451948, 1.5793433004319246, 0.4}},
                          {2.2, -1.1, {8.896164557725887, -3.3536999007256347, 2.2}}}},
                        {RR::Design{{-1, 1}, {-1, -2}, 5},
                         {{-1.5, 0.3, {4.305643371080148, 2.081891572566468, -1.5}},
                          {0.4, 2.0, {-3.020509649387013, 2.2483582510798117, 0.4}},
                          {2.2, -1.1, {-0.9595886056852813, -6.484249751814088, 2.2}}}},
                        {PR::Design{{0, 0}, fixed_line},
                         {{-1.5, 0.3, {-0.6983700857110169, 2.022536582762287, -1.5}},
                          {0.4, 2.0, {1.662574354128754, -0.062243161607987006, 0.4}},
                          {2.2, -1.1, {2.9605934645372933, 1.0474130223749591, 2.2}}}},
                        {RP::Design{{1, 3}, moving_line},
                         {{-1.5, 0.3, {-2.440609438188118, -0.3161847650875582, -1.5}},
                          {0.4, 2.0, {-1.115242041850036, 1.1979480796834698, 0.4}},
                          {2.2, -1.1, {-1.320370631234839, 3.156689549443315, 2.2}}}}};
  for (const Case& c : cases) {
    const ConstraintManifold m(c.design);
    for (const Sample& s : c.samples) {
      const Vector<double, 4> X = image_coordinates(*m.point(s.t, 1, s.at));
      EXPECT_LT((X.head<3>() - s.X).norm(), 4e-15 * (1 + s.X.norm()));
      EXPECT_EQ(X[3], 1);
      EXPECT_NEAR(m.quadric()(point_of_image(X)), 0, 1e-14 * size_of(m.quadric()) * X.squaredNorm());
    }
  }
}

// ---- MECH 5507: quadric fitting, the four-bar of 40 poses (M. J. D. Hayes, S. Radacina-Rusu, IFToMM 2011) ----

const RR::Design fit_crank{{5, 0}, {3, -2}, 2}, fit_rocker{{-1, 1}, {-1, -2}, 5};

/// The poses are not printed; crank angles 0 to 360 degrees with both ends, in this assembly, give the printed numbers.
std::vector<Pose> forty_poses() {
  std::vector<Pose> out;
  for (int i = 0; i < 40; ++i) {
    const double crank = i * 2 * std::numbers::pi / 39;
    const Vector2 A = fit_crank.fixed + 2 * Vector2(std::cos(crank), std::sin(crank)), diagonal = fit_rocker.fixed - A;
    const double d = diagonal.norm(), inner = std::acos((16 + d * d - 25) / (8 * d));  // coupler 4, rocker 5
    const Pose turn = pose_from_radians(0, 0, std::atan2(diagonal[1], diagonal[0]) - inner - std::numbers::pi);
    const Vector2 t = A - rotated(turn, fit_crank.moving);
    out.push_back({t[0], t[1], turn.X3, turn.X4});
  }
  return out;
}

double sum_of_spacings(const RR::Design& d) {
  const ConstraintManifold m(d);
  double sum = 0;
  for (const Pose& x : forty_poses()) sum += *m.spacing(x);
  return sum;
}

TEST(Mech5507QuadricFit, SumOfSpacings) {
  EXPECT_LT((image_point(forty_poses()[7]).head<3>() / image_point(forty_poses()[7])[3] -
             Vector<double, 3>(-3.465191738445722, 1.4627399562144354, -0.35264161650014475))
                .norm(),
            1e-14);
  EXPECT_LT(sum_of_spacings(fit_crank), 1e-13);  // guesses 4 and 5, printed 0.0004 and 0.0010: the optimiser's stop
  EXPECT_LT(sum_of_spacings(fit_rocker), 1e-13);
  struct Guess {
    double K1, K2, K3, x, y, printed, computed;
  };
  const Guess guesses[] = {{-97.720, -57.463, 1491.757, -1.133, 0.534, 1.1132, 1.1125413394716044},
                           {-18.202, -12.363, 261.650, -1.287, 0.889, 1.9333, 1.933810357731679},
                           {888.914, 432.395, -2374.375, -0.894, -5.375, 6.713, 6.713070139826585},  // printed 6.726
                           {-25.445, -17.073, 390.531, -1.309, 1.030, 1.5746, 1.5747165323144219},
                           {-1.398, -6.191, 36.554, -4.388, -2.361, 4.8138, 4.814170408242624}};
  for (const Guess& g : guesses) {
    const Circle circle = std::get<Circle>(*curve_of({1, g.K1, g.K2, g.K3}));
    const double d = sum_of_spacings({circle.centre, {g.x, g.y}, circle.radius});
    EXPECT_NEAR(d, g.computed, 1e-10);
    EXPECT_NEAR(d, g.printed, 7e-4);  // K and (x, y) are printed to three decimals
  }
}

/// The poses lie on the common curve of the two surfaces.
TEST(Mech5507QuadricFit, PosesLieOnTheCommonCurve) {
  const ConstraintCurve curve((ConstraintManifold(fit_crank)), (ConstraintManifold(fit_rocker)));
  for (const Pose& x : forty_poses()) {
    const CommonPoses common = curve.at(x.X3, x.X4);
    double nearest = 1;
    for (const Pose& y : common.poses) nearest = std::min(nearest, std::hypot(x.x - y.x, x.y - y.y));
    EXPECT_LT(nearest, 1e-12);
  }
}

/// Rank 6: the poses leave the pencil of the two surfaces. The rows as printed, X4 = 1: ours of the same pose over 4.
TEST(Mech5507QuadricFit, SingularValuesOfTheRows) {
  Eigen::Matrix<double, 40, 8> C;
  const std::vector<Pose> poses = forty_poses();
  for (std::size_t i = 0; i < 40; ++i) {
    const Pose& x = poses[i];
    const Vector<double, 4> X = image_point(x) / image_point(x)[3];
    C.row(static_cast<int>(i)) << X[0] * X[0] + X[1] * X[1], X[1] + X[0] * X[2], X[1] * X[2] - X[0], X[1] - X[0] * X[2],
        -(X[0] + X[1] * X[2]), (1 + X[2] * X[2]) / 4, (1 - X[2] * X[2]) / 2, X[2];
    const Vector<double, 8> ours = Family::row<double>({x.x, x.y, x.X3 / x.X4, 1}) / 4;
    EXPECT_LT((C.row(static_cast<int>(i)).transpose() - ours).norm(), 1e-14 * ours.norm());
  }
  const Vector<double, 8> s = Eigen::JacobiSVD<Eigen::MatrixXd>(C).singularValues();
  const double computed[8] = {103.05044112301279,
                              9.761947549491175,
                              7.580143826166289,
                              1.298270518785426,
                              0.2740237319009963,
                              0.051577914290324246,
                              0,
                              0};
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(s[k], computed[k], 1e-12);
  EXPECT_EQ(motion_rank(poses).rank, 6);
}

/// The circle printed for noisy points has radius sqrt(K1^2 + K2^2 - K3); printed is 0.99746, which is -K3.
TEST(Mech5507, RadiusOfThePrintedCircle) {
  const Circle circle = std::get<Circle>(*curve_of({1, -0.00047, 0.00027, -0.99746}));
  EXPECT_NEAR(circle.centre[0], 0.00047, 1e-18);
  EXPECT_NEAR(circle.centre[1], -0.00027, 1e-18);
  EXPECT_NEAR(circle.radius, 0.998729339611088, 1e-14);
}

}  // namespace
}  // namespace burmester::planar
