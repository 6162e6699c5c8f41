#include "burmester/planar/exact_degeneracy.hpp"

#include "burmester/geometry/degenerate_pencil.hpp"
#include "burmester/geometry/exact_rank.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/signature.hpp"
#include "burmester/planar/orientations.hpp"

namespace burmester::planar {
namespace {

using Plane2 = Vector<Rational, 2>;
using Point = Point2<Rational>;
using ExactConic = Conic<Rational>;
using Outcome = std::optional<ExactDegeneracy>;

const ExactDegeneracy nothing_listed;
Outcome proved_if(bool holds) { return holds ? Outcome(nothing_listed) : std::nullopt; }

bool parallel(const Pose& a, const Pose& b) {
  return Rational(a.X3) * Rational(b.X4) == Rational(a.X4) * Rational(b.X3);
}
Plane2 step(const Pose& a, const Pose& b) {
  return {Rational(b.x) - Rational(a.x), Rational(b.y) - Rational(a.y)};
}
Rational cross(const Plane2& a, const Plane2& b) { return a[0] * b[1] - a[1] * b[0]; }

// ---- Parallel poses ----

/// Whether the origins of the poses lie on one circle or line.
bool concyclic(FivePoses poses, const OrientationClass& among) {
  Matrix<Rational, 4, 3> rows = Matrix<Rational, 4, 3>::Zero();
  for (int r = 0; r + 1 < among.size; ++r) {
    const Plane2 t = step(poses[among.member[0]], poses[among.member[r + 1]]);
    rows.row(r) << t.dot(t), t[0], t[1];
  }
  return exact_rank(rows) < 3;
}

/// Every two poses that the verdict calls equal are.
bool equal_exactly(FivePoses poses) {
  bool some = false;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < i; ++j) {
      if (!step(poses[i], poses[j]).isZero(0) || !same_orientation(poses[i], poses[j])) continue;
      if (!parallel(poses[i], poses[j])) return false;
      some = true;
    }
  return some;
}

bool in_line_exactly(FivePoses poses) {
  const auto at = triple_and_pair(poses, parallel);
  if (!at) return false;
  const auto& [a, b, c] = at->triple;
  const Plane2 along = step(poses[a], poses[b]);
  return cross(along, step(poses[a], poses[c])) == 0 && cross(along, step(poses[at->pair[0]], poses[at->pair[1]])) != 0;
}

// ---- Rotations ----

/// (R - I) p = -t for the rotation and translation between two poses, times half the norm of the relative image point:
/// sin (-sin, -cos; cos, -sin) p in half the angle.
bool rotations_about_one_point(FivePoses poses, const Anchor& anchor) {
  const Pose& a = poses[anchor.reference];
  std::optional<Plane2> centre;
  for (const Pose& b : poses) {
    const auto [s, c] = relative_turn<Rational>(a, b);
    const Plane2 t = step(a, b);
    if (s == 0 && !t.isZero(0)) return false;
    if (s == 0) continue;
    const Rational half(0.5), ratio = c / s;  // 2 p = t + cot (t turned by a quarter)
    const Plane2 p{Rational(half * (t[0] - ratio * t[1])), Rational(half * (t[1] + ratio * t[0]))};
    if (centre && *centre != p) return false;
    centre = p;
  }
  return centre.has_value();
}

// ---- Degenerate pencils ----

struct Plane {
  Matrix<Rational, 7, 3> basis;
  ExactConic a, b;
  /// Largest coordinate 1.
  Anchored<Rational> w(const Point& z) const {
    const Anchored<Rational> out = basis * z;
    return out / Rational(out.cwiseAbs().maxCoeff());
  }
};

bool is_zero(const ExactConic& c) {
  return std::all_of(c.q.begin(), c.q.end(), [](const Rational& x) { return x == 0; });
}

bool is_dyad(const Anchored<Rational>& w) { return !w.head<5>().isZero(0); }

/// Of one type: K0 is zero all along the line or at one point.
Anchored<Rational> dyad_on(const Point& line, const Plane& p) {
  Point u = Point::Zero(), v = Point::Zero();
  burmester::detail::span_line(line, u, v);
  const Anchored<Rational> first = p.w(u), second = p.w(v);
  return first[0] == 0 && (second[0] != 0 || !is_dyad(first)) ? second : first;
}

Outcome common_line(const Plane& p, const CommonPoints<Rational>& shared) {
  ExactDegeneracy out{{}, dyad_on(shared.line, p)};
  if (shared.count > 0) out.isolated.push_back(p.w(shared.point[0]));
  return out.isolated.empty() || is_dyad(out.isolated[0]) ? Outcome(out) : std::nullopt;
}

Outcome common_vertex(const Plane& p, const Point& vertex) {
  const Anchored<Rational> w = p.w(vertex);
  return is_dyad(w) ? Outcome(ExactDegeneracy{{w}, {}}) : std::nullopt;
}

/// Real points: none of a definite form, the vertex of two complex lines, else infinitely many.
Outcome one_conic(const Plane& p, bool empty) {
  const ExactConic& c = is_zero(p.a) ? p.b : p.a;
  if (is_zero(c) || !exactly_proportional(p.a, p.b)) return std::nullopt;
  const Inertia form = *inertia(matrix_of(c));
  const bool definite = std::abs(form.signature) == form.rank;
  if (definite && form.rank == 2) return proved_if(empty && !is_dyad(p.w(vertex_of(c))));
  return proved_if(empty == (definite && form.rank == 3));
}

Outcome degenerate_pencil(FivePoseCase what, FivePoses poses, const Anchor& anchor) {
  const Matrix<Rational, 4, 7> rows = anchored_rows<Rational>(poses, anchor);
  const NullSpace<Rational, 4, 7> null = null_space(rows);
  if (what == FivePoseCase::rank_deficient) return proved_if(exact_rank(rows) < 4);
  if (!(null.smallest_pivot() > 0)) return std::nullopt;
  const auto conics = relation_conics(null.basis, Rational(anchor.turn));
  const Plane plane{null.basis, conics[0], conics[1]};
  const bool line = what == FivePoseCase::common_line;
  if (!line && what != FivePoseCase::common_vertex) return one_conic(plane, what == FivePoseCase::empty_conic);
  const auto shared = degenerate_common_points_exactly(plane.a, plane.b);
  if (!shared || shared->kind != (line ? PencilKind::common_line : PencilKind::common_vertex)) return std::nullopt;
  return line ? common_line(plane, *shared) : common_vertex(plane, shared->point[0]);
}

}  // namespace

