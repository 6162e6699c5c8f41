#include "burmester/spherical/five_pose_equations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "burmester/geometry/error_free.hpp"
#include "burmester/geometry/number.hpp"
#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {
namespace {

using ImagePoint = Space::Point<double>;
using Matrix3 = Matrix<double, 3, 3>;

ImagePoint image(const Pose& pose) { return Space::point<double>(pose); }

/// A rotation as a quaternion: norms in [1, 2), but for one factor in common.
struct Turn {
  double c;
  Vector3 s;
};

/// sum a_i b_i with products whose rounding error is not lost.
double dot(const ImagePoint& a, const ImagePoint& b) {
  double high = 0, low = 0;
  for (int i = 0; i < 4; ++i) {
    const TwoProduct p = two_product(a[i], b[i]);
    const double sum = high + p.high, part = sum - high;
    low += ((high - (sum - part)) + (p.high - part)) + p.low;
    high = sum;
  }
  return high + low;
}

/// q conj(p). Its vector part is that of (q - p) conj(p), as p conj(p) is a number: with equal norms the difference of
/// close poses is exact and nearly orthogonal to p, so that nothing cancels. Different norms take exact products.
Turn turn(const ImagePoint& p, ImagePoint q) {
  q *= factor_towards(p, q);
  const double norm = p.squaredNorm(), c = p.dot(q);
  const ImagePoint difference = q - p;
  Vector3 s;
  if (std::abs(difference.dot(q + p)) > 0x1p-30 * norm) {
    s = {dot({p[0], -p[1], p[2], -p[3]}, {q[1], q[0], q[3], q[2]}),
         dot({p[0], -p[2], p[3], -p[1]}, {q[2], q[0], q[1], q[3]}),
         dot({p[0], -p[3], p[1], -p[2]}, {q[3], q[0], q[2], q[1]})};
  } else {
    const ImagePoint product = quaternion_product<double>(difference, Space::conjugate<double>(p));
    s = product.tail<3>();
  }
  const double scale = unit_scale(std::sqrt(norm * q.squaredNorm()));
  return {scale * c, scale * s};
}

/// Right-handed, third row along z.
Matrix3 frame_along(const Vector3& z) {
  const Vector3 first = z.unitOrthogonal(), second = z.cross(first);
  Matrix3 out;
  out << first.transpose(), second.transpose(), z.transpose();
  return out;
}

/// Axes that spread by more than this (radians) need no scaling.
constexpr double wide_spread = 0.125;

/// k with W = w and S = u v^T + v u^T.
Lifted lifted_of(const Vector3& w, const Vector3& u, const Vector3& v) {
  Lifted k;
  k << w, 2 * u[0] * v[0], 2 * u[1] * v[1], 2 * u[2] * v[2], u[0] * v[1] + u[1] * v[0], u[0] * v[2] + u[2] * v[0],
      u[1] * v[2] + u[2] * v[1];
  return k;
}

}  // namespace

Vector3 half_angle_sine(const Pose& from, const Pose& to) {
  const Turn t = turn(image(from), image(to));
  return t.s / std::hypot(t.s.norm(), t.c);
}

bool same_orientation(const Pose& a, const Pose& b) { return half_angle_sine(a, b).norm() <= same_tolerance; }

Vector<double, 9> kept_angle(double c, const Vector3& t, double dd) {
  const double x = t[0], y = t[1], z = t[2];
  Vector<double, 9> out;
  out << c * x, c * y, c * z, -(z * z + dd * y * y), -(z * z + dd * x * x), -(x * x + y * y), 2 * dd * x * y, 2 * x * z,
      2 * y * z;
  return out;
}

FivePoseEquations five_pose_equations(FivePoses poses) {
  FivePoseEquations out;
  out.reference = reference_of(poses);
  std::array<Turn, 4> turns;
  double largest = 0;
  Vector3 z = Vector3::Zero();
  out.closest = 2;
  for (int j = 0, r = 0; j < 5; ++j) {
    if (j == out.reference) continue;
    turns[r] = turn(image(poses[static_cast<std::size_t>(out.reference)]), image(poses[static_cast<std::size_t>(j)]));
    const double size = turns[r].s.norm(), norm = std::sqrt(size * size + turns[r].c * turns[r].c);
    out.sine[r] = size / norm;
    out.closest = std::min(out.closest, out.sine[r]);
    if (size > largest) largest = size, z = turns[r].s / size;
    ++r;
  }
  if (!(out.closest > 0)) return out;
  for (const Turn& t : turns) out.spread = std::max(out.spread, t.s.cross(z).norm());
  if (!(out.spread > 0)) return out;
  out.frame.setIdentity();
  out.e = power_of_two_below(largest);
  if (out.spread < wide_spread * largest) {
    out.d = power_of_two_below(out.spread / largest);
    out.frame = frame_along(z);
  }
  for (int r = 0; r < 4; ++r) {
    Vector3 t = turns[static_cast<std::size_t>(r)].s / out.e;
    if (out.d < 1) t = out.frame * t, t[0] /= out.d, t[1] /= out.d;
    const Vector<double, 9> row = kept_angle(turns[static_cast<std::size_t>(r)].c, t, out.d * out.d);
    out.rows.row(r) = row * unit_scale(row.cwiseAbs().maxCoeff());
  }
  return out;
}

