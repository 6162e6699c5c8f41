// Interval arithmetic: boxes that contain the exact value whatever was rounded on the way.
//
// Only in targets made by burmester_enable_intervals (modules/burmester.cmake), and only while an
// UpwardRounding lives: without either, boxes miss the truth silently. Keep its scope small; everything in it
// rounds upward, Eigen and the mathematical functions too. A double is exact: Interval(x) is the point x. A
// comparison that the boxes do not decide throws CGAL::Uncertain_conversion_exception when it is read as
// bool.
#pragma once

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include "burmester/geometry/number.hpp"
#include "burmester/geometry/sign.hpp"

namespace burmester {

using Interval = CGAL::Interval_nt<false>;

/// While it lives the processor rounds upward; then as before.
class UpwardRounding {
 public:
#if defined(__ROUNDING_MATH__) || !defined(__GNUC__) || defined(__clang__)
  UpwardRounding() = default;
#else
  UpwardRounding() =
      delete;  // this target is not compiled for intervals: call burmester_enable_intervals for it
#endif
  UpwardRounding(const UpwardRounding&) = delete;
  UpwardRounding& operator=(const UpwardRounding&) = delete;

 private:
  CGAL::Protect_FPU_rounding<true> upward_;
};

/// The middle of the box; not finite where an end is infinite.
template <>
inline double approximate(const Interval& x) {
  return x.inf() + (x.sup() - x.inf()) / 2;
}

template <>
inline std::optional<int> known_sign(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  if (x.inf() == 0 && x.sup() == 0) return 0;
  return std::nullopt;
}

inline double lower(const Interval& x) { return x.inf(); }
inline double upper(const Interval& x) { return x.sup(); }

}  // namespace burmester