Outcome exact_degeneracy(FivePoseCase what, FivePoses poses, const Anchor& anchor) {
  const OrientationClass most = orientation_classes(poses, parallel)[0];
  switch (what) {
    case FivePoseCase::equal_poses: return proved_if(equal_exactly(poses));
    case FivePoseCase::all_parallel: return proved_if(most.size == 5 && !concyclic(poses, most));
    case FivePoseCase::translation: return proved_if(most.size == 5 && concyclic(poses, most));
    case FivePoseCase::four_parallel: return proved_if(most.size == 4 && !concyclic(poses, most));
    case FivePoseCase::two_orientations_in_line: return proved_if(in_line_exactly(poses));
    case FivePoseCase::rotation: return proved_if(rotations_about_one_point(poses, anchor));
    default: return anchor.turn == 0 ? std::nullopt : degenerate_pencil(what, poses, anchor);
  }
}

int count_of_two_orientations(FivePoses poses) {
  const auto at = triple_and_pair(poses, parallel);
  if (!at) return -1;
  const auto& [i, j, k] = at->triple;
  const Plane2 a = step(poses[i], poses[j]), b = step(poses[i], poses[k]), c = b - a,
               t = step(poses[at->pair[0]], poses[at->pair[1]]);
  const Rational area = cross(a, b), farthest = a.dot(a) * b.dot(b) * c.dot(c), apart = t.dot(t) * area * area;
  if (area == 0 || farthest == apart) return -1;
  return farthest > apart ? 2 : 0;
}

}  // namespace burmester::planar
