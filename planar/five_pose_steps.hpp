// The root steps of the five-pose solver, shared by the double and the quad instance. Not for inclusion by users.
#pragma once

#include "burmester/geometry/signature.hpp"
#include "burmester/planar/five_pose_roots.hpp"
#include "burmester/planar/orientations.hpp"

namespace burmester::planar::detail {

template <class T>
struct Pencil {
  NullSpace<T, 4, 7> null;
  Conic<T> a, b;                        // scaled to size 1
  T a_scale{1}, b_scale{1};
  T e;

  Anchored<T> w(const Point2<T>& z) const {
    Anchored<T> out;
    for (int k = 0; k < 7; ++k)
      out[k] = null.basis(k, 0) * z[0] + null.basis(k, 1) * z[1] + null.basis(k, 2) * z[2];
    return out;
  }

  /// The relations at w(z), scaled like the conics. They cancel less than the conics do.
  std::array<T, 2> residual(const Point2<T>& z) const {
    const std::array<T, 2> f = anchored_relations(w(z), e);
    return {T(f[0] * a_scale), T(f[1] * b_scale)};
  }

  /// One Newton step on the relations in P^2 (the correction is orthogonal to z). Near a double root, where rounding
  /// makes the step, only as far as it helps.
  Point2<T> improved(const Point2<T>& z) const {
    const std::array<T, 2> f = residual(z);
    const Vector<T, 3> ga = a.gradient(z), gb = b.gradient(z), across = gb.cross(z);
    const T determinant = ga.dot(across);
    if (determinant == 0) return z;
    const Vector<T, 3> step = (f[0] * across + f[1] * z.cross(ga)) / determinant;
    const T size = step.squaredNorm() / z.squaredNorm();
    if (size < T(0x1p-40)) return z - step;
    if (!(size < T(0.25))) return z;
    const std::array<T, 2> after = residual(z - step);
    return after[0] * after[0] + after[1] * after[1] < f[0] * f[0] + f[1] * f[1] ? Point2<T>(z - step) : z;
  }
};

template <class T>
constexpr int newton_steps = 1;

template <class T>
void add_root(FivePoseRoots<T>& out, const Pencil<T>& pencil, Point2<T> z) {
  for (int i = 0; i < newton_steps<T>; ++i) z = pencil.improved(z);
  out.w[out.count++] = pencil.w(z);
}

/// The pair of orientations of a 3 + 2 task, w0 = (0, .., V1, V2), as V1 and V2.
template <class T>
std::array<T, 2> orientation_pair(FivePoses poses, const Anchor& anchor, const T& e) {
  const Pose& reference = poses[anchor.reference];
  std::array<T, 2> out{e, T(0)};
  for (const Pose& pose : poses)
    if (!same_orientation(reference, pose)) {
      const RelativeTurn<T> turn = relative_turn<T>(reference, pose);
      out = {T(e * turn.X4), turn.X3};
    }
  return out;
}

/// 3 + 2 orientations: w0 is a root of multiplicity two, at which V2 A - V1 B is singular. Its two lines through w0
/// carry the other two roots.
template <class T>
void two_orientation_roots(FivePoses poses, const Pencil<T>& pencil, double tolerance, FivePoseRoots<T>& out) {
  out.what = FivePoseCase::two_orientations;
  const auto [v1, v2] = orientation_pair(poses, out.anchor, pencil.e);
  Anchored<T> w0 = Anchored<T>::Zero();
  w0[5] = v1, w0[6] = v2;
  Point2<T> z0;
  for (int g = 0; g < 3; ++g) z0[g] = w0[pencil.null.free[g]];
  const Conic<T> at_w0 =
      pencil_member(pencil.a, T(v2 * pencil.b_scale), pencil.b, T(-v1 * pencil.a_scale));
  const LinePair<T> lines = burmester::detail::split(at_w0);
  const double size = size_of(at_w0);
  out.discriminant = approximate(lines.separation) / (size * size);
  out.rounding = tolerance / size;
  if (!(lines.separation > 0)) return;
  const Conic<T>& q = pencil.a.gradient(z0).squaredNorm() > pencil.b.gradient(z0).squaredNorm() ? pencil.a : pencil.b;
  for (const LinearForm<T>& line : {lines.first, lines.second}) {
    const Point2<T> v = line.cross(z0).normalized();
    add_root(out, pencil, Point2<T>((-q(v)) * z0 + q.polar(z0, v) * v));
  }
}

/// One orientation: the span holds PP; with four rows [|t|^2, a, b] of rank below three every point traces
/// congruent circles (or parallel lines), and every point is a moving pivot.
template <class T>
FivePoseCase parallel_case(FivePoses poses, const AnchorChoice& choice) {
  const Anchor& anchor = choice.anchor;
  Matrix<T, 3, 4> rows;  // transposed: complete pivoting does not mind
  for (int j = 0, r = 0; j < 5; ++j) {
    if (j == anchor.reference) continue;
    const std::array<T, 7> row = anchored_row<T>(poses[anchor.reference], poses[j], anchor);
    for (int k = 0; k < 3; ++k) rows(k, r) = row[k];
    ++r;
  }
  const bool dependent = null_space(rows).is_zero(2, noise_factor * choice.noise);
  return dependent ? FivePoseCase::translation : FivePoseCase::all_parallel;
}

/// Whether w is a pair of orientations: K0 = G = U = 0 to within the tolerance.
template <class T>
bool is_orientation_pair(const Anchored<T>& w, double tolerance) {
  const T rest = w.template head<5>().cwiseAbs().maxCoeff(), size = w.cwiseAbs().maxCoeff();
  return approximate(rest) <= tolerance * approximate(size);
}

/// Whether no real point of the conic is a dyad: it is empty, or two complex lines through a pair of orientations.
template <class T>
bool without_dyads(const Conic<T>& c, const Pencil<T>& pencil, double tolerance) {
  const Adjugate<T> adj(c);
  if (!(approximate(adj.trace()) > tolerance)) return false;
  if (!(std::abs(approximate(adj.determinant(c))) > tolerance))
    return is_orientation_pair(pencil.w(burmester::detail::vertex_of(c)), std::sqrt(tolerance));
  const std::optional<Inertia> form = inertia(matrix_of(c));
  return form && std::abs(form->signature) == 3;
}

/// The conics share a component or a vertex: find which, and the isolated root if there is one.
template <class T>
void degenerate_pencil(const Pencil<T>& pencil, double tolerance, FivePoseRoots<T>& out) {
  const CommonPoints<T> common = degenerate_common_points(pencil.a, pencil.b, tolerance);
  if (common.kind == PencilKind::common_line) {
    out.what = FivePoseCase::common_line;
    Point2<T> u, v;
    burmester::detail::span_line(common.line, u, v);
    out.family = pencil.w(Point2<T>(u + v));
  } else {
    const Conic<T>& conic = size_of(pencil.a) > size_of(pencil.b) ? pencil.a : pencil.b;
    out.what = common.kind == PencilKind::common_vertex            ? FivePoseCase::common_vertex
               : without_dyads(conic, pencil, tolerance) ? FivePoseCase::empty_conic
                                                                   : FivePoseCase::whole_conic;
  }
  for (int i = 0; i < common.count; ++i) out.w[out.count++] = pencil.w(common.point[i]);
  // The vertex is only known to the square root of the rounding where it is a double point of every member.
  if (out.what == FivePoseCase::common_vertex && is_orientation_pair(out.w[0], std::sqrt(tolerance))) {
    out.what = FivePoseCase::two_orientations_in_line;
    out.count = 0;
  }
}

/// Scales the conic to size 1 and returns the factor; a conic below the tolerance becomes zero.
template <class T>
T scale_to_one(Conic<T>& c, double tolerance) {
  const double size = size_of(c);
  const T factor(size > tolerance ? unit_scale(size) : 0);
  for (T& q : c.q) q *= factor;
  return factor;
}

/// Names the cases with at most two orientations among four poses; 3 + 2 only where the pencil is regular.
template <class T>
void special_orientations(FivePoses poses, const Pencil<T>& pencil, double tolerance, FivePoseRoots<T>& out) {
  const auto classes = orientation_classes(poses, same_orientation);
  if (classes[0].size == 4)
    out.what = FivePoseCase::four_parallel;
  else if (classes[0].size == 3 && classes[1].size == 2 && out.pencil_size >= tolerance)
    two_orientation_roots(poses, pencil, tolerance, out);
}

template <class T>
FivePoseRoots<T> solve(FivePoses poses, const AnchorChoice& choice) {
  FivePoseRoots<T> out;
  out.anchor = choice.anchor;
  out.indistinct = choice.indistinct;
  if (choice.equal_poses) {
    out.what = FivePoseCase::equal_poses;
    return out;
  }
  if (out.anchor.turn == 0) {
    out.what = parallel_case<T>(poses, choice);
    return out;
  }
  Pencil<T> pencil;
  pencil.e = T(out.anchor.turn);
  pencil.null = null_space(anchored_rows<T>(poses, out.anchor));
  out.smallest_pivot = pencil.null.smallest_pivot();
  const double tolerance = noise_factor * choice.noise;
  if (pencil.null.is_zero(3, tolerance)) {  // pure rotations satisfy K0 = G = u = 0: two independent rows only
    out.what = pencil.null.is_zero(2, tolerance) ? FivePoseCase::rotation : FivePoseCase::rank_deficient;
    return out;
  }
  const std::array<Conic<T>, 2> conics = relation_conics(pencil.null.basis, pencil.e);
  pencil.a = conics[0], pencil.b = conics[1];
  const double amplified = tolerance / std::min(1.0, out.smallest_pivot);
  pencil.a_scale = scale_to_one(pencil.a, amplified), pencil.b_scale = scale_to_one(pencil.b, amplified);
  const std::array<T, 4> cubic = pencil_determinant(pencil.a, pencil.b);
  for (const T& c : cubic) out.pencil_size = std::max(out.pencil_size, std::abs(approximate(c)));
  if (choice.parallel_pair) {
    special_orientations(poses, pencil, amplified, out);
    if (out.what != FivePoseCase::regular) return out;
  }
  out.rounding = amplified / out.pencil_size;
  out.discriminant = approximate(relative_discriminant(cubic));
  const bool triple_root_maybe = !(std::abs(out.discriminant) > out.rounding);
  if (out.pencil_size < amplified || (triple_root_maybe && proportional(pencil.a, pencil.b, amplified))) {
    degenerate_pencil(pencil, amplified, out);
    return out;
  }
  const CommonPoints<T> common = regular_common_points(pencil.a, pencil.b, cubic);
  for (int i = 0; i < common.count; ++i) add_root(out, pencil, common.point[i]);
  return out;
}

}  // namespace burmester::planar::detail
