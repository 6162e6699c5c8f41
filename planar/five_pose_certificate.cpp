#include "burmester/planar/five_pose_certificate.hpp"

#include <optional>

#include "burmester/geometry/conic_count.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/enclosure.hpp"
#include "burmester/planar/exact_degeneracy.hpp"
#include "burmester/planar/five_pose_enclosure.hpp"
#include "burmester/planar/five_pose_oracle.hpp"
#include "burmester/planar/merge_distance.hpp"

namespace burmester::planar {
namespace {

/// The number of real dyads, nothing where T cannot tell: the rank is not proved to be four, the conics have a common
/// point of higher multiplicity, or a sign is not known.
template <class T>
std::optional<int> count_over(FivePoses poses, const Anchor& anchor) {
  const NullSpace<T, 4, 7> null = null_space(anchored_rows<T>(poses, anchor));
  if (anchor.turn == 0 || !(null.smallest_pivot() > 0)) return std::nullopt;
  const std::array<Conic<T>, 2> conics = relation_conics(null.basis, T(anchor.turn));
  return count_common_points(conics[0], conics[1]);
}

/// Krawczyk's test around doubles.
template <class I>
struct AroundDoubles {
  using Ends = I;
  Matrix<I, 4, 7> rows;
  I turn;

  AroundDoubles(FivePoses poses, const Anchor& anchor) : rows(anchored_rows<I>(poses, anchor)), turn(anchor.turn) {}

  template <class System, int N>
  std::optional<Vector<I, N>> operator()(const System& system, const Vector<double, N>& start) const {
    const auto box = krawczyk<I>(system(rows, turn), start);
    if (!box) return std::nullopt;
    return box->template hull<I>();
  }
};

/// Krawczyk's test around numbers of quad precision, where the equations have exact values; intervals of doubles do for
/// the derivatives.
struct AroundQuads {
  using Ends = RationalInterval;
  Matrix<Interval, 4, 7> rows;
  Matrix<Rational, 4, 7> exact_rows;
  double turn;

  AroundQuads(FivePoses poses, const Anchor& anchor)
      : rows(anchored_rows<Interval>(poses, anchor)),
        exact_rows(anchored_rows<Rational>(poses, anchor)),
        turn(anchor.turn) {}

  /// To 106 bits: as good a place for a centre as x itself.
  static Rational rational(const Quad& x) {
    const double high = static_cast<double>(x), low = static_cast<double>(Quad(x - Quad(high)));
    return Rational(high) + Rational(low);
  }

  template <class System, int N>
  std::optional<Vector<RationalInterval, N>> operator()(const System& system, const Vector<Quad, N>& start) const {
    Vector<Rational, N> z;
    for (int i = 0; i < N; ++i) z[i] = rational(start[i]);
    const Vector<Rational, N> f = system(exact_rows, Rational(turn)).value(z);
    Vector<Interval, N> centre, value;
    for (int i = 0; i < N; ++i) centre[i] = enclosure(z[i]), value[i] = enclosure(f[i]);
    const auto radius = krawczyk_radius<Interval>(system(rows, Interval(turn)), centre, value);
    if (!radius) return std::nullopt;
    Vector<RationalInterval, N> x;
    for (int i = 0; i < N; ++i) {
      const Rational r((*radius)[i]);
      x[i] = RationalInterval(Rational(z[i] - r), Rational(z[i] + r));
    }
    return x;
  }
};

/// Disjoint boxes for all roots; false where one cannot be proved.
template <class Around, class T>
bool enclose(FivePoses poses, const std::array<Anchored<T>, 4>& w, Rung rung, CertifiedRoots& out) {
  using I = typename Around::Ends;
  const Anchor& anchor = out.roots.anchor;
  const Around around(poses, anchor);
  std::array<Anchored<I>, 4> found;
  std::array<DyadBox, 4> boxes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.roots.count); ++i) {
    const auto root =
        detail::enclose_root<I>(w[i], anchor, poses[static_cast<std::size_t>(anchor.reference)], around);
    if (!root) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (!detail::different(found[j], root->w)) return false;
    found[i] = root->w;
    boxes[i] = root->dyad;
    boxes[i].rung = rung;
  }
  out.boxes = boxes;
  return true;
}

/// Takes the roots of quad precision, where they are as many as are proved.
bool take_quad_roots(FivePoses poses, CertifiedRoots& out) {
  const FivePoseRoots<Quad> quad = five_pose_roots_as_given(poses);
  if (quad.count != out.count) return false;
  out.roots.count = quad.count;
  out.quad = quad.w;
  for (std::size_t i = 0; i < static_cast<std::size_t>(quad.count); ++i)
    out.roots.w[i] = quad.w[i].template cast<double>();
  return true;
}