Lifted lifted(const ScaledDyad& x, double e) {
  return lifted_of(-2 * x.m.cross(x.h), x.m, x.m / 2) - lifted_of(Vector3::Zero(), x.h, e * e / 2 * x.h);
}

Lifted scaled_relations(const Lifted& k, double e) {
  const double q = e * e / 4, a = k[3], b = k[4], c = k[5], f = k[6], g = k[7], h = k[8];
  Lifted out;
  out << a * k[0] + f * k[1] + g * k[2], f * k[0] + b * k[1] + h * k[2], g * k[0] + h * k[1] + c * k[2],
      b * c - h * h + q * k[0] * k[0], a * c - g * g + q * k[1] * k[1], a * b - f * f + q * k[2] * k[2],
      g * h - c * f + q * k[0] * k[1], f * h - b * g + q * k[0] * k[2], f * g - a * h + q * k[1] * k[2];
  return out;
}

ScaledDyad scaled_dyad(const Lifted& k, double e) {
  const Vector3 v = e / 2 * k.head<3>();  // a b^T = S + skew part
  Matrix3 M;
  M << k[3], k[6] + v[2], k[7] - v[1], k[6] - v[2], k[4], k[8] + v[0], k[7] + v[1], k[8] - v[0], k[5];
  int row = 0, column = 0;
  M.cwiseAbs().maxCoeff(&row, &column);
  const Vector3 a = M.col(column), b = M.row(row).transpose() / M(row, column);  // a b^T = M
  const double length = b.norm(), factor = std::sqrt(a.norm() * length), sign = a.dot(b) < 0 ? -1 : 1;
  const Vector3 m = (a.normalized() + sign * b / length) / 2;
  return {m, m.cross(Vector3(sign * k.head<3>() / (factor * factor))) / (2 * m.squaredNorm())};
}

ScaledDyad scaled_dyad(const Vector3& a, const Vector3& b, double e) {
  const Vector3 unit = a.normalized(), other = (unit.dot(b) < 0 ? -b : b).normalized();
  return {(unit + other) / 2, (unit - other) / (2 * e)};
}

double improve(const FivePoseEquations& equations, ScaledDyad& x) {
  const double e = equations.e;
  const Vector<double, 4> value = equations.rows * lifted(x, e);
  // a and b have free lengths, which change m along m and h along h and m: both steps stay orthogonal to m.
  const Vector3 p = x.m.unitOrthogonal(), q = x.m.cross(p), f = -e * e * x.h;
  Matrix<double, 9, 4> change;
  change << lifted_of(-2 * p.cross(x.h), x.m, p), lifted_of(-2 * q.cross(x.h), x.m, q),
      lifted_of(-2 * x.m.cross(p), f, p), lifted_of(-2 * x.m.cross(q), f, q);
  const Eigen::Matrix4d J = equations.rows * change;
  const Eigen::Vector4d step = -(J.inverse() * value);
  const Vector3 dm = step[0] * p + step[1] * q, dh = step[2] * p + step[3] * q;
  const ScaledDyad next{x.m + dm, x.h + dh};
  const double size = std::sqrt((dm.squaredNorm() + dh.squaredNorm()) / (x.m.squaredNorm() + x.h.squaredNorm()));
  const bool helps =
      size < 0x1p-20 || (size < 0.5 && (equations.rows * lifted(next, e)).squaredNorm() < value.squaredNorm());
  if (!helps) return 0;
  x = next;
  return size;
}

RR::Design dyad_of(const FivePoseEquations& equations, const ScaledDyad& x, FivePoses poses) {
  const double e = equations.e, d = equations.d;
  const auto placed = [&](const Vector3& v) {
    return Vector3(equations.frame.transpose() * Vector3(d * v[0], d * v[1], v[2])).normalized();
  };
  const Vector3 w = -2 * e * d * x.m.cross(x.h), a = placed(x.m + e * x.h);
  const Vector3 m(d * x.m[0], d * x.m[1], x.m[2]), h(d * e * x.h[0], d * e * x.h[1], e * x.h[2]);
  const double sine = std::hypot(w[0], w[1], d * w[2]), cosine = (m - h).dot(m + h);
  const ImagePoint back = Space::conjugate<double>(image(poses[static_cast<std::size_t>(equations.reference)]));
  return {placed(x.m - e * x.h), Space::act<double>(back, a).normalized(), std::atan2(sine, cosine)};
}

}  // namespace burmester::spherical
