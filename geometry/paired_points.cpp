#include "burmester/geometry/paired_points.hpp"

#include <Eigen/QR>
#include <cmath>

namespace burmester {
namespace {

constexpr int most_steps = 6;
constexpr double allowed = paired_within * paired_within;

using Lines = std::array<LinearForm<double>, 3>;

Lines lines_of_partners(const std::array<Correlation<double>, 3>& n, const Point2<double>& p) {
  return {line_of_partners(n[0], p), line_of_partners(n[1], p), line_of_partners(n[2], p)};
}

/// Sum of the squares of the three misses, each as a share of the sizes.
double miss(const Lines& lines, const std::array<double, 3>& squares, const PairedPoints& at) {
  const double size = at.p.squaredNorm() * at.c.squaredNorm();
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double off = lines[k][0] * at.c[0] + lines[k][1] * at.c[1] + lines[k][2] * at.c[2];
    sum += off * off / (squares[k] * size);
  }
  return sum;
}

/// One step, between unit vectors.
PairedPoints stepped(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                     const PairedPoints& at) {
  Matrix<double, 3, 6> slopes;
  Vector<double, 3> off;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double scale = 1 / std::sqrt(squares[k]);
    const LinearForm<double> line = scale * line_of_partners(n[k], at.p);
    slopes.row(row) << scale * (n[k] * at.c).transpose(), line.transpose();
    off[row] = line.dot(at.c);
  }
  const Vector<double, 6> step = slopes.completeOrthogonalDecomposition().solve(-off);
  return {(at.p + step.head<3>()).normalized(), (at.c + step.tail<3>()).normalized()};
}

PairedPoints paired_points(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                           const Lines& lines, const PairedPoints& near) {
  double left = miss(lines, squares, near);
  if (!(left > allowed)) return near;  // also where it is not a number
  PairedPoints out = near, at{near.p.normalized(), near.c.normalized()};
  for (int k = 0; k < most_steps && left > allowed; ++k) {
    at = stepped(n, squares, at);
    const double now = miss(lines_of_partners(n, at.p), squares, at);
    if (!(now < left)) break;
    left = now, out = at;
  }
  return out;
}

}  // namespace

PairedPoints paired_points(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                           const PairedPoints& near) {
  return paired_points(n, squares, lines_of_partners(n, near.p), near);
}

PairedPoints paired_points(const std::array<Correlation<double>, 3>& n, const std::array<double, 3>& squares,
                           const Point2<double>& p) {
  const Lines lines = lines_of_partners(n, p);
  return paired_points(n, squares, lines, {p, concurrence(lines)});
}

}  // namespace burmester
