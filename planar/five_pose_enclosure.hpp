// One root of the five-pose equations in a box: the square systems that Krawczyk's test is applied to, and what a box
// means for the dyad. Internal to the certificate; not for inclusion by users. I: an interval type.
#pragma once

#include <optional>

#include "burmester/geometry/krawczyk.hpp"
#include "burmester/geometry/range.hpp"
#include "burmester/planar/five_pose_certificate.hpp"

namespace burmester::planar::detail {

/// The four equations in (U, G) with K0 = 1: row . (1, G, U, e G.U - 2 |U|^2, U x G) = 0.
template <class T>
struct FinitePivots {
  static constexpr int size = 4;
  Matrix<T, 4, 7> rows;
  T e;

  Vector<T, 4> value(const Vector<T, 4>& x) const {
    const T V1 = e * (x[2] * x[0] + x[3] * x[1]) - T(2) * (x[0] * x[0] + x[1] * x[1]), V2 = x[0] * x[3] - x[1] * x[2];
    Vector<T, 4> f;
    for (int j = 0; j < 4; ++j)
      f[j] = rows(j, 0) + rows(j, 1) * x[2] + rows(j, 2) * x[3] + rows(j, 3) * x[0] + rows(j, 4) * x[1] +
             rows(j, 5) * V1 + rows(j, 6) * V2;
    return f;
  }
  Matrix<T, 4, 4> jacobian(const Vector<T, 4>& x) const {
    const T K1 = e * x[2] - T(4) * x[0], K2 = e * x[3] - T(4) * x[1];
    Matrix<T, 4, 4> J;
    for (int j = 0; j < 4; ++j) {
      J(j, 0) = rows(j, 3) + rows(j, 5) * K1 + rows(j, 6) * x[3];
      J(j, 1) = rows(j, 4) + rows(j, 5) * K2 - rows(j, 6) * x[2];
      J(j, 2) = rows(j, 1) + rows(j, 5) * (e * x[0]) - rows(j, 6) * x[1];
      J(j, 3) = rows(j, 2) + rows(j, 5) * (e * x[1]) + rows(j, 6) * x[0];
    }
    return J;
  }
};

template <class I>
std::array<Range, 2> rotated_back(const Vector<I, 2>& p, const Pose& reference) {
  const I s(reference.X3), c(reference.X4), n = s * s + c * c, cosine = (c * c - s * s) / n, sine = I(2.0) * s * c / n;
  return {range_of(I(cosine * p[0] + sine * p[1])), range_of(I(cosine * p[1] - sine * p[0]))};
}

/// All seven unknowns, one of them 1: the four rows and the two relations. Pivots may be at infinity.
template <class T>
struct AnyPivots {
  static constexpr int size = 6;
  Matrix<T, 4, 7> rows;
  T e;
  int chart = 0;