/// The proved number of real dyads, by intervals or exactly; -1 where there is none.
void prove_count(FivePoses poses, CertifiedRoots& out) {
  const bool pair = out.roots.what == FivePoseCase::two_orientations;
  if (!pair) out.count = count_by_intervals(poses);
  if (out.count >= 0) {
    out.count_rung = Rung::intervals;
    return;
  }
  out.count = pair ? count_of_two_orientations(poses) : count_exactly(poses);
  if (out.count >= 0) out.count_rung = Rung::exact;
}

bool enclose_with_intervals(FivePoses poses, CertifiedRoots& out) {
  const UpwardRounding upward;
  return enclose<AroundDoubles<Interval>>(poses, out.roots.w, Rung::intervals, out);
}
bool enclose_sharply(FivePoses poses, CertifiedRoots& out) {
  const UpwardRounding upward;
  return enclose<AroundQuads>(poses, out.quad, Rung::exact, out);
}

/// Boxes for as many roots as are proved to exist; first those of the fast solver, then those of quad precision.
bool prove_boxes(FivePoses poses, CertifiedRoots& out) {
  if (out.count < 0) return false;
  if (out.roots.count == out.count && enclose_with_intervals(poses, out)) return true;
  if (!take_quad_roots(poses, out)) return false;
  return enclose_sharply(poses, out) ||
         enclose<AroundDoubles<RationalInterval>>(poses, out.roots.w, Rung::exact, out);
}

Anchored<double> approximation(const Anchored<Rational>& w) {
  Anchored<double> out;
  for (int k = 0; k < 7; ++k) out[k] = approximate(w[k]);
  return out;
}

/// The dyads beside a proved degeneracy are rational: their boxes are as small as intervals go.
void list_isolated(FivePoses poses, const ExactDegeneracy& proof, CertifiedRoots& out) {
  const Anchor& anchor = out.roots.anchor;
  out.roots.count = static_cast<int>(proof.isolated.size());
  for (std::size_t i = 0; i < proof.isolated.size(); ++i) {
    Anchored<Interval> w;
    for (int k = 0; k < 7; ++k) w[k] = enclosure(proof.isolated[i][k]);
    out.roots.w[i] = approximation(proof.isolated[i]);
    const UpwardRounding upward;
    out.boxes[i] = detail::any_dyad(w, anchor, poses[static_cast<std::size_t>(anchor.reference)]).dyad;
    out.boxes[i].rung = Rung::exact;
  }
  if (out.roots.what == FivePoseCase::common_line) out.roots.family = approximation(proof.family);
}

void prove_degeneracy(FivePoses poses, CertifiedRoots& out) {
  const auto proof = exact_degeneracy(out.roots.what, poses, out.roots.anchor);
  out.degenerate = proof.has_value();
  if (proof)
    list_isolated(poses, *proof, out);
  else
    out.count = count_exactly(poses);
}

}  // namespace

CertifiedRoots certified_five_pose_roots(FivePoses poses) {
  CertifiedRoots out;
  out.roots = five_pose_roots(poses);
  if (out.roots.what != FivePoseCase::regular && out.roots.what != FivePoseCase::two_orientations) {
    prove_degeneracy(poses, out);
    if (out.degenerate || out.count < 0 || degenerate_within_rounding(out.roots.what, poses, out.roots.anchor))
      return out;
    out.roots.what = FivePoseCase::regular;
    out.roots.rounding = 1;  // of the discriminant: nothing is known of it
    out.count_rung = Rung::exact;
  } else {
    prove_count(poses, out);
  }
  out.complete = prove_boxes(poses, out);
  return out;
}

bool sharpen(FivePoses poses, CertifiedRoots& out) {
  CertifiedRoots sharp = out;
  if (!out.complete || !take_quad_roots(poses, sharp) || !enclose_sharply(poses, sharp)) return false;
  sharp.sharp = true;
  out = sharp;
  return true;
}

int count_by_intervals(FivePoses poses) {
  const Anchor anchor = choose_anchor(poses).anchor;
  const UpwardRounding upward;
  return count_over<Interval>(poses, anchor).value_or(-1);
}

int count_exactly(FivePoses poses) {
  Anchor anchor = choose_anchor(poses).anchor;
  if (anchor.turn == 0) anchor.turn = 1;  // orientations that only rounding tells apart
  return count_over<Rational>(poses, anchor).value_or(-1);
}

}  // namespace burmester::planar
