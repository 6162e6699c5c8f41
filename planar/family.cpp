#include "burmester/planar/family.hpp"

namespace burmester::planar {
namespace {

constexpr double zero = 1e-12;  // relative, in the problem's own units: for callers that chose sensible ones

RR::Design decode_RR(const Vector<double, 8>& k) {
  const Vector2 K = k.segment<2>(1) / k[0], p = k.segment<2>(3) / k[0];
  const double length2 = K.squaredNorm() + p.squaredNorm() - k[5] / k[0];
  return {-K, p, std::sqrt(std::max(0.0, length2))};
}

/// v = conj(p) K in complex notation: p = conj(v / K).
PR::Design decode_PR(const Vector<double, 8>& k) {
  const Vector2 K = k.segment<2>(1);
  const double size2 = K.squaredNorm(), size = std::sqrt(size2);
  return {{(K[0] * k[6] + K[1] * k[7]) / size2, (K[1] * k[6] - K[0] * k[7]) / size2}, {K / size, -k[5] / (2 * size)}};
}

RP::Design decode_RP(const Vector<double, 8>& k) {
  const Vector2 n = -k.segment<2>(3);
  const double size2 = n.squaredNorm(), size = std::sqrt(size2);
  return {{(n[0] * k[6] - n[1] * k[7]) / size2, (n[1] * k[6] + n[0] * k[7]) / size2}, {n / size, -k[5] / (2 * size)}};
}

}  // namespace

std::optional<Family::Design> Family::decode(const Vector<double, 8>& k) {
  const double size = k.norm(), K = k.segment<2>(1).norm(), u = k.segment<2>(3).norm();
  if (!(size > 0)) return std::nullopt;
  if (std::abs(k[0]) > zero * size) {
    const RR::Design d = decode_RR(k);
    const double length2 = d.fixed.squaredNorm() + d.moving.squaredNorm() - k[5] / k[0];
    if (length2 < -zero * size / std::abs(k[0])) return std::nullopt;  // an imaginary circle
    return d;
  }
  if (K > zero * size && u <= zero * size) return decode_PR(k);
  if (u > zero * size && K <= zero * size) return decode_RP(k);
  if (K > zero * size || u > zero * size) return std::nullopt;
  const double orientation = 2 * std::hypot(k[6], k[7]), gap = std::abs(std::abs(k[5]) - orientation);
  if (gap > zero * size) return std::nullopt;  // a pair of orientations, or none
  const double sign = k[5] > 0 ? -1 : 1;
  return PP::Design{std::atan2(sign * k[7], sign * k[6])};
}

}  // namespace burmester::planar