  Anchored<T> w(const Vector<T, 6>& x) const {
    Anchored<T> out;
    for (int k = 0, i = 0; k < 7; ++k) out[k] = k == chart ? T(1) : x[i++];
    return out;
  }
  Vector<T, 6> value(const Vector<T, 6>& x) const {
    const Anchored<T> at = w(x);
    Vector<T, 6> f;
    for (int j = 0; j < 4; ++j) {
      f[j] = rows(j, 0) * at[0];
      for (int k = 1; k < 7; ++k) f[j] += rows(j, k) * at[k];
    }
    const std::array<T, 2> relations = anchored_relations(at, e);
    f[4] = relations[0], f[5] = relations[1];
    return f;
  }
  Matrix<T, 6, 6> jacobian(const Vector<T, 6>& x) const {
    const Anchored<T> v = w(x);
    const T zero(0);
    const std::array<T, 7> first{v[5], T(-(e * v[3])), T(-(e * v[4])), T(T(4) * v[3] - e * v[1]),
                                 T(T(4) * v[4] - e * v[2]), v[0], zero};
    const std::array<T, 7> second{v[6], v[4], T(-v[3]), T(-v[2]), v[1], zero, v[0]};
    Matrix<T, 6, 6> J;
    for (int k = 0, c = 0; k < 7; ++k) {
      if (k == chart) continue;
      for (int j = 0; j < 4; ++j) J(j, c) = rows(j, k);
      J(4, c) = first[static_cast<std::size_t>(k)], J(5, c) = second[static_cast<std::size_t>(k)];
      ++c;
    }
    return J;
  }
};

/// A proved root: all its w, and the dyads they decode to.
template <class I>
struct Enclosed {
  Anchored<I> w;
  DyadBox dyad;
};

/// Of (U, G) with K0 = 1: moving = U / e, fixed = moving - G / 2.
template <class I>
Enclosed<I> finite_dyad(const Vector<I, 4>& x, const I& e, const Anchor& anchor, const Pose& reference) {
  const I L(anchor.length), per_e(unit_scale(anchor.turn)), half(0.5);
  const Vector<I, 2> moving{I(L * per_e * x[0]), I(L * per_e * x[1])};
  const I to_x = L * half * x[2], to_y = L * half * x[3];
  Enclosed<I> out;
  out.w[0] = I(1), out.w[1] = x[2], out.w[2] = x[3], out.w[3] = x[0], out.w[4] = x[1];
  out.w[5] = e * (x[2] * x[0] + x[3] * x[1]) - I(2) * (x[0] * x[0] + x[1] * x[1]);
  out.w[6] = x[0] * x[3] - x[1] * x[2];
  out.dyad.moving = rotated_back(moving, reference);
  out.dyad.fixed = {range_of(I(moving[0] - to_x)), range_of(I(moving[1] - to_y))};
  out.dyad.length = root_of(range_of(I(to_x * to_x + to_y * to_y)));
  return out;
}

/// Of any w: each pivot where it is finite all over the box, else anywhere.
template <class I>
Enclosed<I> any_dyad(const Anchored<I>& w, const Anchor& anchor, const Pose& reference) {
  Enclosed<I> out{w, {}};
  const I L(anchor.length), half(0.5);
  const AnchoredPivots<I> pivots = decode_pivots(w, anchor);
  if (!contains_zero(pivots.by_K)) {
    const Vector<I, 2> moving{I(L * pivots.moving[0]), I(L * pivots.moving[1])};
    out.dyad.moving = rotated_back(moving, reference);
  }
  if (!contains_zero(pivots.by_u))
    out.dyad.fixed = {range_of(I(L * pivots.fixed[0])), range_of(I(L * pivots.fixed[1]))};
  if (!contains_zero(w[0])) {
    const I x = L * half * w[1] / w[0], y = L * half * w[2] / w[0];
    out.dyad.length = root_of(range_of(I(x * x + y * y)));
  }
  return out;
}

/// Whether no point of P^6 has representatives in both boxes: some 2 x 2 minor is not 0.
template <class I>
bool different(const Anchored<I>& a, const Anchored<I>& b) {
  for (int i = 0; i < 7; ++i)
    for (int j = i + 1; j < 7; ++j)
      if (!contains_zero(I(a[i] * b[j] - a[j] * b[i]))) return true;
  return false;
}

/// One root in its box: as finite pivots where K0 is not small beside the rest, as a point of P^6 otherwise or where
/// that fails (a far pivot beside one at infinity). `box(system, start)` is a box around the start, a vector of
/// intervals I, or nothing; system(rows, e) makes the square system.
template <class I, class T, class MakeBox>
std::optional<Enclosed<I>> enclose_root(const Anchored<T>& w, const Anchor& anchor, const Pose& reference,
                                        MakeBox box) {
  int chart = 0;
  for (int k = 1; k < 7; ++k)
    if (std::abs(approximate(w[k])) > std::abs(approximate(w[chart]))) chart = k;
  if (std::abs(approximate(w[0])) > 1e-5 * std::abs(approximate(w[chart]))) {
    const auto system = []<class N>(const Matrix<N, 4, 7>& rows, const N& e) { return FinitePivots<N>{rows, e}; };
    const Vector<T, 4> start(w[3] / w[0], w[4] / w[0], w[1] / w[0], w[2] / w[0]);
    if (const std::optional<Vector<I, 4>> x = box(system, start))
      return finite_dyad(*x, I(anchor.turn), anchor, reference);
  }
  const auto system = [=]<class N>(const Matrix<N, 4, 7>& rows, const N& e) { return AnyPivots<N>{rows, e, chart}; };
  Vector<T, 6> start;
  for (int k = 0, i = 0; k < 7; ++k)
    if (k != chart) start[i++] = w[k] / w[chart];
  if (const std::optional<Vector<I, 6>> x = box(system, start))
    return any_dyad(AnyPivots<I>{{}, I(anchor.turn), chart}.w(*x), anchor, reference);
  return std::nullopt;
}

}  // namespace burmester::planar::detail
