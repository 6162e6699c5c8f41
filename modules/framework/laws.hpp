// Laws as functions: each is checked on hundreds of random and special elements and returns its violations as
// text. modules/framework/conformance.hpp runs them as GoogleTests; any other test framework can do the same.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "burmester/geometry/number.hpp"
#include "burmester/modules/framework/pose_space.hpp"

namespace burmester::laws {

using Violations = std::vector<std::string>;

/// What one law finds; keeps the first few violations and counts the others.
class Findings {
 public:
  explicit Findings(std::string seed) : random(seed), seed_(std::move(seed)) {}

  Random random;  ///< seeded by the law's name

  /// `inputs` returns text and is asked only on failure.
  template <class Inputs>
  void expect(bool holds, std::string_view law, const Inputs& inputs) {
    if (!holds) add(law, inputs());
  }
  template <class Actual, class Expected, class Inputs>
  void expect_near(const Actual& actual, const Expected& expected, double tolerance, std::string_view law,
                   const Inputs& inputs) {
    const double off = size_of(actual - expected);
    if (off <= tolerance) return;  // not so for NaN
    std::ostringstream text = wide();
    text << inputs() << "\n  expected " << show(expected) << "\n  actual   " << show(actual) << "\n  off by "
         << off << ", allowed " << tolerance;
    add(law, text.str());
  }
  Violations result() const {
    Violations out = kept_;
    if (const std::size_t more = count_ - kept_.size())
      out.push_back("and " + std::to_string(more) + " more [seed " + seed_ + "]");
    return out;
  }

  static std::ostringstream wide() {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    return text;
  }
  static std::string show(double x) {
    std::ostringstream text = wide();
    text << x;
    return text.str();
  }
  template <class V>
  static std::string show(const V& v) {
    std::ostringstream text = wide();
    for (int i = 0; i < v.size(); ++i) text << (i == 0 ? "(" : ", ") << v[i];
    text << ')';
    return text.str();
  }

 private:
  static double size_of(double x) { return std::abs(x); }
  template <class V>
  static double size_of(const Eigen::MatrixBase<V>& v) {
    return v.norm();
  }
  void add(std::string_view law, const std::string& inputs) {
    if (++count_ <= 3) kept_.push_back(std::string(law) + "\n  " + inputs + "\n  [seed " + seed_ + "]");
  }

  std::string seed_;
  Violations kept_;
  std::size_t count_ = 0;
};

struct Law {
  std::string name;
  void (*check)(Findings&);
};

/// The violations of one law; `subject` (planar.RR) and the law's name seed its random numbers.
inline Violations violations(const Law& law, std::string_view subject) {
  Findings findings(std::string(subject) + "." + law.name);
  law.check(findings);
  return findings.result();
}
inline Violations violations(const std::vector<Law>& all, std::string_view subject) {
  Violations out;
  for (const Law& law : all)
    for (std::string& text : violations(law, subject)) out.push_back(law.name + ": " + text);
  return out;
}

inline constexpr int trials = 300;

/// Rounding of the space's polynomials, relative to the product of the sizes of their arguments. A coordinate
/// is a sum of at most m = (ambient + 1)^2 terms of at most four factors, each with a coefficient of at most
/// 4: it is off by (m + 4) u times the sum of their sizes (N. Higham, "Accuracy and Stability of Numerical
/// Algorithms", 3.1), and that sum is at most 4 m times the product.
template <PoseSpace S>
inline constexpr double rounding = 4 * (S::ambient + 1) * (S::ambient + 1) *
                                   ((S::ambient + 1) * (S::ambient + 1) + 4) * unit_roundoff;

/// A displacement as a point, with words for a person who reads a failure.
template <PoseSpace S>
struct Element {
  std::string what;
  PointOf<S> x;

  double norm() const { return S::template norm<double>(x); }
  /// |x| / sqrt(norm): 1 for a rotation about the origin, half the shift for a long translation.
  double size() const { return x.norm() / std::sqrt(norm()); }
  FeatureOf<S> operator()(const FeatureOf<S>& a) const { return S::template act<double>(x, a) / norm(); }
  typename S::Pose pose() const { return S::pose(x); }
  std::string text(std::string_view name = "x") const {
    return std::string(name) + " = " + Findings::show(x) + " (" + what + ")";
  }
};

/// Where mistakes hide: the identity, tiny and long shifts and turns, half turns, the basis points.
template <PoseSpace S>
std::vector<Element<S>> special_elements() {
  using Pose = typename S::Pose;
  std::vector<Element<S>> out{{"identity", S::template point<double>(Pose{})}};
  for (int i = 0; i < S::dof; ++i)
    for (const double h : {1e-12, 1e-6, std::numbers::pi / 2, std::numbers::pi, 100.0}) {
      const Vector<double, S::dof> u = h * Vector<double, S::dof>::Unit(i);
      std::ostringstream what;
      what << "identity nudged by " << h << " along " << i;
      out.push_back({what.str(), S::template point<double>(S::nudged(Pose{}, u))});
    }
  if constexpr (S::ambient == S::dof)  // every point with a norm is a displacement
    for (int i = 0; i <= S::ambient; ++i) {
      const PointOf<S> x = PointOf<S>::Unit(i);
      if (S::template norm<double>(x) > 0) out.push_back({"basis point " + std::to_string(i), x});
    }
  return out;
}

/// Elements to try, one half special, one half random. Each comes with a factor: the same displacement.
template <PoseSpace S>
class Pool {
 public:
  explicit Pool(Random& random) : random_(random), special_(special_elements<S>()) {}

  Element<S> draw() {
    Element<S> out = random_.below(2) == 0
                         ? special_[static_cast<std::size_t>(random_.below(count()))]
                         : Element<S>{"random", S::template point<double>(S::random_pose(random_))};
    constexpr double factors[] = {1, 1, -1, 2, -0.75};
    const double factor = factors[random_.below(5)];
    if (factor != 1) out.what += " times " + Findings::show(factor);
    out.x *= factor;
    return out;
  }
  int count() const { return static_cast<int>(special_.size()); }

 private:
  Random& random_;
  std::vector<Element<S>> special_;
};

}  // namespace burmester::laws
