#include "burmester/geometry/real_roots.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/root_isolation.hpp"
#include "burmester/geometry/simple_roots.hpp"

namespace burmester {
namespace {

constexpr int highest_degree_in_doubles = 12;
using Factor = std::shared_ptr<const IntegerPolynomial>;

DyadicInterval dyadic(const Range& box) {
  const Rational low(box.low), high(box.high);
  const int scale = static_cast<int>(std::max(msb(Integer(denominator(low))), msb(Integer(denominator(high)))));
  const auto scaled = [&](const Rational& x) {
    return (Integer(numerator(x)) << scale) / Integer(denominator(x));
  };
  return {scaled(low), scaled(high) - scaled(low), scale};
}

/// |c| / 2^exponent <= 1
Interval enclosed(const Integer& c, int exponent) {
  if (c == 0) return Interval(0);
  const Integer size = abs(c);
  const int excess = std::max(0, static_cast<int>(msb(size)) - 52), power = excess - exponent;
  const auto digits = static_cast<double>(Integer(size >> excess));
  const Interval magnitude = power < -1000
                                 ? Interval(0, 0x1p-900)
                                 : Interval(digits, excess > 0 ? digits + 1 : digits) * std::ldexp(1.0, power);
  return c > 0 ? magnitude : -magnitude;
}

std::vector<Interval> enclosed(const IntegerPolynomial& p) {
  int exponent = 0;
  for (const Integer& c : p.coefficients())
    if (c != 0) exponent = std::max(exponent, static_cast<int>(msb(abs(c))) + 1);
  std::vector<Interval> out;
  for (const Integer& c : p.coefficients()) out.push_back(enclosed(c, exponent));
  return out;
}

/// Values s/t; nothing where the box reaches infinity.
std::optional<Range> affine(const ProjectiveBox& box) {
  if (!box.reciprocal) return box.at;
  if (contains_zero(Interval(box.at.low, box.at.high))) return std::nullopt;
  const Range range = range_of(1 / Interval(box.at.low, box.at.high));
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return std::nullopt;
  return range;
}

/// Disjoint boxes for all real roots, ascending, if they are finite and proved simple.
template <int N>
std::optional<std::vector<Range>> boxes_of_degree(std::span<const Interval> coefficients) {
  std::array<Interval, N + 1> c;
  std::copy(coefficients.begin(), coefficients.end(), c.begin());
  const auto roots = simple_roots<N>(c);
  if (!roots) return std::nullopt;
  std::vector<Range> out;
  for (int i = 0; i < roots->count; ++i) {
    const std::optional<Range> box = affine(roots->at[static_cast<std::size_t>(i)]);
    if (!box) return std::nullopt;
    out.push_back(*box);
  }
  std::sort(out.begin(), out.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  for (std::size_t i = 1; i < out.size(); ++i)
    if (!(out[i - 1].high < out[i].low)) return std::nullopt;
  return out;
}

}  // namespace

std::optional<std::vector<Range>> boxes_of_simple_roots(std::span<const Interval> c) {
  std::optional<std::vector<Range>> out;
  const auto try_degree = [&]<int n>(std::integral_constant<int, n>) {
    if (c.size() == n + 1) out = boxes_of_degree<n>(c);
  };
  [&]<int... n>(std::integer_sequence<int, n...>) {
    (try_degree(std::integral_constant<int, n + 1>{}), ...);
  }(std::make_integer_sequence<int, highest_degree_in_doubles>{});
  return out;
}

namespace {

std::optional<std::vector<RealRoot>> roots_in_doubles(const IntegerPolynomial& p, std::span<const Interval> c) {
  const auto boxes = boxes_of_simple_roots(c);
  if (!boxes) return std::nullopt;
  const auto factor = std::make_shared<const IntegerPolynomial>(p);
  std::vector<RealRoot> out;
  for (const Range& box : *boxes) out.emplace_back(factor, box);
  return out;
}

bool changes_sign(const IntegerPolynomial& p, const DyadicInterval& box) {
  return scaled_value(p, box.low, box.scale).sign() * scaled_value(p, box.low + box.width, box.scale).sign() <= 0;
}

std::vector<RealRoot> exact_roots(const IntegerPolynomial& p) {
  if (p.degree() < 1) return {};
  std::vector<Factor> factors;
  for (IntegerPolynomial& factor : square_free_factors(p))
    factors.push_back(std::make_shared<const IntegerPolynomial>(std::move(factor)));
  std::vector<RealRoot> out;
  for (const DyadicInterval& box : detail::isolate_roots(*factors[0])) {
    std::size_t multiplicity = 1;
    while (multiplicity < factors.size() && changes_sign(*factors[multiplicity], box)) ++multiplicity;
    out.emplace_back(factors[multiplicity - 1], box, static_cast<int>(multiplicity));
  }
  return out;
}

/// `make_intervals` runs while rounding is upward.
template <class MakeIntervals>
std::vector<RealRoot> all_roots(const IntegerPolynomial& p, MakeIntervals make_intervals) {
  if (p.is_zero()) throw std::invalid_argument("the zero polynomial has no isolated roots");
  if (p.degree() < 1) return {};
  if (p[0] != 0 && p.degree() <= highest_degree_in_doubles) {
    const UpwardRounding upward;
    if (auto roots = roots_in_doubles(p, make_intervals())) return std::move(*roots);
  }
  return exact_roots(p);
}

}  // namespace

RealRoot::RealRoot(Factor factor, const Range& box)
    : factor_(std::move(factor)), enclosure_(box), rung_(Rung::intervals) {}

RealRoot::RealRoot(Factor factor, DyadicInterval box, int multiplicity)
    : factor_(std::move(factor)), box_(std::move(box)), multiplicity_(multiplicity), rung_(Rung::exact) {
  narrow([](const DyadicInterval& x) {
    return (x.width << 54) <= std::min(Integer(abs(x.low)), Integer(abs(Integer(x.low + x.width))));
  });
}

double RealRoot::approximate() const {
  if (is_point() || std::isinf(enclosure_.high)) return enclosure_.low;
  return std::isinf(enclosure_.low) ? enclosure_.high : enclosure_.low / 2 + enclosure_.high / 2;
}

RationalInterval RealRoot::bounds() const {
  if (!box_) return {Rational(enclosure_.low), Rational(enclosure_.high)};
  const Integer unit = Integer(1) << box_->scale;
  return {Rational(box_->low, unit), Rational(Integer(box_->low + box_->width), unit)};
}

bool RealRoot::is_point() const { return box_ ? box_->width == 0 : enclosure_.low == enclosure_.high; }

void RealRoot::refine(const Rational& width) {
  if (!(width > 0)) throw std::invalid_argument("a root is refined to a positive width");
  if (!box_) box_ = dyadic(enclosure_);
  narrow([&](const DyadicInterval& x) { return Rational(x.width, Integer(1) << x.scale) <= width; });
}

void RealRoot::refine(double width) {
  if (!std::isfinite(width)) throw std::invalid_argument("a root is refined to a positive, finite width");
  refine(Rational(width));
}

void RealRoot::refine() {
  const RationalInterval box = bounds();
  const Rational width = box.high() - box.low();
  refine(Rational(width * std::min(width, Rational(1, 16))));
}

template <class Done>
void RealRoot::narrow(Done done) {
  if (!is_point() && !done(*box_)) {
    detail::Refinement refinement(*factor_, *box_);
    while (refinement.box().width != 0 && !done(refinement.box())) refinement.step();
    box_ = refinement.box();
  }
  enclosure_ = range_of(bounds());
}

bool RealRoot::is_root_of(const IntegerPolynomial& p) const {
  const IntegerPolynomial common = common_divisor(p, *factor_);
  return common.degree() > 0 && changes_sign(common, box_ ? *box_ : dyadic(enclosure_));
}

std::vector<RealRoot> real_roots(std::span<const double> coefficients) {
  if (!std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return std::isfinite(c); }))
    throw std::invalid_argument("a polynomial has finite coefficients");
  const IntegerPolynomial p = integer_multiple(coefficients);
  return all_roots(p, [&] {
    return std::vector<Interval>(coefficients.begin(), coefficients.begin() + p.degree() + 1);
  });
}

std::vector<RealRoot> real_roots(const Polynomial<Rational>& given) {
  const IntegerPolynomial p = integer_multiple(given);
  return all_roots(p, [&] { return enclosed(p); });
}

std::vector<RealRoot> real_roots_exactly(const Polynomial<Rational>& p) {
  if (p.is_zero()) throw std::invalid_argument("the zero polynomial has no isolated roots");
  return exact_roots(integer_multiple(p));
}

int sign_at(const Polynomial<Rational>& p, RealRoot& root) {
  if (p.is_zero()) return 0;
  for (bool first = true;; first = false) {
    const RationalInterval box = root.bounds(), value = p(box);
    if (value.low() > 0) return 1;
    if (value.high() < 0) return -1;
    if (root.is_point() || (first && root.is_root_of(integer_multiple(p)))) return 0;
    root.refine();
  }
}

}  // namespace burmester
