// The five-pose synthesis equations in the anchored basis.
//
// Let one pose be the reference, t_j = (a, b) the translation and delta_j the rotation from it to pose j, and p
// the moving pivot in the reference pose, seen from the origin of E there (fixed directions). The displaced point
// has moved by d_j = t_j + (R(delta_j) - I) p. It stays on a circle through its reference place when
//     K0 |d_j|^2 + G . d_j = 0,                                                                  (1)
// where G is the gradient of the circle's equation at the reference place: centre = p - G / (2 K0). With u = K0 p,
// K = G - 2 u (the gradient at the origin) and complex notation for plane vectors, v = conj(p) K, (1) is linear:
//     K0 |t|^2 + G . t + 2 u . (R^T - I) t + (cos delta - 1) v1 + sin delta v2 = 0,              (2)
//     K0 v = conj(u) K   (two real relations).                                                   (3)
// All dyad types at once: RR has K0 != 0; PR has K0 = u = 0 (G the normal of the fixed line); RP has K0 = K = 0
// (-2 u the normal of the moving line). With lengths in units of L and U = e u, V1 = e^2 v1, V2 = e v2, where e is
// the size of the rotations, (2) and (3) stay regular as all rotations shrink to nothing.
//
// Equation (2) is the constraint manifold of Hayes and Zsombor-Murray in image coordinates relative to the
// reference pose; the change of basis to (K0, G, U, V) is ours. Notation here: s = X3, c = X4 of the relative pose.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "burmester/geometry/conic.hpp"
#include "burmester/geometry/error_free.hpp"
#include "burmester/planar/pose.hpp"

