// Two doubles side by side: one formula for two things at once, in half the instructions (SSE2, NEON; GCC and Clang).
//
// For formulas without choices: what differs from lane to lane is asked lane by lane.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace burmester {

class Lanes {
 public:
  Lanes() = default;
  Lanes(double both) : v_{both, both} {}  // implicit: the formulas write 2 * x
  Lanes(double first, double second) : v_{first, second} {}
  double operator[](std::size_t k) const { return v_[k]; }

  friend Lanes operator+(Lanes a, Lanes b) { return a.v_ + b.v_; }
  friend Lanes operator-(Lanes a, Lanes b) { return a.v_ - b.v_; }
  friend Lanes operator*(Lanes a, Lanes b) { return a.v_ * b.v_; }
  friend Lanes operator/(Lanes a, Lanes b) { return a.v_ / b.v_; }
  Lanes operator-() const { return -v_; }
  Lanes& operator+=(Lanes b) { return *this = *this + b; }
  Lanes& operator-=(Lanes b) { return *this = *this - b; }
  Lanes& operator*=(Lanes b) { return *this = *this * b; }
  Lanes& operator/=(Lanes b) { return *this = *this / b; }

  friend Lanes abs(Lanes a) {
    constexpr std::int64_t rest = 0x7fffffffffffffff;
    return reinterpret_cast<Pair>(reinterpret_cast<Bits>(a.v_) & Bits{rest, rest});
  }
  /// Of numbers; where one is none the answer may be the other.
  friend Lanes max(Lanes a, Lanes b) { return a.v_ > b.v_ ? a.v_ : b.v_; }
  friend Lanes min(Lanes a, Lanes b) { return a.v_ < b.v_ ? a.v_ : b.v_; }
  friend Lanes sqrt(Lanes a) { return {std::sqrt(a.v_[0]), std::sqrt(a.v_[1])}; }

 private:
  using Pair = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));
  Lanes(Pair v) : v_(v) {}
  Pair v_;
};

/// Whether all are; not so where one is not a number. A double is one lane.
inline bool all_positive(double x) { return x > 0; }
inline bool all_positive(Lanes x) { return x[0] > 0 && x[1] > 0; }

}  // namespace burmester

template <>
struct Eigen::NumTraits<burmester::Lanes> : Eigen::GenericNumTraits<burmester::Lanes> {
  using Real = burmester::Lanes;
  using NonInteger = burmester::Lanes;
  using Nested = burmester::Lanes;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
