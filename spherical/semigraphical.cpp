#include "burmester/spherical/semigraphical.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "burmester/spherical/family.hpp"

namespace burmester::spherical {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Differences = std::array<Matrix3, 4>;  // N_1 .. N_4
using Tangents = Eigen::Matrix<double, 3, 2>;

constexpr double rounding = 0x1p-53;
constexpr double same_axis = 1e-6;  // radians: far below what a plot could separate, far above rounding

Matrix3 rotation(const Pose& pose) {
  const Vector<double, 10> row = Family::row<double>(pose);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row.data()) / row[9];
}

Tangents tangents(const Axis& a) {
  Tangents out;
  out.col(0) = a.unitOrthogonal(), out.col(1) = a.cross(out.col(0));
  return out;
}

Axis moved(const Axis& a, const Eigen::Vector2d& step) { return (a + tangents(a) * step).normalized(); }

double axis_distance(const Axis& a, const Axis& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

Eigen::Matrix<double, 4, 3> rows_at(const Differences& n, const Axis& a) {
  Eigen::Matrix<double, 4, 3> out;
  for (int j = 0; j < 4; ++j) out.row(j) = n[static_cast<std::size_t>(j)] * a;
  return out;
}

/// Delta_j for j from 0, and its gradient.
struct Minor {
  double value = 0;
  Axis gradient = Axis::Zero();
};
Minor minor(const Differences& n, std::size_t j, const Axis& a) {
  std::array<const Matrix3*, 3> m{};
  for (std::size_t k = 0, at = 0; k < 4; ++k)
    if (k != j) m[at++] = &n[k];
  const Axis p = *m[0] * a, q = *m[1] * a, r = *m[2] * a;
  return {p.dot(q.cross(r)),
          m[0]->transpose() * q.cross(r) + m[1]->transpose() * r.cross(p) + m[2]->transpose() * p.cross(q)};
}

/// Newton on two minors. Empty where it leaves the neighbourhood.
std::optional<Axis> refined(const Differences& n, std::array<int, 2> curves, const Axis& start, double neighbourhood) {
  Axis a = start;
  for (int i = 0; i < 60; ++i) {
    const Minor f = minor(n, static_cast<std::size_t>(curves[0] - 1), a),
                g = minor(n, static_cast<std::size_t>(curves[1] - 1), a);
    Eigen::Matrix2d slope;
    slope.row(0) = f.gradient.transpose() * tangents(a);
    slope.row(1) = g.gradient.transpose() * tangents(a);
    const Eigen::Vector2d step = slope.fullPivLu().solve(Eigen::Vector2d(-f.value, -g.value));
    if (!step.allFinite()) return std::nullopt;
    a = moved(a, step);
    if (axis_distance(a, start) > neighbourhood) return std::nullopt;
    if (step.norm() <= 4 * rounding) break;
  }
  return a;
}

AxisPlot plot_of(const Differences& n, int cells, bool& degenerate) {
  AxisPlot out;
  constexpr double quarter_turn = std::numbers::pi / 2;
  for (std::size_t j = 0; j < 4; ++j) {
    double size = 1, largest = 0;
    for (std::size_t k = 0; k < 4; ++k) size *= k == j ? 1 : n[k].norm();
    const SampledSquare grid = sampled(quarter_turn, cells, [&](double longitude, double latitude) {
      const double value = minor(n, j, axis_at(longitude, latitude)).value;
      largest = std::max(largest, std::abs(value));
      return value;
    });
    degenerate = degenerate || largest <= 1000 * rounding * size;  // a few roundings of each of its products
    out.curves[j] = zero_contour(grid);
  }
  if (degenerate) return out;
  const double neighbourhood = 2 * std::numbers::pi / cells;
  for (int i = 1; i <= 4; ++i)
    for (int j = i + 1; j <= 4; ++j)
      for (const auto& p :
           crossings(out.curves[static_cast<std::size_t>(i - 1)], out.curves[static_cast<std::size_t>(j - 1)]))
        if (const auto a = refined(n, {i, j}, axis_at(p[0], p[1]), neighbourhood)) {
          const auto sizes = rows_at(n, *a).jacobiSvd().singularValues();
          out.crossings.push_back({{i, j}, p, *a, sizes[0] > 0 ? sizes[2] / sizes[0] : 0});
        }
  return out;
}

/// Newton on b . N_j a = 0, j = 1..4, in the tangents at a and b.
void polish(const Differences& n, Axis& a, Axis& b) {
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix4d slope;
    Eigen::Vector4d f;
    for (int j = 0; j < 4; ++j) {
      const Matrix3& m = n[static_cast<std::size_t>(j)];
      f[j] = b.dot(m * a);
      slope.row(j) << b.transpose() * m * tangents(a), (m * a).transpose() * tangents(b);
    }
    const Eigen::Vector4d step = slope.fullPivLu().solve(-f);
    if (!step.allFinite() || step.norm() > same_axis) return;
    a = moved(a, step.head<2>()), b = moved(b, step.tail<2>());
  }
}

/// The dyads whose axes the accepted crossings of a plot are, each once: first the plot's own axis, then the other one.
std::vector<std::array<Axis, 2>> dyads_of(const AxisPlot& plot, const Differences& n) {
  std::vector<std::array<Axis, 2>> out;
  for (const Crossing& c : plot.crossings) {
    if (!c.accepted()) continue;
    Axis a = c.axis, b = rows_at(n, a).jacobiSvd(Eigen::ComputeFullV).matrixV().col(2);
    polish(n, a, b);
    if (std::none_of(out.begin(), out.end(), [&](const auto& d) { return axis_distance(d[0], a) < same_axis; }))
      out.push_back({a, b});
  }
  return out;
}

}  // namespace

Axis axis_at(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

std::array<double, 2> longitude_latitude(const Axis& axis) {
  const Axis a = axis[0] < 0 ? Axis(-axis) : axis;
  return {std::atan2(a[1], a[0] + 0.0), std::atan2(a[2], std::hypot(a[0], a[1]))};
}

SemigraphicalAnswer semigraphical(std::span<const Pose> poses, int cells) {
  Differences n, transposed;
  for (std::size_t j = 0; j < 4; ++j) {
    n[j] = rotation(poses[j + 1]) - rotation(poses[0]);
    transposed[j] = n[j].transpose();
  }
  SemigraphicalAnswer out;
  out.moving = plot_of(n, cells, out.degenerate);
  out.fixed = plot_of(transposed, cells, out.degenerate);
  if (out.degenerate) return out;
  const Matrix3 first = rotation(poses[0]);
  const auto design = [&](const Axis& b, const Axis& a) { return RR::Design{b, a, Space::distance(b, first * a)}; };
  for (const auto& [a, b] : dyads_of(out.moving, n)) out.dyads.push_back(design(b, a));
  for (const auto& [b, a] : dyads_of(out.fixed, transposed)) out.from_fixed.push_back(design(b, a));
  return out;
}

}  // namespace burmester::spherical
