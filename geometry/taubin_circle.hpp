// A circle near points of the plane, by an algebraic fit: where the geometric one starts.
#pragma once

#include <Eigen/SVD>
#include <cmath>
#include <optional>
#include <span>

#include "burmester/geometry/vector.hpp"

namespace burmester {

struct TaubinCircle {
  Vector<double, 2> centre;
  double radius = 0;
};

/// Taubin's fit: the least sum of F^2 / |grad F|^2 on average, F = A (x^2 + y^2) + B x + C y + D (G. Taubin, IEEE PAMI
/// 13, 1991; the form by singular values: N. Chernov, "Circular and Linear Regression", 2010, section 5.10). Exact for
/// points of a circle. Nothing where the best F is a line or the points coincide. At least three points.
inline std::optional<TaubinCircle> taubin_circle(std::span<const Vector<double, 2>> points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Vector<double, 2> centroid = Vector<double, 2>::Zero();
  for (const auto& p : points) centroid += p / static_cast<double>(n);
  Eigen::MatrixX3d m(n, 3);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Vector<double, 2> d = points[static_cast<std::size_t>(j)] - centroid;
    m.row(j) << d.squaredNorm(), d[0], d[1];
  }
  const double mean = m.col(0).mean(), size = 2 * std::sqrt(mean);
  if (!(size > 0)) return std::nullopt;
  m.col(0) = (m.col(0).array() - mean) / size;
  const Eigen::Vector3d v = Eigen::JacobiSVD<Eigen::MatrixXd>(m, Eigen::ComputeFullV).matrixV().col(2);
  const double a = v[0] / size;
  const Vector<double, 2> offset{-v[1] / (2 * a), -v[2] / (2 * a)};
  if (!offset.allFinite()) return std::nullopt;
  return TaubinCircle{centroid + offset, std::sqrt(offset.squaredNorm() + mean)};
}

}  // namespace burmester
