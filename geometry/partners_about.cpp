#include "burmester/geometry/partners_about.hpp"

#include "burmester/geometry/range.hpp"

namespace burmester {

Point2<Interval> partners_about(const PartnerCurve& partners, const Point2<double>& c, const Point2<Interval>& p) {
  std::array<Vector<double, 3>, 3> misses;  // N c: how far the lines of partners pass c
  for (std::size_t j = 0; j < 3; ++j) misses[j] = partners.approximate[j] * c;
  std::size_t widest = 0;
  for (std::size_t j = 1; j < 3; ++j)
    if (misses[j].norm() > misses[widest].norm()) widest = j;
  Eigen::Index k = 0;
  c.cwiseAbs().maxCoeff(&k);
  std::array<Correlation<Interval>, 2> n;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t from = (widest + 1 + j) % 3;
    const double share = misses[from].dot(misses[widest]) / misses[widest].squaredNorm();
    for (int i = 0; i < 9; ++i) n[j](i) = partners.enclosing[from](i) - share * partners.enclosing[widest](i);
    for (int i = 0; i < 3; ++i) n[j](i, k) = n[j](i, 0) * c[0] + n[j](i, 1) * c[1] + n[j](i, 2) * c[2];
  }
  const Point2<Interval> seen = partner<Interval>(n, p);
  Point2<Interval> out{Interval(0), Interval(0), Interval(0)};
  if (contains_zero(seen[k])) return out;
  for (int i = 0; i < 3; ++i) out[i] = i == k ? Interval(c[i]) : Interval(seen[i] / seen[k] + c[i]);
  return out;
}

}  // namespace burmester
