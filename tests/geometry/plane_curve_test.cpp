#include "burmester/geometry/plane_curve.hpp"

#include <gtest/gtest.h>

#include "burmester/geometry/rational.hpp"
#include "curve_corpus.hpp"
#include "rational.hpp"

namespace burmester {
namespace {

using Form = TernaryForm<Rational>;
using Point = Point2<Rational>;

Form random_form(Random& random, int degree) {
  Form f(degree);
  for (int k = 0; k < f.size(); ++k) f.coefficients[static_cast<std::size_t>(k)] = random_rational(random);
  return f;
}
Rational power(const Rational& x, int n) { return n == 0 ? Rational(1) : x * power(x, n - 1); }

TEST(TernaryForm, ValueIsTheSumOfItsMonomialsInTheStatedOrder) {
  Random random("TernaryForm.ValueIsTheSumOfItsMonomialsInTheStatedOrder");
  for (int d = 0; d <= Form::highest_degree; ++d) {
    const Form f = random_form(random, d);
    const Point p = random_rationals<3>(random);
    Rational sum = 0;
    std::size_t k = 0;
    for (int j = 0; j <= d; ++j)
      for (int i = 0; i + j <= d; ++i, ++k) {
        EXPECT_EQ(f(i, j), f.coefficients[k]);
        sum += f.coefficients[k] * power(p[0], i) * power(p[1], j) * power(p[2], d - i - j);
      }
    EXPECT_EQ(static_cast<int>(k), f.size());
    EXPECT_EQ(f(p), sum) << "degree " << d;
  }
}

TEST(TernaryForm, GradientObeysEulersIdentityAndIsTheSlope) {
  Random random("TernaryForm.GradientObeysEulersIdentityAndIsTheSlope");
  for (int d = 1; d <= Form::highest_degree; ++d) {
    const Form f = random_form(random, d);
    const Point p = random_rationals<3>(random), v = random_rationals<3>(random);
    EXPECT_EQ(Rational(f.gradient(p).dot(p)), d * f(p));
    if (d <= 2) {  // then the difference is exact
      EXPECT_EQ(f(Point(p + v)) - f(Point(p - v)), 2 * Rational(f.gradient(p).dot(v)));
    }
  }
}

TEST(TernaryForm, DerivativesCommuteAndObeyTheProductRule) {
  Random random("TernaryForm.DerivativesCommuteAndObeyTheProductRule");
  for (int d = 1; d <= 3; ++d) {
    const Form f = random_form(random, d), g = random_form(random, 3);
    for (int a = 0; a < 3; ++a) {
      EXPECT_EQ((f * g).derivative(a).coefficients, (f.derivative(a) * g + f * g.derivative(a)).coefficients);
      for (int b = 0; b < 3; ++b)
        EXPECT_EQ(g.derivative(a).derivative(b).coefficients, g.derivative(b).derivative(a).coefficients);
    }
  }
}

TEST(TernaryForm, ProductsAndSubstitutionsEvaluateAsTheyShould) {
  Random random("TernaryForm.ProductsAndSubstitutionsEvaluateAsTheyShould");
  for (int d = 0; d <= Form::highest_degree; ++d) {
    const Form f = random_form(random, d), g = random_form(random, Form::highest_degree - d);
    const Point p = random_rationals<3>(random);
    Matrix<Rational, 3, 3> m, n;
    for (int i = 0; i < 3; ++i)
      m.col(i) = random_rationals<3>(random), n.col(i) = random_rationals<3>(random);
    EXPECT_EQ((f * g)(p), f(p) * g(p));
    EXPECT_EQ((f + f)(p), 2 * f(p));
    EXPECT_EQ(f.substituted(m)(p), f(Point(m * p)));
    EXPECT_EQ(f.substituted(m).substituted(n).coefficients, f.substituted(m * n).coefficients);
  }
}

TEST(TernaryForm, LinesAndConicsAreForms) {
  Random random("TernaryForm.LinesAndConicsAreForms");
  const LinearForm<Rational> l = random_rationals<3>(random), m = random_rationals<3>(random);
  const Point p = random_rationals<3>(random);
  Conic<Rational> c;
  c.add_product(l, m, 3);
  EXPECT_EQ(Form(l)(p), Rational(l.dot(p)));
  EXPECT_EQ(Form(c)(p), c(p));
  EXPECT_EQ(Form(c).coefficients, (Form(l) * Form(m) * Rational(3)).coefficients);
}

const Matrix<double, 3, 3> Identity = Matrix<double, 3, 3>::Identity();

/// The corpus is what it says: exact in double, through the points it names.
TEST(CurveCorpus, IsExact) {
  Random random("CurveCorpus.IsExact");
  for (const corpus::CorpusCurve& c : corpus::curve_corpus()) {
    const corpus::ProjectiveMap map = corpus::random_projective_map(random);
    EXPECT_EQ(map.matrix * map.inverse, Identity);
    const corpus::CorpusCurve other = moved(c, map);
    EXPECT_EQ(other.curve.cast<Rational>().coefficients,
              c.curve.cast<Rational>().substituted(map.matrix.cast<Rational>()).coefficients)
        << c.name;
    for (const corpus::CorpusCurve& one : {c, other}) {
      if (!one.on_curve) continue;
      EXPECT_EQ(one.curve.cast<Rational>()(one.on_curve->cast<Rational>()), 0) << one.name;
      EXPECT_NE(one.curve.gradient(*one.on_curve), LinearForm<double>(LinearForm<double>::Zero()))
          << one.name;
    }
  }
}

/// Points drawn by the linkage are on the curve; the coefficients are integers and the sum below has none above 2^53.
TEST(CurveCorpus, CouplerPointsAreOnTheCouplerCurve) {
  const corpus::FourBar bars{5, 2, 5, 4, 2, 1};
  const PlaneCurve curve = corpus::coupler_curve(bars);
  EXPECT_EQ(curve.cast<Rational>().coefficients, corpus::coupler_curve<Rational>(bars).coefficients);
  for (double phi = 0; phi < 6; phi += 0.37) {
    const Vector<double, 2> c(bars.crank * std::cos(phi), bars.crank * std::sin(phi));
    const Vector<double, 2> to_b = Vector<double, 2>(bars.ground, 0) - c;
    const double distance = to_b.norm(), r = bars.coupler;
    const double along = (r * r + distance * distance - bars.rocker * bars.rocker) / (2 * distance);
    for (const double side : {std::sqrt(r * r - along * along), -std::sqrt(r * r - along * along)}) {
      const Vector<double, 2> e = to_b / distance, n(-e[1], e[0]), u = (along * e + side * n) / r,
                              w(-u[1], u[0]);
      const Vector<double, 2> p = c + bars.s * u + bars.t * w;
      EXPECT_NEAR(curve(Point2<double>(p[0], p[1], 1)) / size_of(curve), 0, 1e-9) << phi;
    }
  }
}

}  // namespace
}  // namespace burmester