namespace burmester::planar {

using FivePoses = std::span<const Pose, 5>;

/// Where equation (2) is anchored. length and turn are powers of two: scaling by them loses nothing.
struct Anchor {
  int reference = 0;   ///< index of a pose of the closest pair: small differences are then formed once, without loss
  double length = 1;   ///< L: largest distance between two pose origins, rounded down (1 if all coincide)
  double turn = 1;     ///< e: largest |2 sin(delta/2)| between two poses, rounded down (0: all orientations equal)
};

/// w = (K0, G1, G2, U1, U2, V1, V2), the unknowns of (2) and (3).
template <class T>
using Anchored = Vector<T, 7>;

/// X3 and X4 of the rotation from one pose to another, times the product of their norms.
template <class T>
struct RelativeTurn {
  T X3, X4;
};

/// The smaller of the two is formed so that it cannot cancel, however small: with equal norms, b is close to s a (to
/// the quarter turn s (a4, -a3) of a, where X4 is the smaller), their difference is exact and nearly orthogonal to what
/// it is multiplied with; and what is subtracted drops out of the exact result. Over double the relative error of the
/// smaller one is then a few unit roundoffs; points of different norms take the error-free products.
/// P: Pose, or one whose members are T.
template <class T, class P>
RelativeTurn<T> relative_turn(const P& a, const P& b) {
  const T a3(a.X3), a4(a.X4), b3(b.X3), b4(b.X4);
  RelativeTurn<T> turn{T(b3 * a4 - b4 * a3), T(b4 * a4 + b3 * a3)};
  const double sine = approximate(turn.X3), cosine = approximate(turn.X4);
  if (std::abs(cosine) < std::abs(sine)) {
    const T s(sine < 0 ? -1 : 1);
    turn.X4 = (b3 - s * a4) * a3 + (b4 + s * a3) * a4;
    return turn;
  }
  if constexpr (std::is_same_v<T, double>)
    if (std::abs((b3 - a3) * (b3 + a3) + (b4 - a4) * (b4 + a4)) > 0x1p-30) {  // |b|^2 - |a|^2
      turn.X3 = difference_of_products(b3, a4, b4, a3);
      return turn;
    }
  const T s(cosine < 0 ? -1 : 1);
  turn.X3 = (b3 - s * a3) * a4 - (b4 - s * a4) * a3;
  return turn;
}

/// Two equal angles may differ by this much in the sine of half their difference: the angles themselves rounded (up to
/// two turns in radians), then sine and cosine each once.
inline constexpr double same_orientation_tolerance = 0x1p-50;

/// Whether two poses have the same orientation, up to rounding the data once.
inline bool same_orientation(const Pose& a, const Pose& b) {
  const double norms = (a.X3 * a.X3 + a.X4 * a.X4) * (b.X3 * b.X3 + b.X4 * b.X4), s = relative_turn<double>(a, b).X3;
  return s * s <= same_orientation_tolerance * same_orientation_tolerance * norms;
}

struct AnchorChoice {
  Anchor anchor;
  bool equal_poses = false;    ///< two poses coincide (same origin, same orientation up to rounding)
  bool parallel_pair = false;  ///< two poses may have the same orientation: look closer
  /// What rounding the data once (coordinates, X3 and X4) does to the rows of the closest pair, relative to the rows.
  double noise = 0;
  /// Noise would drown the poses: two of them, or all orientations, agree to within rounding. The doubles are then
  /// taken as they are (noise is one unit roundoff), and only a certificate makes the answer worth stating.
  bool indistinct = false;
};

/// Reference pose, length unit and turn unit for five poses.
AnchorChoice choose_anchor(FivePoses poses);

/// Noise above this is noise that drowns the poses.
inline constexpr double largest_noise = 0x1p-18;

/// The row of equation (2) for the displacement from pose `a` (the reference) to pose `b`, times the norm of the
/// relative image point and a power of two that makes its largest entry of order 1.
template <class T, class P>
std::array<T, 7> anchored_row(const P& a, const P& b, const Anchor& anchor) {
  const auto [s, c] = relative_turn<T>(a, b);
  const double per_length = unit_scale(anchor.length), e = anchor.turn > 0 ? unit_scale(anchor.turn) : 1;
  const T x = (T(b.x) - T(a.x)) * T(per_length), y = (T(b.y) - T(a.y)) * T(per_length);
  const T ss = s * s, sc = s * c, n = ss + c * c;
  const T nx = n * x, ny = n * y;
  std::array<T, 7> row{T(nx * x + ny * y), nx, ny, T(4 * e) * (sc * y - ss * x), T(-4 * e) * (ss * y + sc * x),
                       T(-2 * e * e) * ss, T(2 * e) * sc};
  double size = 0;
  for (const T& entry : row) size = std::max(size, std::abs(approximate(entry)));
  if (size > 0) {
    const T scale(unit_scale(size));
    for (T& entry : row) entry *= scale;
  }
  return row;
}

/// The four rows of equation (2); poses: FivePoses, or five whose members are T.
template <class T, class Poses>
Matrix<T, 4, 7> anchored_rows(const Poses& poses, const Anchor& anchor) {
  Matrix<T, 4, 7> rows;
  for (int j = 0, r = 0; j < 5; ++j) {
    if (j == anchor.reference) continue;
    const std::array<T, 7> row = anchored_row<T>(poses[anchor.reference], poses[j], anchor);
    for (int k = 0; k < 7; ++k) rows(r, k) = row[k];
    ++r;
  }
  return rows;
}

/// The relations (3), scaled: K0 V1 - e G.U + 2 |U|^2 and K0 V2 - U x G. Both vanish on dyads.
template <class T>
std::array<T, 2> anchored_relations(const Anchored<T>& w, const T& e) {
  return {T(w[0] * w[5] - e * (w[1] * w[3] + w[2] * w[4]) + 2 * (w[3] * w[3] + w[4] * w[4])),
          T(w[0] * w[6] - (w[3] * w[2] - w[4] * w[1]))};
}

/// The relations on the null space w = basis z, as two conics in z.
template <class T>
std::array<Conic<T>, 2> relation_conics(const Matrix<T, 7, 3>& basis, const T& e) {
  LinearForm<T> form[7];
  for (int k = 0; k < 7; ++k) form[k] = {basis(k, 0), basis(k, 1), basis(k, 2)};
  const LinearForm<T> e1 = e * form[1] - 2 * form[3], e2 = e * form[2] - 2 * form[4];  // e K, scaled like U
  Conic<T> a, b;
  a.add_product(form[0], form[5], 1);
  a.add_product(e1, form[3], -1);
  a.add_product(e2, form[4], -1);
  b.add_product(form[0], form[6], 1);
  b.add_product(form[3], form[2], -1);
  b.add_product(form[4], form[1], 1);
  return {a, b};
}

/// A root decoded: pivots as seen from the reference pose's origin, in fixed directions and units of the anchor's
/// length. moving = conj(v / K) = u / K0 and fixed = -K / (2 K0) = -v / (2 conj(u)) are each read from whichever
/// of the two fractions is better determined (least squares of both), so that only truly infinite pivots are lost.
template <class T>
struct AnchoredPivots {
  T K0;
  Vector<T, 2> moving, fixed, K, u;  ///< moving is not finite for RP, fixed not for PR
  T by_K, by_u;                      ///< the denominators of moving and of fixed
};

template <class T>
AnchoredPivots<T> decode_pivots(const Anchored<T>& w, const Anchor& anchor) {
  const T e(unit_scale(anchor.turn));
  const T K0 = w[0], u1 = w[3] * e, u2 = w[4] * e, v1 = w[5] * e * e, v2 = w[6] * e;
  const T K1 = w[1] - 2 * u1, K2 = w[2] - 2 * u2;
  const T by_K = K0 * K0 + K1 * K1 + K2 * K2, by_u = -2 * (K0 * K0 + u1 * u1 + u2 * u2);
  return {K0,
          {T((K0 * u1 + K1 * v1 + K2 * v2) / by_K), T((K0 * u2 + K2 * v1 - K1 * v2) / by_K)},
          {T((K0 * K1 + u1 * v1 - u2 * v2) / by_u), T((K0 * K2 + u1 * v2 + u2 * v1) / by_u)},
          {K1, K2},
          {u1, u2},
          by_K,
          by_u};
}

}  // namespace burmester::planar
