#include "burmester/geometry/partner_curve.hpp"

#include <algorithm>

#include "burmester/geometry/range.hpp"

namespace burmester {

TubeCurve tube_curve(const Cubic<Interval>& f) {
  Cubic<double> middle;
  double error = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    middle.c[k] = approximate(f.c[k]);
    error = std::max(error, magnitude(Interval(f.c[k] - middle.c[k])));
  }
  return TubeCurve(middle, error);
}

PartnerCurve partner_curve(const std::array<Correlation<Interval>, 3>& n,
                           const std::array<Correlation<Interval>, 3>& seen) {
  std::array<Correlation<double>, 3> middle;
  std::array<double, 3> squares;
  std::array<Correlation<Interval>, 3> back;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 9; ++i) middle[k](i) = approximate(seen[k](i));
    squares[k] = middle[k].squaredNorm();
    back[k] = n[k].transpose();
  }
  return {middle, squares, seen, tube_curve(points_with_partner(back))};
}

PartnerCurve partner_curve(const std::array<Correlation<Interval>, 3>& n, const BranchFrame<Interval>& frame) {
  return partner_curve(n, {frame.seen(n[0]), frame.seen(n[1]), frame.seen(n[2])});
}

}  // namespace burmester
