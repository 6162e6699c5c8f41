#include "burmester/spherical/fit_starts.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "burmester/spherical/five_pose_equations.hpp"

namespace burmester::spherical {
namespace {

/// Points of the half sphere, and how many directions of it are neighbours.
constexpr int grid_size = 1500;
const double grid_spacing = std::sqrt(2 * std::numbers::pi / grid_size), neighbourhood = std::cos(1.6 * grid_spacing);

/// A moving axis with its best fixed axis and the next, by planes through its places.
struct Planes {
  Eigen::Vector3d moving;
  std::array<Eigen::Vector3d, 2> fixed;
  std::array<double, 2> misfit;  ///< weighted squares of the angular errors, in units of e, to first order
};

/// Seen along a, the places R_j a are a + e s (d_j + e s q_j a), with d_j across a and s the length of the longest.
/// A plane b . x = cos(arc) leaves b . R_j a - cos(arc) = e k . (d_j, q_j, 1), where k = (s b1, s b2, s^2 e b3, (b3 -
/// cos(arc)) / e), and (s sin(arc))^2 is k^T N k: the least ratio of the two squares is an eigenvalue (V. Pratt, 1987,
/// for circles of the plane, which are the limit e = 0). Through the centre: e k . (d_j, 1 + (e s)^2 q_j), where k = (s
/// b1, s b2, b3 / e), and s^2 is k^T N k.
template <class D>
Planes planes(const TurnedTask& task, const Eigen::Vector3d& a) {
  constexpr int size = std::is_same_v<D, RR> ? 4 : 3;
  using Square = Eigen::Matrix<double, size, size>;
  const Eigen::Index n = task.t.cols();
  const Eigen::Vector3d p = a.unitOrthogonal(), q = a.cross(p);
  Eigen::Matrix3Xd places(3, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d t = task.t.col(j), across = t.cross(a),
                          d = 2 * (task.c[j] * across + task.e * t.cross(across));
    places.col(j) << d.dot(p), d.dot(q), -2 * across.squaredNorm();
  }
  const double s = std::sqrt(places.topRows<2>().colwise().squaredNorm().maxCoeff()), es = task.e * s;
  Square M = Square::Zero(), N = Square::Identity();
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d x = places.col(j) / s;
    Eigen::Matrix<double, size, 1> z;
    if constexpr (size == 4)
      z << x[0], x[1], x[2] / s, 1;
    else
      z << x[0], x[1], 1 + es * task.e * x[2];
    M.template selfadjointView<Eigen::Lower>().rankUpdate(z, task.weights[j]);
  }
  M = M.template selfadjointView<Eigen::Lower>();
  if constexpr (size == 4)
    N.template bottomRightCorner<2, 2>() << 0, 1, 1, -es * es;
  else
    N(2, 2) = es * es;
  M.diagonal().array() += 0x1p-48 * M.trace();  // exact fits make it singular
  const Eigen::GeneralizedSelfAdjointEigenSolver<Square> ratios(N, M);
  Planes out{a, {}, {}};
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix<double, size, 1> k = ratios.eigenvectors().col(size - 1 - i);
    out.fixed[static_cast<std::size_t>(i)] = k[0] * p + k[1] * q + (size == 4 ? k[2] / es : k[2] * es) * a;
    out.misfit[static_cast<std::size_t>(i)] = s * s / ratios.eigenvalues()[size - 1 - i];
  }
  return out;
}

/// Every so many points of the grid one is a start whatever its misfit.
constexpr std::size_t stride = 15;

/// Local minima of the misfits on a Fibonacci grid of the half sphere, its points mapped by `chart`, and some points of
/// it.
template <class D>
void add_scanned(const TurnedTask& task, const Eigen::Matrix3d& chart, std::vector<AxesAt>& starts) {
  std::vector<Eigen::Vector3d> at;
  std::vector<Planes> grid;
  for (int i = 0; i < grid_size; ++i) {
    const double z = (i + 0.5) / grid_size, r = std::sqrt(1 - z * z),
                 turn = 2 * std::numbers::pi * i / std::numbers::phi;
    at.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    grid.push_back(planes<D>(task, (chart * at.back()).normalized()));
  }
  const auto is_least = [&](std::size_t j, std::size_t i) {
    for (std::size_t k = 0; k < grid.size(); ++k)
      if (grid[k].misfit[i] < grid[j].misfit[i] && std::abs(at[k].dot(at[j])) >= neighbourhood) return false;
    return true;
  };
  for (std::size_t j = 0; j < grid.size(); ++j)
    for (std::size_t i = 0; i < 2; ++i)
      if ((j % stride == 0 && j / stride % 2 == i) || is_least(j, i))
        starts.push_back(axes_at(grid[j].fixed[i], grid[j].moving));
}

/// Turns nearer than this to one axis, in units of the largest: the grid has hardly a point as near to that.
constexpr double nearly_one_axis = 0.1;

/// Charts of the moving axis: all directions alike; where the turns are about nearly one axis z, those as near to z as
/// they are, too: the limit of their dyads are those of the plane ((4) of five_pose_equations.hpp).
std::vector<Eigen::Matrix3d> charts(const TurnedTask& task) {
  std::vector<Eigen::Matrix3d> out{Eigen::Matrix3d::Identity()};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(task.t * task.t.transpose());
  const Eigen::Vector3d z = spread.eigenvectors().col(2);
  double away = 0;
  for (Eigen::Index j = 0; j < task.t.cols(); ++j) away = std::max(away, z.cross(task.t.col(j)).norm());
  if (away > 0 && away < nearly_one_axis)
    out.push_back(spread.eigenvectors() * Eigen::Vector3d(away, away, 1).asDiagonal());
  return out;
}

/// The dyads nearest to the singular vectors of the lifted rows, in scaled coordinates; for sliders they are starts as
/// good as others.
void add_lifted(const TurnedTask& task, std::vector<AxesAt>& starts) {
  Eigen::MatrixXd rows(task.rows.rows(), 10);
  const double e = task.e;
  rows << task.rows, Eigen::VectorXd::Ones(task.rows.rows());
  rows = task.weights.cwiseSqrt().asDiagonal() * rows;
  const Eigen::MatrixXd v = Eigen::JacobiSVD<Eigen::MatrixXd>(rows, Eigen::ComputeFullV).matrixV();
  for (Eigen::Index i = 0; i < 10; ++i) {
    const Lifted k = v.col(i).head<9>();
    const ScaledDyad x = scaled_dyad(k, e);
    const AxesAt axes = axes_at(x.m - e * x.h, x.m + e * x.h);
    if (axes.frame.allFinite()) starts.push_back(axes);
  }
}

}  // namespace

template <class D>
std::vector<AxesAt> fit_starts(const TurnedTask& task) {
  std::vector<AxesAt> out;
  add_lifted(task, out);
  for (const Eigen::Matrix3d& chart : charts(task)) add_scanned<D>(task, chart, out);
  return out;
}

template std::vector<AxesAt> fit_starts<RR>(const TurnedTask&);
template std::vector<AxesAt> fit_starts<PR>(const TurnedTask&);

}  // namespace burmester::spherical
